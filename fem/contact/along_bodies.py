"""Displacements u_z(x, y) along the third axis of bodies in plane strain, condensed to surfaces.

In isotropic bodies, u_z is not coupled with displacements in the plane: div(G grad u_z) = 0, with
the shear stresses G du_z/dx and G du_z/dy.
"""

from collections.abc import Mapping
from functools import cached_property

import numpy as np
from scipy.linalg import cho_factor, cho_solve
from scipy.sparse import coo_array, csr_array

from fem.contact.along import Along, Pull
from fem.contact.along_nodes import AlongNodes
from fem.contact.bodies import Bodies
from fem.contact.condensation import Condensed, condense
from fem.plane.discretisation import Array, Indices
from fem.plane.loads import force_load
from fem.plane.supports import Prescribed


class AlongBodies:
    """Stiffness of all bodies and their rigid shifts along z, condensed to the contact surfaces.

    `T` (nodes, n) maps free unknowns to nodes. The last s unknowns belong to surfaces, rigid bodies
    and obstacles. `shifts` (s, k) are the orthonormal rigid shifts that supports permit; `words`
    describes each shift.
    """

    def __init__(self, bodies: Bodies, along: Along, surface: Indices) -> None:
        """Factorise the stiffness, with the nodes of the plane unknowns `surface` last.

        Raises ValueError for unknown names, and for bodies that have neither a support along z nor
        a contact surface.
        """
        self.bodies, self.along = bodies, along
        self.nodes = AlongNodes(bodies, along)
        self.T, s = self.nodes.ordered(self.nodes.of_dof[surface])
        self.shifts, self.words = self._free_shifts(s)
        self.condensed: Condensed = condense((self.T.T @ self._stiffness() @ self.T).tocsr(), s)

    @property
    def surface(self) -> csr_array:
        """Columns (nodes, s) of T that belong to contact surfaces."""
        return self.T[:, self.T.shape[1] - self.condensed.springs.size :]

    def compliance(self, forces: Array) -> Array:
        """Displacements (s, ...) of the surface under `forces` (s, ...), without rigid shifts."""
        return np.asarray(cho_solve(self._factor, forces, check_finite=False))

    def load(self, pull: Pull) -> tuple[Array, Array]:
        """Forces (n,) of `pull` on the free unknowns, and equivalent forces (s,) on the surface."""
        load = self.T.T @ (pull.f - self.internal_forces(pull.u_0))
        return load, self.condensed.load(load)

    def displacements(self, pull: Pull, pushed: Array, shift: Array) -> Array:
        """u_z (nodes,) for load `pull`, contact forces `pushed` (s,) and rigid `shift` (k,)."""
        load, on_surface = self.load(pull)
        own = self.shifts @ (self.shifts.T @ on_surface)
        surface = self.compliance(on_surface - own + pushed) + self.shifts @ shift
        load[self.condensed.surface] += pushed
        q = self.condensed.inside(load, on_surface + pushed, surface)
        return self.T @ q + pull.u_0

    def pull(self, forces: Mapping[str, float], displacements: Mapping[str, Prescribed]) -> Pull:
        """Load along z from forces and from prescribed displacements of supports, both by name.

        Supports that are not named in `displacements` retain their values.
        """
        if unknown := set(displacements) - set(self.nodes.supported):
            raise ValueError(
                f"there is no support along z on {min(unknown)!r}; supports along z are on: "
                f"{', '.join(self.nodes.supported) or 'none'}"
            )
        f = np.zeros(self.nodes.count)
        for name, force in forces.items():
            if not isinstance(force, int | float | np.number) or not np.isfinite(force):
                raise ValueError(
                    f"the force along z on {name!r} must be a finite number, got {force!r}"
                )
            f += self._force(name, float(force))
        return Pull(f, self.nodes.prescribed({**self.along.supports, **displacements}))

    def reaction(self, boundary: str, u: Array, forces: Array) -> float:
        """Force along z of the support of `boundary`, for displacements `u` and loads `forces`.

        If several supports prescribe a node, its reaction is assigned to the first of these
        supports.
        """
        nodes, known = self.nodes, self.nodes.supported
        if boundary not in known:
            raise ValueError(
                f"there is no support along z on {boundary!r}; supports along z are on: "
                f"{', '.join(known) or 'none'}"
            )
        own = np.zeros(nodes.held.size, bool)
        own[nodes.group[nodes.named(boundary)]] = True
        for name in known[: known.index(boundary)]:
            own[nodes.group[nodes.named(name)]] = False
        missing = self.internal_forces(u) - forces
        return float(missing[own[nodes.group]].sum())

    def internal_forces(self, u: Array) -> Array:
        """Forces (nodes,) that balance shear stresses of `u` (nodes,), over the whole thickness."""
        cells = self.bodies.cells
        weight = cells.mu[:, None, None] * cells.dx[:, :, None]
        stress = (weight * self.gradient(u)).reshape(len(weight), -1)
        force = (stress[:, None] @ cells.slope)[:, 0]
        at = self.nodes.cells.ravel()
        return np.bincount(at, force.ravel(), self.nodes.count).astype(float)

    def gradient(self, u: Array) -> Array:
        """Gradient du_z/dx, du_z/dy (m, points, 2) at the quadrature points of every cell."""
        local = u[self.nodes.cells]
        local = local - local[:, :1]  # a shift causes no shear, only round-off
        found = (self.bodies.cells.slope @ local[..., None])[..., 0]
        return np.asarray(found.reshape(len(local), -1, 2))

    def strain_energy(self, u: Array) -> float:
        """Strain energy of the shear along z [force x length], for the whole thickness."""
        cells = self.bodies.cells
        density = cells.mu[:, None] * (self.gradient(u) ** 2).sum(axis=2)
        return float(np.sum(density * cells.dx)) / 2

    def named(self, amplitudes: Array) -> str:
        """Description of the rigid shift with the largest of the `amplitudes` (k,)."""
        return self.words[int(np.argmax(np.abs(amplitudes)))]

    def refuse(self, words: str) -> None:
        raise ValueError(
            f"{words}: neither supports along z nor friction prevent this motion; add a support "
            "along z"
        )

    @cached_property
    def _factor(self) -> tuple[Array, bool]:
        # springs on the shifts, as on the rigid motions of the plane
        S = self.condensed.S
        size = np.trace(S) / len(S) or 1.0
        return cho_factor(S + size * self.shifts @ self.shifts.T, check_finite=False)

    def _stiffness(self) -> csr_array:
        """Stiffness matrix K (nodes, nodes) of the form int G grad u . grad v."""
        cells, at, count = self.bodies.cells, self.nodes.cells, self.nodes.count
        n = at.shape[1]
        weight = np.repeat(cells.mu[:, None] * cells.dx, 2, axis=1)
        K = cells.slope.swapaxes(1, 2) @ (weight[..., None] * cells.slope)
        entries = np.repeat(at, n, axis=1).ravel(), np.tile(at, n).ravel()
        return coo_array((K.ravel(), entries), (count, count)).tocsr()

    def _free_shifts(self, s: int) -> tuple[Array, tuple[str, ...]]:
        q, words = [], []
        for own, name in self.nodes.loose():
            shift = (self.T.T @ own.astype(float) > 0).astype(float)[self.T.shape[1] - s :]
            words.append(f"{name} can move along z")
            if not np.any(shift):
                self.refuse(words[-1])
            q.append(shift / np.linalg.norm(shift))
        return np.reshape(q, (len(q), s)).T, tuple(words)

    def _force(self, name: str, force: float) -> Array:
        """Forces (nodes,) from a total force along z on a boundary or on an obstacle."""
        nodes, f = self.nodes, np.zeros(self.nodes.count)
        if name not in self.bodies.obstacles:
            f[: nodes.meshed] = force_load(self.bodies.basis, {name: (force, 0.0)})[nodes.dofs[0]]
        elif name in self.along.free:
            f[nodes.named(name)] = force
        elif force != 0:
            raise ValueError(
                f"force along z on obstacle {name!r}: the obstacle must be free along z"
            )
        return f
