"""One pitch of two round races with a strut wedged between them, at a given rotation of the strut.

The strut touches the inner race with a spiral and the outer race with an arc; only these contacts
hold it. The races can expand like rings: only the mean rotations of the bore of the inner race and
of the rim of the outer race are prescribed. All bodies are meshed in the compressed state. The
mesh contains a part of the overlaps of the undeformed outlines; the rest is subtracted from the
gaps.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from fem.wedge.pitch import pitch_problem
from fem.wedge.races_place import Place
from fem.wedge.rest import Drags, Touching, Unrest, at_rest, core_motion

if TYPE_CHECKING:
    from fem.contact.pairs import Pair
    from fem.contact.solution import ContactSolution, Touch

Array = NDArray[np.float64]

ZONE = 1.5  # half-widths of even cells about each contact
MOST = 12  # steps to rest
BODY = "sprag"  # name of the strut in meshes
RACES = ("inner.rim", "outer.bore")
HELD = ("inner.bore", "outer.rim")


P = TypeVar("P", bound=Place)


@dataclass(frozen=True)
class Struts:
    """Set of z struts of width `b` [m] and their races, all of one material with E [Pa]."""

    z: int
    b: float
    E: float
    nu: float


class Sector(Generic[P]):
    """One pitch with the strut at `place`, meshed for the half-widths `widths` [m]."""

    def __init__(
        self, q: Struts, place: P, widths: tuple[float, float], cells: int, *, mu: float
    ) -> None:
        self.q, self.place = q, place
        mesh = place.mesh((ZONE * widths[0], ZONE * widths[1]), cells)
        self.problem = pitch_problem(
            mesh, race_pairs(place, mu), E=q.E, nu=q.nu, z=q.z, races=("inner", "outer"),
            turned=HELD,
        )  # fmt: skip

    def rest(self, drags: Drags = (0.0, 0.0)) -> "State[P]":
        """Equilibrium state in which the strut neither leaves its azimuth nor rotates.

        `drags` [m] are the anticlockwise displacements of inner and outer race at the contacts;
        they are corrected until the strut is at rest.
        """
        return at_rest(self.at, drags, State.unrest, body=BODY, most=MOST)

    def at(self, drags: Drags, **more: Any) -> "State[P]":
        """State with the surfaces of both races displaced anticlockwise by `drags` [m].

        `more` are further arguments of the solver.
        """
        radii = self.place.OA, self.place.OB
        moved = {name: {"r": drag / radius}
                 for name, drag, radius in zip(HELD, drags, radii, strict=True)}  # fmt: skip
        return State(self, drags, self.problem.solve(displacements=moved, **more))


@dataclass(frozen=True)
class State(Touching, Generic[P]):
    """Equilibrium of a pitch; forces of one strut per length [N/m], torque of all struts [N].

    Pairs are values of the inner and the outer contact.
    """

    sector: Sector[P]
    drags: Drags
    solution: "ContactSolution"

    @property
    def start(self) -> P:
        return self.sector.place

    @cached_property
    def motion(self) -> tuple[float, float, float]:
        """Displacements [m] of the pole of the strut, along +x and outwards, and rotation [rad].

        The rotation is positive anticlockwise.
        """
        x, y = self.start.core
        u, turn = core_motion(self.solution, (x, y), self.sector.q.b)
        aside, outwards = u.mean(axis=1)
        return float(aside - turn * (self.start.D - y)), float(outwards - turn * x), turn

    def unrest(self) -> Unrest:
        """Displacement of the strut at its contacts, total overlap, and corrected `drags`."""
        aside, _, turn = self.motion
        below, above = (aside + turn * (self.start.D - y) for y in self.start.touched)
        drags = self.drags[0] + below, self.drags[1] + above
        return Unrest(max(abs(below), abs(above)), self.start.H, drags)

    @cached_property
    def place(self) -> P:
        """Equilibrium position of the strut, with the shares of the races in both overlaps."""
        opened = (
            float(touch.mortar.points.gap @ _shares(touch)) for touch in self.solution.touches
        )
        inner, outer = opened
        return self.start.settled(self.motion[1], self.race_at_contact, (inner, outer))

    @property
    def torque(self) -> float:
        """Driving torque at the bore of the inner race, per length [N]."""
        return self.sector.q.z * self.solution.plane.mean_reaction(HELD[0])["r"]

    @property
    def held(self) -> float:
        """Reaction torque at the rim of the outer race, per length [N]."""
        return -self.sector.q.z * self.solution.plane.mean_reaction(HELD[1])["r"]

    @cached_property
    def T(self) -> tuple[float, float]:
        """Tangential forces of both contacts, in the circumferential direction."""
        inner, outer = self.solution.touches
        return -inner.moment() / self.start.OA, outer.moment() / self.start.OB

    @cached_property
    def N(self) -> tuple[float, float]:
        """Normal forces of both contacts, in the radial direction."""
        inner, outer = (
            math.sqrt(math.hypot(*touch.force) ** 2 - T**2)
            for touch, T in zip(self.solution.touches, self.T, strict=True)
        )
        return inner, outer

    @property
    def angles(self) -> tuple[float, float]:
        """Angles nu and omega [rad], calculated as atan(T/N) from the forces."""
        inner, outer = (math.atan2(T, N) for T, N in zip(self.T, self.N, strict=True))
        return inner, outer

    @property
    def race_mean(self) -> tuple[float, float]:
        """Mean radial displacements [m] of the contact surfaces of the races, positive outwards."""
        inner, outer = (self.solution.plane.mean_displacement(name, _outwards) for name in RACES)
        return inner, outer

    @property
    def race_at_contact(self) -> tuple[float, float]:
        """Radial displacements [m] of the races at the centres of pressure, positive outwards."""
        inner, outer = (self._race_at(i) for i in (0, 1))
        return inner, outer

    @property
    def acts_at(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Radius [m] and azimuth [rad] of the centres of pressure, clockwise from the pole."""
        inner, outer = (_centre(touch) for touch in self.solution.touches)
        return inner, outer

    @property
    def energy(self) -> float:
        """Elastic energy of one pitch per length [N]."""
        return self.solution.strain_energy

    def _race_at(self, i: int) -> float:
        touch, trace = self.solution.touches[i], self.sector.problem.surfaces.masters[i]
        assert trace is not None
        points = touch.mortar.points
        shapes = trace.displacement_shapes(points.t)
        u = self.solution.displacements[trace.dofs[:, :, points.master]]
        radial = (np.einsum("kn,ikn->in", shapes, u) * _outwards(points.y)).sum(axis=0)
        return float(radial @ _shares(touch))


