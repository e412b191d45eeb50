r"""Expected errors of the formulas of a sprag clutch, from dimensions and independent models.

The formulas neglect the change of the force angles by the motion of the ends of the column and of
the races under tangential forces. `analytic.sprag.bending` gives this change. The uncertainty of
the change is a quarter of the sum of the absolute values of its parts, plus beta²/2 with the angle
beta between both contacts. The tangential compliance of a race is 0.4 to 1.2 times the compliance
of its local indentation. The formulas of the elastic deflections neglect three effects: (a/r)² of a
contact, the fraction tan²(nu)/2 by which an inclined force is larger than N, and the difference of
the outer force N_e from N. Hertz's theory replaces an arc by a parabola, with an error of (a/r)²/4
of the gap, and assumes parallel normals, with an error of (a/r)²/2, for both bodies. The difference
of a wall or a column from a half-space is of the order (a/h)².
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
    """Intervals of the errors (formula/finite elements - 1) at a normal force N [N].

    `at` is the state at N, `a` are the half-widths [m] of both contacts, `column` is the sprag
    between its flanks (None if it has no flanks). `meshes` is the relative error of angles that is
    caused by the meshes.
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
        """Larger one of the values (a/r)² [1] of the two contacts."""
        q, (a_i, a_e) = self.sizes, self.a
        return max(a_i / min(q.r_i, q.R_i), a_e / q.r_e) ** 2

    @property
    def tan2(self) -> float:
        return math.tan(self.sizes.nu_0) ** 2

    @property
    def P(self) -> float:
        """Normal force per length, divided by the modulus: N/(l E') [m]."""
        return self.N / (self.sizes.l * self.sizes.E_plane)

    def angle(self) -> Interval:
        """Interval of the error of tan(nu) and tan(omega), which decrease as the column bends."""
        moves = self.bending
        doubt = BEND * moves.size + self.tilted() + float(self.at.beta) ** 2 / 2 + self.meshes
        return 1 / (1 + moves.whole + doubt) - 1, 1 / (1 + moves.whole - doubt) - 1

    def tilted(self) -> float:
        """Bound of the relative change of beta due to the tilt of thin walls at the contacts.

        The walls of thickness h are simply supported beams over a pitch L. The moment M = T h/2
        tilts them by M L/(12 E' I).
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
        """Interval of the error of n_s N tan(nu) OA.

        The lever arm OA is uncertain by 0.1 of the inner deflections.
        """
        (low, high), lever = self.angle(), LEVER * float(self.at.yields.inner) / self.sizes.R_i
        return low - lever, high + lever

    def force(self) -> Interval:
        """Interval of the error of N at a given torque."""
        low, high = self.torque()
        return 1 / (1 + high) - 1, 1 / (1 + low) - 1

    def excess(self) -> Interval:
        """Interval of the error of N_e/N_i - 1, a value proportional to the squares of angles."""
        low, high = self.angle()
        return 2 * low, 2 * high

    def elastic(self) -> Interval:
        """Interval of the error of the sum of deflections, and of the rotation due to this sum."""
        size = ELASTIC + self.tan2 / 2 + self.wide + self.askew
        return -size, size

    @property
    def askew(self) -> float:
        """Relative error of the deflections due to the lateral motion of the sprag ends.

        The error is the work of the tangential forces on this motion, relative to that of N.
        """
        at, (u_i, u_e) = self.at, self.ends.moved
        sideways = abs(u_i * math.tan(float(at.nu))) + abs(u_e * math.tan(float(at.omega)))
        return self.P * sideways / float(at.yields.H)

    def rotation_at_torque(self) -> Interval:
        (low, high), (less, more) = self.elastic(), self.force()
        return low + less, high + more

    def turn(self) -> Interval:
        """Interval of the error of the races' wind-up, which tangential forces increase."""
        (low, high), (less, more) = self.elastic(), (k * self.tan2 for k in SIDEWAYS)
        return (1 + low) / (1 + more) - 1, (1 + high) / (1 + less) - 1

    def hertz(self) -> Interval:
        """Interval of the error of peak pressures."""
        neglected = max(self.wide, self.thin_body("i"), self.thin_body("e"))
        size = EDGES + 10 * self.meshes + HERTZ * neglected
        return -size, size

    def width(self) -> Interval:
        """Interval of the error of half-widths; meshes resolve the edge of contact to one cell."""
        size = max(self.hertz()[1], ACCEPTED)
        return -size, size

    def thin_body(self, which: str) -> float:
        """Value (a/h)² at a contact; h is the smaller of wall thickness and sprag width."""
        wall, a = self.in_wall(which)
        return (a / min(wall, self.sizes.b)) ** 2

    def in_wall(self, which: str) -> Pair:
        """Wall thickness of a race [m] and half-width of its contact [m]."""
        q, (a_i, a_e) = self.sizes, self.a
        return (q.R_i - q.R_id, a_i) if which == "i" else (q.R_ed - q.R_e, a_e)

    def race(self, which: str) -> Interval:
        """Interval of the error of the deflection of a race in the middle of the contact patch."""
        wall, a = self.in_wall(which)
        size = SHARP + (a / wall) ** 2
        return -size, size

    def plane(self) -> Interval:
        """Interval of the error of the sum of deflections, computed by Hertz's contacts and Eq. 6.

        The approaches of the contacts are computed down to the depth of the walls and to half the
        height of the sprag.
        """
        return times(self.elastic(), self.plane_yields() / float(self.at.yields.H))

    def lost(self) -> Interval:
        """Interval of the error of the sum of deflections by the printed closure equations.

        The printed equations omit half of the deflections of contact and sprag on the inner side.
        """
        yields = self.at.yields
        lost = float(yields.contact_i + yields.sprag) / 2
        return times(self.elastic(), 1 - lost / float(yields.H), spread=SLOPES)

    def thin(self, which: str) -> Interval:
        """Interval of the error of Eq. 6 (plane stress) as the mean displacement of long rings."""
        return times((-SHARP, SHARP), self.thin_mean(which) / self.long_mean(which))

    def thin_at_contact(self, which: str) -> Interval:
        """Interval of the error of Eq. 6 as the deflection of a race under its load."""
        race = self.races[which == "e"]
        under = race.under / race.mean * self.long_mean(which)
        return times(self.race(which), self.thin_mean(which) / under)

    def long_mean(self, which: str) -> float:
        """Mean displacement [m] of a race in plane strain under the normal force on it."""
        force = float({"i": np.asarray(self.N), "e": self.at.N_e}[which])
        return self._lame_mean(force, which, "plane strain")

    def thin_mean(self, which: str) -> float:
        """Mean displacement [m] of a race in plane stress under N."""
        return self._lame_mean(self.N, which, "plane stress")

    def plane_yields(self) -> float:
        """Sum of deflections [m] of half planes and uniformly loaded rings, in the limit a -> 0."""
        q, P, half = self.sizes, self.N / self.sizes.l, (self.sizes.R_e - self.sizes.R_i) / 2
        walls = (q.R_i - q.R_id, q.R_ed - q.R_e)
        dents = sum(
            float(approach_to_far_depth(d, P=P, a=a, E=q.E, nu=q.nu, assumption="plane strain"))
            for a, wall in zip(self.a, walls, strict=True) for d in (wall, half)
        )  # fmt: skip
        return dents + sum(self._lame_mean(self.N, which, "plane strain") for which in ("i", "e"))

    @cached_property
    def ends(self) -> Ends:
        """Displacements and rotations of the sprag ends.

        Raises ValueError if a contact is beyond the flanks.
        """
        moved = self.column and ends(
            self.column, turned=float(self.at.turned), alpha_b=float(self.at.alpha_b), a=self.a,
            nu=self.sizes.nu,
        )  # fmt: skip
        if not moved:
            raise ValueError(
                "the contacts must lie between the flanks of the sprag: bending is not defined for "
                "contacts beyond the flanks"
            )
        return moved

    @cached_property
    def bending(self) -> Shift:
        """Relative change of the force angles due to the motion of sprag ends and races.

        Raises ValueError if a contact is beyond the flanks.
        """
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
    """Interval of the error of `ratio` (1 ± `spread`) times a formula with the error `interval`."""
    low, high = interval
    return ratio * (1 - spread) * (1 + low) - 1, ratio * (1 + spread) * (1 + high) - 1
