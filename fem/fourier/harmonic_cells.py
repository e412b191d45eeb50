"""Stiffness of all cells of a body of revolution for displacements that vary as a harmonic.

With u = (U cos n t, V sin n t, W cos n t) along r, the angle t and z, amplitudes U, V, W of (r, z),
the strains have the amplitudes

    rr: U_r,          tt: (U + n V)/r,        zz: W_z,
    2 rt: V_r - (V + n U)/r,   2 tz: V_z - n W/r,   2 zr: U_z + W_r,

and the weak form is, with c = 2 pi for n = 0 and pi otherwise,

    a(u, v) = c int (lambda tr eps(u) tr eps(v) + 2 mu eps(u) : eps(v)) r dr dz.

The strains are linear in n. Therefore K = K_0 + n K_1 + n^2 K_2, with parts that are the same for
all harmonics. The strains of the antisymmetric field (U sin n t, V cos n t, W sin n t) have
these amplitudes with -n in place of n.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csr_array
from skfem import Basis

from fem.plane.discretisation import Array, Indices
from fem.plane.geometry import jacobians, shapes

BLOCK = 256  # cells whose matrices fit the processor's cache together


def strain_rows(around: Array, slope: Array) -> tuple[Array, Array]:
    """Matrices B_0 and B_1 (..., 6, n, 3) of the strains (B_0 + n B_1) u.

    The strains are rr, tt, zz, 2rt, 2tz, 2zr. `around` (..., n) contains the shape functions
    divided by r, `slope` (..., 2, n) their derivatives with respect to r and z.
    """
    N_r, N_z = slope[..., 0, :], slope[..., 1, :]
    U, V, W = range(3)
    B_0 = np.zeros((*around.shape[:-1], 6, around.shape[-1], 3))
    B_1 = np.zeros_like(B_0)
    B_0[..., 0, :, U] = N_r
    B_0[..., 1, :, U] = around
    B_1[..., 1, :, V] = around
    B_0[..., 2, :, W] = N_z
    B_0[..., 3, :, V] = N_r - around
    B_1[..., 3, :, U] = -around
    B_0[..., 4, :, V] = N_z
    B_1[..., 4, :, W] = -around
    B_0[..., 5, :, U] = N_z
    B_0[..., 5, :, W] = N_r
    return B_0, B_1


def stress(strain: Array, lam: Array, mu: Array) -> Array:
    """Amplitudes (..., 6) rr, tt, zz, rt, tz, zr of sigma = lambda tr(eps) I + 2 mu eps."""
    sigma = mu[..., None] * strain
    sigma[..., :3] *= 2
    sigma[..., :3] += (lam * strain[..., :3].sum(axis=-1))[..., None]
    return sigma


@dataclass(frozen=True, kw_only=True)
class HarmonicCells:
    """Isotropic cells, with their shape functions at the quadrature points (m, q).

    `slope` and `around` are the arguments of `strain_rows`, `dx` (m, q) are the weights of the
    points times r, `dofs` (m, 3 n) the unknowns, `lam` and `mu` (m,) Lamé's constants.
    """

    slope: Array
    around: Array
    dx: Array
    dofs: Indices
    lam: Array
    mu: Array
    count: int

    @classmethod
    def of(cls, basis: Basis, lam: Array, mu: Array) -> "HarmonicCells":
        """Cells of `basis` at its quadrature points; the basis has three components per node."""
        J, det = jacobians(basis.mesh, basis.X)
        inverse = np.array([[J[..., 1, 1], -J[..., 0, 1]], [-J[..., 1, 0], J[..., 0, 0]]]) / det
        N, slope = shapes(basis.elem.elem, basis.X)
        r = np.asarray(basis.global_coordinates())[0]
        return cls(
            slope=np.einsum("jimq,jnq->mqin", inverse, slope, optimize=True),
            around=N.T / r[..., None], dx=abs(det) * basis.W * r,
            dofs=np.asarray(basis.element_dofs).T, lam=lam, mu=mu, count=basis.N,
        )  # fmt: skip

    def stiffness_parts(self, powers: Sequence[int] = (0, 1, 2)) -> tuple[csr_array, ...]:
        """Parts K_0, K_1, K_2 of K = K_0 + n K_1 + n^2 K_2, for one radian.

        All parts have the same sparsity pattern. Only the parts of the given `powers` of n are
        computed.
        """
        m, k = self.dofs.shape
        K = np.empty((len(powers), m, k, k))
        for start in range(0, m, BLOCK):
            block = slice(start, start + BLOCK)
            K[:, block] = self._parts(block, powers)
        at = np.repeat(self.dofs, k, axis=1).ravel(), np.tile(self.dofs, k).ravel()
        shape = (self.count, self.count)
        return tuple(coo_array((part.ravel(), at), shape).tocsr() for part in K)

    def _parts(self, block: slice, powers: Sequence[int]) -> list[Array]:
        """Matrices (cells, 3 n, 3 n) of the cells in `block`, for each of the `powers`."""
        lam, mu = self.lam[block, None, None], self.mu[block, None, None]
        m, q, _, n = self.slope[block].shape
        left, right = [], []
        for B in strain_rows(self.around[block], self.slope[block]):
            rows = B.reshape(m, q, 6, 3 * n)
            sigma = stress(rows.swapaxes(2, 3), lam, mu).swapaxes(2, 3)
            left.append(rows.reshape(m, 6 * q, 3 * n).swapaxes(1, 2))
            right.append((sigma * self.dx[block, :, None, None]).reshape(m, 6 * q, 3 * n))
        found = []
        for power in powers:
            part = left[power // 2] @ right[(power + 1) // 2]
            found.append(part + part.swapaxes(1, 2) if power == 1 else part)
        return found

    def strain(self, u: Array, n: int) -> Array:
        """Amplitudes (m, q, 6) of the strains of `u` at the quadrature points.

        `n` is negative for the antisymmetric harmonic.
        """
        B_0, B_1 = strain_rows(self.around, self.slope)
        local = u[self.dofs].reshape(len(self.dofs), -1, 3)
        return np.asarray(np.einsum("mqsnc,mnc->mqs", B_0 + n * B_1, local, optimize=True))

    def internal_forces(self, u: Array, n: int) -> Array:
        """Forces (unknowns,) of the stresses of `u`, for one radian."""
        B_0, B_1 = strain_rows(self.around, self.slope)
        sigma = stress(self.strain(u, n), self.lam[:, None], self.mu[:, None])
        force = np.einsum(
            "mqsnc,mqs->mnc", B_0 + n * B_1, sigma * self.dx[..., None], optimize=True
        )
        return np.bincount(self.dofs.ravel(), force.ravel(), self.count).astype(float)
