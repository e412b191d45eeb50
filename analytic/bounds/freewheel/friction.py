"""Expected errors of the friction of a freewheel, from the possible errors of the clamping angle.

A tangential force causes no normal displacement on a body that is symmetric about the contact
normal. The contact on a flat is at the angle psi, about 2 tan(alpha), from the middle of the flat;
F_t is tan(alpha) N; and the shape of the bodies determines less than half of an approach.
Therefore, tangential forces change approaches by at most the fraction tan² alpha. tan² alpha
increases linearly with the approaches from its value at alpha_0.
"""

import math
from collections.abc import Callable

from analytic.bounds.freewheel.intervals import Interval, times
from analytic.bounds.freewheel.star import StarBounds

WIDEST = 0.04  # interval at the limit: near tan(alpha) = mu it has no meaning
SAME_EQUATION = 1e-6  # relative difference of two forms of one equation, besides their ratio


class FrictionBounds:
    """Intervals of the errors (formula/reference - 1) under torque and axial load.

    `star` contains the bounds of the angle. `mu` is the friction coefficient, `lever` is F_ax R/T.
    """

    def __init__(self, star: StarBounds, *, mu: float, lever: float) -> None:
        self.star, self.mu, self.lever = star, mu, lever
        self.tan = math.tan(star.at.alpha)
        least = math.tan(float(star.star.alpha(d_i=0.0, d_o=0.0)))
        self.rest = (self.tan**2 - least**2) / 2

    def one_contact(self) -> Interval:
        """Interval of the error of F_t/N if each contact is considered separately."""
        return self._wider(self.star.slope(tilted=True))

    def both_contacts(self) -> Interval:
        """Interval of the error of the mean F_t/N of both contacts."""
        return self._wider(self.star.slope())

    def normal_force(self) -> Interval:
        """Interval of the error of N."""
        return self._wider(self.star.force())

    def whole_load(self) -> Interval:
        """Interval of the error of Eq. 8 with the axial load of all rollers in place of F_a."""
        more = math.hypot(1.0, self.star.star.z * self.lever) / math.hypot(1.0, self.lever)
        return times(self.one_contact(), more, SAME_EQUATION)

    def two_tangents(self) -> Interval:
        """Interval of the error of Eq. 8 as printed, with tan(alpha) in place of mu_req."""
        return times(self.both_contacts(), math.hypot(1.0, self.lever), SAME_EQUATION)

    def limit_load(self) -> Interval | None:
        """Interval of the error of F_ax at the friction limit; None if the interval is too wide.

        The interval is too wide if tan(alpha) is near mu: the torque alone nearly causes slip.
        """
        return self._sharp(lambda tan: math.sqrt((self.mu / tan) ** 2 - 1))

    def limit_creep(self) -> Interval | None:
        """Interval of the error of F_t/F_z at the friction limit; None if `limit_load` is None."""
        return self._sharp(lambda tan: 1 / math.sqrt((self.mu / tan) ** 2 - 1))

    def _wider(self, interval: Interval) -> Interval:
        """Return `interval`, widened by the effect of tangential forces on the angle."""
        return interval[0] - self.rest, interval[1] + self.rest

    def _sharp(self, of: Callable[[float], float]) -> Interval | None:
        found = at_limit(of, self.tan, self.one_contact(), self.mu)
        return None if found is None or not found[1] - found[0] < WIDEST else found


def limit_load(star: StarBounds, mu: float) -> Interval | None:
    """Interval of the error of the axial load F_ax at which a path reaches the friction limit.

    The interval follows from the possible error of tan(alpha) of one contact.
    """
    return at_limit(lambda tan: math.sqrt((mu / tan) ** 2 - 1), math.tan(star.at.alpha),
                    star.slope(tilted=True), mu)  # fmt: skip


def at_limit(
    of: Callable[[float], float], value: float, slope: Interval, mu: float
) -> Interval | None:
    """Interval of the error of `of(tan(alpha))`, if `tan(alpha)` has the error `slope`.

    None if tan(alpha) may reach mu, so that the torque alone would expel the rollers.

    >>> at_limit(lambda tan: 1 / tan, 0.05, (-0.5, 0.0), mu=0.2)
    (0.0, 1.0)
    """
    ends = [value / (1 + m) for m in slope]
    if max(*ends, value) >= mu:
        return None
    found = [of(value) / of(tan) - 1 for tan in ends]
    return min(found), max(found)
