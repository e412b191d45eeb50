"""Finite-element model of the locked ring: half a sector, its roller, fine contact zones."""

from functools import lru_cache
from typing import TYPE_CHECKING

from verify.cases.polyhedral.inputs import PolygonRing

if TYPE_CHECKING:
    from fem.contact.locked import LockedSector

CELLS = 6  # even ones in every fine zone, on the mesh of level 1
ZONE = 1.5  # half-widths of even cells under the roller
FIRST = 0.1  # fine zone over the wall while the half-width is unknown
WIDEST = 0.45  # limit over wall, roller radius and the hub's distance from the middle
COARSE = (1, 2)  # meshes that determine the width of the contacts
HELD = 2  # level of the mesh for bonded stretches


def zoned_fem(
    q: PolygonRing, refine: int, *, d: float, zones: tuple[float, float], e: float | None = None,
    elastic: bool = False,
) -> "LockedSector":  # fmt: skip
    """Model of half a sector with its roller, with fine cells in the contact `zones` [m].

    The zones are those at ring and race. The roller is rigid, or `elastic` with the material of the
    ring in a rigid race. If `e` [m] is given, the hub force acts there.
    """
    from fem.contact.locked import FlatSector, LockedSector, elastic_roller, rigid_roller
    from fem.plane.material import Elastic
    from meshes.contact.roller import half_roller
    from meshes.join import join
    from meshes.polyhedral.half_sector import half_sector

    parts = {"ring": half_sector(
        z=q.z, d_e=q.d_e, d_i=q.d_i, fillet=q.rho, refine=refine, zone=zones[0], cells=CELLS,
        hub=None if e is None else (e, (e + min(q.half_flat, 1.2 * e)) / 2),
    )}  # fmt: skip
    if elastic:
        roller = half_roller(R=d / 2, zones=zones, refine=refine, cells=CELLS)
        parts["roller"] = roller.translated((q.d_e / 2 + d / 2, 0.0))
    sector = FlatSector(q.half_angle, q.d_i, q.d_e, q.apothem, q.j_D)
    pose = elastic_roller if elastic else rigid_roller
    problem = pose(sector, join(parts), d=d, material=Elastic(E=q.E, nu=q.nu))
    return LockedSector(sector, problem, d, e)


def locked_fem(
    q: PolygonRing, refine: int, *, d: float, p: float, e: float | None = None,
    hub: tuple[float, float] = (0.0, 0.0), elastic: bool = False,
) -> "LockedSector":  # fmt: skip
    """Model of half a sector whose fine zones fit the contacts under `p` [Pa] and `hub` at e.

    `hub` is a force (normal, along the flat) [N/m].
    """
    zones = fine_zones(q, d, p, e, hub, elastic)
    return zoned_fem(q, refine, d=d, e=e, zones=zones, elastic=elastic)


@lru_cache(maxsize=64)
def fine_zones(
    q: PolygonRing, d: float, p: float, e: float | None, hub: tuple[float, float], elastic: bool
) -> tuple[float, float]:
    """Widths [m] of the fine zones at ring and race, equal on all meshes.

    Coarse solutions give the widths of the contacts. The meshes have nodes near the ends of the
    contacts.
    """
    wall = q.d_e / 2 - q.apothem
    beside = wall if e is None else min(wall, e)
    first = FIRST * min(beside, q.half_angle * q.d_e / 2, d)
    widest = WIDEST * min(beside, d / 2), WIDEST * min(wall, d / 2)
    zones = first, first
    for refine in COARSE:
        ring = zoned_fem(q, refine, d=d, e=e, zones=zones, elastic=elastic)
        near, far = (
            min(ZONE * a, most) if a > 0 else zone
            for a, most, zone in zip(ring.half_widths(p, hub), widest, zones, strict=True)
        )
        zones = near, far
    return zones


def held_fem(q: PolygonRing, width: float) -> float:
    """Force per length on a fixed part (2 `width` long) of the rim, divided by the pressure [m]."""
    from fem.plane.material import Elastic
    from fem.plane.solve import solve_plane
    from meshes.polyhedral.half_sector import half_sector

    mesh = half_sector(
        z=q.z, d_e=q.d_e, d_i=q.d_i, fillet=q.rho, refine=HELD, zone=width, cells=CELLS
    )
    ring = solve_plane(
        mesh,
        materials=Elastic(E=q.E, nu=q.nu),
        assumption="plane stress",
        supports={"mid": "n", "corner": "n", "zone": "n"},
        pressures={"bore": 1.0},
    )
    return -2 * ring.reaction("zone")[0]
