"""Finite elements of one pitch of a roller freewheel: star, roller and ring as they lie at psi.

The roller lies in its place with both contacts overlapping, free but for them. The star is clamped
in its bore, the ring's mean rotation held; its moment is the torque. Where the roller comes to rest
says psi and both approaches.
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

    from fem.contact.along import Along
    from fem.contact.problem import ContactProblem
    from fem.contact.solution import ContactSolution

Array = NDArray[np.float64]

ZONE = 1.5  # half-widths of even cells about each contact
CORE = 0.05  # of the radius: where the roller's rotation is read
STILL, MOST = 1e-5, 8  # of both approaches: what the roller may move; steps


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
        self, place: Place, widths: tuple[float, float], cells: int, *, mu: float,
        along: "Along | None" = None,
    ) -> None:  # fmt: skip
        self.place = place
        self.problem = fem_problem(place, fem_mesh(place, widths, cells), mu, along)

    def rest(self, drags: tuple[float, float] = (0.0, 0.0)) -> "State":
        """The state in which the roller's centre neither leaves its place nor turns.

        `drags` [m], how far the surfaces of star and ring are turned into the wedge, are improved
        until it does not. In small displacements forces act where the mesh has them: a roller that
        creeps out, or turns, until friction holds it, would bear them beside its contacts.
        """
        for _ in range(MOST):
            state = self.at(drags)
            out, turned = state.motion
            if max(abs(out), abs(turned)) <= STILL * (state.place.d_i + state.place.d_o):
                return state
            drags = drags[0] - out - turned, drags[1] - out + turned
        raise ArithmeticError(f"the roller moves by {out:.1e} m after {MOST} steps")

    def at(self, drags: tuple[float, float], **more: Any) -> "State":
        """The state with the surfaces of star and ring turned into the wedge by `drags` [m].

        `more` goes to the solver: what happens along z, and steps.
        """
        q, angle = self.place.q, drags[0] / self.place.q.X
        moved: Any = {
            "ring.rim": {"r": -drags[1] / q.R},
            "star.bore": {"x": lambda x: angle * x[1], "y": lambda x: -angle * x[0]},
        }
        return State(self.place, drags, self.problem.solve(displacements=moved, **more))


@dataclass(frozen=True)
class State:
    """A pitch at rest; forces of one roller per length [N/m], the torque of all per length [N]."""

    start: Place
    drags: tuple[float, float]
    solution: "ContactSolution"

    @cached_property
    def motion(self) -> tuple[float, float]:
        """How far [m] the roller's centre creeps into the wedge and how far its rim turns."""
        r, half = self.start.q.r, self.start.psi / 2
        u = np.array(self.solution.plane.displacement_at((self.start.x, self.start.y)))
        near = CORE * r
        x = np.array([[self.start.x], [self.start.y]]) + near * np.array(
            [[1, -1, 0, 0], [0, 0, 1, -1]]
        )
        right, left, up, down = self.solution.plane.at(x).u.T
        turn = (right[1] - left[1] - up[0] + down[0]) / (4 * near)
        return float(u @ (math.cos(half), -math.sin(half))), float(r * turn)

    @cached_property
    def place(self) -> Place:
        """Where the roller's centre is, seen from the star as it is turned."""
        u = self.solution.plane.displacement_at((self.start.x, self.start.y))
        x, y = self.start.x + u[0], self.start.y + u[1]
        c, s = math.cos(self.tilt), math.sin(self.tilt)
        return Place(self.start.q, c * x - s * y, s * x + c * y)

    @property
    def tilt(self) -> float:
        """How far the star is turned, clockwise [rad]."""
        return self.drags[0] / self.start.q.X

    @property
    def torque(self) -> float:
        return -self.start.q.z * self.solution.plane.mean_reaction("ring.rim")["r"]

    @property
    def on_star(self) -> tuple[float, float]:
        """Force on the star along its flat's normal inwards, and along it out of the wedge."""
        x, y = self.solution.touches[0].force
        c, s = math.cos(self.tilt), math.sin(self.tilt)
        return -s * x - c * y, -c * x + s * y

    @property
    def on_ring(self) -> tuple[float, float]:
        """Force on the ring along the ray through the roller's centre, and across out of the wedge."""
        x, y = self.solution.touches[1].force
        psi = self.place.psi + self.tilt
        c, s = math.cos(psi), math.sin(psi)
        return s * x + c * y, s * y - c * x

    @property
    def widths(self) -> tuple[float, float]:
        """Half-widths of both contacts [m], from the moments of the pressure."""
        inner, outer = self.solution.touches
        return inner.half_width(), outer.half_width()

    @property
    def peaks(self) -> tuple[float, float]:
        """Largest pressures [Pa]."""
        inner, outer = self.solution.touches
        return inner.peak, outer.peak


def fem_mesh(place: Place, widths: tuple[float, float], cells: int) -> "Mesh2D":
    from meshes.freewheel.sector import inner_cam_sector

    q = place.q
    return inner_cam_sector(
        R=q.R, R_a=q.R_a, X=q.X, r_b=q.r_b, r=q.r, z=q.z, centre=(place.x, place.y),
        zones=(ZONE * widths[0], ZONE * widths[1]), cells=cells,
    )  # fmt: skip


def fem_problem(
    place: Place, mesh: "Mesh2D", mu: float, along: "Along | None" = None
) -> "ContactProblem":
    from fem.contact.pairs import Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle, Flat
    from fem.plane.material import Elastic
    from fem.plane.means import Mean
    from fem.plane.ties import Tie

    q, pitch = place.q, 2 * math.pi / place.q.z
    rim = Circle((place.x, place.y), q.r)
    meet: Any = {"normal": "master", "friction": mu, "slave_shape": rim, "press_fit": True}
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
        along=along,
    )  # fmt: skip
