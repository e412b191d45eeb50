"""Prescribed displacement components on named boundaries and at points of a plane mesh.

Components are "x", "y", "n" (outward normal) and "t" (tangent, the normal rotated by +90 deg).
Every supported node retains 0 or 1 free direction. The solution is therefore u = T q + u0 with free
unknowns q, and inclined and curved guides need no penalty.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, NoReturn

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array
from skfem import Basis

from fem.plane.axis import on_axis
from fem.plane.discretisation import Array, Indices, named_facets
from fem.plane.guides import wall_normals

if TYPE_CHECKING:
    from fem.plane.ties import Tied

Prescribed = float | Callable[[Array], Array]
Support = str | Mapping[str, Prescribed]
Anchors = Mapping[tuple[float, float], Support]
Owner = str | tuple[float, float]
COMPONENTS = "xynt"
INDEPENDENT = 1e-9  # singular values of the unit directions at a node: below, two are one
COINCIDENT = 1e-9  # relative to the mesh's extent
CONTRADICTION = 1e-9  # relative to the values prescribed at a node
AXIS = "the axis"  # holder of the condition u_r = 0 on the axis of a body of revolution
CENTRE = "the centre of a tie"  # holder of the nodes that follow themselves, turned


@dataclass(frozen=True)
class Conditions:
    """Conditions direction . u(node) = value; `dofs` (2, m), `direction` (2, m), `value` (m,).

    `owner` (m,) is the index in `owners` of the boundary or point to which each condition belongs.
    """

    dofs: Indices
    direction: Array
    value: Array
    owner: Indices
    owners: tuple[Owner, ...]

    def of(self, boundary: str) -> NDArray[np.bool_]:
        """Mask (m,) of the conditions that belong to `boundary`."""
        if boundary not in self.owners:
            return np.zeros(self.owner.size, bool)
        return self.owner == self.owners.index(boundary)

    def anchored_at(self, node: Indices) -> NDArray[np.bool_]:
        """Mask (m,) of the conditions of an anchor at the node with the unknowns `node` (2,)."""
        points = [i for i, owner in enumerate(self.owners) if isinstance(owner, tuple)]
        return np.isin(self.owner, points) & (self.dofs[0] == node[0])

    def by_node(self) -> tuple[Indices, Indices, Array]:
        """Indices, unknowns and directions of the conditions of each node.

        The results are indices (nodes, c), unknowns (2, nodes) and directions (nodes, c, 2). c is
        the largest number of conditions at a node, and at least 2. At nodes with fewer
        conditions, the remaining indices are -1 and the directions are zero.
        """
        node, first, group = np.unique(self.dofs[0], return_index=True, return_inverse=True)
        order = np.argsort(group, kind="stable")
        start = np.searchsorted(group[order], np.arange(node.size))
        rank = np.arange(order.size) - start[group[order]]
        number = np.full((node.size, max(2, int(rank.max(initial=-1)) + 1)), -1)
        number[group[order], rank] = order
        direction = np.zeros((*number.shape, 2))
        direction[group[order], rank] = self.direction[:, order].T
        return number, self.dofs[:, first], direction

    def forces(self, reaction: Array) -> Array:
        """Forces (m,) in the directions of the conditions; their sum is `reaction` (unknowns,)."""
        number, dofs, direction = self.by_node()
        # least norm: equal conditions share the force
        inverse = np.linalg.pinv(direction.swapaxes(1, 2), rcond=INDEPENDENT)
        each = np.einsum("nci,in->nc", inverse, reaction[dofs])
        force = np.zeros(self.owner.size)
        force[number[number >= 0]] = each[number >= 0]
        return force

    def beside(self, reaction: Array) -> Array:
        """Part of `reaction` (unknowns,) that no condition can carry."""
        left = reaction.copy()
        np.subtract.at(left, self.dofs, self.direction * self.forces(reaction))
        return left


def node_dofs(basis: Basis) -> Indices:
    """Unknowns u_x and u_y of every node (2, nodes): vertices, edge nodes, cell nodes."""
    blocks = [basis.nodal_dofs, basis.facet_dofs, basis.interior_dofs]
    return np.hstack([np.asarray(b)[:2] for b in blocks if b is not None and np.size(b)])


def collect(
    basis: Basis,
    supports: Mapping[str, Support],
    anchors: Anchors,
    *,
    turn: bool = False,
    tied: "Tied | None" = None,
) -> Conditions:
    """All conditions of `supports` (by boundary) and `anchors` (by point).

    With `turn`, x is a radius, and nodes on the axis cannot leave it. Walls continue at boundaries
    that are `tied`; nodes on the axis of rotation of a tie are fixed.
    """
    rest = AXIS if turn else CENTRE
    still = np.zeros((2, 0), int) if tied is None else tied.still
    held = turn or still.size > 0
    owners: tuple[Owner, ...] = (*supports, *anchors, *([rest] if held else []))
    wanted = [
        (i, component, value)
        for i, support in enumerate((*supports.values(), *anchors.values()))
        for component, value in _components(support, f"support {owners[i]!r}")
    ]
    names = {i for i, component, _ in wanted if component in "nt" and i < len(supports)}
    guides = wall_normals(basis, {i: str(owners[i]) for i in sorted(names)}, turn, tied)
    parts = [_kept_on_axis(basis, len(owners) - 1)] if turn else []
    if still.size:
        parts.append(_kept_still(still, len(owners) - 1))
    for i, component, value in wanted:
        place = owners[i]
        if isinstance(place, tuple):
            dofs, direction = _at_point(basis, place, component)
        elif component in "nt":
            dofs, normal = guides[i]
            direction = normal if component == "n" else np.array([-normal[1], normal[0]])
        else:
            dofs = nodes_on(basis, named_facets(basis.mesh, place))
            direction = np.repeat(np.eye(2)[:, ["xy".index(component)]], dofs.shape[1], axis=1)
        values = _values(value, basis.doflocs[:, dofs[0]])
        parts.append((dofs, direction, values, np.full(values.size, i)))
    if not parts:
        none = np.zeros(0, int)
        return Conditions(np.zeros((2, 0), int), np.zeros((2, 0)), np.zeros(0), none, owners)
    joined = [np.concatenate(a, axis=-1) for a in zip(*parts, strict=True)]
    return Conditions(joined[0], joined[1], joined[2], joined[3], owners)


def nearest_node(basis: Basis, point: tuple[float, float]) -> Indices:
    """Unknowns u_x and u_y of the node at `point`.

    Raises ValueError if there is no node or if there are several nodes.
    """
    dofs = node_dofs(basis)
    distance = np.hypot(*(basis.doflocs[:, dofs[0]] - np.reshape(point, (2, 1))))
    nearest = int(np.argmin(distance))
    if np.count_nonzero(distance <= COINCIDENT * np.ptp(basis.mesh.p, axis=1).max()) > 1:
        raise ValueError(
            f"several nodes at {tuple(point)}: bodies touch there; use another point or a boundary"
        )
    if distance[nearest] > 1e-6 * np.ptp(basis.mesh.p, axis=1).max():
        raise ValueError(
            f"no node at {tuple(point)}: the distance to the nearest node is "
            f"{distance[nearest]:.3g}; add this point to the mesh"
        )
    return dofs[:, nearest]


def free_directions(
    basis: Basis, conditions: Conditions, place: Indices, led: Indices | None = None
) -> tuple[csr_array, Array]:
    """Matrix T (unknowns, free) with orthonormal columns and u0 (unknowns,) of u = T q + u0.

    The free unknowns q have the order of their nodes in `place` (unknowns,). The unknowns `led` of
    followers are omitted; their rows of T are zero.
    """
    number, dofs, direction = conditions.by_node()
    value = (
        np.where(number >= 0, conditions.value[number], 0.0) if number.size else np.zeros((0, 2))
    )
    u = np.einsum("nic,nc->ni", np.linalg.pinv(direction, rcond=INDEPENDENT), value)
    missed = np.abs(np.einsum("nci,ni->nc", direction, u) - value)
    size = np.abs(value).max(axis=1, keepdims=True, initial=0.0)
    if np.any(wrong := np.any(missed > CONTRADICTION * size, axis=1)):
        _refuse(basis, conditions, number[np.argmax(wrong)])
    u0, fixed = np.zeros(basis.N), np.zeros(basis.N, bool)
    u0[dofs], fixed[dofs] = u.T, True
    if led is not None:
        fixed[led] = True
    _, s, v = np.linalg.svd(direction, full_matrices=False)
    guided = np.flatnonzero(s[:, 1] < INDEPENDENT)
    tangent = np.where(np.abs(v[guided, 1]) < INDEPENDENT**2, 0.0, v[guided, 1])
    tangent *= np.sign(tangent.sum(axis=1, keepdims=True)) + (tangent.sum(axis=1) == 0)[:, None]
    rows, tangents = dofs[:, guided].T.ravel(), tangent.ravel()
    free = np.flatnonzero(~fixed)
    n, m = free.size, guided.size
    column = np.empty(n + m, int)
    column[np.argsort(place[np.concatenate([free, rows[::2]])])] = np.arange(n + m)
    columns = column[np.concatenate([np.arange(n), n + np.repeat(np.arange(m), 2)])]
    entries = np.concatenate([np.ones(n), tangents])
    T = csr_array((entries, (np.concatenate([free, rows]), columns)), (basis.N, n + m))
    T.eliminate_zeros()
    return T, u0


def _components(support: Support, where: str) -> Iterable[tuple[str, Prescribed]]:
    items = dict.fromkeys(support, 0.0) if isinstance(support, str) else dict(support)
    if unknown := set(items) - set(COMPONENTS):
        raise ValueError(
            f"{where}: components must be x, y, n or t, got {''.join(sorted(unknown))!r}"
        )
    return items.items()


def nodes_on(basis: Basis, facets: Indices) -> Indices:
    """Unknowns u_x and u_y (2, m) of every node on `facets`."""
    nodes = [basis.nodal_dofs[:, np.unique(basis.mesh.facets[:, facets])]]
    if basis.facet_dofs is not None and np.size(basis.facet_dofs):
        nodes.append(basis.facet_dofs[:2, np.unique(facets)])
    return np.hstack(nodes)


def _kept_on_axis(basis: Basis, owner: int) -> tuple[Indices, Array, Array, Indices]:
    """Conditions u_r = 0 at all nodes on the axis."""
    dofs = node_dofs(basis)
    dofs = dofs[:, on_axis(basis.mesh, basis.doflocs[:, dofs[0]])]
    count = dofs.shape[1]
    direction = np.repeat([[1.0], [0.0]], count, axis=1)
    return dofs, direction, np.zeros(count), np.full(count, owner)


def _kept_still(still: Indices, owner: int) -> tuple[Indices, Array, Array, Indices]:
    """Conditions u = 0 at the nodes `still` (2, k)."""
    count = 2 * still.shape[1]
    direction = np.repeat(np.eye(2), still.shape[1], axis=1)
    return np.tile(still, 2), direction, np.zeros(count), np.full(count, owner)


def _at_point(basis: Basis, point: tuple[float, float], component: str) -> tuple[Indices, Array]:
    if component in "nt":
        raise ValueError(
            f"anchor at {point}: components must be x or y, because a point has no normal"
        )
    return nearest_node(basis, point)[:, None], np.eye(2)[:, ["xy".index(component)]]


def _values(value: Prescribed, x: Array) -> Array:
    given = value(x) if callable(value) else value
    return np.broadcast_to(np.asarray(given, float), x.shape[1:]).copy()


def _refuse(basis: Basis, conditions: Conditions, number: Indices) -> NoReturn:
    """Raise ValueError for the conditions `number` (c,) of a node, which contradict each other."""
    own = number[number >= 0]
    x, y = basis.doflocs[:, conditions.dofs[0, own[0]]]
    by = ", ".join(sorted({repr(conditions.owners[i]) for i in conditions.owner[own]}))
    values = conditions.value[own].tolist()
    raise ValueError(
        f"at the node ({x:.10g}, {y:.10g}), the supports {by} contradict each other: they "
        f"prescribe {values}"
    )
