"""Displacements u_z(x, y) along the third axis of bodies in plane strain, condensed to surfaces.

In isotropic bodies they do not mix with the plane: div(G grad u_z) = 0, with the shear stresses
G du_z/dx and G du_z/dy. Nodes of a rigid body, and nodes that are tied, share one unknown.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cho_factor, cho_solve
from scipy.sparse import coo_array, csr_array
from scipy.sparse.csgraph import connected_components

from fem.contact.bodies import Bodies
from fem.contact.condensation import Condensed, condense
from fem.plane.discretisation import Array, Indices, named_facets
from fem.plane.loads import force_load
from fem.plane.ordering import nested_dissection
from fem.plane.supports import Prescribed, node_dofs, nodes_on

CONTRADICTION = 1e-9  # of the values prescribed along z


@dataclass(frozen=True)
class Along:
    """What holds bodies along z.

    `supports` prescribe u_z on boundaries, and on obstacles, which otherwise stay where they are;
    those named in `free` move as forces have it. Ties of the plane hold along z as well.
    """

    supports: Mapping[str, Prescribed] = field(default_factory=dict)
    free: tuple[str, ...] = ()


@dataclass(frozen=True)
class Pull:
    """Forces `f` (nodes,) along z and prescribed displacements `u_0` (nodes,)."""

    f: Array
    u_0: Array

    def after(self, before: "Pull | None", share: float) -> "Pull":
        """So much of this, and the rest of what was `before`."""
        if before is None:
            return Pull(share * self.f, share * self.u_0)
        rest = 1 - share
        return Pull(share * self.f + rest * before.f, share * self.u_0 + rest * before.u_0)


class AlongBodies:
    """Stiffness and shifts along z of all bodies, seen from their contact surfaces.

    Nodes are those of the displacements: vertices, then those on edges and in cells; obstacles
    follow. `T` (nodes, n) spreads the free unknowns, of which the last s belong to surfaces, rigid
    bodies and obstacles. `shifts` (s, k) are orthonormal shifts that supports leave, `words` says
    whose.
    """

    def __init__(self, bodies: Bodies, along: Along, surface: Indices) -> None:
        """Factorise, with the `surface` unknowns (s,) of the plane last.

        ValueError for unknown names, contradicting supports, and bodies that neither supports nor
        any contact surface hold.
        """
        self.bodies, self.along = bodies, along
        self.dofs = node_dofs(bodies.basis)
        self.meshed = self.dofs.shape[1]
        self.count = self.meshed + len(bodies.obstacles)
        self._node = np.empty(bodies.basis.N, int)
        self._node[self.dofs] = np.arange(self.meshed)
        self._check_names()
        self._class = self._classes()
        self._held = np.zeros(self._class.max() + 1, bool)
        for name in self._supported:
            self._held[self._class[self._nodes(name)]] = True
        self.K = self._assembled()
        self.T, s = self._unknowns(self._node[surface])
        self.shifts, self.words = self._free_shifts(s)
        self.condensed: Condensed = condense((self.T.T @ self.K @ self.T).tocsr(), s)

    @property
    def columns(self) -> Indices:
        """Of a row of the plane problem, the unknowns (nodes,) x of nodes and obstacles."""
        obstacles = self.bodies.basis.N + 3 * np.arange(len(self.bodies.obstacles))
        return np.concatenate([self.dofs[0], obstacles])

    @property
    def surface(self) -> csr_array:
        """The columns (nodes, s) of T that belong to contact surfaces."""
        return self.T[:, self.T.shape[1] - self.condensed.springs.size :]

    @cached_property
    def _factor(self) -> tuple[Array, bool]:
        S = self.condensed.S
        size = np.trace(S) / len(S) or 1.0
        return cho_factor(S + size * self.shifts @ self.shifts.T, check_finite=False)

    def compliance(self, forces: Array) -> Array:
        """Displacements (s, ...) of the surface under `forces` (s, ...), without shifts."""
        return np.asarray(cho_solve(self._factor, forces, check_finite=False))

    def load(self, pull: Pull) -> tuple[Array, Array]:
        """Forces (n,) on the free unknowns, and those (s,) that stand for them on the surface."""
        load = self.T.T @ (pull.f - self.internal_forces(pull.u_0))
        return load, self.condensed.load(load)

    def displacements(self, pull: Pull, pushed: Array, shift: Array) -> Array:
        """u_z (nodes,) under loads, contact forces `pushed` (s,) and the free `shift` (k,)."""
        load, on_surface = self.load(pull)
        own = self.shifts @ (self.shifts.T @ on_surface)
        surface = self.compliance(on_surface - own + pushed) + self.shifts @ shift
        load[self.condensed.surface] += pushed
        q = self.condensed.inside(load, on_surface + pushed, surface)
        return self.T @ q + pull.u_0

    def pull(self, forces: Mapping[str, float], displacements: Mapping[str, Prescribed]) -> Pull:
        """Loads along z by name; supports that `displacements` do not name keep their values."""
        f = np.zeros(self.count)
        for name, force in forces.items():
            if not isinstance(force, int | float | np.number) or not np.isfinite(force):
                raise ValueError(f"the force along z on {name!r} is a finite number, got {force!r}")
            if name not in self.bodies.obstacles:
                f[: self.meshed] += force_load(self.bodies.basis, {name: (float(force), 0.0)})[
                    self.dofs[0]
                ]
            elif name in self.along.free:
                f[self._nodes(name)] += force
            elif force != 0:
                raise ValueError(f"the force along z on obstacle {name!r}: it is not free along z")
        if unknown := set(displacements) - set(self._supported):
            raise ValueError(
                f"no support holds {sorted(unknown)[0]!r} along z; there are: "
                f"{', '.join(self._supported) or 'none'}"
            )
        return Pull(f, self._prescribed({**self.along.supports, **displacements}))

    def reaction(self, boundary: str, u: Array, forces: Array) -> float:
        """Force along z that the support of `boundary` exerts at `u`, under `forces` (nodes,).

        Where several supports hold a node, the first one named has it.
        """
        missing = self.internal_forces(u) - forces
        own = np.zeros(self._held.size, bool)
        own[self._class[self._nodes(boundary)]] = True
        for name in self._supported[: self._supported.index(boundary)]:
            own[self._class[self._nodes(name)]] = False
        return float(missing[own[self._class]].sum())

    def internal_forces(self, u: Array) -> Array:
        """Forces (nodes,) of the shear stresses of `u` (nodes,), for the whole thickness."""
        cells = self.bodies.cells
        weight = cells.mu[:, None, None] * cells.dx[:, :, None]
        stress = weight * self.gradient(u)
        force = np.einsum("mpn,mp->mn", cells.slope, stress.reshape(len(stress), -1), optimize=True)
        at = self._node[cells.dofs[..., 0]]
        return np.bincount(at.ravel(), force.ravel(), self.count).astype(float)

    def gradient(self, u: Array) -> Array:
        """du_z/dx, du_z/dy (m, points, 2) at the quadrature points of every cell."""
        cells = self.bodies.cells
        local = u[self._node[cells.dofs[..., 0]]]
        local = local - local[:, :1]  # a shift shears nothing, and would only round
        found = (cells.slope @ local[..., None])[..., 0]
        return np.asarray(found.reshape(len(local), -1, 2))

    def strain_energy(self, u: Array) -> float:
        """Of the shear along z [force x length], for the whole thickness."""
        cells = self.bodies.cells
        density = cells.mu[:, None] * (self.gradient(u) ** 2).sum(axis=2)
        return float(np.sum(density * cells.dx)) / 2

    @property
    def _supported(self) -> list[str]:
        fixed = [o for o in self.bodies.obstacles if o not in self.along.free]
        return [*self.along.supports, *(o for o in fixed if o not in self.along.supports)]

    def _check_names(self) -> None:
        for name in self.along.free:
            if name not in self.bodies.obstacles or name in self.along.supports:
                known = ", ".join(self.bodies.obstacles) or "none"
                raise ValueError(
                    f"along z obstacles without support are free, got {name!r}; there are: {known}"
                )
        for name in self._supported:
            self._nodes(name)

    def _nodes(self, name: str) -> Indices:
        """Nodes of a boundary, or of an obstacle."""
        if name in self.bodies.obstacles:
            return np.array([self.meshed + list(self.bodies.obstacles).index(name)])
        basis = self.bodies.basis
        return np.asarray(self._node[nodes_on(basis, named_facets(basis.mesh, name))[0]])

    def _classes(self) -> Indices:
        """A number (nodes,) for all nodes that only move together."""
        tied = self.bodies.tied
        first, second = [self._node[tied.leader[0]]], [self._node[tied.follower[0]]]
        for cells in self.bodies.rigid:
            own = np.unique(self._node[self.bodies.cells.dofs[cells, :, 0]])
            first.append(own[:-1])
            second.append(own[1:])
        return self._components(np.concatenate(first), np.concatenate(second))

    def _components(self, first: Indices, second: Indices) -> Indices:
        links = csr_array((np.ones(first.size), (first, second)), (self.count, self.count))
        return np.asarray(connected_components(links, directed=False)[1])

    def _assembled(self) -> csr_array:
        """K (nodes, nodes) of int G grad u . grad v."""
        cells = self.bodies.cells
        m, _, n = cells.slope.shape
        weight = np.repeat(cells.mu[:, None] * cells.dx, 2, axis=1)
        K = cells.slope.swapaxes(1, 2) @ (weight[..., None] * cells.slope)
        at = self._node[cells.dofs[..., 0]]
        entries = np.repeat(at, n, axis=1).ravel(), np.tile(at, n).ravel()
        return coo_array((K.ravel(), entries), (self.count, self.count)).tocsr()

    def _unknowns(self, surface: Indices) -> tuple[csr_array, int]:
        """T (nodes, n) and the number of unknowns on surfaces, which come last."""
        place = np.full(self.count, self.count)
        place[: self.meshed] = nested_dissection(self.bodies.basis)[self.dofs[0]]
        last = np.zeros(self.count, bool)
        last[surface] = last[self.meshed :] = True
        for cells in self.bodies.rigid:
            last[self._node[self.bodies.cells.dofs[cells, :, 0]]] = True
        order, late = np.zeros(self._held.size, int), np.zeros(self._held.size, bool)
        np.maximum.at(order, self._class, place)
        late[self._class[last]] = True
        free = np.flatnonzero(~self._held)
        free = free[np.lexsort((order[free], late[free]))]
        column = np.full(self._held.size, -1)
        column[free] = np.arange(free.size)
        own = np.flatnonzero(column[self._class] >= 0)
        at = own, column[self._class[own]]
        return csr_array((np.ones(own.size), at), (self.count, free.size)), int(late[free].sum())

    def _free_shifts(self, s: int) -> tuple[Array, tuple[str, ...]]:
        body = self._whole_bodies()
        q = np.zeros((s, 0))
        words: list[str] = []
        for k in range(body.max() + 1):
            own = body == k
            if np.any(self._held[self._class[own]]):
                continue
            shift = (self.T.T @ own.astype(float) > 0).astype(float)[self.T.shape[1] - s :]
            words.append(f"{self._name(own)} can move along z")
            if not np.any(shift):
                self.refuse(words[-1])
            q = np.hstack([q, shift[:, None] / np.linalg.norm(shift)])
        return q, tuple(words)

    def _whole_bodies(self) -> Indices:
        """The body (nodes,) of every node: what hangs together by cells, ties and rigid bodies."""
        at = self._node[self.bodies.cells.dofs[..., 0]]
        same = np.zeros(self._held.size, int)
        same[self._class] = np.arange(self.count)
        first = np.concatenate([np.repeat(at[:, :1], at.shape[1], axis=1).ravel(), same[self._class]])
        return self._components(first, np.concatenate([at.ravel(), np.arange(self.count)]))

    def _name(self, own: NDArray[np.bool_]) -> str:
        for name, node in zip(self.bodies.obstacles, range(self.meshed, self.count), strict=True):
            if own[node]:
                return f"obstacle {name!r}"
        at = self._node[self.bodies.cells.dofs[..., 0]]
        for name, cells in (self.bodies.basis.mesh.subdomains or {}).items():
            if np.all(own[at[cells]]):
                return f"body {name!r}"
        x, y = self.bodies.basis.doflocs[:, self.dofs[0, np.argmax(own)]]
        return f"the body at ({x:.5g}, {y:.5g})"

    def named(self, amplitudes: Array) -> str:
        """The shift that most of the `amplitudes` (k,) belongs to, in words."""
        return self.words[int(np.argmax(np.abs(amplitudes)))]

    def refuse(self, words: str) -> None:
        raise ValueError(f"{words}: neither supports along z nor friction hold it")

    def _prescribed(self, values: Mapping[str, Prescribed]) -> Array:
        given = np.full(self._held.size, np.nan)
        size = 0.0
        for name, value in values.items():
            nodes = self._nodes(name)
            if callable(value):
                if name in self.bodies.obstacles:
                    raise ValueError(f"the motion along z of obstacle {name!r} is a number")
                value = value(self.bodies.basis.doflocs[:, self.dofs[0, nodes]])
            u = np.broadcast_to(np.asarray(value, float), nodes.shape)
            if not np.all(np.isfinite(u)):
                raise ValueError(f"the displacement along z of {name!r} is not finite")
            size = max(size, float(np.abs(u).max(initial=0.0)))
            before = given[self._class[nodes]]
            given[self._class[nodes]] = u
            fresh = np.isnan(before)
            missed = np.abs(np.where(fresh, u, before) - u).max(initial=0.0)
            missed = max(missed, np.abs(given[self._class[nodes]] - u).max(initial=0.0))
            if missed > CONTRADICTION * size:
                raise ValueError(
                    f"supports along z contradict each other at {name!r}: missed by {missed:.3g}"
                )
        return np.nan_to_num(given)[self._class]
