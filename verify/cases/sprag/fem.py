"""Finite elements of one pitch of a sprag clutch, at a rotation of the sprag.

The sprag touches both races and is free but for them. The races breathe as rings do: only the mean
rotation of the inner one's bore and of the outer one's rim is held. All bodies are drawn as they
are compressed, and the overlaps that do this are taken off the gaps.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from verify.cases.contact.errors import fem_errors
from verify.cases.sprag.bodies import Place

if TYPE_CHECKING:
    from skfem.mesh import Mesh2D

    from fem.contact.pairs import Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.solution import ContactSolution, Touch

Array = NDArray[np.float64]

ZONE = 1.5  # half-widths of even cells about each contact
CORE = 0.05  # of the sprag's width: where its motion is read
STILL, MOST = 1e-5, 12  # of both overlaps: what the sprag may move; steps
RACES = ("inner.rim", "outer.bore")
HELD = ("inner.bore", "outer.rim")


class Sector:
    """One pitch with the sprag at a place, meshed for contacts of these half-widths [m]."""

    def __init__(self, place: Place, widths: tuple[float, float], cells: int, *, mu: float) -> None:
        self.place = place
        self.problem = fem_problem(place, fem_mesh(place, widths, cells), mu)

    def rest(self, drags: tuple[float, float] = (0.0, 0.0)) -> "State":
        """The state in which the sprag neither leaves its azimuth nor turns.

        `drags` [m], how far inner and outer race are turned anticlockwise where they are touched,
        are improved until it does not.
        """
        bound = STILL * self.place.H
        for _ in range(MOST):
            state = self.at(drags)
            aside, _, turn = state.motion
            at = self.place.fem_drawn
            below, above = (aside + turn * (self.place.D - y) for y in (at.inner[1], at.outer[1]))
            if max(abs(below), abs(above)) <= bound:
                return state
            drags = drags[0] + below, drags[1] + above
        slips = ", and every node of a contact slips" if state.solution.slides else ""
        raise fem_errors().NotFoundError(
            "no equilibrium was found: the sprag still moves by "
            f"{max(abs(below), abs(above)):.1e} m after {MOST} steps{slips}"
        )

    def at(self, drags: tuple[float, float], **more: Any) -> "State":
        """The state with the surfaces of both races turned anticlockwise by `drags` [m].

        `more` goes to the solver.
        """
        radii = self.place.OA, self.place.OB
        moved = {name: {"r": drag / radius}
                 for name, drag, radius in zip(HELD, drags, radii, strict=True)}  # fmt: skip
        return State(self, drags, self.problem.solve(displacements=moved, **more))


@dataclass(frozen=True)
class State:
    """A pitch in equilibrium; forces of one sprag per length [N/m], torque of all [N].

    Pairs are of the inner and the outer contact.
    """

    sector: Sector
    drags: tuple[float, float]
    solution: "ContactSolution"

    @property
    def start(self) -> Place:
        return self.sector.place

    @cached_property
    def motion(self) -> tuple[float, float, float]:
        """How far [m] the sprag moves aside (+x) and outwards about its pole; how it turns [rad].

        The turn counts anticlockwise.
        """
        (x, y), near = self.start.fem_core, CORE * self.start.q.b
        points = np.array([[x], [y]]) + near * np.array([[1, -1, 0, 0], [0, 0, 1, -1]])
        u = self.solution.plane.at(points).u
        right, left, up, down = u.T
        turn = float((right[1] - left[1] - up[0] + down[0]) / (4 * near))
        aside, outwards = u.mean(axis=1)
        return float(aside - turn * (self.start.D - y)), float(outwards - turn * x), turn

    @cached_property
    def place(self) -> Place:
        """Where the sprag is, and what the races take of its overlaps."""
        moved = replace(self.start, D=self.start.D + self.motion[1])
        inner, outer = self.race_at_contact
        d_i, d_e = moved.overlaps
        b_i, b_e = (
            before + float(touch.mortar.points.gap @ _shares(touch))
            for before, touch in zip(self.start.bends, self.solution.touches, strict=True)
        )
        return replace(moved, shares=(-inner / d_i, outer / d_e), bends=(b_i, b_e))

    @property
    def torque(self) -> float:
        """That the inner race's bore is driven with [N]."""
        return self.start.q.z * self.solution.plane.mean_reaction(HELD[0])["r"]

    @property
    def held(self) -> float:
        """That the outer race's rim bears [N]."""
        return -self.start.q.z * self.solution.plane.mean_reaction(HELD[1])["r"]

    @cached_property
    def T(self) -> tuple[float, float]:
        """Tangential forces, as seen from the axis."""
        inner, outer = self.solution.touches
        return -inner.moment() / self.start.OA, outer.moment() / self.start.OB

    @cached_property
    def N(self) -> tuple[float, float]:
        """Normal forces, as seen from the axis."""
        inner, outer = (
            math.sqrt(math.hypot(*touch.force) ** 2 - T**2)
            for touch, T in zip(self.solution.touches, self.T, strict=True)
        )
        return inner, outer

    @property
    def angles(self) -> tuple[float, float]:
        """atan(T/N) [rad]: nu and omega, as the forces say."""
        inner, outer = (math.atan2(T, N) for T, N in zip(self.T, self.N, strict=True))
        return inner, outer

    @property
    def widths(self) -> tuple[float, float]:
        """Half-widths [m], from the moments of the pressure."""
        inner, outer = self.solution.touches
        return inner.half_width(), outer.half_width()

    @property
    def peaks(self) -> tuple[float, float]:
        """Largest pressures [Pa]."""
        inner, outer = self.solution.touches
        return inner.peak, outer.peak

    @property
    def race_mean(self) -> tuple[float, float]:
        """Radial displacements [m] outwards of the touched circles, on the average."""
        inner, outer = (self.solution.plane.mean_displacement(name, _outwards) for name in RACES)
        return inner, outer

    @property
    def race_at_contact(self) -> tuple[float, float]:
        """Radial displacements [m] outwards of the races under the centre of pressure."""
        inner, outer = (self._race_at(i) for i in (0, 1))
        return inner, outer

    @property
    def acts_at(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Radius [m] and azimuth, clockwise from the pole's [rad], of the centres of pressure."""
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
    """Parts (n,) of the normal force at the integration points."""
    load = touch.p * touch.weight
    return np.asarray(load / load.sum())


def _centre(touch: "Touch") -> tuple[float, float]:
    share, y = _shares(touch), touch.mortar.points.y
    x = y @ share
    return float(np.hypot(*y) @ share), math.atan2(x[0], x[1])


def fem_mesh(place: Place, widths: Sequence[float], cells: int) -> "Mesh2D":
    from meshes.sprag.sector import sprag_sector

    q, at = place.q, place.fem_drawn
    return sprag_sector(
        R_id=q.R_id * place.OA / q.R_i, R_i=place.OA, R_e=place.OB,
        R_ed=q.R_ed * place.OB / q.R_e, z=q.z, sprag=at.sprag, pole=at.pole, turn=at.turn,
        zones=(ZONE * widths[0], ZONE * widths[1]), cells=cells,
    )  # fmt: skip


def fem_problem(place: Place, mesh: "Mesh2D", mu: float) -> "ContactProblem":
    from fem.contact.problem import ContactProblem
    from fem.plane.material import Elastic
    from fem.plane.means import Mean
    from fem.plane.ties import Tie

    q = place.q
    return ContactProblem(
        mesh,
        materials=Elastic(E=q.E, nu=q.nu),
        assumption="plane strain",
        contacts=fem_pairs(place, mu),
        ties=[
            Tie(leader=f"{body}.right", follower=f"{body}.left", angle=2 * math.pi / q.z)
            for body in ("inner", "outer")
        ],
        means={name: Mean({"r": 0.0}) for name in HELD},
    )


def fem_pairs(place: Place, mu: float) -> list["Pair"]:
    """The contacts with the inner and the outer race."""
    from fem.contact.pairs import Pair
    from fem.contact.shapes import Circle, Spiral

    at = place.fem_drawn
    x, y = at.placed(np.array(at.sprag.centre))
    s, start = at.sprag, at.sprag.theta_0 - at.turn - math.pi / 2
    meet: Any = {"normal": "master", "friction": mu, "press_fit": True}
    return [
        Pair(slave="sprag.inner", master=RACES[0], interference=place.overlaps[0] - place.bends[0],
             slave_shape=Spiral(at.pole, s.rho_0, start, s.m),
             master_shape=Circle((0.0, 0.0), place.OA), **meet),
        Pair(slave="sprag.outer", master=RACES[1], interference=place.overlaps[1] - place.bends[1],
             slave_shape=Circle((float(x), float(y)), s.r_e),
             master_shape=Circle((0.0, 0.0), place.OB, hollow=True), **meet),
    ]  # fmt: skip
