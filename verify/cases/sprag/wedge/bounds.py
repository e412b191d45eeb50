r"""What formulas of a sprag clutch are expected to miss, from sizes and second models.

The angles of the forces miss what `analytic.sprag.bending` says of the column's ends and the races
under tangential forces, to a quarter of all its parts and half beta² of the triangle. A race's
tangential compliance is 0.4 to 1.2 of that of its dent.

The elastic yields leave out (a/r)² of a contact, half tan²(nu) by which a force that stands askew
is longer than N, and that the outer force is N_e. Hertz takes an arc for a parabola, an error of
(a/r)²/4 of the gap, and its normals for parallel, (a/r)²/2, on both bodies; a wall or a column is
no half-space by (a/h)².
"""

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np

from analytic.contact.hertz_line_approach import approach_to_far_depth
from analytic.ring import lame
from analytic.sprag.bending import Ends, Pair, Shift, ends, shift
from analytic.sprag.closure import Wedged, wedged
from analytic.sprag.compliance import Yields
from verify.cases.sprag.inputs import WedgeInputs
from verify.cases.sprag.wedge.model import (
    elastic,
    half_widths,
    plane_modulus,
    races,
    sprag_column,
)

Interval = tuple[float, float]

BEND = 0.25  # of all parts of a shift: point forces, straight walls, proportional slip
MESHES = 5e-4  # of angles of one's own sprags; ten times that of pressures
LEVER = 0.1  # of the yields about the inner contact, how they share
SHARP = 1e-3  # what reciprocity leaves, of second order
ELASTIC = 1e-3  # of yields: polynomials of the column (4e-4), N for N_e on one side (5e-4)
HERTZ, EDGES = 2.0, 2e-3  # bound of what Hertz neglects over (a/r)²; where contacts end in a cell
ACCEPTED = 1e-2  # of half-widths
SIDEWAYS = 0.4, 1.2  # bounds of the tangential over the normal compliance
SLOPES = 5e-3  # of how much rotation goes with a yield of one side, over that of the other
WIDEST = 1.5  # of the sensitivity: an interval that leaves a row of one's own sharp enough


