"""Nodes of bodies that move along z: numbers, names, and groups with equal displacement."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components

from fem.contact.along import Along
from fem.contact.bodies import Bodies
from fem.plane.discretisation import Array, Indices, named_facets
from fem.plane.ordering import nested_dissection
from fem.plane.supports import Prescribed, node_dofs, nodes_on

CONTRADICTION = 1e-9  # relative to the values prescribed along z


class AlongNodes:
    """Nodes with a displacement along z: nodes of the mesh, and one node for each obstacle.

    `dofs` (2, meshed) are the unknowns x and y of the nodes, `of_dof` (unknowns,) the node of each
    unknown, `cells` (cells, n) the nodes of each cell. Nodes of a rigid body, and tied nodes, have
    the same `group` (count,). `held` (groups,) is true for groups with a support.
    """

    def __init__(self, bodies: Bodies, along: Along) -> None:
        """Number the nodes. Raises ValueError for unknown names."""
        self.bodies, self.along = bodies, along
        self.dofs = node_dofs(bodies.basis)
        self.meshed = self.dofs.shape[1]
        self.count = self.meshed + len(bodies.obstacles)
        self.of_dof = np.empty(bodies.basis.N, int)
        self.of_dof[self.dofs] = np.arange(self.meshed)
        self.cells: Indices = self.of_dof[bodies.cells.dofs[..., 0]]
        self._check_free()
        self._rigid = [np.unique(self.cells[own]) for own in bodies.rigid]
        self.group = self._groups()
        self.held = np.zeros(self.group.max() + 1, bool)
        for name in self.supported:
            self.held[self.group[self.named(name)]] = True

    @property
    def columns(self) -> Indices:
        """Numbers (count,) of the unknowns u_x of nodes and obstacles in the plane problem."""
        obstacles = self.bodies.basis.N + 3 * np.arange(len(self.bodies.obstacles))
        return np.concatenate([self.dofs[0], obstacles])

    @property
    def supported(self) -> list[str]:
        """Names of boundaries and obstacles whose u_z is prescribed."""
        fixed = [o for o in self.bodies.obstacles if o not in self.along.free]
        return [*self.along.supports, *(o for o in fixed if o not in self.along.supports)]

    def named(self, name: str) -> Indices:
        """Numbers of the nodes of a boundary or of an obstacle."""
        if name in self.bodies.obstacles:
            return np.array([self.meshed + list(self.bodies.obstacles).index(name)])
        basis = self.bodies.basis
        return np.asarray(self.of_dof[nodes_on(basis, named_facets(basis.mesh, name))[0]])

    def prescribed(self, values: Mapping[str, Prescribed]) -> Array:
        """Displacements (count,) of supported nodes.

        Raises ValueError if supports prescribe different values at the same node.
        """
        given = np.full(self.held.size, np.nan)
        largest = 0.0
        for name, value in values.items():
            at = self.group[self.named(name)]
            u = np.broadcast_to(self._value(name, value), at.shape)
            largest = max(largest, float(np.abs(u).max(initial=0.0)))
            given[at] = np.where(np.isnan(given[at]), u, given[at])
            missed = float(np.abs(given[at] - u).max(initial=0.0))
            if missed > CONTRADICTION * largest:
                raise ValueError(
                    "supports along z prescribe displacements that contradict each other at "
                    f"{name!r}: they differ by {missed:.3g}"
                )
        return np.asarray(np.nan_to_num(given)[self.group])

    def ordered(self, surface: Indices) -> tuple[csr_array, int]:
        """Matrix T (count, n) from free unknowns to nodes, and the number of surface unknowns.

        The unknowns are in order of elimination. The surface unknowns are the last; they belong to
        the nodes `surface`, to rigid bodies and to obstacles.
        """
        place = np.full(self.count, self.count)
        place[: self.meshed] = nested_dissection(self.bodies.basis)[self.dofs[0]]
        last = np.concatenate([surface, *self._rigid, np.arange(self.meshed, self.count)])
        order, late = np.zeros(self.held.size, int), np.zeros(self.held.size, bool)
        np.maximum.at(order, self.group, place)
        late[self.group[last.astype(int)]] = True
        free = np.flatnonzero(~self.held)
        free = free[np.lexsort((order[free], late[free]))]
        column = np.full(self.held.size, -1)
        column[free] = np.arange(free.size)
        own = np.flatnonzero(column[self.group] >= 0)
        at = own, column[self.group[own]]
        return csr_array((np.ones(own.size), at), (self.count, free.size)), int(late[free].sum())

    def loose(self) -> list[tuple[NDArray[np.bool_], str]]:
        """For every body without support along z: a mask (count,) of its nodes, and its name.

        A body is a set of nodes connected by cells, ties and rigid bodies.
        """
        first = np.repeat(self.cells[:, :1], self.cells.shape[1], axis=1).ravel()
        one = np.zeros(self.held.size, int)
        one[self.group] = np.arange(self.count)
        body = self._joined([first, one[self.group]], [self.cells.ravel(), np.arange(self.count)])
        bodies = [body == k for k in range(body.max() + 1)]
        return [(own, self._word(own)) for own in bodies if not np.any(self.held[self.group[own]])]

    def _check_free(self) -> None:
        for name in self.along.free:
            if name not in self.bodies.obstacles or name in self.along.supports:
                known = ", ".join(self.bodies.obstacles) or "none"
                raise ValueError(
                    f"`free` must name obstacles without support along z, got {name!r}; "
                    f"obstacles: {known}"
                )

    def _value(self, name: str, value: Prescribed) -> Array:
        if callable(value):
            if name in self.bodies.obstacles:
                raise ValueError(f"the motion along z of obstacle {name!r} must be a number")
            u = np.asarray(value(self.bodies.basis.doflocs[:, self.dofs[0, self.named(name)]]))
        else:
            u = np.asarray(value, float)
        if not np.all(np.isfinite(u)):
            raise ValueError(f"the displacement along z of {name!r} must be finite")
        return u

    def _groups(self) -> Indices:
        tied = self.bodies.tied
        return self._joined(
            [self.of_dof[tied.leader[0]], *(own[:-1] for own in self._rigid)],
            [self.of_dof[tied.follower[0]], *(own[1:] for own in self._rigid)],
        )

    def _joined(self, first: list[Indices], second: list[Indices]) -> Indices:
        """Number (count,) of the group of each node; nodes linked by pairs have the same number."""
        at = np.concatenate(first), np.concatenate(second)
        links = csr_array((np.ones(at[0].size), at), (self.count, self.count))
        return np.asarray(connected_components(links, directed=False)[1])

    def _word(self, own: NDArray[np.bool_]) -> str:
        for name, node in zip(self.bodies.obstacles, range(self.meshed, self.count), strict=True):
            if own[node]:
                return f"obstacle {name!r}"
        for name, cells in (self.bodies.basis.mesh.subdomains or {}).items():
            if np.all(own[self.cells[cells]]):
                return f"body {name!r}"
        x, y = self.bodies.basis.doflocs[:, self.dofs[0, np.argmax(own)]]
        return f"the body at ({x:.5g}, {y:.5g})"
