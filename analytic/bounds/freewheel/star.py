"""Expected errors of the formulas of a star, from its dimensions and from three simpler bodies.

The approach of the star lies between the smallest and the largest of the approaches of a layer and
of two discs (`star_bracket`). The torque also causes a wind-up of the star on its bore, by which
the flat under the roller moves inwards. All other values follow from the approaches. Hertz's
parabolas on half planes cause errors of the order of (a/r)². Under N, surfaces tilt as a half plane
tilts at a depth equal to the wall thickness. Tangential forces deform the contacts. Thereby, they
increase the rotation of the ring by the fraction tan² alpha times the ratio of tangential to normal
compliance; this ratio is slightly below 1.
"""

import math
from collections.abc import Callable
from itertools import product

from analytic.bounds.freewheel.intervals import (
    LOOSE,
    SIDEWAYS,
    TIGHT,
    Interval,
    enclosed,
    of_approach,
    of_contact,
    of_round_bodies,
    tilting,
    times,
    winding,
)
from analytic.bounds.freewheel.parts import FreewheelParts, Loaded
from analytic.bounds.freewheel.star_bracket import between_discs, expected_approach

STEEPER = 1.15  # d ln(N)/d ln(approach) at most


class StarBounds:
    """Intervals of the errors (formula/reference - 1) in one state, from bounds of approaches."""

    def __init__(self, star: FreewheelParts, at: Loaded) -> None:
        self.star, self.at = star, at
        P, c = at.N / star.L, of_round_bodies(star, at)
        low, high = (float(d) for d in expected_approach(star, P))
        wound = winding(star, at.T, star.r_b, star.flat)
        wound *= float(star.centre(d_i=at.d_i, d_o=at.d_o)[0])
        low, high = low * (1 - c), high * (1 + c)
        # not the d_i of the formula: the expectation must not depend on what is verified
        self.own = {"d_i": float(between_discs(star, P)), "d_o": at.d_o}
        self.d_i = low + TIGHT * wound, high + LOOSE * wound
        self.d_o = at.d_o * (1 - c), at.d_o * (1 + c)
        wall = min(star.flat - star.r_b, star.R_a - star.race)
        self.tilt = tilting(star, P, wall) / math.tan(at.alpha)

    def approach(self, which: str) -> Interval:
        """Interval of the error of the approach `which`, d_i or d_o."""
        return of_approach(self.own[which], getattr(self, which))

    def contact(self) -> Interval:
        """Interval of the error of half-widths and pressures."""
        return of_contact(self.star, self.at)

    def angle(self) -> Interval:
        """Interval of the error of alpha."""
        return self._of(lambda **d: float(self.star.alpha(**d)))

    def unloaded(self) -> Interval:
        """Interval of the error if the angle without load is used in place of alpha."""
        return self._instead(float(self.star.alpha(d_i=0.0, d_o=0.0)))

    def unloaded_as_printed(self) -> Interval:
        """Interval of the error of alpha by Eq. 4 with r in place of R in the numerator.

        The angle is evaluated by cos 2a = 2 cos² a - 1.
        """
        s = self.star
        return self._instead(math.acos((s.r + s.flat) / (s.race - s.r) - 1) / 2)

    def as_printed(self) -> Interval:
        """Interval of the error of alpha by Eq. 5 with the signs of its denominator reversed.

        The angle is evaluated by the half-angle formula, tan² a = (1 - cos 2a)/(1 + cos 2a).
        """
        s, d = self.star, self.own
        cos = (s.flat - d["d_i"] + s.r) / (s.race - d["d_o"] + s.r)
        return self._instead(math.atan(math.sqrt((1 - cos) / (1 + cos))))

    def _instead(self, angle: float) -> Interval:
        """Interval of the error of an `angle` [rad] that is used in place of alpha."""
        return times(self.angle(), angle / float(self.star.alpha(**self.own)))

    def travel(self) -> Interval:
        """Interval of the error of the roller travel s."""
        return self._of(lambda **d: float(self.star.arc(**d)))

    def slope(self, *, tilted: bool = False) -> Interval:
        """Interval of the error of tan(alpha) as a formula for the mean F_t/N of both contacts.

        If `tilted`, the reference is F_t/N at one contact.
        """
        low, high = self._of(lambda **d: math.tan(float(self.star.alpha(**d))))
        more = self.tilt if tilted else 0.0
        return low - more, high + more

    def force(self) -> Interval:
        """Interval of the error of N at a given torque; N is proportional to 1/tan(alpha)."""
        low, high = self.slope(tilted=True)
        return 1 / (1 + high) - 1, 1 / (1 + low) - 1

    def torsion(self) -> Interval:
        """Interval of the error of phi, due to roller travel and tangential forces."""
        (low, high), square = self.travel(), math.tan(self.at.alpha) ** 2
        less, more = (share * square for share in SIDEWAYS)
        return (1 + low) / (1 + more) - 1, (1 + high) / (1 + less) - 1

    def force_at_angle(self) -> Interval:
        """Interval of the error of the normal force at a given angle.

        The angle determines the sum of both approaches.
        """
        size = sum(self.own.values())
        low, high = (sum(ends) / size for ends in zip(self.d_i, self.d_o, strict=True))
        return low**STEEPER - 1, high**STEEPER - 1

    def _of(self, value: Callable[..., float]) -> Interval:
        corners = [value(d_i=d_i, d_o=d_o) for d_i, d_o in product(self.d_i, self.d_o)]
        return enclosed(value(**self.own), corners)
