"""One pitch of a roller freewheel for finite elements: sizes, names and the mesh."""

from typing import TYPE_CHECKING, Any

from fem.wedge.flat_place import Names, Pitch, Place
from verify.cases.freewheel.bodies import OneClutch

if TYPE_CHECKING:
    from skfem.mesh import Mesh2D

ZONE = 1.5  # half-widths of even cells about each contact
NAMES = {
    1: Names("star", "ring", "star.flat", "ring.bore", "star.bore", "ring.rim"),
    -1: Names("cup", "shaft", "cup.flat", "shaft.rim", "cup.rim", "shaft.bore"),
}


def pitch(q: OneClutch) -> Pitch:
    """Pitch of a star (`sense` +1) or cup (-1)."""
    return Pitch(
        sense=q.sense, race=q.race, flat=q.flat, r=q.r, r_b=q.r_b, R_a=q.R_a, z=q.z, E=q.E,
        nu=q.nu, names=NAMES[q.sense], mesh=fem_mesh,
    )  # fmt: skip


def overlapping(q: OneClutch, d_i: float, d_o: float) -> Place:
    """Position of the roller at which its contacts approach by `d_i` and `d_o` [m]."""
    return Place.overlapping(pitch(q), d_i, d_o)


def fem_mesh(place: Place, widths: tuple[float, float], cells: int) -> "Mesh2D":
    """Mesh of the pitch whose fine zones suit the contact half-widths `widths` [m].

    Half a fine zone has `cells` cells.
    """
    from meshes.freewheel.sector import inner_cam_sector, outer_cam_sector

    q = place.q
    zones = ZONE * widths[0], ZONE * widths[1]
    more: Any = {"R_a": q.R_a, "r_b": q.r_b, "r": q.r, "z": q.z, "centre": (place.x, place.y)}
    if q.sense > 0:
        return inner_cam_sector(R=q.race, X=q.flat, zones=zones, cells=cells, **more)
    return outer_cam_sector(R_s=q.race, X_o=q.flat, zones=zones, cells=cells, **more)
