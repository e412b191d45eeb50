"""Finite-element models of the polyhedral ring: half a sector under pressure or hub force."""

from typing import TYPE_CHECKING, Any

import numpy as np

from verify.cases.polyhedral.inputs import HubRing, PolygonRing
from verify.core.figures import Array, Field

if TYPE_CHECKING:
    from fem.plane.material import Assumption
    from fem.plane.solution import PlaneSolution

UNIT = 1e6  # Pa, pressure of the solution; all results are proportional to it
# cells along the fillet: outside the corner there are as many, and where they are wide against the
# wall a displacement there errs by a third order in h beside the fourth, with the other sign
ARC = 12
STATIONS = 25  # along the outside of half a sector


def pressed_fem(
    q: PolygonRing, refine: int, assumption: "Assumption", arc: int = 6
) -> "PlaneSolution":
    """Solution of half a sector with the pressure `UNIT` in its bore and a free outer surface.

    The fillet has `arc` cells if `refine` is 1.
    """
    from fem.plane.material import Elastic
    from fem.plane.solve import solve_plane
    from meshes.polyhedral.half_sector import half_sector

    return solve_plane(
        half_sector(z=q.z, d_e=q.d_e, d_i=q.d_i, fillet=q.rho, refine=refine, arc=arc),
        materials=Elastic(E=q.E, nu=q.nu),
        assumption=assumption,
        supports={"mid": "n", "corner": "n"},
        pressures={"bore": UNIT},
    )


def stations(q: PolygonRing) -> Array:
    """Angles [rad] of points of the outer surface, from the middle of a flat to a corner, (m,)."""
    return np.linspace(0, q.half_angle, STATIONS)


def factors_fem(q: PolygonRing, ring: "PlaneSolution") -> dict[str, float]:
    """Outward displacements [m] under `UNIT`: in the middle of the flats, mean, at corners."""
    from fem.plane.sectors import radial

    rim = ring.on_boundary("rim")
    middle, corner = radial(ring, q.d_e / 2, np.array([0.0, q.half_angle]))
    return {"mid": float(middle), "mean": float(rim.mean(rim.polar()[0])), "corner": float(corner)}


def whole_fem(name: str, z: int, half: dict[str, Array], **data: tuple[Array, str]) -> Field:
    """Field of the whole ring, made of 2 z copies of half a sector; `data`: (values, unit)."""
    from fem.plane.sectors import all_sectors

    points, moved, cells = all_sectors(half, z)
    return Field(
        name=name, points=points, cells=cells, point_data={"displacement": moved},
        cell_data={key: np.tile(values, 2 * z) for key, (values, _) in data.items()},
        units={"displacement": "m"} | {key: unit for key, (_, unit) in data.items()},
    )  # fmt: skip


def expanded(q: PolygonRing, z: int) -> Field:
    """Field of a ring with `z` flats whose flats have closed the clearance, on a coarse mesh."""
    other = q.model_copy(update={"z": z})
    ring = pressed_fem(other, 1, "plane stress")
    cells: dict[str, Any] = ring.cells()
    scale = q.j_D / 2 / factors_fem(other, ring)["mid"]
    cells["displacement"] = cells["displacement"] * scale
    return whole_fem(f"z = {z}", z, cells, von_mises=(cells["von_mises"] * scale, "Pa"))


def pushed_fem(q: HubRing, refine: int) -> tuple["PlaneSolution", "PlaneSolution"]:
    """Two solutions of half a sector: hub force at e, and normal part of this force in the corner.

    Displacements at the point of the force are unbounded; at other points, they converge.
    """
    from fem.plane.material import Elastic
    from fem.plane.solve import solve_plane
    from meshes.polyhedral.half_sector import HUB, ROWS, half_sector

    normal, along = q.R_b / np.hypot(1, q.tan_phi) * np.array([1, -q.tan_phi]) / 2
    corner = q.d_i / 2 * np.array([np.cos(q.half_angle), np.sin(q.half_angle)])
    # cells on both sides of e are equal if space permits: a point force between large and
    # small ones brings an error of third order beside the mesh's fourth
    even = HUB * min(q.e, (q.d_e / 2 - q.apothem) / ROWS)
    beside = q.e + min(even, (q.half_flat - q.e) / 2)
    loads = (
        ((q.apothem, q.e), (normal, along)),
        (tuple(corner), tuple(normal * corner / (q.d_i / 2))),
    )
    mesh = half_sector(
        z=q.z, d_e=q.d_e, d_i=q.d_i, fillet=q.rho, refine=refine, hub=(q.e, beside), arc=ARC
    )
    at, in_corner = (
        solve_plane(
            mesh,
            materials=Elastic(E=q.E, nu=q.nu),
            assumption="plane stress",
            supports={"mid": "n", "corner": "n"},
            point_forces={point: force},
        )
        for point, force in loads
    )
    return at, in_corner


def in_fillet_fem(
    q: PolygonRing, ring: "PlaneSolution", p: float = UNIT, *, name: str = "fillet"
) -> float:
    """Largest hoop stress [Pa] of the fillet, boundary `name`, under the pressure `p` [Pa]."""
    from fem.plane.sectors import largest_hoop_stress

    centre = (q.d_i / 2 - q.rho) * np.array([np.cos(q.half_angle), np.sin(q.half_angle)])
    return largest_hoop_stress(ring.on_boundary(name), centre, q.half_angle, p)
