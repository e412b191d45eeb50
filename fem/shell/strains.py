r"""Strains of a shell with six unknowns per node: displacement u and rotation θ in space.

With the tangents a_α = ∂x/∂ξ_α and the normal n of the quadratic surface, the vectors

.. math:: e_\alpha = u_{,\alpha} - \theta\times a_\alpha, \qquad k_\alpha = \theta_{,\alpha}

are zero in every rigid motion. From these vectors

.. math:: \varepsilon_{\alpha\beta} = \tfrac12 (a_\alpha\cdot e_\beta + a_\beta\cdot e_\alpha),
   \quad \gamma_\alpha = n\cdot e_\alpha,
   \quad \kappa_{\alpha\beta}
   = \tfrac12 (a_\alpha\cdot k_\beta\times n + a_\beta\cdot k_\alpha\times n)

are the membrane strains, the shear strains and the curvatures, as in the first-order theory of
Sanders and Koiter, in which n moves with u. Along a strip, they are those of a Timoshenko beam. The
last strain, ω = (a_2·e_1 - a_1·e_2)/2 divided by the area, is the difference between θ·n and the
rotation of the surface in its plane. It is zero in the exact solution for any stiffness assigned to
it. This stiffness is the shear modulus at the tying points, and as small as the bending stiffness
between them. A larger value would cause locking of thin curved shells. A smaller value would leave
θ·n free in flat shells.
"""

from dataclasses import dataclass

import numpy as np

from fem.shell.reference import NODES, POINTS, TO_POINTS, TYING, WEIGHTS, Array, Indices, shapes

MEMBRANE, BENDING, SHEAR = slice(0, 3), slice(3, 6), slice(6, 8)
TIED, UNTIED = 8, 9  # index of ω interpolated from its tying points, and without interpolation
STRAINS, UNKNOWNS = 10, 6 * NODES
SHEAR_FACTOR = 5 / 6
FLAT_OUT = 1e-6  # area at a Gauss point over the cell's mean, below which it counts as none


@dataclass(frozen=True)
class Frame:
    """Geometry at points of all cells, and shape functions.

    `N` (k, 9) are shape functions, `slopes` (k, 2, 9) their derivatives. Tangents `a` (m, k, 2, 3),
    unit normals `n` (m, k, 3), and area per reference area (m, k).
    """

    N: Array
    slopes: Array
    a: Array
    n: Array
    area: Array

    @classmethod
    def of(cls, corners: Array, X: Array) -> "Frame":
        """Geometry at the points X (2, k) of cells with nodes at `corners` (m, 9, 3)."""
        N, slopes = shapes(X)
        a = np.einsum("kai,mic->mkac", slopes, corners)
        normal = np.cross(a[:, :, 0], a[:, :, 1])
        area = np.linalg.norm(normal, axis=-1)
        return cls(N, slopes, a, normal / np.maximum(area, 1e-300)[..., None], area)

    def along(self, alpha: int, c: Array) -> Array:
        """Matrix rows (m, k, 54) that give c·e_α from the unknowns, for the vectors c (m, k, 3)."""
        B = np.empty((*c.shape[:2], NODES, 6))
        B[..., :3] = self.slopes[None, :, alpha, :, None] * c[:, :, None]
        turned = np.cross(c, self.a[:, :, alpha])  # c·(-θ x a) = θ·(c x a)
        B[..., 3:] = self.N[None, :, :, None] * turned[:, :, None]
        return B.reshape(*c.shape[:2], UNKNOWNS)

    def local(self) -> tuple[Array, Array]:
        """Unit tangents (m, k, 2, 3) at the points, and derivatives ∂ξ_α/∂s_i (m, k, 2, 2).

        The first tangent has the direction of the cell's mean a_1, projected onto the surface.
        """
        cell = self.a[:, :, 0].mean(axis=1, keepdims=True)
        first = cell - np.sum(cell * self.n, axis=-1, keepdims=True) * self.n
        first /= np.linalg.norm(first, axis=-1, keepdims=True)
        e = np.stack([first, np.cross(self.n, first)], axis=2)
        return e, np.linalg.inv(np.einsum("mkic,mkac->mkia", e, self.a))


def operator(corners: Array) -> tuple[Array, Array, Array]:
    """Strain matrix B (m, 9, 10, 54), areas (m, 9), tangents (m, 9, 2, 3) at the Gauss points.

    The rows are ε11, ε22, 2 ε12, κ11, κ22, 2 κ12, γ1, γ2, ω interpolated from its tying points, and
    ω without interpolation, in the directions of the unit tangents. Raises ValueError for folded
    cells.
    """
    at = Frame.of(corners, POINTS)
    _check_folds(at)
    e, slope = at.local()
    B = np.zeros((len(corners), len(WEIGHTS), STRAINS, UNKNOWNS))
    ab, ba = at.along(0, at.a[:, :, 1]), at.along(1, at.a[:, :, 0])
    e12 = _in_plane(corners, slope[..., None], B)
    _keep_mean(B, at.area * WEIGHTS, slope[..., None], (ab + ba) / 2 - e12)
    _curvatures(at, e, slope, B)
    B[:, :, UNTIED] = (ab - ba) / 2 / at.area[..., None]
    return B, at.area * WEIGHTS, e


