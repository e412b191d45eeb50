"""Stiffness and internal forces of all cells together, faster than by weak forms of scikit-fem.

The forms are a(u, v) = int sigma(u) : eps(v), and the same form with given u, for sigma(u) = lambda
tr(eps(u)) I + 2 mu eps(u). Lamé's constants are uniform in a cell. Therefore

    K[a i, b j] = lambda M[a i, b j] + mu M[a j, b i] + mu delta_ij sum_k M[a k, b k],
    M[a i, b j] = int d_i N_a d_j N_b,

with shape functions N_a, N_b and components i, j. In a body of revolution (`turn`), areas are
multiplied by the circumference, 2 pi r dA. The hoop strain u_r/r is an additional strain and
contributes to the trace; N_a/r appears in both:

    K[a i, b j] += lambda (delta_i0 G[a, b j] + delta_j0 G[b, a i] + delta_i0 delta_j0 H[a, b])
                   + 2 mu delta_i0 delta_j0 H[a, b],
    G[a, b j] = int N_a/r d_j N_b, H[a, b] = int N_a/r N_b/r.
"""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csc_array, csr_array
from skfem import Basis

from fem.plane.axis import depth
from fem.plane.discretisation import Array, Indices
from fem.plane.geometry import jacobians, shapes

BLOCK = 512  # cells whose matrices fit the processor's cache together


