"""Where a formula may be used: the points of a grid at which its error stays within a limit.

A point is inside a limit where the whole error bar is, outside where all of it is beyond, and
undecided between. A box is a product of ranges of the axes, all of whose points are inside.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from verify.shown import Array

LIMITS = (0.02, 0.05, 0.10)  # of the error
INSIDE, OUTSIDE, UNDECIDED, UNSOLVED = 1, -1, 0, -9
MOST_BOXES = 2_000_000  # that are looked at; beyond, boxes grow from the base point alone

Verdicts = NDArray[np.int8]


@dataclass(frozen=True)
class Box:
    """Ranges of indices, both ends included, one for each axis, and how many points they hold."""

    ranges: tuple[tuple[int, int], ...]
    points: int


@dataclass(frozen=True)
class Step:
    """What takes the formula out of a limit soonest from a base point: an axis and a direction.

    `last` is the index of the last value inside, `first` that of the first value that isn't, and
    `share` how far that is of the way to the axis's end.
    """

    axis: int
    last: int
    first: int
    share: float


def verdicts(error: Array, U_error: Array, limit: float) -> Verdicts:
    """INSIDE, OUTSIDE, UNDECIDED or UNSOLVED for errors with their bars, of any shape."""
    size = np.abs(error)
    found = np.full(size.shape, UNDECIDED, dtype=np.int8)
    with np.errstate(invalid="ignore"):
        found[size + U_error <= limit] = INSIDE
        found[size - U_error > limit] = OUTSIDE
    found[~(np.isfinite(error) & np.isfinite(U_error))] = UNSOLVED
    return found


def largest_box(inside: NDArray[np.bool_]) -> Box | None:
    """The box with the most points, all inside, in a grid of any dimension; None where none is.

    Of boxes alike, the one that reaches furthest on the first axes.
    """
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
    lengths = [np.array([j - i + 1 for i, j in e]) for e in ends]
    volume = lengths[0]
    for one in lengths[1:]:
        volume = np.multiply.outer(volume, one)
    full = np.where(whole == volume, volume, 0)
    if not full.any():
        return None
    best = np.unravel_index(int(full.argmax()), full.shape)
    return Box(tuple(ends[k][n] for k, n in enumerate(best)), int(full.max()))


def _grown(inside: NDArray[np.bool_]) -> Box | None:
    """A box that grows from the point with the most neighbours inside, side by side."""
    if not inside.any():
        return None
    near = inside.astype(np.float64)
    for axis in range(inside.ndim):
        near = near + np.roll(near, 1, axis) + np.roll(near, -1, axis)
    start = np.unravel_index(int(np.where(inside, near, -1).argmax()), inside.shape)
    ranges = [(int(i), int(i)) for i in start]
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


def first_break(inside: NDArray[np.bool_], base: Sequence[int]) -> Step | None:
    """The axis along which the limit is left soonest from `base`, all others held; None if never.

    Soonest is by the share of the way to the end of the axis.
    """
    found: list[Step] = []
    for axis, n in enumerate(inside.shape):
        line = inside[tuple(slice(None) if k == axis else i for k, i in enumerate(base))]
        for step, end in ((1, n - 1), (-1, 0)):
            way = range(base[axis] + step, end + step, step)
            out = next((i for i in way if not line[i]), None)
            if out is not None:
                share = abs(out - base[axis]) / abs(end - base[axis])
                found.append(Step(axis, out - step, out, share))
    return min(found, key=lambda s: s.share, default=None)


def crossing(x: Array, error: Array, limit: float) -> tuple[float, ...]:
    """Where |error| passes `limit` along sorted values `x` (n,), between solved neighbours."""
    size = np.abs(error) - limit
    found = []
    for k in range(len(x) - 1):
        a, b = size[k], size[k + 1]
        if np.isfinite(a) and np.isfinite(b) and (a > 0) != (b > 0):
            found.append(float(x[k] + (x[k + 1] - x[k]) * a / (a - b)))
    return tuple(found)
