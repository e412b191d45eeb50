"""Half a sector of a polyhedral ring, from the middle of a side of its bore to a corner.

The middle of the side is on the x axis, the corner at the angle pi/z.
"""

import math
from itertools import pairwise

from skfem.mesh import Mesh2D

from meshes.contact.blocks import Block, Edge, mesh_blocks
from meshes.contact.fan import Zone
from meshes.counts import at_least
from meshes.polyhedral.fans import BODY, across, corner_column, corner_fan, roller_fan
from meshes.polyhedral.outline import Outline

ROWS = 3  # cells across the wall on the coarsest mesh without a fine zone
NEAR = 0.7  # a fan that ends so near to the hub ends there
LONG = 3.0  # fillet over wall from which on it needs no fan
HUB = 4  # cells on the hub's stretch on the coarsest mesh
PARTS = {"rim": ("rim", "zone"), "bore": ("flat", "hub", "fillet"), "flat": ("flat", "hub")}


def half_sector(
    *,
    z: int,
    d_e: float,
    d_i: float,
    fillet: float,
    refine: int,
    zone: float | None = None,
    cells: int = 6,
    hub: tuple[float, float] | None = None,
    arc: int = 6,
    order: int = 2,
    straight: bool = False,
) -> Mesh2D:
    """Mesh of half a sector of a ring with a polygonal bore, fine at the fillet.

    The cells are mapped quadrilaterals. The bore has `z` sides; `d_e` is the outside diameter,
    `d_i` the diameter of the circle through the rounded corners, and `fillet` the radius of the
    corners. All lengths have the same unit. `refine` 1 is the coarsest mesh, 2 halves all cells,
    and so on. With a `zone`, `cells` equal cells (for `refine` 1) lie on the outside over 0 <= y <=
    `zone`, at the contact of a roller. The `hub` acts on the flat between the distances s_0 and s_1
    [length] from the middle of the side. At least `arc` cells (for `refine` 1) lie on the fillet.
    Boundaries: "rim" (whole outside) and its part "zone"; "bore" with its parts "flat" and
    "fillet"; "hub", part of the flat; the sections "mid" (y = 0) and "corner". Body: "ring".
    `order` is 1 or 2; `straight` cells have straight edges.

    Raises ValueError unless z >= 3, 0 < d_i < d_e, 0 < fillet < d_i/2, the zone is narrow relative
    to wall and sector, and the hub acts on the flat.
    """
    ring = Outline(z, d_e, d_i, fillet)
    if refine < 1:
        raise ValueError(f"refine must be at least 1, got {refine}")
    fine = None if zone is None else Zone(zone, cells, refine)
    rows = ROWS if fine is None else fine.rows
    stops = _stops(ring, hub, first=None if fine is None else ring.wall(0.0))
    if fine is not None and not 0 < fine.width <= min(ring.wall(0.0), ring.above(stops[0])[1]) / 2:
        raise ValueError(
            "the fine zone must be positive and at most half of each of two lengths: the "
            f"thickness of the wall at the middle of the side ({ring.wall(0.0):g} m), and the "
            "extent in y of the blocks below the roller, at the outer circle "
            f"({ring.above(stops[0])[1]:g} m); got zone={fine.width:g} m"
        )
    blocks = [] if fine is None else roller_fan(ring, fine, stops[0])
    for ends in pairwise(stops):
        blocks.append(_column(ring, ends, hub=ends == hub, rows=rows, refine=refine))
    if fine is None and ring.fillet * ring.angle > LONG * (ring.r_e - ring.r_i):
        rest = stops[-1], ring.half_flat
        blocks.append(_column(ring, rest, hub=False, rows=rows, refine=refine))
        blocks.append(corner_column(ring, rows, refine, arc))
    else:
        blocks += corner_fan(ring, stops[-1], rows, refine, arc)
    return mesh_blocks(blocks, order=order, straight=straight, whole=PARTS)


def _stops(ring: Outline, hub: tuple[float, float] | None, first: float | None) -> list[float]:
    """Ascending positions on the flat of the lines across the wall, which separate the blocks.

    The lines are the end of the fan at the roller, both ends of the hub, and the start of the fan
    at the corner. The width of a fan is about the local thickness of the wall. `first` is the width
    of the fan at the roller; if it is None, the first line is at 0.
    """
    end, last = ring.half_flat, ring.wall(ring.half_flat)
    if hub is None:
        share = end * (first or 0.0) / ((first or 0.0) + last)
        low, high = share, share
    else:
        low, high = hub
        if not 0 < low < high < end:
            raise ValueError(
                "the hub must act on the flat at 0 < s_0 < s_1 < "
                f"{end:g} m (half of the flat), got s_0={low:g} m, s_1={high:g} m"
            )
    start = 0.0 if first is None else (first if first < NEAR * low else low)
    stop = end - last if last < NEAR * (end - high) else high
    return sorted({start, low, high, stop})


def _column(
    ring: Outline, ends: tuple[float, float], *, hub: bool, rows: int, refine: int
) -> Block:
    """Block between two lines across the wall, with nearly square cells."""
    (a, b), (c, d) = (across(ring, s) for s in ends)
    size = min(math.dist(a, b), math.dist(c, d)) / rows
    n = refine * max(HUB if hub else 1, at_least(math.dist(a, c) / size))
    left = Edge(a, b, rows * refine, name="" if ends[0] else "mid")
    right = Edge(c, d, rows * refine)
    inside = Edge(a, c, n, name="hub" if hub else "flat")
    outside = Edge(b, d, n, (0.0, 0.0), name="rim")
    return Block((inside, right, outside, left), BODY)
