"""Rigid links without friction between two points of a frame, for example for parts in contact.

A link prescribes the displacement of its second point relative to its first point in one direction;
displacements in other directions are free. The force of the link is part of the solution and can
also be a tension. If a link represents a contact, check the sign of its force.
"""

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array, csc_array
from scipy.sparse.linalg import SuperLU, splu

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Place = int | tuple[int, float]  # a node, or an element and how far along it (0 to 1)

DEPENDENT = 1e-9  # singular value of unit rows


@dataclass(frozen=True, kw_only=True)
class Link:
    """Link that prescribes (u_second - u_first) . direction = value.

    A point is a node, or the number of an element and a fraction of its length. `direction` (x, y)
    may have any length except zero. If the link represents a contact, `direction` leads from
    `first` to `second`, and `value` is minus the gap [length] that is closed.
    """

    first: Place
    second: Place
    direction: tuple[float, float]
    value: float = 0.0

    def __post_init__(self) -> None:
        length = math.hypot(*self.direction)
        if not (math.isfinite(length) and length > 0):
            raise ValueError(
                f"the direction (x, y) of a link must be finite and not zero, got {self.direction}"
            )
        if not math.isfinite(self.value):
            raise ValueError(
                f"the relative displacement of a link must be finite, got {self.value} m"
            )
        if self.first == self.second:
            raise ValueError(f"a link must have two different points, got {self.first} twice")


@dataclass(frozen=True)
class Divided:
    """Mesh of straight elements with a node at every linked point.

    New nodes and elements are numbered after the given ones; the first part of a divided element
    retains the number of the element. `parent` (m,) is the original element of each element; `ends`
    (k, 2) are the nodes of every link.
    """

    points: Array
    elements: Indices
    parent: Indices
    ends: Indices


def divide(points: Array, elements: Indices, links: Sequence[Link]) -> Divided:
    """Divide straight elements at linked points. Raises ValueError for points outside elements."""
    cuts: dict[int, dict[float, int]] = {}
    count = len(points)
    added: list[Array] = []
    ends = np.empty((len(links), 2), dtype=np.int64)
    for i, link in enumerate(links):
        for j, place in enumerate((link.first, link.second)):
            at = _at_end(place, elements)
            if isinstance(at, int):
                ends[i, j] = _node(at, count)
                continue
            e, share = at
            if share not in cuts.setdefault(e, {}):
                cuts[e][share] = count + len(added)
                a, b = points[elements[e]]
                added.append(a + share * (b - a))
            ends[i, j] = cuts[e][share]
    cut, more, parent = elements.copy(), [], list(range(len(elements)))
    for e, own in cuts.items():
        chain = [*(own[share] for share in sorted(own)), int(elements[e, 1])]
        cut[e, 1] = chain[0]
        more += list(itertools.pairwise(chain))
        parent += [e] * len(own)
    return Divided(
        np.vstack([points, *added]) if added else points,
        np.vstack([cut, more]) if more else cut,
        np.array(parent), ends,
    )  # fmt: skip


def _at_end(place: Place, elements: Indices) -> Place:
    """Node number of a point at an end of an element; all other points are returned unchanged."""
    if not isinstance(place, tuple):
        return place
    e, share = place
    if not 0 <= e < len(elements):
        raise ValueError(f"no element {e}: the frame has elements 0 to {len(elements) - 1}")
    if not 0 <= share <= 1:
        raise ValueError(f"the position of a link on element {e} must lie in [0, 1], got {share:g}")
    return int(elements[e, int(share)]) if share in (0, 1) else place


def _node(node: int, count: int) -> int:
    if not 0 <= node < count:
        raise ValueError(f"no node {node}: the frame has nodes 0 to {count - 1}")
    return node


@dataclass(frozen=True)
class Ties:
    """Links between nodes as equations B u = g, for a frame with three unknowns per node."""

    B: csc_array
    g: Array

    @property
    def count(self) -> int:
        return int(self.g.size)


def ties(nodes: int, links: Sequence[Link], ends: Indices | None = None) -> Ties:
    """Equations of `links` between nodes.

    The linked nodes are `ends` (k, 2). Without `ends`, the points of the links must be nodes.
    """
    rows, columns, entries = [], [], []
    for i, link in enumerate(links):
        direction = np.array(link.direction) / math.hypot(*link.direction)
        for j, sign in ((0, -1.0), (1, 1.0)):
            place = (link.first, link.second)[j] if ends is None else int(ends[i, j])
            if isinstance(place, tuple):
                raise ValueError(f"links of curved elements must be at nodes, got {place}")
            first = 3 * _node(place, nodes)
            rows += [i, i]
            columns += [first, first + 1]
            entries += (sign * direction).tolist()
    B = csc_array(coo_array((entries, (rows, columns)), shape=(len(links), 3 * nodes)))
    return Ties(B, np.array([link.value for link in links], dtype=np.float64))


def check_ties(tied: Ties, points: Array, part: Indices, free: NDArray[np.bool_]) -> bool:
    """True if the supports prevent rigid motions without the links.

    `part` (n,) is the number of the connected part to which each node belongs. Raises ValueError
    for redundant links, and for frames that can move rigidly in spite of the links.
    """
    own = np.linalg.svd(tied.B[:, free].toarray(), compute_uv=False)
    if free.sum() < tied.count or own[-1] < DEPENDENT:
        raise ValueError(
            "links must not be redundant and must not join points that supports already fix"
        )
    x, y = (points - points.mean(axis=0)).T / max(np.ptp(points, axis=0).max(), 1e-300)
    modes = np.zeros((len(points), 3, 3 * (int(part.max()) + 1)))
    node = np.arange(len(points))
    for dof, mode, entry in ((0, 0, 1.0), (1, 1, 1.0), (0, 2, -y), (1, 2, x), (2, 2, 1.0)):
        modes[node, dof, 3 * part + mode] = entry
    motions = modes.reshape(free.size, -1)
    if not _holds(np.vstack([motions[~free], tied.B @ motions])):
        raise ValueError("the frame can move rigidly in spite of its links: add a support")
    return _holds(motions[~free])


def _holds(rows: Array) -> bool:
    """True if linear conditions prevent all rigid motions; `rows` is (conditions, motions)."""
    s = np.linalg.svd(rows, compute_uv=False)
    return bool(s.size == rows.shape[1] and s[-1] > DEPENDENT)


Solver = Callable[[Array, Array], tuple[Array, Array]]


def tied_solver(K: csc_array, B: csc_array, alone: bool) -> Solver:
    """Function that solves K u - B^T p = r, B u = g for (u, p), by the compliance of the links.

    `alone` is True if the supports hold the frame without the links; K is then positive definite.
    Otherwise, s B^T B is added to K. This makes K positive definite and does not change the
    solution, because B u is g. Raises RuntimeError if the sum is also singular.
    """
    s = 0.0 if alone else float(abs(K.diagonal()).mean())
    factor = positive_factor(csc_array(K + s * (B.T @ B)) if s else K)
    moved = factor.solve(B.T.toarray())
    compliance = B @ moved

    def solve(r: Array, g: Array) -> tuple[Array, Array]:
        u = factor.solve(r + s * (B.T @ g))
        p = np.linalg.solve(compliance, g - B @ u)
        return u + moved @ p, p

    return solve


def positive_factor(K: csc_array) -> SuperLU:
    """Factors of a positive definite matrix. Raises RuntimeError if a pivot is zero."""
    return splu(
        K, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True}
    )