@dataclass(frozen=True, kw_only=True)
class Cells:
    """Isotropic cells in the plane, per unit thickness, or for the full circumference.

    `slope` (m, 2 points, n) contains d_x N, then d_y N, for each quadrature point in turn. `dx`
    (m, points) are the integration weights, `dofs` (m, n, 2) the unknowns, `lam` and `mu` (m,)
    Lamé's constants. `around` (m, points, n) is N/r for a body of revolution, otherwise None.
    """

    slope: Array
    dx: Array
    dofs: Indices
    lam: Array
    mu: Array
    count: int
    around: Array | None = None

    @classmethod
    def of(cls, basis: Basis, lam: Array, mu: Array, *, turn: bool = False) -> "Cells":
        """Cells of `basis`, at its quadrature points."""
        J, det = jacobians(basis.mesh, basis.X)
        J = np.array([[J[..., 1, 1], -J[..., 0, 1]], [-J[..., 1, 0], J[..., 0, 0]]]) / det
        N, slope = shapes(basis.elem.elem, basis.X)
        m, (n, points) = len(det), slope.shape[1:]
        slope = np.einsum("jimq,jnq->mqin", J, slope, optimize=True).reshape(m, 2 * points, n)
        dofs = np.asarray(basis.element_dofs).T.reshape(m, n, 2)
        dx, around = abs(det) * basis.W, None
        if turn:
            x = np.asarray(basis.global_coordinates())
            dx, around = dx * depth(x, turn), N.T / x[0][:, :, None]
        return cls(slope=slope, dx=dx, dofs=dofs, lam=lam, mu=mu, count=basis.N, around=around)

    def reduced(self, T: csr_array) -> csc_array:
        """Reduced stiffness T' K T (n, n) for displacements u = T q with T (unknowns, n)."""
        held = np.diff(T.indptr)
        if not T.shape[1] or np.any(held > 1):
            return (T.T @ self.stiffness() @ T).tocsc()
        place, weight = np.full(self.count, -1), np.zeros(self.count)
        place[held == 1], weight[held == 1] = T.indices, T.data
        return self.stiffness(place, weight).T

    def stiffness(self, place: Indices | None = None, weight: Array | None = None) -> csr_array:
        """Stiffness K (unknowns, unknowns) of a(u, v) = v . K u.

        `place` (unknowns,) is the new number of each unknown, or -1 for unknowns that are omitted
        from K. Unknowns with the same number are combined, each with its `weight` (unknowns,).
        """
        m, _, n = self.slope.shape
        K = np.empty((m, 2 * n, 2 * n))
        for start in range(0, m, BLOCK):
            block = slice(start, start + BLOCK)
            K[block] = self._stiffness(block).reshape(-1, 2 * n, 2 * n)
        dofs, count = self.dofs.reshape(m, 2 * n).astype(np.int32), self.count
        if place is not None:
            count = int(place.max()) + 1
            dofs = place.astype(np.int32)[dofs]
            left = dofs < 0
            if weight is not None:
                share = weight[self.dofs.reshape(m, 2 * n)]
                shared = np.any((share != 1) & ~left, axis=1)
                K[shared] *= share[shared, :, None] * share[shared, None]
            K[left] = 0.0
            K.swapaxes(1, 2)[left] = 0.0
            # zeros where the cell has entries: the pattern is unchanged
            kept = np.take_along_axis(dofs, np.argmax(~left, axis=1)[:, None], axis=1)
            dofs = np.where(left, np.maximum(kept, 0), dofs)
        at = np.repeat(dofs, 2 * n, axis=1).ravel(), np.tile(dofs, 2 * n).ravel()
        return coo_array((K.ravel(), at), (count, count)).tocsr()

    def _stiffness(self, block: slice) -> Array:
        """Stiffness K[a i, b j] of the cells in `block`."""
        slope, dx = self.slope[block], self.dx[block]
        m, rows, n = slope.shape
        g = slope.reshape(m, rows // 2, 2, n).swapaxes(2, 3).reshape(m, rows // 2, 2 * n)
        M = ((g.swapaxes(1, 2) * dx[:, None]) @ g).reshape(m, n, 2, n, 2)
        lam, mu = self.lam[block, None, None], self.mu[block, None, None]
        trace = mu * (M[:, :, 0, :, 0] + M[:, :, 1, :, 1])
        K = np.empty_like(M)
        for i, j in np.ndindex(2, 2):
            K[:, :, i, :, j] = lam * M[:, :, i, :, j] + mu * M[:, :, j, :, i]
        K[:, :, 0, :, 0] += trace
        K[:, :, 1, :, 1] += trace
        if self.around is not None:
            N = self.around[block] * dx[..., None]
            G = (N.swapaxes(1, 2) @ g).reshape(m, n, n, 2)
            H = N.swapaxes(1, 2) @ self.around[block]
            K[:, :, 0] += lam[..., None] * G
            K[:, :, :, :, 0] += lam[..., None] * G.transpose(0, 2, 3, 1)
            K[:, :, 0, :, 0] += (lam + 2 * mu) * H
        return K

    def diagonal(self) -> Array:
        """Diagonal entries K[a i, a i] (m, n, 2) of the stiffness of every cell."""
        m, rows, n = self.slope.shape
        dx = self.dx[..., None, None]
        square = (self.slope.reshape(m, rows // 2, 2, n) ** 2 * dx).sum(axis=1).swapaxes(1, 2)
        lam, mu = self.lam[:, None, None], self.mu[:, None, None]
        found = (lam + mu) * square + mu * square.sum(axis=2, keepdims=True)
        if self.around is not None:
            x = self.slope[:, ::2]
            both = (2 * self.lam[:, None, None] * x + (lam + 2 * mu) * self.around) * self.around
            found[..., 0] += (both * self.dx[..., None]).sum(axis=1)
        return np.asarray(found)

    def gradient(self, u: Array) -> Array:
        """Gradients d_i u_j (m, points, 2, 2) at the quadrature points; j is the last index."""
        local = u[self.dofs]
        local -= local[:, :1]  # a translation causes no strain, only round-off
        m, rows, _ = self.slope.shape
        return (self.slope @ local).reshape(m, rows // 2, 2, 2)

    def hoop_strain(self, u: Array) -> Array | float:
        """Hoop strain u_r/r (m, points) at the quadrature points of a body of revolution, or 0."""
        if self.around is None:
            return 0.0
        return np.asarray((self.around @ u[self.dofs[..., 0], None])[..., 0])

    def dilatation(self, grad: Array, hoop: Array | float) -> Array:
        """Trace of the strain (m, points) at the quadrature points."""
        return np.asarray(grad[..., 0, 0] + grad[..., 1, 1] + hoop)

    def strain_energy(self, u: Array) -> float:
        """Strain energy a(u, u)/2, from the strains of each cell."""
        grad = self.gradient(u)
        strain = (grad + grad.swapaxes(2, 3)) / 2
        hoop = self.hoop_strain(u)
        density = self.lam[:, None] * self.dilatation(grad, hoop) ** 2
        density += 2 * self.mu[:, None] * ((strain**2).sum(axis=(2, 3)) + hoop**2)
        return float(np.sum(density * self.dx)) / 2

    def internal_forces(self, u: Array) -> Array:
        """Internal forces (unknowns,) of the stresses of `u`: a(u, v) for every shape function v.

        The forces are computed from the strains of each cell. The round-off of K times a large
        rigid motion is thereby avoided.
        """
        m, rows, _ = self.slope.shape
        grad = self.gradient(u)
        stress = self.mu[:, None, None, None] * (grad + grad.swapaxes(2, 3))
        hoop = self.hoop_strain(u)
        pressure = self.lam[:, None] * self.dilatation(grad, hoop)
        stress += pressure[:, :, None, None] * np.eye(2)
        stress *= self.dx[:, :, None, None]
        force = self.slope.swapaxes(1, 2) @ stress.reshape(m, rows, 2)
        if self.around is not None:
            pull = (pressure + 2 * self.mu[:, None] * hoop) * self.dx
            force[..., 0] += (pull[:, None] @ self.around)[:, 0]
        return np.bincount(self.dofs.ravel(), force.ravel(), self.count).astype(float)
