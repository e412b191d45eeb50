"""The blocks about a contact: a fine core at the origin and two blocks that fan out from it."""

import math
from dataclasses import dataclass, replace

from meshes.contact.blocks import Block, Edge, Point
from meshes.contact.grading import beta, cells_along, last_cell

DEEP = 2 / 3  # depth of the core over its width: the largest shear of a line contact lies inside
GROWTH = 1.5  # how much longer than the one before a cell of the coarsest mesh is at most
SQUAT = 0.3  # of the thickness of a strip: the longest cell along it


@dataclass(frozen=True)
class Zone:
    """The fine core: `width` along the surface in x, `cells` on it, on the mesh `refine` 1.

    `refine` 2 halves every cell of the mesh, and so on.
    """

    width: float
    cells: int
    refine: int

    def __post_init__(self) -> None:
        for name, value in (("cells", self.cells), ("refine", self.refine)):
            if value < 1:
                raise ValueError(f"a fine zone needs {name} >= 1, got {value}")

    @property
    def depth(self) -> float:
        """About two thirds of the width, in cells that are square."""
        return self.width * self.rows / self.cells

    @property
    def rows(self) -> int:
        return max(1, round(DEEP * self.cells))


@dataclass(frozen=True)
class Outline:
    """A neighbourhood of the origin in x >= 0, y <= 0, with four corners.

    The surface leads from the origin to `end`, the axis to `foot`, and `far` lies opposite the
    origin. The surface is an arc about (0, `centre`), the base from `far` to `foot` one about
    (0, `base`); None for lines. Names of boundaries: of the surface, from `end` to `far`, the base.
    """

    end: Point
    far: Point
    foot: Point
    names: tuple[str, str, str]
    centre: float | None = None
    base: float | None = None

    def edge_of(self, zone: Zone) -> tuple[Point, Point]:
        """Where the core ends on the surface, and its corner `zone.depth` inside the body."""
        x, c = zone.width, self.centre
        if c is None:
            return (x, 0.0), (x, -zone.depth)
        y = c - math.copysign(math.sqrt(c**2 - x**2), c)
        scale = (c + zone.depth) / c
        return (x, y), (scale * x, c + scale * (y - c))


def fan(outline: Outline, zone: Zone, body: str, bend: Point | None = None) -> list[Block]:
    """Core, block along the surface and block along the axis.

    The diagonal between the two is an arc about `bend`, a line without one.
    """
    o, n, m = (0.0, 0.0), zone.cells * zone.refine, zone.rows * zone.refine
    brink, corner = outline.edge_of(zone)
    below, down = (0.0, -zone.depth), outline.names
    centre, base = (c if c is None else (0.0, c) for c in (outline.centre, outline.base))
    foot = Edge(o, brink, n, centre, name=down[0])
    bottom = Edge(below, corner, n, centre)
    stem, side = Edge(o, below, m, name="axis"), Edge(brink, corner, m)
    first = foot.length / zone.cells, zone.depth / zone.rows
    out, diagonal, axis = graded(
        [
            (Edge(brink, outline.end, 0, centre, name=down[0]), first[0]),
            (Edge(corner, outline.far, 0, bend), math.hypot(*first)),
            (Edge(below, outline.foot, 0, name="axis"), first[1]),
        ],
        zone.refine,
    )
    end = Edge(outline.end, outline.far, m, name=down[1])
    last = Edge(outline.foot, outline.far, n, base, name=down[2])
    return [
        Block((foot, side, bottom, stem), body),
        Block((out, end, diagonal, side), body),
        Block((bottom, diagonal, last, axis), body),
    ]


def strip_cells(beside: Edge, zone: Zone, *, length: float, thickness: float) -> int:
    """How many even cells go on from a graded edge over `length` of a strip.

    They are no longer than GROWTH times the edge's last cell and SQUAT times `thickness`.
    """
    last = last_cell(length=beside.length, cells=beside.cells // zone.refine, beta=beside.beta)
    return zone.refine * math.ceil(length / min(GROWTH * last, SQUAT * thickness))


def graded(edges: list[tuple[Edge, float]], refine: int) -> list[Edge]:
    """The edges, all with as many cells, growing from their sizes at the start at `refine` 1."""
    cells = max(
        cells_along(length=edge.length, first=first, growth=GROWTH) for edge, first in edges
    )
    return [
        replace(
            edge,
            cells=cells * refine,
            beta=beta(length=edge.length, first=first, cells=cells),
        )
        for edge, first in edges
    ]
