"""Largest box of a grid in which all points meet a condition."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

MOST_BOXES = 2_000_000  # that are looked at; beyond, one box grows until it can't

Flags = NDArray[np.bool_]


@dataclass(frozen=True)
class Box:
    """Box of grid points: range of indices on each axis, ends included, and number of points."""

    ranges: tuple[tuple[int, int], ...]
    points: int


def largest_box(inside: Flags) -> Box | None:
    """Largest box that contains only grid points with `inside` True; None if there is no box.

    The grid can have any number of dimensions.
    Of several largest boxes, the first in the order of the axes is returned. In grids with more
    than MOST_BOXES boxes, the result is a box that cannot be widened, although a larger box may
    exist.
    """
    if not inside.any():
        return None
    ends = [[(i, j) for i in range(n) for j in range(i, n)] for n in inside.shape]
    if np.prod([len(e) for e in ends], dtype=float) > MOST_BOXES:
        return _grown(inside)
    whole = np.pad(inside.astype(np.int64), [(1, 0)] * inside.ndim)
    for axis in range(inside.ndim):
        whole = whole.cumsum(axis=axis)
    # the sum over each box from the running sums at its corners
    for axis, pairs in enumerate(ends):
        low, high = (np.array(side) for side in zip(*pairs, strict=True))
        whole = np.take(whole, high + 1, axis=axis) - np.take(whole, low, axis=axis)
    volume = np.ones((), dtype=np.int64)
    for one in ends:
        volume = np.multiply.outer(volume, np.array([j - i + 1 for i, j in one]))
    full = np.where(whole == volume, volume, 0)
    best = np.unravel_index(int(full.argmax()), full.shape)
    return Box(tuple(ends[k][n] for k, n in enumerate(best)), int(full.max()))


def _grown(inside: Flags) -> Box:
    """Box grown from the innermost point, one side at a time, until no side can move."""
    ranges = [(int(i), int(i)) for i in _deepest(inside)]
    growing = True
    while growing:
        growing = False
        for axis, side in product(range(inside.ndim), (-1, 1)):
            low, high = ranges[axis]
            wider = (low - 1, high) if side < 0 else (low, high + 1)
            if wider[0] < 0 or wider[1] >= inside.shape[axis]:
                continue
            tried = [*ranges[:axis], wider, *ranges[axis + 1 :]]
            if inside[tuple(slice(i, j + 1) for i, j in tried)].all():
                ranges, growing = tried, True
    return Box(tuple(ranges), int(np.prod([j - i + 1 for i, j in ranges])))


def _deepest(inside: Flags) -> Sequence[int]:
    """Indices of the point that is most distant from points where `inside` is False.

    The edge of the grid does not count as such a point. Outer layers are removed repeatedly as long
    as points remain.
    """
    left = inside
    while True:
        less = left
        for axis in range(inside.ndim):
            padded = np.pad(less, [(int(k == axis), int(k == axis)) for k in range(inside.ndim)],
                            mode="edge")  # fmt: skip
            n = inside.shape[axis]
            less = less & np.take(padded, range(n), axis) & np.take(padded, range(2, n + 2), axis)
        if not less.any() or (less == left).all():
            return [int(i) for i in np.argwhere(left)[len(np.argwhere(left)) // 2]]
        left = less
