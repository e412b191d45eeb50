"""A strip that is touched at one place of its surface, the plane from which a race is bent.

The surface lies on y = 0 and is touched at the origin, the body below. Each side of it ends in a
cut, and the nodes of both cuts have the same places in y.
"""

from dataclasses import dataclass

from meshes.contact.blocks import Block, Edge
from meshes.contact.fan import Outline, Zone, fan, strip_cells

SLIM = 1.5  # a longer side goes on beside a fan about as wide as deep, in even cells


@dataclass(frozen=True)
class Side:
    """Half of the surface: the name and end [length, from the origin] of each part, outwards."""

    parts: tuple[tuple[str, float], ...]
    cut: str

    @property
    def reach(self) -> float:
        """Length of the part that is touched."""
        return self.parts[0][1]


@dataclass(frozen=True)
class Strip:
    """The strip between the cuts of `left` and `right`, `depth` deep, and how fine it is."""

    left: Side
    right: Side
    depth: float
    base: str
    body: str
    zone: Zone

    def blocks(self) -> list[Block]:
        """A fan on each side of the origin, and even blocks beside and below them."""
        sides = self.left, self.right
        # both fans share their axis, and need as many cells along it
        least = max(self._half(side)[1].edges[0].cells for side in sides) // self.zone.refine
        left, right = (self._half(side, least) for side in sides)
        return [block.mirrored(-1, 1) for block in left] + right

    @property
    def _deep(self) -> float:
        """How deep the fans reach."""
        reach = min(self.left.reach, self.right.reach)
        return self.depth if self.depth <= SLIM * reach else reach

    def _half(self, side: Side, least: int = 1) -> list[Block]:
        deep, fine = self._deep, self.zone
        name, reach = side.parts[0]
        width = reach if reach <= SLIM * deep else deep
        rest = [(name, reach)] * (width < reach) + list(side.parts[1:])
        below = deep < self.depth
        names = name, "" if rest else side.cut, "" if below else self.base
        outline = Outline((width, 0.0), (width, -deep), (0.0, -deep), names)
        blocks = fan(outline, fine, self.body, least=least)
        surface, axis = blocks[1].edges[0], blocks[2].edges[3]
        columns = [(0.0, width, fine.cells * fine.refine, name)]
        for part, end in rest:
            start = columns[-1][1]
            columns.append((start, end, strip_cells(surface, fine, length=end - start), part))
        rows = fine.rows * fine.refine
        blocks += [self._rectangle(column, (0.0, -deep, rows), side) for column in columns[1:]]
        if below:
            rows = strip_cells(axis, fine, length=self.depth - deep)
            blocks += [self._rectangle(c, (-deep, -self.depth, rows), side) for c in columns]
        return blocks

    def _rectangle(
        self,
        column: tuple[float, float, int, str],
        row: tuple[float, float, int],
        side: Side,
    ) -> Block:
        (x, end, n, part), (y, bottom, m) = column, row
        outer = side.cut if end == side.parts[-1][1] else ""
        edges = (
            Edge((x, y), (end, y), n, name=part if y == 0 else ""),
            Edge((end, y), (end, bottom), m, name=outer),
            Edge((x, bottom), (end, bottom), n, name=self.base if bottom == -self.depth else ""),
            Edge((x, y), (x, bottom), m),
        )
        return Block(edges, self.body)