@dataclass(frozen=True)
class Bounds:
    """Intervals for formula/FE - 1 at a normal force N [N]."""

    q: WedgeInputs
    N: float

    @property
    def wide(self) -> float:
        """(a/r)² of the wider contact."""
        q, sprag = self.q, self.q.sprag
        a_i, a_e = half_widths(q, np.asarray(self.N))
        return max(float(a_i) / min(q.r_i, q.R_i), float(a_e / sprag.r_e)) ** 2

    @property
    def tan2(self) -> float:
        return math.tan(self.q.nu_0) ** 2

    def angle(self) -> Interval:
        """Of tan(nu) and tan(omega), which fall as the column bends."""
        moves = bending(self.q, self.N)
        doubt = BEND * moves.size + self.tilted() + float(self._at.beta) ** 2 / 2 + self.unseen
        return 1 / (1 + moves.whole + doubt) - 1, 1 / (1 + moves.whole - doubt) - 1

    def tilted(self) -> float:
        """By how much of beta the contacts roll at most as the moment T h/2 tilts thin walls h.

        Walls are beams over a pitch L, simply supported: M L/(12 E' I).
        """
        q, at = self.q, self._at
        T = self.N * math.tan(float(at.nu)) / (q.l * plane_modulus(q))
        r_i, r_e = q.r_i, float(q.sprag.r_e)
        # parts of a tilt by which beta changes
        shares = r_i / (r_i + q.R_i), r_e / (q.R_e - r_e)
        tilts = (T / 2 * (2 * math.pi * R / q.z) / h**2
                 for R, h in ((q.R_i, q.R_i - q.R_id), (q.R_e, q.R_ed - q.R_e)))  # fmt: skip
        return sum(a * b for a, b in zip(shares, tilts, strict=True)) / float(at.beta)

    @property
    def unseen(self) -> float:
        """What meshes leave of angles of one's own; on the case's they were refined until still."""
        return 0.0 if self.q == WedgeInputs() else MESHES

    def torque(self) -> Interval:
        """Of n_s N tan(nu) OA, whose lever is as unsure as a tenth of the inner yields."""
        (low, high), lever = self.angle(), LEVER * float(self._yields.inner) / self.q.R_i
        return low - lever, high + lever

    def force(self) -> Interval:
        """Of N at a torque."""
        low, high = self.torque()
        return 1 / (1 + high) - 1, 1 / (1 + low) - 1

    def excess(self) -> Interval:
        """Of N_e/N_i - 1, which goes as the square of both angles."""
        low, high = self.angle()
        return 2 * low, 2 * high

    def elastic(self) -> Interval:
        """Of all yields together, and of the rotation that goes with them."""
        size = ELASTIC + self.tan2 / 2 + self.wide + self.askew
        return -size, size

    @property
    def askew(self) -> float:
        """Of all yields: forces along AB do work on ends that move sideways, N does not."""
        at, (u_i, u_e) = self._at, moved_ends(self.q, self.N).moved
        P = self.N / (self.q.l * plane_modulus(self.q))
        sideways = abs(u_i * math.tan(float(at.nu))) + abs(u_e * math.tan(float(at.omega)))
        return P * sideways / float(at.yields.H)

    def rotation_at_torque(self) -> Interval:
        (low, high), (less, more) = self.elastic(), self.force()
        return low + less, high + more

    def turn(self) -> Interval:
        """Of the races, to which tangential forces add."""
        (low, high), (less, more) = self.elastic(), (k * self.tan2 for k in SIDEWAYS)
        return (1 + low) / (1 + more) - 1, (1 + high) / (1 + less) - 1

    def hertz(self) -> Interval:
        """Of peak pressures."""
        size = (
            EDGES
            + 10 * self.unseen
            + HERTZ * max(self.wide, self.thin_body("i"), self.thin_body("e"))
        )
        return -size, size

    def width(self) -> Interval:
        """Of half-widths, which end within a cell."""
        size = max(self.hertz()[1], ACCEPTED)
        return -size, size

    def thin_body(self, which: str) -> float:
        """(a/h)² of the thinner body at a contact: the race's wall or the sprag's width."""
        wall, a = self.in_wall(which)
        return (a / min(wall, self.q.b)) ** 2

    def in_wall(self, which: str) -> Pair:
        """Wall of a race and half-width of its contact [m]."""
        q, (a_i, a_e) = self.q, half_widths(self.q, np.asarray(self.N))
        if which == "i":
            return q.R_i - q.R_id, float(a_i)
        return q.R_ed - q.R_e, float(a_e)

    def race(self, which: str) -> Interval:
        """Of what a race yields under its load, at the middle of the patch."""
        wall, a = self.in_wall(which)
        size = SHARP + (a / wall) ** 2
        return -size, size

    def plane(self) -> Interval:
        """Of Hertz's contacts to the walls' depth and half the sprag's height, and of Eq. 6."""
        return times(self.elastic(), plane_yields(self.q, self.N) / float(self._yields.H))

    def lost(self) -> Interval:
        """Of the printed closure, half of what yields at the inner contact left out."""
        lost = float(self._yields.contact_i + self._yields.sprag) / 2
        return times(self.elastic(), 1 - lost / float(self._yields.H), spread=SLOPES)

    def thin(self, which: str) -> Interval:
        """Of Eq. 6, thin rings, for the mean of long ones."""
        return times((-SHARP, SHARP), thin_mean(self.q, self.N, which) / self.long_mean(which))

    def thin_at_contact(self, which: str) -> Interval:
        """Of Eq. 6 for what a race yields under its load."""
        race, a = races(self.q)[which == "e"], half_widths(self.q, np.asarray(self.N))
        under = float(race.under(a[which == "e"])) / race.mean * self.long_mean(which)
        return times(self.race(which), thin_mean(self.q, self.N, which) / under)

    def long_mean(self, which: str) -> float:
        """Of a long race [m], each under its own normal force."""
        at = wedged(elastic(self.q), self.N)
        return lame_mean(self.q, float({"i": at.N, "e": at.N_e}[which]), which, "plane strain")

    @property
    def _at(self) -> Wedged:
        return wedged(elastic(self.q), self.N)

    @property
    def _yields(self) -> Yields:
        return self._at.yields


