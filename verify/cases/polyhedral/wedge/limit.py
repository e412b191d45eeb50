"""Limit of friction at which a roller is released from its wedge, by finite elements."""

import math

import numpy as np
from numpy.typing import NDArray

from verify.cases.polyhedral.wedge.inputs import WedgeInputs

Array = NDArray[np.float64]

COARSE = 6  # cells on the half-width: forces do not depend on it
ANY = 0.5  # over N: the roller stays above it; forces differ between wedges
LOST = 1e-6  # relative to N: smaller forces are round-off of an open contact
ANGLES = (0.1, 0.3, 0.5, 0.7, 0.9, 0.98, 1.02, 1.2, 1.45)  # tan(alpha/2)/mu of the sweep


def pressed_fem(q: WedgeInputs, down: float, *, half: float, mu: float) -> tuple[float, float]:
    """Two ratios for a race displaced by `down` [m] towards the roller: N to the given N, T to N.

    `half` is half of the wedge angle [rad]. Both values are zero if the contact is lost.
    """
    from fem.contact.wedged import Geometry, Wedge
    from verify.cases.polyhedral.wedge.mesh import fem_mesh

    geometry = Geometry(q.R, half, q.a)
    wedge = Wedge(geometry, fem_mesh(geometry, COARSE), E=q.E, nu=q.nu, mu=mu)
    N, T = wedge.forces(wedge.at(down))
    left = N / q.line_load
    return (left, T / N) if left > LOST else (0.0, 0.0)


def least_fem(q: WedgeInputs, down: float, share: float) -> tuple[float, float]:
    """Smallest mu that holds the roller, sought near `share` = T/N, and its uncertainty."""
    from fem.contact.wedged_states import least_friction

    return least_friction(lambda mu: pressed_fem(q, down, half=q.half, mu=mu)[0], share)


def around_fem(q: WedgeInputs, down: float) -> Array:
    """Fractions of N that remain with friction 1 % below and 1 % above tan(alpha/2), (2,)."""
    limit = math.tan(q.half)
    return np.array([
        pressed_fem(q, down, half=q.half, mu=share * limit)[0] for share in (0.99, 1.01)
    ])  # fmt: skip


def over_angles_fem(q: WedgeInputs, down: float) -> Array:
    """Array (3, m): tan(alpha/2)/mu, remaining fraction of N, T/(mu N) (0 if no N remains)."""
    found = []
    for share in ANGLES:
        left, ratio = pressed_fem(q, down, half=math.atan(share * q.mu), mu=q.mu)
        found.append((share, left, ratio / q.mu if left > ANY else 0.0))
    return np.array(found).T
