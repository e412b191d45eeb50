"""Prescribed and uniform displacement components on boundaries, lines and points of a solid.

The solution is u = T q + u0 with free unknowns q; all nodes with equal displacement have a common
unknown.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array
from skfem.mesh import Mesh3D

from fem.solid.geometry import Array, Indices
from fem.solid.places import Place, nodes_at

Prescribed = float | Callable[[Array], Array]
Support = str | Mapping[str, Prescribed]
AXES = "xyz"
CONTRADICTION = 1e-9  # relative to the values prescribed at a node


@dataclass(frozen=True)
class Conditions:
    """Unknowns with prescribed values, and groups of unknowns with equal values.

    `dofs`, `value` and `owner` (m,) belong to the prescribed unknowns; `owner` is the index of the
    place in `owners`. `ties` are the groups of unknowns, and `tied_by` is the place of each group.
    """

    dofs: Indices
    value: Array
    owner: Indices
    owners: tuple[Place, ...]
    ties: tuple[Indices, ...]
    tied_by: tuple[Place, ...]

    def forces(self, reaction: Array, place: Place) -> Array:
        """Part (unknowns,) of `reaction` (unknowns,) that `place` exerts.

        Places that fix the same unknown carry equal shares.
        """
        holders = np.bincount(self.dofs, minlength=reaction.size)
        chosen = np.zeros(reaction.size)
        if place in self.owners:
            own = self.dofs[self.owner == self.owners.index(place)]
            chosen[own] = reaction[own] / holders[own]
        for group, by in zip(self.ties, self.tied_by, strict=True):
            if by == place:
                chosen[group] = reaction[group]
        return chosen


def collect(
    mesh: Mesh3D, supports: Mapping[Place, Support], uniform: Mapping[Place, str]
) -> Conditions:
    """Conditions of all places. Raises ValueError if two conditions of a node are incompatible."""
    parts = []
    for k, (place, support) in enumerate(supports.items()):
        nodes = nodes_at(mesh, place)
        for axis, wanted in _components(place, support):
            given = wanted(mesh.doflocs[:, nodes]) if callable(wanted) else wanted
            values = np.broadcast_to(np.asarray(given, float), nodes.shape)
            if not np.all(np.isfinite(values)):
                raise ValueError(
                    f"support {place!r}: the displacement along {AXES[axis]} must be finite"
                )
            parts.append((3 * nodes + axis, values, np.full(nodes.size, k)))
    ties = [
        (3 * nodes_at(mesh, place) + axis, place)
        for place, components in uniform.items()
        for axis, _ in _components(place, components)
    ]
    none = (np.zeros(0, int), np.zeros(0), np.zeros(0, int))
    dofs, value, owner = (np.concatenate(a) for a in zip(none, *parts, strict=True))
    found = Conditions(
        dofs, value, owner, tuple(supports), tuple(t for t, _ in ties), tuple(p for _, p in ties)
    )
    _check(mesh, found)
    return found


def free_directions(conditions: Conditions, place: Indices) -> tuple[csr_array, Array]:
    """Matrix T (unknowns, free) of zeros and ones, and u0 (unknowns,), of u = T q + u0.

    The order of the free unknowns is that of their nodes in `place` (nodes,). The unknowns that are
    common to a group are last.
    """
    count = 3 * place.size
    u0 = np.zeros(count)
    u0[conditions.dofs] = conditions.value
    turn = (3 * place[:, None] + np.arange(3)).ravel()
    for k, group in enumerate(conditions.ties):
        turn[group] = count + k
    free = np.ones(count, bool)
    free[conditions.dofs] = False
    rows = np.flatnonzero(free)
    kept, columns = np.unique(turn[rows], return_inverse=True)
    return csr_array((np.ones(rows.size), (rows, columns)), (count, kept.size)), u0


def _components(place: Place, support: Support) -> Iterator[tuple[int, Prescribed]]:
    items = dict.fromkeys(support, 0.0) if isinstance(support, str) else dict(support)
    if unknown := set(items) - set(AXES):
        names = "".join(sorted(unknown))
        raise ValueError(f"support {place!r}: components must be x, y or z, got {names!r}")
    for name, value in items.items():
        yield AXES.index(name), value


def _check(mesh: Mesh3D, found: Conditions) -> None:
    """Raise ValueError if an unknown has two values, two groups, or a value and a group."""
    count = 3 * mesh.doflocs.shape[1]
    low, high = np.full(count, np.inf), np.full(count, -np.inf)
    np.minimum.at(low, found.dofs, found.value)
    np.maximum.at(high, found.dofs, found.value)
    wrong = high - low > CONTRADICTION * np.maximum(abs(high), abs(low))
    _refuse(mesh, wrong, "two supports of one node contradict each other")
    tied = np.bincount(np.concatenate([np.zeros(0, int), *found.ties]), minlength=count)
    _refuse(mesh, tied > 1, "a node must move uniformly with one group only")
    _refuse(mesh, (tied > 0) & np.isfinite(low), "a node must not be supported and move uniformly")


def _refuse(mesh: Mesh3D, wrong: NDArray[np.bool_], rule: str) -> None:
    if np.any(wrong):
        node, axis = divmod(int(np.argmax(wrong)), 3)
        x, y, z = mesh.doflocs[:, node]
        raise ValueError(f"at ({x:.10g}, {y:.10g}, {z:.10g}), along {AXES[axis]}: {rule}")
