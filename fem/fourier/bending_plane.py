"""Section of a body of revolution in the plane in which a mode bends, on both sides of the axis."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from fem.fourier.harmonic_cells import stress
from fem.fourier.vibration import RotatingSolid
from fem.plane.discretisation import Array

CUT = 0.98  # relative to the volume, whose stress a picture's colours span


class BendingPlane(NamedTuple):
    """Bent section as a mesh with displacements and axial stresses.

    `points` (n, 2) are coordinates along and across the axis, `cells` (m, 4) are node numbers. The
    largest component of `displacement` (n, 2) is 1. `stress` (m,) of the cells is divided by the
    magnitude that a share CUT of the volume does not exceed, and is limited to this magnitude.
    """

    points: Array
    cells: NDArray[np.int64]
    displacement: Array
    stress: Array


def bending_plane(body: RotatingSolid, u: Array) -> BendingPlane:
    """Section in the bending plane for the amplitudes `u` (unknowns,) of the first harmonic."""
    cells, mesh = body.solid.cells, body.solid.mesh
    sigma = stress(cells.strain(u, 1), cells.lam[:, None], cells.mu[:, None])[..., 2]
    volume = cells.dx.sum(axis=1)
    mean = (sigma * cells.dx).sum(axis=1) / volume
    order = np.argsort(abs(mean))
    below = np.cumsum(volume[order]) <= CUT * volume.sum()
    mean = np.clip(mean / abs(mean[order][below][-1]), -1, 1)
    U, _, W = u[body.solid.basis.nodal_dofs]
    r, z = mesh.p
    top = max(abs(U).max(), abs(W).max())
    shift = np.column_stack([np.tile(W, 2) * np.repeat([1, -1], W.size), np.tile(U, 2)])
    return BendingPlane(
        points=np.column_stack([np.tile(z, 2), np.concatenate([r, -r])]),
        cells=np.hstack([mesh.t, mesh.t + r.size]).T.astype(np.int64),
        displacement=shift / top,
        stress=np.concatenate([mean, -mean]),
    )
