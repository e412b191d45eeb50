"""Finite elements of the locked ring: half a sector against a rigid roller, driven to its state."""

from typing import TYPE_CHECKING, Any

import numpy as np

from verify.cases.polyhedral_inputs import PolygonRing

if TYPE_CHECKING:
    from fem.contact.problem import ContactProblem
    from fem.contact.solution import ContactSolution

ZONE = 1.5  # half-widths of even cells under the roller
CELLS = 6  # on them, on the mesh of level 1
FIRST = 0.1  # of the wall that the fine zone takes while the half-width is unknown
WIDEST = 0.45
COARSE = 2


class LockedRing:
    """Half a sector with its roller; forces per unit width, those of the whole roller or hub."""

    def __init__(
        self, q: PolygonRing, level: int, *, d: float, e: float, p: float,
        hub: tuple[float, float] = (0.0, 0.0),
    ) -> None:  # fmt: skip
        """Fine where it touches under the pressure `p` [Pa] and `hub` (normal, along) [N/m] at e.

        A coarse solution says how wide the contact is; the meshes have a vertex near its end.
        """
        self.q, self.d, self.e = q, d, e
        wall = q.d_e / 2 - q.apothem
        zone = FIRST * min(wall, q.half_angle * q.d_e / 2, d)
        for refine in (COARSE, COARSE, level):
            self.problem = self._fem_problem(zone, refine)
            a = self.at(p, hub).touches[0].half_width((q.d_e / 2, 0.0))
            zone = min(ZONE * a, WIDEST * wall) if a > 0 else zone

    def _fem_problem(self, zone: float, refine: int) -> "ContactProblem":
        from fem.contact.pairs import Obstacle, Pair
        from fem.contact.problem import ContactProblem
        from fem.contact.shapes import Circle
        from fem.plane.material import Elastic
        from meshes.polyhedral.half_sector import half_sector

        q, r = self.q, self.q.d_e / 2
        mesh = half_sector(
            z=q.z, d_e=q.d_e, d_i=q.d_i, fillet=q.rho, refine=refine, zone=zone, cells=CELLS,
            hub=(self.e, (self.e + min(q.half_flat, 1.2 * self.e)) / 2),
        )  # fmt: skip
        roller = Circle((r + self.d / 2, 0.0), self.d / 2)
        return ContactProblem(
            mesh,
            materials=Elastic(E=q.E, nu=q.nu),
            assumption="plane stress",
            supports={"mid": "n", "corner": "n"},
            obstacles={"roller": Obstacle(roller)},
            # the mesh touches the roller; the clearance counts as an interference below zero
            contacts=[
                Pair(slave="rim", master="roller", slave_shape=Circle((0.0, 0.0), r),
                     interference=-q.j_D / 2)
            ],
        )  # fmt: skip

    def at(self, p: float, hub: tuple[float, float] = (0.0, 0.0)) -> "ContactSolution":
        """The state under the pressure `p` and the hub's force."""
        node = (self.q.apothem, self.e)
        force = (hub[0] / 2, hub[1] / 2)
        return self.problem.solve(pressures={"bore": p}, point_forces={node: force})

    def force(self, p: float, hub: tuple[float, float] = (0.0, 0.0)) -> float:
        """Normal force [N/m] of a roller."""
        return 2 * self.at(p, hub).touches[0].force[0]

    def balance(self, p: float, hub: tuple[float, float]) -> tuple[float, float, float]:
        """What is left of forces x, y [N/m] on half a sector, and its hoop force along x."""
        q, state = self.q, self.at(p, hub)
        c, s = np.cos(q.half_angle), np.sin(q.half_angle)
        cuts = np.sum([state.plane.reaction(name)[:2] for name in ("mid", "corner")], axis=0)
        push = p * np.array([q.d_i / 2 * s, q.apothem - q.d_i / 2 * c])
        rest: Any = cuts + push + np.array(hub) / 2 - np.array(state.touches[0].force)
        return float(rest[0]), float(rest[1]), float(cuts[0])


def held_fem(q: PolygonRing, width: float) -> float:
    """Force [N/m] per pressure [Pa] of a stretch 2 `width` of the outside that cannot move out."""
    from fem.plane.material import Elastic
    from fem.plane.solve import solve_plane
    from meshes.polyhedral.half_sector import half_sector

    mesh = half_sector(
        z=q.z, d_e=q.d_e, d_i=q.d_i, fillet=q.rho, refine=COARSE, zone=width, cells=CELLS
    )
    ring = solve_plane(
        mesh,
        materials=Elastic(E=q.E, nu=q.nu),
        assumption="plane stress",
        supports={"mid": "n", "corner": "n", "zone": "n"},
        pressures={"bore": 1.0},
    )
    return -2 * ring.reaction("zone")[0]
