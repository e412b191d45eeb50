"""Contact problems of the locked ring: half a sector and its roller, rigid or elastic.

The mesh touches; what the roller rests on then moves outward by the clearance j_D/2, so that gaps
stay linear in the loads.
"""

from typing import TYPE_CHECKING

from verify.cases.polyhedral.inputs import PolygonRing

if TYPE_CHECKING:
    from skfem.mesh import Mesh2D

    from fem.contact.problem import ContactProblem

CELLS = 6  # even ones in every fine zone, on the mesh of level 1


def rigid_roller_fem(
    q: PolygonRing, *, d: float, e: float | None, zone: float, refine: int
) -> "ContactProblem":
    """The ring under a rigid roller, the obstacle "stop".

    The zone [m] is fine on the ring; the hub may push on the flat at e [m] where one is given.
    """
    from fem.contact.pairs import Obstacle, Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle
    from fem.plane.material import Elastic
    from meshes.join import join

    r = q.d_e / 2
    return ContactProblem(
        join({"ring": _ring_fem(q, e, zone, refine)}),
        materials=Elastic(E=q.E, nu=q.nu),
        assumption="plane stress",
        supports={"ring.mid": "n", "ring.corner": "n"},
        obstacles={"stop": Obstacle(Circle((r + d / 2, 0.0), d / 2))},
        contacts=[Pair(slave="ring.rim", master="stop", slave_shape=Circle((0.0, 0.0), r))],
    )


def elastic_roller_fem(
    q: PolygonRing, *, d: float, e: float | None, zones: tuple[float, float], refine: int
) -> "ContactProblem":
    """The ring under half a roller of its own material, free along x, in a rigid race, "stop".

    The zones [m] are fine where the roller touches ring and race.
    """
    from fem.contact.pairs import Obstacle, Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle
    from fem.plane.material import Elastic
    from meshes.contact.roller import half_roller
    from meshes.join import join

    r, race = q.d_e / 2, q.d_e / 2 + d + q.j_D / 2
    own = Circle((r + d / 2, 0.0), d / 2)
    roller = half_roller(R=d / 2, zones=zones, refine=refine, cells=CELLS)
    return ContactProblem(
        join({"ring": _ring_fem(q, e, zones[0], refine), "roller": roller.translated(own.centre)}),
        materials=Elastic(E=q.E, nu=q.nu),
        assumption="plane stress",
        supports={"ring.mid": "n", "ring.corner": "n", "roller.cut": "y"},
        obstacles={"stop": Obstacle(Circle((r + d - race, 0.0), race, hollow=True))},
        contacts=[
            Pair(slave="ring.rim", master="roller.near", slave_shape=Circle((0.0, 0.0), r),
                 master_shape=own),
            Pair(slave="roller.far", master="stop", slave_shape=own),
        ],
    )  # fmt: skip


def _ring_fem(q: PolygonRing, e: float | None, zone: float, refine: int) -> "Mesh2D":
    from meshes.polyhedral.half_sector import half_sector

    return half_sector(
        z=q.z, d_e=q.d_e, d_i=q.d_i, fillet=q.rho, refine=refine, zone=zone, cells=CELLS,
        hub=None if e is None else (e, (e + min(q.half_flat, 1.2 * e)) / 2),
    )  # fmt: skip
