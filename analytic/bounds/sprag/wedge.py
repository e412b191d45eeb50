r"""Expected errors of the formulas of a sprag clutch, from sizes and second models.

The angles of the forces omit the part that `analytic.sprag.bending` has for the column's ends and
the races under tangential forces, to a quarter of all its parts and half beta² of the triangle. The
tangential compliance of a race is 0.4 to 1.2 times the compliance of its local indentation.

The elastic deflections omit (a/r)² of a contact, half tan²(nu) by which an inclined force is
larger than N, and that the outer force is N_e. Hertz takes an arc for a parabola, an error of
(a/r)²/4 of the gap, and its normals for parallel, (a/r)²/2, on both bodies; a wall or a column is
no half-space by (a/h)².
"""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from analytic.bounds.sprag.wedge_sizes import Race, Sizes, State
from analytic.contact.hertz_line_approach import approach_to_far_depth
from analytic.ring import lame
from analytic.sprag.bending import Ends, Pair, Shift, ends, shift
from analytic.sprag.column import Column

Interval = tuple[float, float]
Assumption = Literal["plane stress", "plane strain"]

BEND = 0.25  # of all parts of a shift: point forces, straight walls, proportional slip
LEVER = 0.1  # relative to the deflections at the inner contact: error of their distribution
SHARP = 1e-3  # error of second order by reciprocity
ELASTIC = 1e-3  # over deflections: polynomials of the column (4e-4), N for N_e on one side (5e-4)
HERTZ, EDGES = 2.0, 2e-3  # Hertz's error over (a/r)²; effect of a contact edge inside a cell
ACCEPTED = 1e-2  # of half-widths
SIDEWAYS = 0.4, 1.2  # bounds of the tangential over the normal compliance
SLOPES = 5e-3  # relative to the ratio of the rotations per deflection of both sides


