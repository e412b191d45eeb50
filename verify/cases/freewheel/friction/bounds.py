"""What is expected of a freewheel's friction, from what may be wrong with the clamping angle.

A tangential force moves nothing across itself where a body is its own mirror image. Contacts on
flats are off their middle by psi, some 2 tan(alpha), F_t is tan(alpha) of N, and the bodies' shape
makes less than half of an approach: by size, approaches change by tan² alpha of themselves at most.
From alpha_0 on tan² alpha is linear in them.
"""

import math
from collections.abc import Callable

from verify.cases.freewheel.bounds import Bounds, Interval, times
from verify.cases.freewheel.pulled import Pulled

WIDEST = 0.04  # interval at the limit: near tan(alpha) = mu it says nothing
ALIKE = 1e-6  # of a value: what two forms of one equation differ by beside their ratio


class FrictionBounds:
    """Intervals for formula/reference - 1 under torque and axial load."""

    def __init__(self, q: Pulled) -> None:
        self.q, self.star = q, Bounds(q, q.state)
        tan, least = (math.tan(float(a)) for a in (q.state.alpha, q.cam.alpha0))
        self.rest = (tan**2 - least**2) / 2

    def one_contact(self) -> Interval:
        """Of F_t/N where both contacts count by themselves."""
        return self._wider(self.star.slope(tilted=True))

    def both_contacts(self) -> Interval:
        """Of the mean of both."""
        return self._wider(self.star.slope())

    def normal_force(self) -> Interval:
        """Of N."""
        return self._wider(self.star.force())

    def whole_load(self) -> Interval:
        """Eq. 8 with the F_ax of Eq. 9: z times the axial force of a roller."""
        lever = self.q.lever
        more = math.hypot(1.0, self.q.z * lever) / math.hypot(1.0, lever)
        return times(self.one_contact(), more, ALIKE)

    def two_tangents(self) -> Interval:
        """Eq. 8 as it stands calls tan(alpha) what is mu_req."""
        return times(self.both_contacts(), math.hypot(1.0, self.q.lever), ALIKE)

    def limit_load(self) -> Interval | None:
        """Of F_ax at the limit: none where the slope's alone nearly lets the roller out."""
        return self._through(lambda tan: math.sqrt((self.q.mu / tan) ** 2 - 1))

    def limit_creep(self) -> Interval | None:
        """Of F_t/F_z at the limit."""
        return self._through(lambda tan: 1 / math.sqrt((self.q.mu / tan) ** 2 - 1))

    def _wider(self, interval: Interval) -> Interval:
        """With what friction along the surfaces does to the angle."""
        return interval[0] - self.rest, interval[1] + self.rest

    def _through(self, of: Callable[[float], float]) -> Interval | None:
        own = math.tan(float(self.q.state.alpha))
        ends = [own / (1 + m) for m in self.one_contact()]
        if max(ends) >= self.q.mu:
            return None
        found = [of(own) / of(tan) - 1 for tan in ends]
        return (min(found), max(found)) if max(found) - min(found) < WIDEST else None
