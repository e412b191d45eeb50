"""Stiffness and internal forces of all cells in space, computed together.

The form is a(u, v) = int sigma(u) : eps(v), sigma(u) = lambda tr(eps(u)) I + 2 mu eps(u). With
shape functions N_a, N_b, components i, j and M[a i, b j] = int d_i N_a d_j N_b,

    K[a i, b j] = lambda M[a i, b j] + mu M[a j, b i] + mu delta_ij sum_k M[a k, b k].
"""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import bsr_array, csr_array
from skfem.mesh import Mesh3D

from fem.plane.geometry import shapes
from fem.solid.geometry import Array, Indices, cube_rule, jacobians

BLOCK = 128  # cells whose matrices fit the processor's cache together


@dataclass(frozen=True, kw_only=True)
class Cells:
    """Isotropic cells in space; node a has the unknowns 3 a to 3 a + 2.

    `slope` (m, 3 points, n) contains d_i N at the quadrature points: point by point, i = x, y, z.
    `N` (points, n) are the shape functions at these points, `dx` (m, points) the weights, `nodes`
    (m, n) the nodes, `lam` and `mu` (m,) Lamé's constants [stress]. `count` is the number of nodes.
    """

    slope: Array
    N: Array
    dx: Array
    nodes: Indices
    lam: Array
    mu: Array
    count: int

    @classmethod
    def of(cls, mesh: Mesh3D, lam: Array, mu: Array, points: tuple[int, int, int]) -> "Cells":
        """Cells of `mesh`, with `points` Gauss points along each reference direction."""
        X, weight = cube_rule(points)
        J, det = jacobians(mesh, X)
        N, slope = shapes(mesh.elem(), X)
        m, n = len(det), len(N)
        slope = np.einsum("mqji,jnq->mqin", np.linalg.inv(J), slope, optimize=True)
        return cls(
            slope=np.ascontiguousarray(slope.reshape(m, 3 * weight.size, n)),
            N=N.T,
            dx=abs(det) * weight,
            nodes=np.asarray(mesh.dofs.element_dofs, np.int64).T,  # pairs outgrow 32 bits
            lam=lam,
            mu=mu,
            count=mesh.doflocs.shape[1],
        )

    def stiffness(self) -> csr_array:
        """Stiffness K (unknowns, unknowns) of a(u, v) = v . K u."""
        m, n = self.nodes.shape
        K = np.empty((3, 3, m, n, n))
        for start in range(0, m, BLOCK):
            block = slice(start, start + BLOCK)
            K[:, :, block] = self._stiffness(block).transpose(2, 4, 0, 1, 3)
        keys = (self.nodes[:, :, None] * self.count + self.nodes[:, None]).ravel()
        pairs, place = np.unique(keys, return_inverse=True)
        data = np.empty((pairs.size, 3, 3))
        for i, j in np.ndindex(3, 3):
            data[:, i, j] = np.bincount(place, K[i, j].ravel(), pairs.size)
        rows, columns = np.divmod(pairs, self.count)
        ends = np.searchsorted(rows, np.arange(self.count + 1))
        shape = 3 * self.count, 3 * self.count
        return bsr_array((data, columns, ends), shape=shape).tocsr()

    def _stiffness(self, block: slice) -> Array:
        """Stiffness K[a i, b j] (cells, n, 3, n, 3) of the cells in `block`."""
        slope, dx = self.slope[block], self.dx[block]
        m, rows, n = slope.shape
        g = slope.reshape(m, rows // 3, 3, n).swapaxes(2, 3).reshape(m, rows // 3, 3 * n)
        M = ((g.swapaxes(1, 2) * dx[:, None]) @ g).reshape(m, n, 3, n, 3)
        lam, mu = (a[block, None, None, None, None] for a in (self.lam, self.mu))
        K = lam * M + mu * M.transpose(0, 1, 4, 3, 2)
        trace = mu[..., 0, 0] * np.einsum("makbk->mab", M)
        for i in range(3):
            K[:, :, i, :, i] += trace
        return K

    def gradient(self, u: Array) -> Array:
        """Gradients d_i u_j (m, points, 3, 3) at the quadrature points; j is the last index."""
        local = u.reshape(-1, 3)[self.nodes]
        local = local - local[:, :1]  # a translation causes no strain, only round-off
        return (self.slope @ local).reshape(*self.dx.shape, 3, 3)

    def stress(self, u: Array) -> Array:
        """Stress sigma (m, points, 3, 3) at the quadrature points."""
        grad = self.gradient(u)
        stress = self.mu[:, None, None, None] * (grad + grad.swapaxes(2, 3))
        pressure = self.lam[:, None] * np.trace(grad, axis1=2, axis2=3)
        return stress + pressure[..., None, None] * np.eye(3)

    def strain_energy(self, u: Array) -> float:
        """Strain energy a(u, u)/2, from the strains of each cell."""
        grad = self.gradient(u)
        strain = (grad + grad.swapaxes(2, 3)) / 2
        density = self.lam[:, None] * np.trace(grad, axis1=2, axis2=3) ** 2
        density += 2 * self.mu[:, None] * (strain**2).sum(axis=(2, 3))
        return float(np.sum(density * self.dx)) / 2

    def internal_forces(self, u: Array) -> Array:
        """Internal forces (unknowns,) of the stresses of `u`: a(u, v) for every shape function v.

        They are computed from the strains of each cell. The round-off of K times a large rigid
        motion is thereby avoided.
        """
        stress = (self.stress(u) * self.dx[..., None, None]).reshape(*self.slope.shape[:2], 3)
        return self.gathered(self.slope.swapaxes(1, 2) @ stress)

    def body_force(self, density: Array) -> Array:
        """Nodal forces (unknowns,) due to `density` (m, points, 3) [force / length^3]."""
        return self.gathered(self.N.T @ (density * self.dx[..., None]))

    def gathered(self, forces: Array) -> Array:
        """Sum (unknowns,) of the forces (m, n, 3) at the nodes of the cells."""
        node = self.nodes.ravel()
        parts = [np.bincount(node, forces[..., i].ravel(), self.count) for i in range(3)]
        return np.array(parts, float).T.ravel()
