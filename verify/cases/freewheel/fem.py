"""Finite elements of one pitch of a roller freewheel: cam, roller and race as they lie at psi.

The roller lies in its place with both contacts overlapping, free but for them. A star is clamped in
its bore, the ring's mean rotation held; of a cup the rim's mean rotation, and that of the shaft's
bore. The race's moment is the torque. Where the roller comes to rest says psi and both approaches.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from verify.cases.contact.errors import fem_errors
from verify.cases.freewheel.bodies import BODIES, Bodies, OneClutch

if TYPE_CHECKING:
    from skfem.mesh import Mesh2D

    from fem.contact.along import Along
    from fem.contact.pairs import Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.solution import ContactSolution

Array = NDArray[np.float64]

ZONE = 1.5  # half-widths of even cells about each contact
CORE = 0.05  # of the radius: where the roller's rotation is read
STILL, MOST = 1e-5, 8  # of both approaches: what the roller may move; steps


@dataclass(frozen=True)
class Place:
    """Where the roller's centre is: `x`, `y` [m] along the flat and along its normal."""

    q: OneClutch
    x: float
    y: float

    @property
    def psi(self) -> float:
        """Angle at the axis between the flat's normal and the roller's centre [rad]."""
        return math.atan2(self.x, self.y)

    @property
    def d_i(self) -> float:
        """Approach [m] of roller and inner part."""
        return self._approaches[0]

    @property
    def d_o(self) -> float:
        """Approach [m] of roller and outer part."""
        return self._approaches[1]

    @property
    def _approaches(self) -> tuple[float, float]:
        q = self.q
        to_flat = q.sense * (q.flat + q.sense * q.r - self.y)
        to_race = q.sense * (math.hypot(self.x, self.y) - (q.race - q.sense * q.r))
        return (to_flat, to_race) if q.sense > 0 else (to_race, to_flat)

    @classmethod
    def overlapping(cls, q: OneClutch, d_i: float, d_o: float) -> "Place":
        """The place in which the contacts overlap by these."""
        to_flat, to_race = (d_i, d_o) if q.sense > 0 else (d_o, d_i)
        y = q.flat + q.sense * q.r - q.sense * to_flat
        return cls(q, math.sqrt((q.race - q.sense * q.r + q.sense * to_race) ** 2 - y**2), y)


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

        `drags` [m], how far the surfaces of inner and outer part are turned into the wedge, are
        improved until it does not. In small displacements forces act where the mesh has them: a
        roller that creeps out, or turns, until friction holds it, would bear them beside its
        contacts.
        """
        for _ in range(MOST):
            state = self.at(drags)
            out, turned = state.motion
            if max(abs(out), abs(turned)) <= STILL * (state.place.d_i + state.place.d_o):
                return state
            drags = drags[0] - out - turned, drags[1] - out + turned
        slips = ", and every node of a contact slips" if state.solution.slides else ""
        raise fem_errors().NotFoundError(
            f"no equilibrium was found: the roller still moves by {out:.1e} m after "
            f"{MOST} steps{slips}"
        )

    def at(self, drags: tuple[float, float], **more: Any) -> "State":
        """The state with the surfaces of inner and outer part turned into the wedge by `drags` [m].

        `more` goes to the solver: what happens along z, and steps.
        """
        q, names = self.place.q, BODIES[self.place.q.sense]
        cam, race = drags if q.sense > 0 else drags[::-1]
        angle = q.sense * cam / q.flat
        turned: Any = (
            {"x": lambda x: angle * x[1], "y": lambda x: -angle * x[0]} if q.sense > 0
            else {"r": -angle}
        )  # fmt: skip
        moved = {names.race_held: {"r": -q.sense * race / q.race}, names.cam_held: turned}
        return State(self.place, drags, self.problem.solve(displacements=moved, **more))


@dataclass(frozen=True)
class State:
    """A pitch at rest; forces of one roller per length [N/m], the torque of all per length [N]."""

    start: Place
    drags: tuple[float, float]
    solution: "ContactSolution"

    @cached_property
    def motion(self) -> tuple[float, float]:
        """How far [m] the roller's centre creeps into the wedge, and its rim turns there."""
        r, half, sense = self.start.q.r, self.start.psi / 2, self.start.q.sense
        u = np.array(self.solution.plane.displacement_at((self.start.x, self.start.y)))
        near = CORE * r
        x = np.array([[self.start.x], [self.start.y]]) + near * np.array(
            [[1, -1, 0, 0], [0, 0, 1, -1]]
        )
        right, left, up, down = self.solution.plane.at(x).u.T
        turn = (right[1] - left[1] - up[0] + down[0]) / (4 * near)
        out = float(u @ (math.cos(half), -math.sin(half)))
        return sense * out, float(sense * r * turn)

    @cached_property
    def place(self) -> Place:
        """Where the roller's centre is, seen from the cam as it is turned."""
        u = self.solution.plane.displacement_at((self.start.x, self.start.y))
        x, y = self.start.x + u[0], self.start.y + u[1]
        c, s = math.cos(self.tilt), math.sin(self.tilt)
        return Place(self.start.q, c * x - s * y, s * x + c * y)

    @property
    def tilt(self) -> float:
        """How far the cam is turned, clockwise [rad]."""
        return self.start.q.sense * self.drags[self._flat] / self.start.q.flat

    @property
    def torque(self) -> float:
        q = self.start.q
        held = BODIES[q.sense].race_held
        return -q.sense * q.z * self.solution.plane.mean_reaction(held)["r"]

    @property
    def on_flat(self) -> tuple[float, float]:
        """Force on the cam into its flat, and along it out of the wedge."""
        x, y = (self.start.q.sense * f for f in self.solution.touches[self._flat].force)
        c, s = math.cos(self.tilt), math.sin(self.tilt)
        return -s * x - c * y, -c * x + s * y

    @property
    def on_race(self) -> tuple[float, float]:
        """Force on the race along the ray through the roller, and across out of the wedge."""
        x, y = (self.start.q.sense * f for f in self.solution.touches[1 - self._flat].force)
        psi = self.place.psi + self.tilt
        c, s = math.cos(psi), math.sin(psi)
        return s * x + c * y, s * y - c * x

    @property
    def _flat(self) -> int:
        """Which contact is the flat's: the inner one of a star."""
        return 0 if self.start.q.sense > 0 else 1

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
    from meshes.freewheel.sector import inner_cam_sector, outer_cam_sector

    q = place.q
    zones = ZONE * widths[0], ZONE * widths[1]
    more: Any = {"R_a": q.R_a, "r_b": q.r_b, "r": q.r, "z": q.z, "centre": (place.x, place.y)}
    if q.sense > 0:
        return inner_cam_sector(R=q.race, X=q.flat, zones=zones, cells=cells, **more)
    return outer_cam_sector(R_s=q.race, X_o=q.flat, zones=zones, cells=cells, **more)


