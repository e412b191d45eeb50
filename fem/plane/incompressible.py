"""Nearly incompressible materials: limit of nu for standard elements; triangle for mixed elements.

Above this limit, standard elements of degree 2 still give correct displacements. However, their
volumetric stress lambda div u oscillates about the exact stress; the amplitude increases with
lambda/mu.
"""

import numpy as np
from skfem import ElementTriP2
from skfem.mesh import Mesh2D
from skfem.refdom import RefTri

from fem.plane.geometry import Array

LIMIT = 0.45  # of Poisson's ratio: up to here plain elements are used, lambda/mu is at most 9
ROUND_OFF = 1e-9  # nu comes back from lambda and mu


def plane_ratio(lam: Array, mu: Array) -> Array:
    """Ratio lambda/(2 (lambda + mu)) (m,): nu, or nu/(1 + nu) in plane stress; 0 in rigid cells."""
    return np.asarray(lam / (2 * np.where(mu > 0, lam + mu, 1.0)))


def nearly_incompressible(lam: Array, mu: Array) -> bool:
    """True if Poisson's ratio of a cell is above `LIMIT`; never in plane stress."""
    return bool(np.any(plane_ratio(lam, mu) > LIMIT * (1 + ROUND_OFF)))


def refuse(mesh: Mesh2D, lam: Array, mu: Array, reason: str) -> None:
    """Raise ValueError with `reason` and the cell number if a cell is nearly incompressible."""
    if not nearly_incompressible(lam, mu):
        return
    nu = plane_ratio(lam, mu)
    k = int(np.argmax(nu))
    x, y = mesh.p[:, mesh.t[:, k]].mean(axis=1)
    raise ValueError(
        f"{reason}: nu <= {LIMIT:g} is required, got nu={nu[k]:.6g} in cell {k} of "
        f"{mesh.nelements}, about ({x:.10g}, {y:.10g})"
    )


class ElementTriP2Plus(ElementTriP2):
    """Quadratic triangle with a seventh node at its centre, for Crouzeix and Raviart's elements.

    Together with discontinuous linear pressures, it satisfies the inf-sup condition. The six-node
    triangle does not satisfy it.
    """

    interior_dofs = 1
    maxdeg = 3
    dofnames = ("u", "u", "u")
    doflocs = np.vstack([ElementTriP2.doflocs, [[1 / 3, 1 / 3]]])

    def lbasis(self, X: Array, i: int) -> tuple[Array, Array]:
        """Shape function `i` and its derivatives at `X` (2, ...)."""
        x, y = X
        z = 1 - x - y
        bubble, slope = 27 * x * y * z, 27 * np.array([y * (z - x), x * (z - y)])
        if i == len(self.doflocs) - 1:
            return bubble, slope
        value, gradient = super().lbasis(X, i)
        at_centre = 4 / 9 if i >= RefTri.nnodes else -1 / 9
        return value - at_centre * bubble, gradient - at_centre * slope
