"""Plane strip that is mapped to a race, with a contact at one point of its surface.

The surface is y = 0, with the contact at the origin and the body below. A section bounds the strip
on each side; the nodes of both sections have the same y.
"""

import math
from dataclasses import dataclass, replace

from meshes.contact.blocks import Block, Edge
from meshes.contact.fan import Outline, Zone, fan, graded
from meshes.contact.grading import last_cell
from meshes.counts import at_least

SLIM = 1.5  # a longer side goes on beside a fan about as wide as deep, in growing cells
LONG = 0.6  # over the width across the strip, how long its cells far from the contact are about


@dataclass(frozen=True)
class Side:
    """Half of the surface of a strip, divided into `parts` from the origin outwards.

    Each part has a name and an end, given as its distance [length] from the origin.
    """

    parts: tuple[tuple[str, float], ...]
    cut: str

    @property
    def reach(self) -> float:
        """Length of the first part, in which the contact lies."""
        return self.parts[0][1]


@dataclass(frozen=True)
class Strip:
    """Strip with the halves `left` and `right` of its surface, the `depth` and the fine `zone`."""

    left: Side
    right: Side
    depth: float
    base: str
    body: str
    zone: Zone

    def blocks(self) -> list[Block]:
        """Fans on both sides of the origin, and blocks beside and below the fans."""
        sides = self.left, self.right
        # both fans share their axis, and need as many cells along it
        least = max(self._half(side)[1].edges[0].cells for side in sides) // self.zone.refine
        left, right = (self._half(side, least) for side in sides)
        return [block.mirrored(-1, 1) for block in left] + right

    @property
    def _deep(self) -> float:
        """Depth of the fans."""
        reach = min(self.left.reach, self.right.reach)
        return self.depth if self.depth <= SLIM * reach else reach

    def _half(self, side: Side, least: int = 1) -> list[Block]:
        deep, fine = self._deep, self.zone
        name, reach = side.parts[0]
        # the core is that much wider than deep: so the fan's diagonal runs at half a right angle
        square = deep + fine.width - fine.depth
        width = reach if reach <= SLIM * square else square
        rest = list(side.parts if width < reach else side.parts[1:])
        below = deep < self.depth
        names = name, "" if rest else side.cut, "" if below else self.base
        outline = Outline((width, 0.0), (width, -deep), (0.0, -deep), names)
        blocks = fan(outline, fine, self.body, least=least)
        columns = [Edge((0.0, 0.0), (width, 0.0), fine.cells * fine.refine, name=name)]
        columns += _beyond(blocks[1].edges[0], rest, fine.refine, LONG * self.depth)
        fanned = Edge((0.0, 0.0), (0.0, -deep), fine.rows * fine.refine)
        blocks += [self._rectangle(column, fanned, side) for column in columns[1:]]
        if below:
            longest = LONG * (self.left.parts[-1][1] + self.right.parts[-1][1])
            (row,) = _beyond(blocks[2].edges[3], [("", self.depth)], fine.refine, longest)
            blocks += [self._rectangle(column, row, side) for column in columns]
        return blocks

    def _rectangle(self, column: Edge, row: Edge, side: Side) -> Block:
        """Block with the width of `column` and the height of `row`."""
        x, end, y, bottom = column.start[0], column.end[0], row.start[1], row.end[1]
        cut = side.cut if math.isclose(end, side.parts[-1][1]) else ""
        base = self.base if math.isclose(bottom, -self.depth) else ""
        edges = (
            replace(column, start=(x, y), end=(end, y), name=column.name if y == 0 else ""),
            replace(row, start=(end, y), end=(end, bottom), name=cut),
            replace(column, start=(x, bottom), end=(end, bottom), name=base),
            replace(row, start=(x, y), end=(x, bottom), name=""),
        )
        return Block(edges, self.body)


def _beyond(edge: Edge, parts: list[tuple[str, float]], refine: int, longest: float) -> list[Edge]:
    """Edges that continue the line of `edge` to the end of each part, with growing cells.

    The mean cell length is at most `longest` for `refine` 1.
    """
    found = []
    for name, end in parts:
        share = end / math.hypot(*edge.end)
        there = edge.end[0] * share, edge.end[1] * share
        size = last_cell(length=edge.length, cells=edge.cells // refine, beta=edge.beta)
        new = Edge(edge.end, there, 0, name=name)
        (edge,) = graded([(new, size)], refine, least=at_least(new.length / longest))
        found.append(edge)
    return found
