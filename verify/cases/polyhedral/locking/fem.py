"""Finite elements of the locked ring: half a sector against its roller, driven to its state."""

from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from verify.cases.polyhedral.inputs import PolygonRing
from verify.cases.polyhedral.locking.model import CELLS, elastic_roller_fem, rigid_roller_fem

if TYPE_CHECKING:
    from fem.contact.problem import ContactProblem
    from fem.contact.solution import ContactSolution

ZONE = 1.5  # half-widths of even cells under the roller
FIRST = 0.1  # of the wall that the fine zone takes while the half-width is unknown
WIDEST = 0.45  # of wall, roller's radius and the hub's distance from the middle
COARSE = (1, 2)  # meshes that say how wide the contacts are
STEP, STEPS = 0.6, 9  # of pressures for shares: in that which N balances on a flat; how many
HELD = 2  # level of the mesh for bonded stretches


class ZonedRing:
    """Half a sector with its roller; forces per unit width, those of the whole roller or hub.

    The roller is rigid, or `elastic` as the ring in a rigid race; `zones` [m] of ring and race are
    fine. The hub may push at `e` [m].
    """

    def __init__(
        self, q: PolygonRing, refine: int, *, d: float, zones: tuple[float, float],
        e: float | None = None, elastic: bool = False,
    ) -> None:  # fmt: skip
        self.q, self.d, self.e = q, d, e
        size: Any = {"d": d, "e": e, "refine": refine}
        self.problem: ContactProblem = (
            elastic_roller_fem(q, zones=zones, **size)
            if elastic
            else rigid_roller_fem(q, zone=zones[0], **size)
        )

    def at(self, p: float, hub: tuple[float, float] = (0.0, 0.0)) -> "ContactSolution":
        """The state under the pressure `p` and the hub's force."""
        return self.problem.solve(
            pressures={"ring.bore": p},
            point_forces={} if self.e is None else {
                (self.q.apothem, self.e): (hub[0] / 2, hub[1] / 2)
            },
            displacements={"stop": {"x": self.q.j_D / 2}},
        )  # fmt: skip

    def force(self, p: float, hub: tuple[float, float] = (0.0, 0.0)) -> float:
        """Normal force [N/m] of a roller."""
        return 2 * self.at(p, hub).touches[0].force[0]

    def efficiency(self, p: float) -> tuple[float, float]:
        """Share of the force of a further pressure on the flat that reaches the roller, its u.

        A cubic over some pressures smooths the steps by which nodes come to touch; the standard
        uncertainty is that of its slope.
        """
        side = self.q.d_i * np.sin(self.q.half_angle)
        reach, t = STEP * self.force(p), np.linspace(-1, 1, STEPS)
        powers = np.vander(t, 4, increasing=True)
        N = np.array([self.force(p + reach * x / side) for x in t]) / reach
        fit, (rest,), *_ = np.linalg.lstsq(powers, N, rcond=None)
        spread = np.linalg.inv(powers.T @ powers)[1, 1] * rest / (STEPS - 4)
        return float(fit[1]), float(np.sqrt(spread))

    def half_widths(self, p: float, hub: tuple[float, float] = (0.0, 0.0)) -> tuple[float, float]:
        """Half-widths [m] of the contacts on the ring and on the race; 0 on that of a rigid one."""
        near, *far = self.at(p, hub).touches
        r = self.q.d_e / 2
        on_race = far[0].half_width((r + self.d, 0.0)) if far else 0.0
        return near.half_width((r, 0.0)), on_race

    def balance(self, p: float, hub: tuple[float, float]) -> tuple[float, float, float]:
        """What is left of forces x, y [N/m] on half a sector, and its hoop force along x."""
        q, state = self.q, self.at(p, hub)
        c, s = np.cos(q.half_angle), np.sin(q.half_angle)
        names = ("ring.mid", "ring.corner")
        cuts = np.sum([state.plane.reaction(name)[:2] for name in names], axis=0)
        push = p * np.array([q.d_i / 2 * s, q.apothem - q.d_i / 2 * c])
        rest: Any = cuts + push + np.array(hub) / 2 - np.array(state.touches[0].force)
        return float(rest[0]), float(rest[1]), float(cuts[0])


class LockedRing(ZonedRing):
    """The same, fine where it touches under the pressure `p` [Pa] and `hub` at e.

    `hub` is a force (normal, along the flat) [N/m].
    """

    def __init__(
        self, q: PolygonRing, refine: int, *, d: float, p: float, e: float | None = None,
        hub: tuple[float, float] = (0.0, 0.0), elastic: bool = False,
    ) -> None:  # fmt: skip
        zones = fine_zones(q, d, p, e, hub, elastic)
        super().__init__(q, refine, d=d, e=e, zones=zones, elastic=elastic)


@lru_cache(maxsize=64)
def fine_zones(
    q: PolygonRing, d: float, p: float, e: float | None, hub: tuple[float, float], elastic: bool
) -> tuple[float, float]:
    """Widths [m] of the zones of ring and race that are fine, the same on all meshes.

    Coarse solutions say how wide the contacts are; the meshes have vertices near their ends.
    """
    wall = q.d_e / 2 - q.apothem
    beside = wall if e is None else min(wall, e)
    first = FIRST * min(beside, q.half_angle * q.d_e / 2, d)
    widest = WIDEST * min(beside, d / 2), WIDEST * min(wall, d / 2)
    zones = first, first
    for refine in COARSE:
        ring = ZonedRing(q, refine, d=d, e=e, zones=zones, elastic=elastic)
        near, far = (
            min(ZONE * a, most) if a > 0 else zone
            for a, most, zone in zip(ring.half_widths(p, hub), widest, zones, strict=True)
        )
        zones = near, far
    return zones


def held_fem(q: PolygonRing, width: float) -> float:
    """Force [N/m] per pressure [Pa] of a stretch 2 `width` of the outside that cannot move out."""
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
