"""Blocks about a contact: a fine core at the origin, and two blocks that fan out from the core."""

import math
from dataclasses import dataclass, replace

from meshes.contact.blocks import Block, Edge, Point
from meshes.contact.grading import beta, cells_along, last_cell
from meshes.counts import at_least

# For a smooth pressure on two thirds of a disc's zone (zone/R = 0.015) the energy errs by 2e-4 on
# the coarsest mesh and 7e-7 on the fourth: growth by 1.3 and a core as deep as 2/3 of its width
# halve that, for 1.7 times the unknowns.
DEEP = 1 / 2  # depth of the core over its width
GROWTH = 1.6  # largest ratio of the lengths of successive cells of the coarsest mesh


@dataclass(frozen=True)
class Zone:
    """Fine core with the given `width` in x along the surface, and `cells` cells over the width.

    This number of cells applies to `refine` 1; `refine` 2 halves every cell of the mesh, and so on.
    """

    width: float
    cells: int
    refine: int

    def __post_init__(self) -> None:
        for name, value in (("cells", self.cells), ("refine", self.refine)):
            if value < 1:
                raise ValueError(f"a fine zone requires {name} >= 1, got {value}")

    @property
    def depth(self) -> float:
        """Depth of the core: about half its width, so that its cells are square."""
        return self.width * self.rows / self.cells

    @property
    def rows(self) -> int:
        return max(1, round(DEEP * self.cells))


@dataclass(frozen=True)
class Outline:
    """Outline of a region at the origin in x >= 0, y <= 0, with four corners.

    The surface extends from the origin to `end`, the axis from the origin to `foot`; `far` is the
    corner opposite to the origin. The surface is an arc about (0, `centre`), the base from `far` to
    `foot` an arc about (0, `base`); None denotes straight lines. `names` are those of the surface,
    of the side from `end` to `far`, and of the base.
    """

    end: Point
    far: Point
    foot: Point
    names: tuple[str, str, str]
    centre: float | None = None
    base: float | None = None


def core(zone: Zone, centre: float | None) -> tuple[Point, Point]:
    """End of the core on the surface, and corner of the core inside the body.

    The surface is an arc about (0, `centre`), or a straight line if `centre` is None.
    """
    x = zone.width
    if centre is None:
        return (x, 0.0), (x, -zone.depth)
    y = centre - math.copysign(math.sqrt(centre**2 - x**2), centre)
    scale = (centre + zone.depth) / centre
    return (x, y), (scale * x, centre + scale * (y - centre))


def fan(
    outline: Outline, zone: Zone, body: str, bend: Point | None = None, *, least: int = 1
) -> list[Block]:
    """Three blocks: a core, a block along the surface, and a block along the axis.

    The diagonal between the two outer blocks is an arc about `bend`, or a line. With `refine` 1,
    there are at least `least` cells outwards, because two fans with a common axis must have equal
    numbers of cells.
    """
    n, m = zone.cells * zone.refine, zone.rows * zone.refine
    centre, around = (c if c is None else (0.0, c) for c in (outline.centre, outline.base))
    surface, beyond, base = outline.names
    origin, below = (0.0, 0.0), (0.0, -zone.depth)
    brink, corner = core(zone, outline.centre)
    fine = Edge(origin, brink, n, centre, name=surface)
    inside = Edge(below, corner, n, centre)
    stem = Edge(origin, below, m, name="axis")
    side = Edge(brink, corner, m)
    along, down = fine.length / zone.cells, zone.depth / zone.rows
    grown = [
        (Edge(brink, outline.end, 0, centre, name=surface), along),
        (Edge(corner, outline.far, 0, bend), math.hypot(along, down)),
        (Edge(below, outline.foot, 0, name="axis"), down),
    ]
    out, diagonal, axis = graded(grown, zone.refine, least=least)
    end = Edge(outline.end, outline.far, m, name=beyond)
    last = Edge(outline.foot, outline.far, n, around, name=base)
    return [
        Block((fine, side, inside, stem), body),
        Block((out, end, diagonal, side), body),
        Block((inside, diagonal, last, axis), body),
    ]


def strip_cells(beside: Edge, zone: Zone, *, length: float) -> int:
    """Number of equal cells over `length`, about as long as the last cell of the edge `beside`.

    No cell is longer than GROWTH times this last cell, whose length is about two fifths of the
    thickness of the fan.
    """
    last = last_cell(length=beside.length, cells=beside.cells // zone.refine, beta=beside.beta)
    return zone.refine * at_least(length / (GROWTH * last))


def graded(edges: list[tuple[Edge, float]], refine: int, *, least: int = 1) -> list[Edge]:
    """Edges with equal numbers of graded cells; the size of the first cell is given per edge."""
    n = max(cells_along(length=edge.length, first=size, growth=GROWTH) for edge, size in edges)
    n = max(n, least)
    return [
        replace(edge, cells=n * refine, beta=beta(length=edge.length, first=size, cells=n))
        for edge, size in edges
    ]
