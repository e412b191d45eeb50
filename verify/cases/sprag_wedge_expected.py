r"""What formulas of a sprag clutch are expected to miss, from sizes and second models.

The elastic yields leave out (a/r)² of a contact, and tan²(nu) of the force, which stands askew. A
column whose contacts lie e beside its middle, on opposite sides, bends into an S,

.. math:: \psi = \frac{P e h/4}{E' b^3/12},

by which its ends turn; the contacts move along by at most h/2 psi each, h = R_e - R_i, those of
short columns by half more, and the strut with them. Tangential forces turn the races further by
tan² times a compliance somewhat below the normal one.
"""

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np

from analytic.contact.hertz_line_approach import approach_to_far_depth
from analytic.ring import lame
from analytic.sprag.closure import wedged
from analytic.sprag.compliance import Yields
from verify.cases.sprag_inputs import WedgeInputs
from verify.cases.sprag_wedge_model import (
    elastic,
    half_widths,
    plane_modulus,
    races,
    rigid_force,
)

Interval = tuple[float, float]

ROUGH = 2e-3  # acceptance of the subject for force ratios; meshes and second order
SHARP = 1e-3  # what reciprocity leaves, of second order
ELASTIC = 2e-3  # of yields, beside what is computed
HERTZ, ACCEPTED = 4.0, 1e-2  # bound of what Hertz neglects over (a/r)², and no less
BENDS = 1.5  # of psi, by which a strut turns at most
RACES = 4e-3  # of what a race yields under its load
SIDEWAYS = 0.4, 1.2  # bounds of the tangential over the normal compliance
SLOPES = 5e-3  # of how much rotation goes with a yield of one side, over that of the other
WIDEST = 1.5  # of the demand: an interval that leaves a row of one's own sharp enough


@dataclass(frozen=True)
class Expected:
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

    @property
    def bent(self) -> float:
        """Angle psi [rad] by which the column's ends turn."""
        q, at = self.q, wedged(elastic(self.q), self.N)
        e = float(at.rho) * abs(float(at.turned))
        section = plane_modulus(q) * q.b**3 / 12
        return self.N / q.l * e * (q.R_e - q.R_i) / 4 / section

    def angle(self) -> Interval:
        """Of tan(nu) and tan(omega), which fall as the column bends."""
        return -ROUGH, ROUGH + BENDS * self.bent / math.tan(self.q.nu_0)

    def torque(self) -> Interval:
        low, high = self.angle()
        return low - SHARP, high + SHARP

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
        size = ELASTIC + self.tan2 + self.wide
        return -size - self.bent, size

    def rotation_at_torque(self) -> Interval:
        (low, high), (less, more) = self.elastic(), self.force()
        return low + less, high + more

    def turn(self) -> Interval:
        """Of the races, to which tangential forces add."""
        (low, high), (less, more) = self.elastic(), (k * self.tan2 for k in SIDEWAYS)
        return (1 + low) / (1 + more) - 1, (1 + high) / (1 + less) - 1

    def hertz(self) -> Interval:
        """Of pressures and half-widths."""
        size = max(HERTZ * self.wide, ACCEPTED)
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
        return times((-RACES, RACES), thin_mean(self.q, self.N, which) / under)

    def long_mean(self, which: str) -> float:
        """Of a long race [m], each under its own normal force."""
        at = wedged(elastic(self.q), self.N)
        return lame_mean(self.q, float({"i": at.N, "e": at.N_e}[which]), which, "plane strain")

    @property
    def _yields(self) -> Yields:
        return elastic(self.q).compliance.yields(self.N)


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


@lru_cache(maxsize=64)
def at_share(q: WedgeInputs, share: float) -> Expected:
    """At the normal force that is `share` of a rigid clutch's."""
    return Expected(q, share * rigid_force(q))
