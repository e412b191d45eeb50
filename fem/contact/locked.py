"""Sector of a ring with flats in its bore; pressure on the flats presses the ring against rollers.

The model is half a sector between the middle of a flat on the x axis and a corner, in plane stress.
In the mesh, the bodies touch. The support of the roller then moves outwards by the clearance; gaps
are therefore linear in the loads. Forces are per unit width, and belong to the complete roller or
hub, not to its half in the model.
"""

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from skfem.mesh import Mesh2D

from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle
from fem.contact.solution import ContactSolution
from fem.plane.material import Elastic

STEP, STEPS = 0.6, 9  # step of the pressures over the equilibrium pressure; number of steps

Force = tuple[float, float]  # along the flat's normal, and along it away from its middle


class FlatSector(NamedTuple):
    """Dimensions of a sector; lengths are in the unit of the mesh.

    `half_angle` [rad] is half the angle between rollers, `d_i` the diameter through the corners of
    the bore, `d_e` the outside diameter, and `apothem` the distance of the flats from the centre.
    `clearance` is the diameter of the race minus `d_e` and twice the diameter of the roller.
    """

    half_angle: float
    d_i: float
    d_e: float
    apothem: float
    clearance: float


def rigid_roller(
    sector: FlatSector, mesh: Mesh2D, *, d: float, material: Elastic
) -> ContactProblem:
    """Contact problem of the sector (body "ring") under a rigid roller (obstacle "stop")."""
    r = sector.d_e / 2
    return ContactProblem(
        mesh,
        materials=material,
        assumption="plane stress",
        supports={"ring.mid": "n", "ring.corner": "n"},
        obstacles={"stop": Obstacle(Circle((r + d / 2, 0.0), d / 2))},
        contacts=[Pair(slave="ring.rim", master="stop", slave_shape=Circle((0.0, 0.0), r))],
    )


def elastic_roller(
    sector: FlatSector, mesh: Mesh2D, *, d: float, material: Elastic
) -> ContactProblem:
    """Contact problem of the sector under half an elastic roller in a rigid race.

    The body "roller" has the material of the ring and is free along x. The race is the obstacle
    "stop".
    """
    r, race = sector.d_e / 2, sector.d_e / 2 + d + sector.clearance / 2
    own = Circle((r + d / 2, 0.0), d / 2)
    return ContactProblem(
        mesh,
        materials=material,
        assumption="plane stress",
        supports={"ring.mid": "n", "ring.corner": "n", "roller.cut": "y"},
        obstacles={"stop": Obstacle(Circle((r + d - race, 0.0), race, hollow=True))},
        contacts=[
            Pair(slave="ring.rim", master="roller.near", slave_shape=Circle((0.0, 0.0), r),
                 master_shape=own),
            Pair(slave="roller.far", master="stop", slave_shape=own),
        ],
    )  # fmt: skip


@dataclass(frozen=True)
class LockedSector:
    """Sector with a roller of diameter `d`; `e` is the distance of the hub force from mid-flat."""

    sector: FlatSector
    problem: ContactProblem
    d: float
    e: float | None = None

    def at(self, p: float, hub: Force = (0.0, 0.0)) -> ContactSolution:
        """Contact state under the pressure `p` and the hub force `hub`."""
        return self.problem.solve(
            pressures={"ring.bore": p},
            point_forces={} if self.e is None else {
                (self.sector.apothem, self.e): (hub[0] / 2, hub[1] / 2)
            },
            displacements={"stop": {"x": self.sector.clearance / 2}},
        )  # fmt: skip

    def force(self, p: float, hub: Force = (0.0, 0.0)) -> float:
        """Normal force of a roller per unit width."""
        return 2 * self.at(p, hub).touches[0].force[0]

    def efficiency(self, p: float) -> tuple[float, float]:
        """Fraction of an additional pressure force on the flat that reaches the roller.

        The results are this fraction and its standard uncertainty u. Nodes come into contact one by
        one, which causes steps of the force. A cubic polynomial over several pressures smooths
        these steps. u is the standard uncertainty of the slope of the polynomial.
        """
        side = self.sector.d_i * np.sin(self.sector.half_angle)
        reach, t = STEP * self.force(p), np.linspace(-1, 1, STEPS)
        powers = np.vander(t, 4, increasing=True)
        N = np.array([self.force(p + reach * x / side) for x in t]) / reach
        fit, (rest,), *_ = np.linalg.lstsq(powers, N, rcond=None)
        spread = np.linalg.inv(powers.T @ powers)[1, 1] * rest / (STEPS - 4)
        return float(fit[1]), float(np.sqrt(spread))

    def half_widths(self, p: float, hub: Force = (0.0, 0.0)) -> tuple[float, float]:
        """Half-widths of two contacts: on the ring, and on the race (0 if the roller is rigid)."""
        near, *far = self.at(p, hub).touches
        r = self.sector.d_e / 2
        on_race = far[0].half_width((r + self.d, 0.0)) if far else 0.0
        return near.half_width((r, 0.0)), on_race

    def balance(self, p: float, hub: Force) -> tuple[float, float, float]:
        """Unbalanced forces along x and y on half a sector, and force along x on the two cuts."""
        sector, state = self.sector, self.at(p, hub)
        c, s = np.cos(sector.half_angle), np.sin(sector.half_angle)
        names = ("ring.mid", "ring.corner")
        cuts = np.sum([state.plane.reaction(name)[:2] for name in names], axis=0)
        push = p * np.array([sector.d_i / 2 * s, sector.apothem - sector.d_i / 2 * c])
        rest: Any = cuts + push + np.array(hub) / 2 - np.array(state.touches[0].force)
        return float(rest[0]), float(rest[1]), float(cuts[0])
