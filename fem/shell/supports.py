"""Supports of a shell: nodes by name, tied components of boundaries, check of rigid motions."""

from collections.abc import Mapping, Sequence

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from fem.shell.reference import Array, Indices

COMPONENTS = "xyzabc"  # displacements, and rotations about x, y and z
Support = str | Mapping[str, float]
Boundaries = Mapping[str, Indices]
Named = Mapping[str | int, Support]


def nodes_of(where: str | int, boundaries: Boundaries, count: int) -> Indices:
    """Nodes of a boundary given by name, or the node with a given number."""
    if isinstance(where, str):
        if where not in boundaries:
            known = ", ".join(boundaries) or "none"
            raise ValueError(f"no boundary {where!r}; boundaries: {known}")
        return np.unique(boundaries[where])
    if not 0 <= where < count:
        raise ValueError(f"no node {where}: the shell has nodes 0 to {count - 1}")
    return np.array([where])


def place(component: str, where: str | int) -> int:
    """Position of a component among the six components of a node."""
    if component not in COMPONENTS or len(component) != 1:
        at = f"boundary {where!r}" if isinstance(where, str) else f"node {where}"
        raise ValueError(f"{at}: components must be x, y, z, a, b or c, got {component!r}")
    return COMPONENTS.index(component)


def held_values(supports: Named, boundaries: Boundaries, count: int) -> Array:
    """Prescribed values (6 count,), NaN if free. Raises ValueError if an unknown has two values."""
    values = np.full((count, 6), np.nan)
    for where, support in supports.items():
        nodes = nodes_of(where, boundaries, count)
        items = dict.fromkeys(support, 0.0) if isinstance(support, str) else support
        for component, value in items.items():
            if not np.isfinite(value):
                raise ValueError(f"{where!r}: the value of {component} must be finite, got {value}")
            column = place(component, where)
            before = values[nodes, column]
            if np.any(before[~np.isnan(before)] != value):
                raise ValueError(f"{where!r}: {component} is already prescribed with another value")
            values[nodes, column] = value
    return values.ravel()


def tied_unknowns(ties: Mapping[str, str], boundaries: Boundaries, count: int) -> Indices:
    """Pairs (2, k) of equal unknowns; `ties` states the equal components of each boundary."""
    pairs = [np.empty((2, 0), int)]
    for name, components in ties.items():
        nodes = nodes_of(name, boundaries, count)
        for component in components:
            members = 6 * nodes + place(component, name)
            pairs.append(np.array([np.full(members.size - 1, members[0]), members[1:]]))
    return np.hstack(pairs)


def reduced_numbers(held: Array, pairs: Indices) -> tuple[Indices, Array]:
    """For each unknown (6 nodes,): its index among the free unknowns, and its prescribed value.

    The index is -1 for a supported unknown. If one of several tied unknowns is supported, all of
    them are.
    """
    graph = coo_array((np.ones(pairs.shape[1]), tuple(pairs)), shape=(held.size, held.size))
    groups, group = connected_components(graph, directed=False)
    fixed = ~np.isnan(held)
    value = np.full(groups, np.nan)
    value[group[fixed]] = held[fixed]
    if np.any(differ := value[group[fixed]] != held[fixed]):
        node, column = divmod(int(np.flatnonzero(fixed)[differ][0]), 6)
        raise ValueError(
            f"node {node}: {COMPONENTS[column]} is tied to a node with another prescribed value: "
            "prescribe equal values"
        )
    free = np.isnan(value)
    number = np.full(groups, -1)
    number[free] = np.arange(free.sum())
    return number[group], value[group]


def check_rigid_motions(points: Array, cells: Indices, held: Array, pairs: Indices) -> None:
    """Raise ValueError if a connected part of the shell can move rigidly."""
    count = len(points)
    first = np.repeat(cells[:, :1], cells.shape[1], axis=1).ravel()
    ends = np.hstack([np.array([first, cells.ravel()]), pairs // 6])
    graph = coo_array((np.ones(ends.shape[1]), tuple(ends)), shape=(count, count))
    parts, part = connected_components(graph, directed=False)
    fixed = ~np.isnan(held)
    for k in range(parts):
        members = np.flatnonzero(part == k)
        by_node = np.zeros((count, 6, 6))
        by_node[members] = _rigid_modes(points[members])
        modes = by_node.reshape(6 * count, 6)
        tied = pairs[:, part[pairs[0] // 6] == k]
        conditions = np.vstack([modes[fixed], modes[tied[0]] - modes[tied[1]], np.zeros((6, 6))])
        _, s, v = np.linalg.svd(conditions, full_matrices=False)
        if s[5] < 1e-9:
            which = "the shell" if parts == 1 else f"the part of node {members[0]}"
            raise ValueError(
                f"{which} can move rigidly ({_words(v[5])}): support it against this motion"
            )


def _rigid_modes(points: Array) -> Array:
    """Displacements and rotations (nodes, 6, 6 modes) of rigid motions about the mean point."""
    at = points - points.mean(axis=0)
    at = at / max(np.ptp(at, axis=0).max(), 1e-300)
    modes = np.tile(np.eye(6), (len(at), 1, 1))
    for axis in range(3):
        modes[:, :3, 3 + axis] = np.cross(np.eye(3)[axis], at)
    return modes


def _words(motion: Array) -> str:
    names: Sequence[str] = ("x", "y", "z", "turn about x", "turn about y", "turn about z")
    return ", ".join(
        f"{c:+.2g} {word}" for c, word in zip(motion, names, strict=True) if abs(c) > 1e-9
    )