@dataclass(frozen=True, kw_only=True, eq=False)
class Bounds:
    """Intervals for formula/FE - 1 at a normal force N [N].

    `at` is the state there, `a` half-widths [m] of both contacts, `column` the sprag between its
    flanks, None if it has none. `meshes` is the error of angles by meshes.
    """

    sizes: Sizes
    N: float
    at: State
    a: Pair
    races: tuple[Race, Race]
    column: Column | None
    meshes: float = 0.0

    @property
    def wide(self) -> float:
        """(a/r)² of the wider contact."""
        q, (a_i, a_e) = self.sizes, self.a
        return max(a_i / min(q.r_i, q.R_i), a_e / q.r_e) ** 2

    @property
    def tan2(self) -> float:
        return math.tan(self.sizes.nu_0) ** 2

    @property
    def P(self) -> float:
        """N/(l E') [m]."""
        return self.N / (self.sizes.l * self.sizes.E_plane)

    def angle(self) -> Interval:
        """Error of tan(nu) and tan(omega), which fall as the column bends."""
        moves = self.bending
        doubt = BEND * moves.size + self.tilted() + float(self.at.beta) ** 2 / 2 + self.meshes
        return 1 / (1 + moves.whole + doubt) - 1, 1 / (1 + moves.whole - doubt) - 1

    def tilted(self) -> float:
        """Largest rolling of the contacts, over beta, as the moment T h/2 tilts thin walls h.

        Walls are beams over a pitch L, simply supported: M L/(12 E' I).
        """
        q, at = self.sizes, self.at
        T = self.N * math.tan(float(at.nu)) / (q.l * q.E_plane)
        r_i, r_e = q.r_i, q.r_e
        # parts of a tilt by which beta changes
        shares = r_i / (r_i + q.R_i), r_e / (q.R_e - r_e)
        tilts = (T / 2 * (2 * math.pi * R / q.z) / h**2
                 for R, h in ((q.R_i, q.R_i - q.R_id), (q.R_e, q.R_ed - q.R_e)))  # fmt: skip
        return sum(a * b for a, b in zip(shares, tilts, strict=True)) / float(at.beta)

    def torque(self) -> Interval:
        """Error of n_s N tan(nu) OA; its lever is uncertain by 0.1 of the inner deflections."""
        (low, high), lever = self.angle(), LEVER * float(self.at.yields.inner) / self.sizes.R_i
        return low - lever, high + lever

    def force(self) -> Interval:
        """Interval of the error of N at a torque."""
        low, high = self.torque()
        return 1 / (1 + high) - 1, 1 / (1 + low) - 1

    def excess(self) -> Interval:
        """Error of N_e/N_i - 1, proportional to the square of both angles."""
        low, high = self.angle()
        return 2 * low, 2 * high

    def elastic(self) -> Interval:
        """Error of the sum of all deflections, and of the related rotation."""
        size = ELASTIC + self.tan2 / 2 + self.wide + self.askew
        return -size, size

    @property
    def askew(self) -> float:
        """Error of the deflections: only forces along AB do work on lateral motion of ends."""
        at, (u_i, u_e) = self.at, self.ends.moved
        sideways = abs(u_i * math.tan(float(at.nu))) + abs(u_e * math.tan(float(at.omega)))
        return self.P * sideways / float(at.yields.H)

    def rotation_at_torque(self) -> Interval:
        (low, high), (less, more) = self.elastic(), self.force()
        return low + less, high + more

    def turn(self) -> Interval:
        """Error of the deflection of the races, to which tangential forces add."""
        (low, high), (less, more) = self.elastic(), (k * self.tan2 for k in SIDEWAYS)
        return (1 + low) / (1 + more) - 1, (1 + high) / (1 + less) - 1

    def hertz(self) -> Interval:
        """Interval of the error of peak pressures."""
        neglected = max(self.wide, self.thin_body("i"), self.thin_body("e"))
        size = EDGES + 10 * self.meshes + HERTZ * neglected
        return -size, size

    def width(self) -> Interval:
        """Error of half-widths; the edge of the contact is known only within a cell."""
        size = max(self.hertz()[1], ACCEPTED)
        return -size, size

    def thin_body(self, which: str) -> float:
        """(a/h)² of the thinner body at a contact: the race's wall or the sprag's width."""
        wall, a = self.in_wall(which)
        return (a / min(wall, self.sizes.b)) ** 2

    def in_wall(self, which: str) -> Pair:
        """Wall of a race and half-width of its contact [m]."""
        q, (a_i, a_e) = self.sizes, self.a
        return (q.R_i - q.R_id, a_i) if which == "i" else (q.R_ed - q.R_e, a_e)

    def race(self, which: str) -> Interval:
        """Error of the deflection of a race under its load, at the middle of the patch."""
        wall, a = self.in_wall(which)
        size = SHARP + (a / wall) ** 2
        return -size, size

    def plane(self) -> Interval:
        """Error of Hertz's contacts to the walls' depth and half the sprag, and of Eq. 6."""
        return times(self.elastic(), self.plane_yields() / float(self.at.yields.H))

    def lost(self) -> Interval:
        """Error of the printed closure, which omits half of the deflection at the inner contact."""
        yields = self.at.yields
        lost = float(yields.contact_i + yields.sprag) / 2
        return times(self.elastic(), 1 - lost / float(yields.H), spread=SLOPES)

    def thin(self, which: str) -> Interval:
        """Error of Eq. 6, thin rings, for the mean displacement of long rings."""
        return times((-SHARP, SHARP), self.thin_mean(which) / self.long_mean(which))

    def thin_at_contact(self, which: str) -> Interval:
        """Error of Eq. 6 for the deflection of a race under its load."""
        race = self.races[which == "e"]
        under = race.under / race.mean * self.long_mean(which)
        return times(self.race(which), self.thin_mean(which) / under)

    def long_mean(self, which: str) -> float:
        """Mean displacement of each long race [m] under the normal force on it."""
        force = float({"i": np.asarray(self.N), "e": self.at.N_e}[which])
        return self._lame_mean(force, which, "plane strain")

    def thin_mean(self, which: str) -> float:
        """Mean displacement of each thin race [m] under N."""
        return self._lame_mean(self.N, which, "plane stress")

    def plane_yields(self) -> float:
        """All deflections [m] of half planes and uniformly loaded rings, contacts being small."""
        q, P, half = self.sizes, self.N / self.sizes.l, (self.sizes.R_e - self.sizes.R_i) / 2
        walls = (q.R_i - q.R_id, q.R_ed - q.R_e)
        dents = sum(
            float(approach_to_far_depth(d, P=P, a=a, E=q.E, nu=q.nu, assumption="plane strain"))
            for a, wall in zip(self.a, walls, strict=True) for d in (wall, half)
        )  # fmt: skip
        return dents + sum(self._lame_mean(self.N, which, "plane strain") for which in ("i", "e"))

    @cached_property
    def ends(self) -> Ends:
        """Movement and rotation of the sprag's ends; ValueError off the flanks."""
        moved = self.column and ends(
            self.column, turned=float(self.at.turned), alpha_b=float(self.at.alpha_b), a=self.a,
            nu=self.sizes.nu,
        )  # fmt: skip
        if not moved:
            raise ValueError("the contacts are beyond the sprag's flanks: no bending")
        return moved

    @cached_property
    def bending(self) -> Shift:
        """Change of force ratios as ends and races move; ValueError off the flanks."""
        moved = self.ends
        assert self.column is not None
        sideways = self.P * math.tan(float(self.at.nu)) * sum(SIDEWAYS) / 2
        inner, outer = (sideways * (race.at - race.mean) for race in self.races)
        return shift(self.at, moved, column=self.column, a=self.a, P=self.P, races=(inner, outer))

    def _lame_mean(self, N: float, which: str, ends: Assumption) -> float:
        """Mean displacement [m] of the inner or outer race ("i", "e") under a uniform pressure."""
        q, inner = self.sizes, which == "i"
        r_i, r_o, r = (q.R_id, q.R_i, q.R_i) if inner else (q.R_e, q.R_ed, q.R_e)
        p = q.z * N / (2 * math.pi * r * q.l)
        u = lame.radial_displacement(
            r, r_i=r_i, r_o=r_o, p_i=0.0 if inner else p, p_o=p if inner else 0.0, E=q.E, nu=q.nu,
            ends=ends,
        )  # fmt: skip
        return abs(float(u))


def times(interval: Interval, ratio: float, spread: float = 0.0) -> Interval:
    """The interval of a formula that is `ratio` times another formula, within `spread`."""
    low, high = interval
    return ratio * (1 - spread) * (1 + low) - 1, ratio * (1 + spread) * (1 + high) - 1
