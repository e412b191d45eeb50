"""Centre line of an accordion spring as leaves and arcs, for the meshes of this package."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

Tail = Literal["arc", "mid-leaf"]
Kind = Literal["leaf", "arc", "tip"]


@dataclass(frozen=True)
class Piece:
    """Leaf (turn 0) or arc of at most 90 deg that starts at (x, y); heading and turn in rad.

    A "tip" is the free part of the leaf of head or tail. `unit` is numbered from 1 at the head.
    """

    kind: Kind
    x: float
    y: float
    heading: float
    length: float
    turn: float
    unit: int

    @property
    def end(self) -> tuple[float, float]:
        """End point of the piece; the chord from (x, y) bisects the change of direction."""
        half = self.turn / 2
        chord = self.length * (math.sin(half) / half if half else 1.0)
        return (
            self.x + chord * math.cos(self.heading + half),
            self.y + chord * math.sin(self.heading + half),
        )

    @property
    def centre(self) -> tuple[float, float]:
        """Centre of curvature of an arc; for a positive turn, it is on the left."""
        radius = self.length / self.turn
        return (
            self.x - radius * math.sin(self.heading),
            self.y + radius * math.cos(self.heading),
        )


def accordion(
    *,
    n: int,
    L1: float,
    radius: float,
    alpha: float,
    tail: Tail,
    leaf: float | None = None,
    tips: bool = False,
) -> Iterator[Piece]:
    """Pieces from the middle of the head (origin, heading along y) to the support of the tail.

    `radius` is that of the centre line of the arcs; `leaf` is the straight length of the n - 2
    middle units, by default chosen so that the loops extend equally to both sides. With `tips`,
    both end leaves are complete: the path begins at the tip of the head, half a leaf before the
    origin, and ends at the tip of the tail.
    """
    if leaf is None:
        leaf = (L1 + 2 * radius * math.cos(alpha)) / math.sin(alpha)
    side, quarter = -1, radius * math.pi / 2
    plan: list[tuple[Kind, float, float, int]] = [("tip", L1 / 2, 0.0, 1)] if tips else []
    plan += [("leaf", L1 / 2, 0.0, 1), ("arc", quarter, -math.pi / 2, 1)]
    for unit in range(2, n):
        plan += [
            ("arc", radius * alpha, side * alpha, unit),
            ("leaf", leaf, 0.0, unit),
            ("arc", radius * alpha, -side * alpha, unit),
        ]
        side = -side
    plan.append(("arc", quarter, side * math.pi / 2, n))
    if tail == "mid-leaf":
        plan.append(("leaf", L1 / 2, 0.0, n))
    if tips:
        plan.append(("tip", L1 / 2 if tail == "mid-leaf" else L1, 0.0, n))
    x, y, heading = 0.0, -L1 / 2 if tips else 0.0, math.pi / 2
    for kind, length, turn, unit in plan:
        piece = Piece(kind, x, y, heading, length, turn, unit)
        yield piece
        (x, y), heading = piece.end, heading + turn
