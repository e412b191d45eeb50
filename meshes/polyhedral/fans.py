"""Finely meshed ends of a half sector: below the roller, and around the fillet of the corner.

Points are in the local frame of the sector; see `half_sector`. A position `s` is the distance along
the flat from the middle of the side.
"""

import math
from dataclasses import replace

from meshes.contact.blocks import Block, Edge, Point
from meshes.contact.fan import Outline as Neighbourhood
from meshes.contact.fan import Zone, fan, graded
from meshes.counts import at_least
from meshes.polyhedral.outline import Outline

BODY = "ring"
SLENDER = 2.0  # largest length of a cell over the thickness of the wall
LEAN = 0.6  # relative to the core's depth, by which its end leans to the corner to open the fan
DEEP = 1 / 3  # of the wall at the corner, which the core around the fillet takes at most


def roller_fan(ring: Outline, zone: Zone, s: float) -> list[Block]:
    """Blocks from the middle of the side to the line across the wall at `s`, fine at the roller.

    `s` is the distance along the flat from the middle of the side.
    """
    middle = (ring.apothem, 0.0)
    # the fan's frame has its origin on the outside, the surface along x and the body in y <= 0
    places = {(y, x - ring.r_e): (x, y) for x, y in (*across(ring, s), middle)}
    far, end, foot = places

    def place(point: Point) -> Point:
        return places.get(point, (ring.r_e + point[1], point[0]))

    def placed(edge: Edge) -> Edge:
        centre = None if edge.centre is None else place(edge.centre)
        name = "mid" if edge.name == "axis" else edge.name
        if name == "rim" and edge.start == (0.0, 0.0):
            name = "zone"
        start, end = place(edge.start), place(edge.end)
        return replace(edge, start=start, end=end, centre=centre, name=name)

    far, end, foot = places
    around = Neighbourhood(end, far, foot, ("rim", "", "flat"), centre=-ring.r_e)
    found = []
    for block in fan(around, zone, BODY):
        a, b, c, d = (placed(edge) for edge in block.edges)
        found.append(Block((a, b, c, d), BODY))
    return found


def across(ring: Outline, s: float) -> tuple[Point, Point]:
    """Ends of the line across the wall at `s`: on the flat, and on the outer circle."""
    return (ring.apothem, s), ring.above(s)


def corner_fan(ring: Outline, s: float, rows: int, refine: int, arc: int) -> list[Block]:
    """Blocks from the line across the wall at `s` to the corner, fine around the fillet.

    With `refine` 1, at least `arc` cells lie on the fillet. The same number of cells lies opposite
    to it on the outer circle.
    """
    n, depth = _core(ring, rows, arc)
    start, bottom = (ring.apothem, ring.half_flat), ring.on_corner_ray(ring.r_i)
    x, y = ring.fillet_centre
    far = ring.fillet + depth
    lean = min(LEAN * depth / far, ring.angle / 3)
    deep = (x + far * math.cos(lean), y + far * math.sin(lean))
    below = ring.on_corner_ray(ring.r_i + depth)
    foot, top = across(ring, s)
    beyond = ring.on_corner_ray(ring.r_e)
    fine = Edge(start, bottom, n * refine, (x, y), name="fillet")
    inside = Edge(deep, below, n * refine, (x, y))
    side = Edge(start, deep, rows * refine)
    stem = Edge(bottom, below, rows * refine, name="corner")
    along, down = ring.fillet * ring.angle / n, depth / rows
    grown = [
        (Edge(start, foot, 0, name="flat"), along),
        (Edge(deep, top, 0), math.sqrt(2) * down),
        (Edge(below, beyond, 0, name="corner"), down),
    ]
    out, diagonal, cut = graded(grown, refine)
    end = Edge(foot, top, rows * refine, name="" if s else "mid")
    last = Edge(beyond, top, n * refine, (0.0, 0.0), name="rim")
    return [
        Block((fine, side, inside, stem), BODY),
        Block((out, end, diagonal, side), BODY),
        Block((inside, diagonal, last, cut), BODY),
    ]


def corner_column(ring: Outline, rows: int, refine: int, arc: int) -> Block:
    """Block over a fillet whose arc is much longer than the thickness of the wall.

    A finer mesh is not required at such a fillet. The slender cells of a fan would add an error of
    third order in h to the error of fourth order; for some rings, the two errors have
    opposite signs.
    """
    bottom, top = ring.on_corner_ray(ring.r_i), ring.on_corner_ray(ring.r_e)
    start, above = across(ring, ring.half_flat)
    wall = ring.r_e - ring.r_i
    n = refine * max(arc, at_least(ring.fillet * ring.angle * rows / wall))
    fine = Edge(start, bottom, n, ring.fillet_centre, name="fillet")
    rim = Edge(above, top, n, (0.0, 0.0), name="rim")
    left = Edge(start, above, rows * refine)
    return Block((fine, Edge(bottom, top, rows * refine, name="corner"), rim, left), BODY)


def _core(ring: Outline, rows: int, least: int) -> tuple[int, float]:
    """Number of cells along the fillet, and depth of the core (the fine cells around the fillet).

    The core has `rows` layers of square cells if the wall is thick enough. In a thin wall, the
    cells are flatter; they are then so short that the arc of a cell departs from its tangent by at
    most the thickness of the cell.
    """
    arc, wall = ring.fillet * ring.angle, ring.r_e - ring.r_i
    n = max(least, at_least(arc / (SLENDER * wall)))
    depth = min(rows * arc / n, DEEP * wall)
    return max(n, at_least(arc / math.sqrt(2 * ring.fillet * depth / rows))), depth
