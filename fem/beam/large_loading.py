"""Loads of a geometrically exact frame: dead and follower forces, prescribed displacements."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csc_array

from fem.beam.large_elements import Elements, Extended
from fem.beam.section import DOFS, Array, Loads, Supports

Forces = Mapping[int, tuple[float, float]]
Movements = Mapping[int, Mapping[str, float]]
Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class Loading:
    """Loads and prescribed displacements.

    `dead` (3n,) are dead forces and couples, `follower` (n, 2) are follower forces in the reference
    state, and `moved` (3n,) are prescribed displacements.
    """

    dead: Array
    follower: Array
    moved: Array

    def plus(self, factor: float, other: "Loading") -> "Loading":
        """Sum of this load and `factor` times another load."""
        return Loading(
            self.dead + factor * other.dead,
            self.follower + factor * other.follower,
            self.moved + factor * other.moved,
        )

    def forces(self, u: Extended) -> Array:
        """Forces and couples (3n,) at the displacements `u` (n, 3)."""
        f = self.dead.reshape(-1, 3).copy()
        f[:, :2] += self._turned(u)
        return f.ravel()

    def slope(self, u: Extended) -> csc_array | None:
        """Derivative of follower forces with respect to u, or None without follower forces.

        Follower forces rotate with their node.
        """
        if not self.follower.any():
            return None
        x, y = self._turned(u).T
        node = 3 * np.arange(len(u))
        rows, columns = np.concatenate([node, node + 1]), np.tile(node + 2, 2)
        size = 3 * len(u)
        return csc_array((np.concatenate([-y, x]), (rows, columns)), shape=(size, size))

    def _turned(self, u: Extended) -> Array:
        phi = u[:, 2].astype(float)
        c, s, (x, y) = np.cos(phi), np.sin(phi), self.follower.T
        return np.column_stack([c * x - s * y, s * x + c * y])


def nothing(count: int) -> Loading:
    return Loading(np.zeros(3 * count), np.zeros((count, 2)), np.zeros(3 * count))


def loading(
    elements: Elements, loads: Loads | None, follower: Forces | None, distributed: Forces | None
) -> Loading:
    """Sum of nodal loads, follower forces, and dead forces per reference length of elements."""
    found = nothing(elements.count)
    for node, load in (loads or {}).items():
        known(elements.count, node)
        found.dead[3 * node : 3 * node + 3] += load
    for node, force in (follower or {}).items():
        known(elements.count, node)
        found.follower[node] += force
    for e, q in (distributed or {}).items():
        if not 0 <= e < len(elements.nodes):
            raise ValueError(f"no element {e}: the frame has {len(elements.nodes)} elements")
        share = elements.weight[e] @ elements.shape.astype(float)
        for node, length in zip(elements.nodes[e], share, strict=True):
            found.dead[3 * node : 3 * node + 2] += length * np.asarray(q, float)
    if not (np.isfinite(found.dead).all() and np.isfinite(found.follower).all()):
        raise ValueError("loads must be finite numbers")
    return found


def movement(count: int, moved: Movements) -> tuple[Loading, Mask]:
    """Prescribed displacements, and a mask (3n,) of the prescribed components."""
    found, held = nothing(count), np.zeros(3 * count, bool)
    for node, items in moved.items():
        known(count, node)
        for component, value in items.items():
            i = 3 * node + _component(node, component)
            found.moved[i], held[i] = value, True
    if not np.isfinite(found.moved).all():
        raise ValueError("prescribed displacements must be finite numbers")
    return found, held


def held_components(count: int, supports: Supports) -> Mask:
    """Mask (3n,) of the components that supports fix at zero."""
    held = np.zeros(3 * count, bool)
    for node, support in supports.items():
        known(count, node)
        for component in support:
            held[3 * node + _component(node, component)] = True
        if not isinstance(support, str) and any(support.values()):
            raise ValueError(
                f"node {node}: supports must prescribe 0; use displaced() for other displacements"
            )
    return held


def known(count: int, node: int) -> None:
    if not 0 <= node < count:
        raise ValueError(f"no node {node}: the frame has nodes 0 to {count - 1}")


def _component(node: int, name: str) -> int:
    if len(name) != 1 or name not in DOFS:
        raise ValueError(f"node {node}: components must be x, y or r, got {name!r}")
    return DOFS.index(name)
