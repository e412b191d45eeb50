"""Solutions of harmonics of a body of revolution, and their sum at points and angles.

Stress rows are rr, tt, zz, rt, tz, zr. Energies and forces belong to the full circumference.
"""

from dataclasses import dataclass

import numpy as np
from skfem import Basis

from fem.fourier.harmonic_cells import HarmonicCells, strain_rows, stress
from fem.fourier.loads import turn_of
from fem.fourier.supports import boundary_dofs, rigid_motions
from fem.plane.axis import AT_AXIS
from fem.plane.discretisation import Array
from fem.plane.locate import locate

SHEARED = np.array([False, False, False, True, True, False])  # vary as u_t does: rt and tz


@dataclass(frozen=True)
class HarmonicSolution:
    """Amplitudes `u` (unknowns,) of harmonic `n` on `basis` under the forces `f` (unknowns,)."""

    basis: Basis
    cells: HarmonicCells
    n: int
    antisymmetric: bool
    u: Array
    f: Array

    @property
    def strain_energy(self) -> float:
        """Strain energy: half the integral of stress times strain [force x length]."""
        strain = self.cells.strain(self.u, self._signed)
        sigma = stress(strain, self.cells.lam[:, None], self.cells.mu[:, None])
        density = (sigma * strain).sum(axis=-1)
        return turn_of(self.n) * float(np.sum(density * self.cells.dx)) / 2

    @property
    def work(self) -> float:
        """Work of the forces, f . u [force x length]: twice the strain energy."""
        return float(self.f @ self.u)

    def amplitudes_at(self, points: Array) -> tuple[Array, Array]:
        """Amplitudes of displacement (3, m) and stress (6, m) at `points` (2, m): (r, z).

        On the axis, ratios such as u_r/r are replaced by derivatives. Raises ValueError for a point
        outside the mesh.
        """
        points = np.asarray(points, float)
        if points.ndim != 2 or len(points) != 2 or not np.all(np.isfinite(points)):
            raise ValueError(f"points must be finite and of shape (2, m), got shape {points.shape}")
        cells, X = locate(self.basis.mesh, points)
        dofs = self.cells.dofs[cells].reshape(cells.size, -1, 3)
        N, slope = np.zeros(dofs.shape[:2]), np.zeros((cells.size, 2, dofs.shape[1]))
        for a in range(dofs.shape[1]):
            shape = self.basis.elem.gbasis(self.basis.mapping, X[:, :, None], 3 * a, tind=cells)[0]
            N[:, a] = np.asarray(shape)[0, :, 0]
            slope[:, :, a] = np.asarray(shape.grad)[0, :, :, 0].T
        reach = self.basis.mesh.p[0, self.basis.mesh.t[:, cells]].max(axis=0)
        near = (points[0] < AT_AXIS * reach)[:, None]
        around = np.where(near, slope[:, 0], N / np.where(near, 1.0, points[0][:, None]))
        B_0, B_1 = strain_rows(around, slope)
        local = self.u[dofs]
        strain = np.einsum("msnc,mnc->ms", B_0 + self._signed * B_1, local)
        sigma = stress(strain, self.cells.lam[cells], self.cells.mu[cells])
        return np.einsum("mn,mnc->cm", N, local), sigma.T

    def reaction(self, boundary: str) -> Array:
        """Resultant forces and moments of the supports of `boundary` in this harmonic.

        n = 0: the axial force (antisymmetric: the torque). n = 1: the force along x and the moment
        about y (antisymmetric: along y, about x). For n >= 2 the result is empty, because there is
        no resultant.
        """
        dofs = boundary_dofs(self.basis, boundary).ravel()
        internal = turn_of(self.n) * self.cells.internal_forces(self.u, self._signed)
        missing = internal - self.f
        motions = rigid_motions(self.basis, self.n, self.antisymmetric)
        return np.asarray(motions[dofs].T @ missing[dofs])

    @property
    def _signed(self) -> int:
        return -self.n if self.antisymmetric else self.n


@dataclass(frozen=True)
class FourierSolution:
    """Sum of several harmonics."""

    parts: tuple[HarmonicSolution, ...]

    @property
    def strain_energy(self) -> float:
        """Strain energy [force x length]: sum over the harmonics, which are orthogonal."""
        return sum(part.strain_energy for part in self.parts)

    def at(self, points: Array, angle: Array) -> tuple[Array, Array]:
        """Displacement (3, m) along r, t, z and stress (6, m) at `points` (2, m) and `angle` [rad].

        `angle` is one value for all points, or one value for each point.
        """
        angle = np.broadcast_to(np.asarray(angle, float), points.shape[1:])
        u = np.zeros((3, points.shape[1]))
        sigma = np.zeros((6, points.shape[1]))
        for part in self.parts:
            own = part.amplitudes_at(points)
            c, s = np.cos(part.n * angle), np.sin(part.n * angle)
            if part.antisymmetric:
                c, s = s, c
            u += own[0] * np.array([c, s, c])
            sigma += own[1] * np.where(SHEARED[:, None], s, c)
        return u, sigma
