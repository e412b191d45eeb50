"""One pitch of rollers between flats and a round race, with the roller at the angle psi.

The roller has a given position in which both contacts overlap; only the contacts hold it. An inner
cam is clamped at its bore. For an outer cam, the mean rotation of its rim is prescribed, as for the
race. The moment of the race is the torque. The equilibrium position of the roller gives psi and
both approaches.
"""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from fem.wedge.flat_place import Place
from fem.wedge.pitch import pitch_problem
from fem.wedge.rest import Drags, Touching, Unrest, at_rest, core_motion

if TYPE_CHECKING:
    from skfem.mesh import Mesh2D

    from fem.contact.along import Along
    from fem.contact.pairs import Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.solution import ContactSolution

MOST = 8  # steps to rest


class Sector:
    """One pitch with the roller at `place`, meshed for the half-widths `widths` [m]."""

    def __init__(
        self, place: Place, widths: tuple[float, float], cells: int, *, mu: float,
        along: "Along | None" = None,
    ) -> None:  # fmt: skip
        self.place = place
        self.problem = flat_problem(place, place.q.mesh(place, widths, cells), mu, along)

    def rest(self, drags: Drags = (0.0, 0.0)) -> "State":
        """Equilibrium state in which the roller neither moves from its place nor rotates.

        `drags` [m] are the displacements of the surfaces of inner and outer part into the wedge;
        they are corrected until the roller is at rest.
        """
        return at_rest(self.at, drags, State.unrest, body="roller", most=MOST)

    def at(self, drags: Drags, **more: Any) -> "State":
        """State with the surfaces of inner and outer part displaced into the wedge by `drags` [m].

        `more` are further arguments of the solver: loads along z, and steps.
        """
        q = self.place.q
        cam, race = drags if q.sense > 0 else drags[::-1]
        angle = q.sense * cam / q.flat
        turned: Any = (
            {"x": lambda x: angle * x[1], "y": lambda x: -angle * x[0]} if q.sense > 0
            else {"r": -angle}
        )  # fmt: skip
        moved = {q.names.race_held: {"r": -q.sense * race / q.race}, q.names.cam_held: turned}
        return State(self.place, drags, self.problem.solve(displacements=moved, **more))


@dataclass(frozen=True)
class State(Touching):
    """Equilibrium of a pitch, with forces per length.

    Forces are those of one roller [N/m]; the torque is that of all rollers [N].
    """

    start: Place
    drags: Drags
    solution: "ContactSolution"

    @cached_property
    def motion(self) -> tuple[float, float]:
        """Displacement [m] of the roller's centre into the wedge, and rotation of the roller.

        The rotation is multiplied by r [m].
        """
        r, half, sense = self.start.q.r, self.start.psi / 2, self.start.q.sense
        u = np.array(self.solution.plane.displacement_at((self.start.x, self.start.y)))
        _, turn = core_motion(self.solution, (self.start.x, self.start.y), r)
        out = float(u @ (math.cos(half), -math.sin(half)))
        return sense * out, float(sense * r * turn)

    def unrest(self) -> Unrest:
        """Motion of the roller, and corrected surface displacements that prevent this motion."""
        out, turned = self.motion
        drags = self.drags[0] - out - turned, self.drags[1] - out + turned
        return Unrest(max(abs(out), abs(turned)), self.place.d_i + self.place.d_o, drags)

    @cached_property
    def place(self) -> Place:
        """Position of the centre of the roller in the frame of reference of the rotated cam."""
        u = self.solution.plane.displacement_at((self.start.x, self.start.y))
        x, y = self.start.x + u[0], self.start.y + u[1]
        c, s = math.cos(self.tilt), math.sin(self.tilt)
        return replace(self.start, x=c * x - s * y, y=s * x + c * y)

    @property
    def tilt(self) -> float:
        """Angle of rotation of the cam, clockwise [rad]."""
        return self.start.q.sense * self.drags[self._flat] / self.start.q.flat

    @property
    def torque(self) -> float:
        q = self.start.q
        return -q.sense * q.z * self.solution.plane.mean_reaction(q.names.race_held)["r"]

    @property
    def on_flat(self) -> tuple[float, float]:
        """Components of the force on the cam, normal to the flat and along the flat.

        The first is positive into the flat, the second is positive out of the wedge.
        """
        x, y = (self.start.q.sense * f for f in self.solution.touches[self._flat].force)
        c, s = math.cos(self.tilt), math.sin(self.tilt)
        return -s * x - c * y, -c * x + s * y

    @property
    def on_race(self) -> tuple[float, float]:
        """Components of the force on the race, along the ray through the roller and normal to it.

        The second component is positive out of the wedge.
        """
        x, y = (self.start.q.sense * f for f in self.solution.touches[1 - self._flat].force)
        psi = self.place.psi + self.tilt
        c, s = math.cos(psi), math.sin(psi)
        return s * x + c * y, s * y - c * x

    @property
    def _flat(self) -> int:
        """Index of the contact at the flat: 0 (inner contact) for an inner cam, otherwise 1."""
        return 0 if self.start.q.sense > 0 else 1


def flat_problem(
    place: Place, mesh: "Mesh2D", mu: float, along: "Along | None" = None
) -> "ContactProblem":
    """Contact problem of the pitch on a mesh, with friction `mu` at both contacts."""
    q = place.q
    inside = q.sense > 0
    turned = (q.names.race_held,) if inside else (q.names.race_held, q.names.cam_held)
    return pitch_problem(
        mesh, flat_pairs(place, mu)[:: q.sense], E=q.E, nu=q.nu, z=q.z,
        races=(q.names.cam, q.names.race), turned=turned,
        supports={q.names.cam_held: "xy"} if inside else {}, along=along,
    )  # fmt: skip


def flat_pairs(place: Place, mu: float) -> "list[Pair]":
    """Contact pairs on the flat and on the race."""
    from fem.contact.pairs import Pair
    from fem.contact.shapes import Circle, Flat

    q, rim = place.q, Circle((place.x, place.y), place.q.r)
    meet: Any = {"normal": "master", "friction": mu, "slave_shape": rim, "press_fit": True}
    on_flat, on_race = ("roller.inner", "roller.outer")[:: q.sense]
    flat = Flat((0.0, q.flat), (0.0, float(q.sense)))
    race = Circle((0.0, 0.0), q.race, hollow=q.sense > 0)
    return [
        Pair(slave=on_flat, master=q.names.flat, master_shape=flat, **meet),
        Pair(slave=on_race, master=q.names.bore, master_shape=race, **meet),
    ]
