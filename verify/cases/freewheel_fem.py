"""Finite elements of one pitch of a roller freewheel: star, roller and ring as they lie at psi.

The roller lies in its place with both contacts overlapping. The star is clamped in its bore, the
ring's mean rotation held and the roller free: contact and friction bring it to rest near that place
and the ring's moment is the torque. Where the roller is then says psi and both approaches.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from verify.cases.freewheel_inputs import StarInputs

if TYPE_CHECKING:
    from skfem.mesh import Mesh2D

    from fem.contact.problem import ContactProblem
    from fem.contact.solution import ContactSolution

Array = NDArray[np.float64]

ZONE = 1.5  # half-widths of even cells about each contact
CELLS = 6


@dataclass(frozen=True)
class Place:
    """Where the roller's centre is: `x`, `y` [m] along the flat and along its normal."""

    q: StarInputs
    x: float
    y: float

    @property
    def psi(self) -> float:
        """Angle at the axis between the flat's normal and the roller's centre [rad]."""
        return math.atan2(self.x, self.y)

    @property
    def d_i(self) -> float:
        """Approach [m] of roller and star."""
        return self.q.X + self.q.r - self.y

    @property
    def d_o(self) -> float:
        """Approach [m] of roller and ring."""
        return math.hypot(self.x, self.y) - (self.q.R - self.q.r)

    @classmethod
    def overlapping(cls, q: StarInputs, d_i: float, d_o: float) -> "Place":
        """The place in which the contacts overlap by these."""
        y = q.X + q.r - d_i
        return cls(q, math.sqrt((q.R - q.r + d_o) ** 2 - y**2), y)


class Sector:
    """One pitch with the roller at a place, meshed for contacts of these half-widths [m]."""

    def __init__(
        self, place: Place, widths: tuple[float, float], refine: int, *, mu: float
    ) -> None:
        self.place, self.q = place, place.q
        self.mesh = fem_mesh(place, widths, refine)
        self.problem = fem_problem(place, self.mesh, mu)

    def at(self, turn: float = 0.0, after: "ContactSolution | None" = None) -> "State":
        """The state with the ring's mean rotation `turn` [rad], positive where it locks."""
        solution = self.problem.solve(displacements={"ring.rim": {"r": -turn}}, after=after)
        return State(self.place, solution)


@dataclass(frozen=True)
class State:
    """A pitch at rest; forces of one roller per length [N/m], the torque of all per length."""

    start: Place
    solution: "ContactSolution"

    @cached_property
    def place(self) -> Place:
        """Where the roller's centre has come to rest."""
        x, y = self.solution.plane.displacement_at((self.start.x, self.start.y))
        return Place(self.start.q, self.start.x + x, self.start.y + y)

    @property
    def torque(self) -> float:
        """Of all rollers per length [N]."""
        return -self.start.q.z * self.solution.plane.mean_reaction("ring.rim")["r"]

    @property
    def normal(self) -> tuple[float, float]:
        """Normal forces at the star and at the ring [N/m]."""
        inner, outer = self.solution.touches
        return inner.normal_force, outer.normal_force

    @property
    def tangential(self) -> tuple[float, float]:
        """Friction forces at the star and at the ring [N/m]."""
        inner, outer = self.solution.touches
        return inner.friction_force, outer.friction_force


def fem_mesh(place: Place, widths: tuple[float, float], refine: int) -> "Mesh2D":
    from meshes.freewheel.sector import inner_cam_sector

    q = place.q
    return inner_cam_sector(
        R=q.R, R_a=q.R_a, X=q.X, r_b=q.r_b, r=q.r, z=q.z, centre=(place.x, place.y),
        zones=(ZONE * widths[0], ZONE * widths[1]), cells=CELLS, refine=refine,
    )  # fmt: skip


def fem_problem(place: Place, mesh: "Mesh2D", mu: float) -> "ContactProblem":
    from fem.contact.pairs import Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle, Flat
    from fem.plane.material import Elastic
    from fem.plane.means import Mean
    from fem.plane.ties import Tie

    q, pitch = place.q, 2 * math.pi / place.q.z
    rim = Circle((place.x, place.y), q.r)
    meet: Any = {"friction": mu, "slave_shape": rim, "press_fit": True}
    return ContactProblem(
        mesh,
        materials=Elastic(E=q.E, nu=q.nu),
        assumption="plane strain",
        supports={"star.bore": "xy"},
        contacts=[
            Pair(slave="roller.inner", master="star.flat",
                 master_shape=Flat((0.0, q.X), (0.0, 1.0)), **meet),
            Pair(slave="roller.outer", master="ring.bore",
                 master_shape=Circle((0.0, 0.0), q.R, hollow=True), **meet),
        ],
        ties=[
            Tie(leader=f"{body}.right", follower=f"{body}.left", angle=pitch)
            for body in ("star", "ring")
        ],
        means={"ring.rim": Mean({"r": 0.0})},
    )  # fmt: skip
