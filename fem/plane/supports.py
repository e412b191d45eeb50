"""Prescribed displacement components on named boundaries and at points of a plane mesh.

Components are "x", "y", "n" (outward normal) and "t" (tangent, the normal turned by +90 deg).
Every supported node keeps 0 or 1 free direction, so that the solution is u = T q + u0 with
free unknowns q; inclined and curved guides need no penalty.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components
from skfem import Basis

from fem.plane.discretisation import Array, Indices, facet_basis, named_facets

Prescribed = float | Callable[[Array], Array]
Support = str | Mapping[str, Prescribed]
Anchors = Mapping[tuple[float, float], Support]
COMPONENTS = "xynt"


@dataclass(frozen=True)
class Conditions:
    """Conditions direction . u(node) = value; `dofs` (2, m), `direction` (2, m), `value` (m,)."""

    dofs: Indices
    direction: Array
    value: Array


def node_dofs(basis: Basis) -> Indices:
    """X and y unknown of every node, shape (2, nodes): vertices, edge nodes, cell nodes."""
    blocks = [basis.nodal_dofs, basis.facet_dofs, basis.interior_dofs]
    return np.hstack([np.asarray(b)[:2] for b in blocks if b is not None and np.size(b)])


def collect(basis: Basis, supports: Mapping[str, Support], anchors: Anchors) -> Conditions:
    """All conditions of `supports` (by boundary) and `anchors` (by point)."""
    parts = [
        _on_boundary(basis, name, component, value)
        for name, support in supports.items()
        for component, value in _components(support, f"support {name!r}")
    ]
    parts += [
        _at_point(basis, point, component, value)
        for point, support in anchors.items()
        for component, value in _components(support, f"anchor at {point}")
    ]
    if not parts:
        return Conditions(np.zeros((2, 0), int), np.zeros((2, 0)), np.zeros(0))
    return Conditions(*(np.concatenate(a, axis=-1) for a in zip(*parts, strict=True)))


def nearest_node(basis: Basis, point: tuple[float, float]) -> Indices:
    """The two unknowns of the node at `point`; ValueError where no node lies there."""
    dofs = node_dofs(basis)
    distance = np.hypot(*(basis.doflocs[:, dofs[0]] - np.reshape(point, (2, 1))))
    nearest = int(np.argmin(distance))
    if distance[nearest] > 1e-6 * np.ptp(basis.mesh.p):
        raise ValueError(
            f"no node at {tuple(point)}: the nearest is {distance[nearest]:.3g} away; "
            "give the mesh a point there"
        )
    return dofs[:, nearest]


def free_directions(basis: Basis, conditions: Conditions) -> tuple[csr_array, Array]:
    """T (unknowns, free) with orthonormal columns and u0 (unknowns,) of u = T q + u0."""
    owner, first = np.unique(conditions.dofs[0], return_inverse=True)
    partner = dict(zip(*conditions.dofs, strict=True))
    fixed, u0 = np.zeros(basis.N, bool), np.zeros(basis.N)
    rows: list[int] = []
    tangents: list[tuple[float, float]] = []
    order = np.argsort(first, kind="stable")
    groups = np.split(order, np.cumsum(np.bincount(first))[:-1]) if owner.size else []
    for x, group in zip(owner.tolist(), groups, strict=True):
        y = int(partner[x])
        u0[[x, y]], tangent = _resolve(conditions.direction[:, group].T, conditions.value[group])
        fixed[[x, y]] = True
        if tangent is not None:
            rows += [x, y]
            tangents.append((tangent[0], tangent[1]))
    free = np.flatnonzero(~fixed)
    n, m = free.size, len(tangents)
    columns = np.concatenate([np.arange(n), n + np.repeat(np.arange(m), 2)])
    entries = np.concatenate([np.ones(n), np.ravel(tangents)])
    T = csr_array((entries, (np.concatenate([free, rows]).astype(int), columns)), (basis.N, n + m))
    return T, u0


def check_rigid_motions(basis: Basis, conditions: Conditions) -> None:
    """ValueError naming the rigid motion that the conditions leave to a body."""
    cells = np.vstack([np.asarray(basis.element_dofs)])
    pairs = np.broadcast_to(cells[:1], cells.shape).ravel(), cells.ravel()
    links = csr_array((np.ones(cells.size), pairs), (basis.N, basis.N))
    count, part = connected_components(links, directed=False)
    dofs = node_dofs(basis)
    for k in range(count):
        own = dofs[:, part[dofs[0]] == k]
        at = basis.doflocs[:, own[0]]
        centre, size = at.mean(axis=1, keepdims=True), np.ptp(at)
        mine = part[conditions.dofs[0]] == k
        d = conditions.direction[:, mine]
        x, y = (basis.doflocs[:, conditions.dofs[0, mine]] - centre) / size
        rows = np.column_stack([d[0], d[1], -y * d[0] + x * d[1]])
        _, s, v = np.linalg.svd(np.vstack([rows, np.zeros((3, 3))]), full_matrices=False)
        if s[2] < 1e-9:
            motion = ", ".join(
                f"{c:+.2g} {word}"
                for c, word in zip(v[2], ("x", "y", "rotation"), strict=True)
                if abs(c) > 1e-9
            )
            raise ValueError(
                f"body {k + 1} of {count} can move rigidly ({motion}): support it against that"
            )


def _components(support: Support, where: str) -> Iterable[tuple[str, Prescribed]]:
    items = dict.fromkeys(support, 0.0) if isinstance(support, str) else dict(support)
    if unknown := set(items) - set(COMPONENTS):
        raise ValueError(f"{where}: components are x, y, n, t, got {''.join(sorted(unknown))!r}")
    return items.items()


def _on_boundary(
    basis: Basis, name: str, component: str, value: Prescribed
) -> tuple[Indices, Array, Array]:
    trace = facet_basis(basis, named_facets(basis.mesh, name), points=np.array([0.0, 0.5, 1.0]))
    edge_dofs, ends = basis.facet_dofs, basis.nodal_dofs[:, basis.mesh.facets[:, trace.find]]
    nodes = [ends[:, 0], ends[:, 1]]
    stations = [0, 2]
    if edge_dofs is not None and np.size(edge_dofs):
        nodes.append(edge_dofs[:2, trace.find])
        stations.append(1)
    dofs, normal = np.hstack(nodes), np.hstack([trace.normals[:, :, i] for i in stations])
    unique, inverse = np.unique(dofs, axis=1, return_inverse=True)
    # a vertex between two facets takes their mean normal
    mean = np.array([np.bincount(inverse.ravel(), weights=row) for row in normal])
    mean /= np.hypot(*mean)
    return unique, _direction(component, mean), _values(value, basis.doflocs[:, unique[0]])


def _at_point(
    basis: Basis, point: tuple[float, float], component: str, value: Prescribed
) -> tuple[Indices, Array, Array]:
    if component in "nt":
        raise ValueError(f"anchor at {point}: a point has no normal, use x and y")
    dofs = nearest_node(basis, point)[:, None]
    return dofs, _direction(component, np.zeros((2, 1))), _values(value, basis.doflocs[:, dofs[0]])


def _direction(component: str, normal: Array) -> Array:
    if component in "xy":
        return np.repeat(np.eye(2)[:, ["xy".index(component)]], normal.shape[1], axis=1)
    return normal if component == "n" else np.array([-normal[1], normal[0]])


def _values(value: Prescribed, x: Array) -> Array:
    given = value(x) if callable(value) else value
    return np.broadcast_to(np.asarray(given, float), x.shape[1:]).copy()


def _resolve(directions: Array, values: Array) -> tuple[Array, Array | None]:
    """Displacement that meets all conditions of one node and the direction that stays free."""
    u = np.asarray(np.linalg.lstsq(directions, values, rcond=1e-9)[0], dtype=np.float64)
    if not np.allclose(directions @ u, values, rtol=1e-9, atol=1e-9 * np.abs(values).max()):
        raise ValueError(f"two supports of one node contradict each other: {values.tolist()}")
    _, s, v = np.linalg.svd(directions)
    tangent: Array = v[1]
    independent = int(np.sum(s > 1e-9))
    return u, tangent if independent == 1 else None