def _check_folds(at: Frame) -> None:
    """Raise ValueError if the normals of a cell reverse, or if a cell has no area."""
    mean = np.einsum("mk,mkc->mc", at.area, at.n)
    upright = np.einsum("mkc,mc->mk", at.n, mean).min(axis=1)
    bad = (upright <= 0) | (at.area.min(axis=1) <= FLAT_OUT * at.area.mean(axis=1))
    if bad.any():
        raise ValueError(
            f"cell {np.argmax(bad)} is folded or has no area: correct the order or position of its "
            "nodes"
        )


def _in_plane(corners: Array, s: Array, B: Array) -> Array:
    """Write membrane, shear and drilling strains, interpolated from tying points, to `B`.

    Returns the interpolated ε_12. s[:, :, α, i] is the derivative of ξ_α along the unit tangent i.
    """
    first, second, both = (Frame.of(corners, X) for X in TYING)
    one, two, mixed = TO_POINTS

    def spread(to: Array, tied: Array) -> Array:
        return np.asarray(np.einsum("qk,mku->mqu", to, tied, optimize=True))

    e11 = spread(one, first.along(0, first.a[:, :, 0]))
    e22 = spread(two, second.along(1, second.a[:, :, 1]))
    g1, g2 = spread(one, first.along(0, first.n)), spread(two, second.along(1, second.n))
    ab, ba = both.along(0, both.a[:, :, 1]), both.along(1, both.a[:, :, 0])
    e12, omega = spread(mixed, ab + ba) / 2, spread(mixed, ab - ba) / 2

    B[:, :, MEMBRANE] = _along_tangents(s, e12)
    for row, i, j, factor in ((0, 0, 0, 1), (1, 1, 1, 1), (2, 0, 1, 2)):
        B[:, :, row] += factor * s[:, :, 0, i] * s[:, :, 0, j] * e11
        B[:, :, row] += factor * s[:, :, 1, i] * s[:, :, 1, j] * e22
    B[:, :, 6] = s[:, :, 0, 0] * g1 + s[:, :, 1, 0] * g2
    B[:, :, 7] = s[:, :, 0, 1] * g1 + s[:, :, 1, 1] * g2
    B[:, :, TIED] = omega * (s[:, :, 0, 0] * s[:, :, 1, 1] - s[:, :, 0, 1] * s[:, :, 1, 0])
    return e12


def _along_tangents(s: Array, e12: Array) -> Array:
    """Contribution of a covariant ε_12 to ε11, ε22, 2 ε12 (m, q, 3, 54) along unit tangents."""
    return np.stack(
        [
            2 * s[:, :, 0, 0] * s[:, :, 1, 0] * e12,
            2 * s[:, :, 0, 1] * s[:, :, 1, 1] * e12,
            2 * (s[:, :, 0, 0] * s[:, :, 1, 1] + s[:, :, 1, 0] * s[:, :, 0, 1]) * e12,
        ],
        axis=2,
    )


def _keep_mean(B: Array, area: Array, s: Array, lost: Array) -> None:
    """Add the cell mean of the part of ε_12 that tying removed to the membrane strains in `B`.

    This mean is zero in parallelograms. All other flat cells pass the patch test only with it.
    """
    mean = np.einsum("mq,mqsu->msu", area, _along_tangents(s, lost), optimize=True)
    B[:, :, MEMBRANE] += (mean / area.sum(axis=1)[:, None, None])[:, None]


def _curvatures(at: Frame, e: Array, slope: Array, B: Array) -> None:
    """Write the curvatures, which depend on θ only, to `B`: e_i·(θ' x n) = θ'·(n x e_i)."""
    along = np.einsum("kan,mkai->mkin", at.slopes, slope)[..., None]
    e1, e2 = e[:, :, 0, None], e[:, :, 1, None]
    B = B.reshape(*B.shape[:3], NODES, 6)[..., 3:]
    B[:, :, 3] = along[:, :, 0] * e2
    B[:, :, 4] = -along[:, :, 1] * e1
    B[:, :, 5] = along[:, :, 1] * e2 - along[:, :, 0] * e1


def moduli(E: Array, nu: Array, thickness: Array, area: Array) -> Array:
    """Stiffness (m, 10, 10) of cells of given `area` (m,) for the strains of `operator`.

    The cells are in plane stress.
    """
    D = np.zeros((len(E), STRAINS, STRAINS))
    G = E / (2 * (1 + nu))
    plane = np.zeros((len(E), 3, 3))
    plane[:, 0, 0] = plane[:, 1, 1] = E / (1 - nu**2)
    plane[:, 0, 1] = plane[:, 1, 0] = nu * E / (1 - nu**2)
    plane[:, 2, 2] = G
    D[:, MEMBRANE, MEMBRANE] = plane * thickness[:, None, None]
    D[:, BENDING, BENDING] = plane * thickness[:, None, None] ** 3 / 12
    D[:, 6, 6] = D[:, 7, 7] = SHEAR_FACTOR * G * thickness
    D[:, TIED, TIED] = G * thickness
    D[:, UNTIED, UNTIED] = G * thickness * np.minimum(thickness**2 / area, 1)
    return D


def unknowns(cells: Indices) -> Indices:
    """Indices (m, 54) of the unknowns of the cells, six per node."""
    return (6 * cells[:, :, None] + np.arange(6)).reshape(len(cells), UNKNOWNS)
