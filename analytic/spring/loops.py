"""The accordion spring's centre line as a wire, with the two loops that its free tips close.

Head and tail are whole leaves of the length L_1, fixed in their middles; the half of each beyond
the middle is free until its tip touches the next leaf. Coordinates as in `analytic.spring.frame`:
the origin is the middle of the head, whose leaf is along y; the force acts along x.
"""

from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.spring.wire import Wire, arc, leaf

Array = NDArray[np.float64]
Tail = Literal["arc", "mid-leaf"]
Normal = Literal["force", "leaf"]
QUARTER = np.pi / 2


@dataclass(frozen=True)
class Pair:
    """A tip, and the point of the next leaf that it will touch, loaded by opposite unit forces.

    They load a section at (x, y) with the couple `moment` . (1, x, y) and the force `force`:
    on `loop` together with the spring's force; `with_tip` contains the free half leaf, too.
    `distance` is from centre line to centre line, `gap` the distance minus the thickness.
    """

    moment: Array
    force: Array
    loop: Wire
    with_tip: Wire
    distance: Array
    gap: Array


@dataclass(frozen=True)
class Line:
    """Second moments of the line from the middle of the head to the clamp, and both pairs.

    `tops` (..., n - 1, 3) are the most distant places (1, x, y) from the force's line, one a loop.
    """

    whole: Wire
    head: Pair
    tail: Pair
    tops: Array


@dataclass
class _Pen:
    """End of the line as far as it is assembled, and its second moments up to there."""

    at: Array
    heading: Array
    drawn: Wire = field(init=False)

    def __post_init__(self) -> None:
        shape = self.heading.shape
        self.drawn = Wire(np.zeros((*shape, 3, 3)), np.zeros((*shape, 2, 2)))

    def leaf(self, length: Array) -> "_Pen":
        wire, self.at = leaf(self.at, self.heading, length)
        self.drawn += wire
        return self

    def arc(self, radius: Array, turn: Array) -> "_Pen":
        wire, self.at = arc(self.at, self.heading, radius, turn)
        self.drawn, self.heading = self.drawn + wire, self.heading + turn
        return self

    def here(self) -> "_Pen":
        """A second pen at the same place, with the same line behind it."""
        other = _Pen(self.at, self.heading)
        other.drawn = self.drawn
        return other


def line(
    *,
    n: int,
    L1: ArrayLike,
    radius: ArrayLike,
    alpha: ArrayLike,
    b: ArrayLike,
    straight: ArrayLike,
    tail: Tail,
    normal: Normal,
) -> Line:
    """Line of n segments with arcs of `radius` and middle leaves of the length `straight`.

    `normal` is the direction of the forces between tip and leaf: that of the "force" of the
    spring, or the normal of the unloaded "leaf". Arrays broadcast.
    """
    L1, R, alpha, b, straight = np.broadcast_arrays(
        *(np.asarray(v, float) for v in (L1, radius, alpha, b, straight))
    )
    a, quarter = L1 / 2, np.full(L1.shape, QUARTER)
    pen = _Pen(np.zeros((*L1.shape, 2)), quarter)
    head_tip = pen.at - _along(pen.heading, a)
    pen.leaf(a).arc(R, -quarter)
    units, tops, side = [], [pen.at], -1
    for _ in range(2, n):
        units.append(pen.arc(R, side * alpha).here())
        pen.leaf(straight).arc(R, -side * alpha)
        tops.append(pen.at)
        side = -side
    end = pen.arc(R, side * quarter).here()
    tail_tip = end.at + _along(end.heading, L1)
    half = pen.leaf(a).drawn - end.drawn
    whole = pen.drawn if tail == "mid-leaf" else end.drawn
    nothing = half - half
    head_foot, head_n, head_d = _foot(head_tip, units[0], normal)
    tail_foot, tail_n, tail_d = _foot(tail_tip, units[-1], normal)
    before = _up_to(units[0], head_foot)
    free = leaf(head_tip, quarter, a)[0]
    after = whole - _up_to(units[-1], tail_foot)
    bent = leaf(end.at + _along(end.heading, a), end.heading, a)[0]
    thin = b / 2 * (1 + 1 / np.sin(alpha)) * (np.sin(alpha) if normal == "leaf" else 1.0)
    return Line(
        whole,
        # from the head, the force on the tip precedes a section; so does that on the tail's leaf
        Pair(_couple(head_tip, -head_n), -head_n, before, before + free, head_d, head_d - thin),
        Pair(_couple(tail_foot, tail_n), tail_n, after,
             after + (bent if tail == "mid-leaf" else nothing), tail_d, tail_d - thin),
        np.concatenate([np.ones((*L1.shape, n - 1, 1)), np.stack(tops, axis=-2)], axis=-1),
    )  # fmt: skip


def _along(heading: Array, length: Array) -> Array:
    return np.stack([np.cos(heading), np.sin(heading)], axis=-1) * length[..., None]


def _foot(tip: Array, unit: _Pen, normal: Normal) -> tuple[Array, Array, Array]:
    """Intersection of the normal through `tip` with the leaf ahead of `unit`; normal; distance."""
    t = _along(unit.heading, np.ones_like(unit.heading))
    across = np.stack([-t[..., 1], t[..., 0]], axis=-1)
    away = ((unit.at - tip) * across).sum(axis=-1)
    across, away = across * np.sign(away)[..., None], abs(away)
    if normal == "leaf":
        direction, distance = across, away
    else:
        direction = np.zeros_like(across)
        direction[..., 0] = np.sign(across[..., 0])
        distance = away / abs(across[..., 0])
    return tip + direction * distance[..., None], direction, distance


def _up_to(unit: _Pen, place: Array) -> Wire:
    """The line from the head's middle to `place` on the leaf ahead of `unit`."""
    s = np.hypot(*np.moveaxis(place - unit.at, -1, 0))
    return unit.drawn + leaf(unit.at, unit.heading, np.asarray(s))[0]


def _couple(at: Array, force: Array) -> Array:
    """Coefficients (1, x, y) of a section's couple y' F_x - x' F_y, x' and y' counted from `at`."""
    x, y = np.moveaxis(at, -1, 0)
    f_x, f_y = np.moveaxis(force, -1, 0)
    return np.stack([x * f_y - y * f_x, -f_y, f_x], axis=-1)