def _outwards(x: Array) -> Array:
    return np.asarray(x / np.hypot(*x))


def _shares(touch: "Touch") -> Array:
    """Shares (n,) of the normal force at the integration points."""
    load = touch.p * touch.weight
    return np.asarray(load / load.sum())


def _centre(touch: "Touch") -> tuple[float, float]:
    share, y = _shares(touch), touch.mortar.points.y
    x = y @ share
    return float(np.hypot(*y) @ share), math.atan2(x[0], x[1])


def race_pairs(place: Place, mu: float) -> "list[Pair]":
    """Contact pairs with the inner and the outer race."""
    from fem.contact.pairs import Pair
    from fem.contact.shapes import Circle, Spiral

    pole, rho_0, start, m = place.spiral
    centre, r_e = place.arc
    meet: Any = {"normal": "master", "friction": mu, "press_fit": True}
    return [
        Pair(slave=f"{BODY}.inner", master=RACES[0],
             interference=place.overlaps[0] - place.bends[0],
             slave_shape=Spiral(pole, rho_0, start, m),
             master_shape=Circle((0.0, 0.0), place.OA), **meet),
        Pair(slave=f"{BODY}.outer", master=RACES[1],
             interference=place.overlaps[1] - place.bends[1], slave_shape=Circle(centre, r_e),
             master_shape=Circle((0.0, 0.0), place.OB, hollow=True), **meet),
    ]  # fmt: skip