def fem_problem(
    place: Place, mesh: "Mesh2D", mu: float, along: "Along | None" = None
) -> "ContactProblem":
    from fem.contact.problem import ContactProblem
    from fem.plane.material import Elastic
    from fem.plane.means import Mean
    from fem.plane.ties import Tie

    q, names = place.q, BODIES[place.q.sense]
    means = {names.race_held: Mean({"r": 0.0})}
    if q.sense < 0:
        means[names.cam_held] = Mean({"r": 0.0})
    return ContactProblem(
        mesh,
        materials=Elastic(E=q.E, nu=q.nu),
        assumption="plane strain",
        supports={names.cam_held: "xy"} if q.sense > 0 else {},
        contacts=fem_pairs(place, names, mu)[:: q.sense],
        ties=[
            Tie(leader=f"{body}.right", follower=f"{body}.left", angle=2 * math.pi / q.z)
            for body in (names.cam, names.race)
        ],
        means=means,
        along=along,
    )


def fem_pairs(place: Place, names: Bodies, mu: float) -> list["Pair"]:
    """The contacts on the flat and on the race."""
    from fem.contact.pairs import Pair
    from fem.contact.shapes import Circle, Flat

    q, rim = place.q, Circle((place.x, place.y), place.q.r)
    meet: Any = {"normal": "master", "friction": mu, "slave_shape": rim, "press_fit": True}
    on_flat, on_race = ("roller.inner", "roller.outer")[:: q.sense]
    flat = Flat((0.0, q.flat), (0.0, float(q.sense)))
    race = Circle((0.0, 0.0), q.race, hollow=q.sense > 0)
    return [
        Pair(slave=on_flat, master=names.flat, master_shape=flat, **meet),
        Pair(slave=on_race, master=names.bore, master_shape=race, **meet),
    ]
