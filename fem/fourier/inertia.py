"""Mass and moments of inertia of a rotating body with its discs, from its matrices."""

import numpy as np

from fem.fourier.supports import rigid_motions
from fem.fourier.vibration import RotatingSolid
from fem.plane.discretisation import Array


def rigid_inertia(body: RotatingSolid) -> Array:
    """Mass [kg], and polar and diametral moments of inertia [kg m^2] about the origin (3,).

    The values are v M v, w G w and w M w, with unit translation v across the axis and unit tilt w.
    """
    twice = np.asarray(body.T.multiply(body.T).sum(axis=0)).ravel()
    across, tilt = ((body.T.T @ rigid_motions(body.solid.basis, 1, False)) / twice[:, None]).T
    return np.array([across @ body.M @ across, tilt @ body.G @ tilt, tilt @ body.M @ tilt])
