"""Ring with a contact on its bore at the origin, such as the race around a roller."""

import math

from skfem.mesh import Mesh2D

from meshes.contact.blocks import Block, Edge, Point, mesh_blocks
from meshes.contact.fan import Outline, Zone, core, fan, strip_cells


def half_race(
    *,
    r_i: float,
    r_o: float,
    zone: float,
    refine: int,
    cells: int = 6,
    order: int = 2,
    straight: bool = False,
) -> Mesh2D:
    """Mesh of the half x >= 0 of the ring about (0, r_i), fine at the origin on its bore.

    With `refine` 1, `cells` equal cells lie on the bore over 0 <= x <= `zone` [unit of r_i]; cells
    are larger outside. `refine` 2 halves all cells, and so on. Boundaries: "bore", "rim" and "axis"
    (x = 0, both sections). Body: "race". `order` is 1 or 2; `straight` cells have straight edges.
    Raises ValueError unless 0 < r_i < r_o, 0 < zone <= r_i/2 and zone < r_o - r_i.
    """
    if not 0 < r_i < r_o < math.inf:
        raise ValueError(f"a race must have 0 < r_i < r_o, got r_i={r_i:g} m, r_o={r_o:g} m")
    if not 0 < zone <= r_i / 2 or not zone < r_o - r_i:
        raise ValueError(
            "the fine zone of a race must have 0 < zone <= r_i/2 and zone < r_o - r_i, got "
            f"zone={zone:g} m, r_i={r_i:g} m, r_o={r_o:g} m"
        )
    fine, wall, centre = Zone(zone, cells, refine), r_o - r_i, (0.0, r_i)
    # in the plane of angle and ln r, a conformal map, the fan is a square beside the core
    brink = math.asin(zone / r_i)
    angle = min(math.pi / 2, brink + math.log(r_o / (r_i + fine.depth)))
    inner, outer = (_at(r, angle, r_i) for r in (r_i, r_o))
    bend = _centre(core(fine, r_i)[1], outer, turn=angle - brink)
    names = ("bore", "", "rim")
    blocks = fan(Outline(inner, outer, (0.0, -wall), names, r_i, r_i), fine, "race", bend)
    bore, end, *_ = blocks[1].edges
    n = strip_cells(bore, fine, length=r_i * (math.pi - angle))
    edges = (
        Edge(inner, (0.0, 2 * r_i), n, centre, name="bore"),
        Edge((0.0, 2 * r_i), (0.0, r_i + r_o), end.cells, name="axis"),
        Edge(outer, (0.0, r_i + r_o), n, centre, name="rim"),
        end,
    )
    return mesh_blocks([*blocks, Block(edges, "race")], order=order, straight=straight)


def _at(r: float, angle: float, r_i: float) -> Point:
    """Point at the radius `r`, at `angle` [rad] from the lowest point of the bore."""
    return r * math.sin(angle), r_i - r * math.cos(angle)


def _centre(a: Point, b: Point, *, turn: float) -> Point:
    """Centre of the arc from `a` to `b` that turns to the left by `turn` [rad]."""
    reach = 1 / (2 * math.tan(turn / 2))
    return (a[0] + b[0]) / 2 - reach * (b[1] - a[1]), (a[1] + b[1]) / 2 + reach * (b[0] - a[0])
