"""Edges of cells, joined to few polylines for a vector overlay."""

from collections import defaultdict

import numpy as np
from numpy.typing import NDArray

from verify.core.figures import Array

Indices = NDArray[np.int64]


def edges(cells: Indices) -> tuple[Indices, Indices, Indices]:
    """Edges (k, 2) of cells (m, corners), and the number of cells and one cell at each edge."""
    corners = cells.shape[1]
    if corners == 2:
        return cells, np.ones(len(cells), dtype=np.int64), np.arange(len(cells))
    pairs = np.concatenate([cells[:, [i, (i + 1) % corners]] for i in range(corners)])
    found, first, counts = np.unique(
        np.sort(pairs, axis=1), axis=0, return_index=True, return_counts=True
    )
    return found, counts, first % len(cells)


def polylines(cells: Indices, points: Array, tolerance: float) -> tuple[Array, ...]:
    """Polylines along the free edges of surfaces, or along all cells that are lines.

    Points within the distance `tolerance` of a polyline are omitted. `points` is (n, 2).
    Closed polylines repeat their first point.
    """
    found, counts, _ = edges(cells)
    free = found[counts == 1]
    return tuple(simplified(points[chain], tolerance) for chain in _chains(free))


def simplified(line: Array, tolerance: float) -> Array:
    """The polyline (k, 2) without points within `tolerance` of a chord (Douglas-Peucker)."""
    keep = np.zeros(len(line), dtype=bool)
    keep[[0, -1]] = True
    spans = [(0, len(line) - 1)]
    while spans:
        i, j = spans.pop()
        if j - i < 2:
            continue
        off = _distances(line[i + 1 : j], line[i], line[j])
        far = int(off.argmax())
        if off[far] > tolerance:
            middle = i + 1 + far
            keep[middle] = True
            spans += [(i, middle), (middle, j)]
    return line[keep]


def _distances(points: Array, a: Array, b: Array) -> Array:
    """Distances of points to the segment from `a` to `b`, which may be a single point."""
    chord = b - a
    square = float(chord @ chord)
    along = np.clip((points - a) @ chord / square, 0, 1) if square else np.zeros(len(points))
    return np.asarray(np.linalg.norm(points - a - along[:, None] * chord, axis=1))


def _chains(found: Indices) -> list[list[int]]:
    """Paths that use every edge once; they end at points that do not have exactly two edges."""
    neighbours: dict[int, list[int]] = defaultdict(list)
    for a, b in found.tolist():
        neighbours[a].append(b)
        neighbours[b].append(a)
    ends = [node for node, others in neighbours.items() if len(others) != 2]
    chains = []
    for start in [*ends, *neighbours]:  # open walks first; what remains are loops
        while neighbours[start]:
            chain, node = [start], start
            while neighbours[node]:
                following = neighbours[node].pop()
                neighbours[following].remove(node)
                chain.append(following)
                node = following
                if node == start or len(neighbours[node]) != 1:
                    break
            chains.append(chain)
    return chains
