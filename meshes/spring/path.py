"""The centre line of an accordion spring as leaves and arcs, for the meshes of this package."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

Tail = Literal["arc", "mid-leaf"]


@dataclass(frozen=True)
class Piece:
    """A leaf (turn 0) or an arc of at most 90 deg from (x, y) on, heading and turn in rad."""

    kind: Literal["leaf", "arc"]
    x: float
    y: float
    heading: float
    length: float
    turn: float

    @property
    def end(self) -> tuple[float, float]:
        """Where the piece ends: along the chord, which bisects the turn."""
        half = self.turn / 2
        chord = self.length * (math.sin(half) / half if half else 1.0)
        return (
            self.x + chord * math.cos(self.heading + half),
            self.y + chord * math.sin(self.heading + half),
        )

    @property
    def centre(self) -> tuple[float, float]:
        """Centre of curvature of an arc, on its left for a positive turn."""
        radius = self.length / self.turn
        return (
            self.x - radius * math.sin(self.heading),
            self.y + radius * math.cos(self.heading),
        )


def accordion(
    *, n: int, L1: float, radius: float, alpha: float, tail: Tail, leaf: float | None = None
) -> Iterator[Piece]:
    """Pieces from the middle of the head (origin, heading along y) to where the tail is held.

    `radius` is that of the arcs' centre line; `leaf` the straight length of the n - 2 middle
    units, by default that of a spring whose loops reach equally far to both sides.
    """
    if leaf is None:
        leaf = (L1 + 2 * radius * math.cos(alpha)) / math.sin(alpha)
    side = -1
    plan: list[tuple[float, float]] = [(L1 / 2, 0.0), (radius * math.pi / 2, -math.pi / 2)]
    for _ in range(n - 2):
        plan += [(radius * alpha, side * alpha), (leaf, 0.0), (radius * alpha, -side * alpha)]
        side = -side
    plan.append((radius * math.pi / 2, side * math.pi / 2))
    if tail == "mid-leaf":
        plan.append((L1 / 2, 0.0))
    x, y, heading = 0.0, 0.0, math.pi / 2
    for length, turn in plan:
        piece = Piece("arc" if turn else "leaf", x, y, heading, length, turn)
        yield piece
        (x, y), heading = piece.end, heading + turn
