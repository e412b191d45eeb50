"""Arc lengths along the lines of a frame, to measure sliding and to exclude nearby elements."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csc_array
from scipy.sparse.csgraph import dijkstra

from fem.beam.section import Array, Indices
from fem.beam.touching_points import Probes, lengths, shapes


@dataclass(frozen=True)
class Arcs:
    """Arc lengths along the lines of a frame, for each of its m elements.

    `size` (m,) is the length of the element, `member` (m,) the number of its line, and `start` (m,)
    the arc length at xi = 0. `sense` (m,) is +1 if the arc length increases with xi, otherwise -1.
    """

    points: Array
    elements: Indices
    size: Array
    member: Indices
    start: Array
    sense: Array

    def place(self, element: Indices, xi: Array) -> tuple[Array, Array]:
        """Arc lengths (k,) of points on elements, and their derivatives with respect to xi."""
        nodes = self.elements[element]
        _, slope, _ = shapes(xi, nodes.shape[1])
        stretch = np.hypot(*np.einsum("kp,kpd->dk", slope, self.points[nodes]))
        sense = self.sense[element]
        s = self.start[element] + sense * lengths(self.points, nodes, xi)
        return s, sense * stretch


def arcs(points: Array, elements: Indices) -> Arcs:
    """Arc lengths along lines of elements.

    A line ends at a free end or at a branch; a closed line ends where it starts.
    """
    ends = elements[:, :2]
    at: dict[int, list[int]] = {}
    for e, pair in enumerate(ends.tolist()):
        for node in pair:
            at.setdefault(node, []).append(e)
    size = lengths(points, elements, np.ones(len(elements)))
    member = np.full(len(elements), -1)
    start, sense = np.zeros(len(elements)), np.ones(len(elements))
    loose = [e for e, pair in enumerate(ends.tolist()) if any(len(at[n]) != 2 for n in pair)]
    for first in [*loose, *range(len(elements))]:
        if member[first] >= 0:
            continue
        node = int(ends[first, 0] if len(at[ends[first, 0]]) != 2 else ends[first, 1])
        if first not in loose:
            node = int(ends[first, 0])
        number, s, e = member.max() + 1, 0.0, first
        while member[e] < 0:
            forward = ends[e, 0] == node
            member[e], sense[e] = number, 1.0 if forward else -1.0
            start[e] = s if forward else s + size[e]
            s, node = s + size[e], int(ends[e, 1] if forward else ends[e, 0])
            e = next((other for other in at[node] if other != e and len(at[node]) == 2), e)
    return Arcs(points, elements, size, member, start, sense)


class Apart:
    """Test whether elements are at least the arc length `least` away from the cell of a probe.

    The test fails for the element of the probe and for elements with a common node.
    """

    def __init__(self, points: Array, elements: Indices, probes: Probes, least: float) -> None:
        self.least = least
        ends, row = np.unique(elements[:, :2], return_inverse=True)
        self.row = row.reshape(-1, 2)
        size = lengths(points, elements, np.ones(len(elements)))
        graph = csc_array((size, tuple(self.row.T)), shape=(ends.size, ends.size))
        self.between = dijkstra(graph, directed=False, limit=least)
        before = lengths(points, probes.nodes, probes.lower)
        beyond = size[probes.element] - lengths(points, probes.nodes, probes.upper)
        self.to_ends = np.column_stack([before, beyond])
        self.own = probes.element

    def __call__(self, probe: Indices, element: Indices) -> NDArray[np.bool_]:
        near = np.full(probe.shape, np.inf)
        shared = self.own[probe] == element
        for i in range(2):
            for j in range(2):
                between = self.between[self.row[self.own[probe], i], self.row[element, j]]
                shared |= between == 0
                near = np.minimum(near, self.to_ends[probe, i] + between)
        return ~shared & (near >= self.least)
