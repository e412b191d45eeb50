"""Cells of nearly incompressible bodies, with a volumetric stress that is linear in each cell.

The mixed form has the displacements u and p = lambda theta. The dilatation theta is linear in each
cell and discontinuous between cells. The dilatation is eliminated in each cell as the projection of
div u:

    K = 2 mu int eps(u) : eps(v) + lambda int theta(u) theta(v),  int psi (theta(u) - div u) = 0

for psi = 1, x, y. The condensed matrix is symmetric and positive definite. Two pairs of elements
satisfy the inf-sup condition: Q2 with pressures linear in x, y (pressures linear in the reference
coordinates would lose an order of convergence in distorted cells), and the seven-node triangle
(Crouzeix and Raviart 1973; Boffi, Brezzi and Fortin 2013, sec. 8.6).
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from skfem import Basis
from skfem.mesh import Mesh2D

from fem.plane.cells import Cells
from fem.plane.discretisation import degree_on, vector_basis
from fem.plane.geometry import Array, Indices
from fem.plane.incompressible import nearly_incompressible, refuse


@dataclass(frozen=True, kw_only=True)
class MixedCells(Cells):
    """Cells with a projected dilatation.

    `psi` (m, points, 3) are orthonormal linear functions at the quadrature points. At other points,
    they are [1, x - x_0, y - y_0] `inverse` (m, 3, 3), where (x_0, y_0) is the `origin` (2, m).
    """

    psi: Array
    inverse: Array
    origin: Array

    @classmethod
    def of(cls, basis: Basis, lam: Array, mu: Array, *, turn: bool = False) -> "MixedCells":
        """Cells of `basis`, at its quadrature points."""
        plain = Cells.of(basis, lam, mu, turn=turn)
        origin = basis.mesh.p[:, basis.mesh.t].mean(axis=1)
        linear = _linear(np.asarray(basis.global_coordinates()) - origin[:, :, None])
        weight = np.sqrt(plain.dx)[..., None]
        Q, R = np.linalg.qr(linear * weight)
        return cls(**vars(plain), psi=Q / weight, inverse=np.linalg.inv(R), origin=origin)

    def dilatation(self, grad: Array, hoop: Array | float) -> Array:
        """Projected dilatation (m, points) at the quadrature points."""
        return np.asarray((self.psi @ self._moments(super().dilatation(grad, hoop)))[..., 0])

    def dilatation_at(self, u: Array, x: Array, cells: Indices) -> Array:
        """Projected dilatation of `u` at `x` (2, m, ...) in `cells` (m,)."""
        strain = super().dilatation(self.gradient(u), self.hoop_strain(u))
        factors = (self.inverse @ self._moments(strain))[cells, :, 0]
        origin = self.origin[:, cells].reshape(2, -1, *[1] * (x.ndim - 2))
        return np.asarray(np.einsum("m...k,mk->m...", _linear(x - origin), factors))

    def _moments(self, strain: Array) -> Array:
        """Integrals of psi x strain (m, 3, 1)."""
        return np.asarray(self.psi.swapaxes(1, 2) @ (strain * self.dx)[..., None])

    def _projection(self, block: slice) -> Array:
        """Integrals of psi x div N (m, 3, 2 n) in the cells of `block`."""
        m, rows, n = self.slope[block].shape
        div = self.slope[block].reshape(m, rows // 2, 2, n).swapaxes(2, 3).copy()
        if self.around is not None:
            div[..., 0] += self.around[block]
        psi = self.psi[block] * self.dx[block, :, None]
        return np.asarray(psi.swapaxes(1, 2) @ div.reshape(m, rows // 2, 2 * n))

    @cached_property
    def _shear(self) -> Cells:
        return replace(self, lam=np.zeros_like(self.lam))

    def _stiffness(self, block: slice) -> Array:
        """Stiffness K[a i, b j] of the cells in `block`."""
        V = self._projection(block)
        volume = self.lam[block, None, None] * V.swapaxes(1, 2) @ V
        K = Cells._stiffness(self._shear, block)
        return np.asarray(K + volume.reshape(K.shape))


def basis_for(
    mesh: Mesh2D, lam: Array, mu: Array, degree: int | None, *, turn: bool = False
) -> Basis:
    """Basis of displacements for Lamé's `lam`, `mu`. Raises ValueError if degree 1 would lock."""
    if degree_on(mesh, degree) == 1:
        refuse(mesh, lam, mu, "displacements of degree 1 lock, use degree=2")
    return vector_basis(mesh, degree, turn=turn, mixed=nearly_incompressible(lam, mu))


def cells_of(basis: Basis, lam: Array, mu: Array, *, turn: bool = False) -> Cells:
    """Cells of `basis`: mixed cells if a material is nearly incompressible."""
    kind = MixedCells if nearly_incompressible(lam, mu) else Cells
    return kind.of(basis, lam, mu, turn=turn)


def _linear(x: Array) -> Array:
    """Functions 1, x, y (m, ..., 3) at `x` (2, m, ...)."""
    return np.stack([np.ones(x.shape[1:]), *x], axis=-1)
