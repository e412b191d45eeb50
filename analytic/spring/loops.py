"""Centre line of the accordion spring, with the loops that its free tips close.

Head and tail are whole leaves of length L_1, fixed in their middles. The half of each leaf beyond
the middle is free until its tip touches the next leaf. The coordinates are those of
`analytic.spring.frame`: the origin is the middle of the head, whose leaf is along y; the force acts
along x.
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
    """Pair of a tip and the point of the next leaf that it will touch, under opposite unit forces.

    The unit forces cause in a section at (x, y) the couple `moment` . (1, x, y) and the force
    `force`. The pair of forces loads the line from the tip to the touched point: `with_tip`. `loop`
    is this line without the free half leaf; the force of the spring also acts on it. `distance` is
    measured between centre lines, `gap` between surfaces.
    """

    moment: Array
    force: Array
    loop: Wire
    with_tip: Wire
    distance: Array
    gap: Array


@dataclass(frozen=True)
class Line:
    """Line from the middle of the head to the clamp: its second moments and its contact pairs.

    `tops` (..., n - 1, 3) contains one point (1, x, y) for each loop: the point with the largest
    distance from the line of the force.
    """

    whole: Wire
    head: Pair
    tail: Pair
    tops: Array


@dataclass
class _Pen:
    """End of a partly assembled line, and the second moments of this line."""

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
        """Copy of this end and of the line that leads to it."""
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

    `normal` is the direction of the forces between tip and leaf: that of the "force" of the spring,
    or the normal of the unloaded "leaf". Arrays broadcast.
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
    """Point opposite to `tip` on the leaf ahead of `unit`, direction to this point, distance."""
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
    """Line from the middle of the head to `place` on the leaf ahead of `unit`."""
    s = np.hypot(*np.moveaxis(place - unit.at, -1, 0))
    return unit.drawn + leaf(unit.at, unit.heading, np.asarray(s))[0]


def _couple(at: Array, force: Array) -> Array:
    """Coefficients of (1, x, y) in the couple y' F_x - x' F_y, with x', y' relative to `at`."""
    x, y = np.moveaxis(at, -1, 0)
    f_x, f_y = np.moveaxis(force, -1, 0)
    return np.stack([x * f_y - y * f_x, -f_y, f_x], axis=-1)