@lru_cache(maxsize=256)
def moved_ends(q: WedgeInputs, N: float) -> Ends:
    """How the sprag's ends move and turn under N [N]; ValueError off the flanks."""
    at, column = wedged(elastic(q), N), sprag_column(q)
    a_i, a_e = (float(a) for a in half_widths(q, np.asarray(N)))
    moved = column and ends(
        column, turned=float(at.turned), alpha_b=float(at.alpha_b), a=(a_i, a_e), nu=q.nu
    )
    if not (column and moved):
        raise ValueError("a sprag that does not stand between its flanks has no bending")
    return moved


@lru_cache(maxsize=256)
def bending(q: WedgeInputs, N: float) -> Shift:
    """How far force ratios change as ends and races move under N [N]; ValueError off the flanks."""
    moved, at, column = moved_ends(q, N), wedged(elastic(q), N), sprag_column(q)
    assert column is not None
    a_i, a_e = (float(a) for a in half_widths(q, np.asarray(N)))
    P = N / (q.l * plane_modulus(q))
    sideways = P * math.tan(float(at.nu)) * sum(SIDEWAYS) / 2
    inner, outer = (
        sideways * float(race.at(np.asarray(a)) - race.mean)
        for race, a in zip(races(q), (a_i, a_e), strict=True)
    )
    return shift(at, moved, column=column, a=(a_i, a_e), P=P, races=(inner, outer))


def plane_yields(q: WedgeInputs, N: float) -> float:
    """All yields [m] of half planes and smeared rings, for contacts much smaller than bodies."""
    P, half = N / q.l, (q.R_e - q.R_i) / 2
    walls = (q.R_i - q.R_id, q.R_ed - q.R_e)
    dents = sum(
        float(approach_to_far_depth(d, P=P, a=a, E=q.E, nu=q.nu, assumption="plane strain"))
        for a, wall in zip(half_widths(q, np.asarray(N)), walls, strict=True) for d in (wall, half)
    )  # fmt: skip
    return dents + sum(lame_mean(q, N, which, "plane strain") for which in ("i", "e"))


def thin_mean(q: WedgeInputs, N: float, which: str) -> float:
    return lame_mean(q, N, which, "plane stress")


def lame_mean(q: WedgeInputs, N: float, which: str, ends: Literal["plane stress", "plane strain"],
              ) -> float:  # fmt: skip
    """Mean displacement [m] of the inner or outer race ("i", "e") under smeared forces."""
    inner = which == "i"
    r_i, r_o, r = (q.R_id, q.R_i, q.R_i) if inner else (q.R_e, q.R_ed, q.R_e)
    p = q.z * N / (2 * math.pi * r * q.l)
    u = lame.radial_displacement(
        r, r_i=r_i, r_o=r_o, p_i=0.0 if inner else p, p_o=p if inner else 0.0, E=q.E, nu=q.nu,
        ends=ends,
    )  # fmt: skip
    return abs(float(u))


def times(interval: Interval, ratio: float, spread: float = 0.0) -> Interval:
    """The interval of a formula that is `ratio` times another, within `spread` of that."""
    low, high = interval
    return ratio * (1 - spread) * (1 + low) - 1, ratio * (1 + spread) * (1 + high) - 1
