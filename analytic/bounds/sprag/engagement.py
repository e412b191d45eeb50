"""Intervals for formulas of an engagement over the steps of the equations of motion, less 1.

In Eqs. 14-16, N_e = N_i, but a strut under two forces has N_e/N_i = cos(omega)/cos(nu): at the same
rotation, the steps have the same N, and a torque that is smaller by 0 to N_e/N_i - 1.
"""

from dataclasses import dataclass

Interval = tuple[float, float]

ENERGY = 1e-5  # relative to the work: error of the cubics of a table
BOOKED = 2 * ENERGY  # also for the rotation of the outer race against its inertia only
PART = 0.1  # relative to the centroid's outward travel, from the trapezia of 401 states


@dataclass(frozen=True, kw_only=True)
class Bounds:
    """From the sizes of the terms in which formulas and steps differ, all relative.

    `unequal` is N_e/N_i - 1, `passed_on` the relative change of the peak of N per change of torque,
    `inertia` the ratio of inertia of sprags and race, `left_out` the relative work of the outward
    motion of the centroid. If races rotate at the start (`turns`), contacts slide first.
    """

    unequal: float
    passed_on: float
    inertia: float
    left_out: float
    turns: bool

    def statics(self) -> Interval:
        """Error of the force at rest."""
        return -self.unequal, 0.0

    def energy(self) -> Interval:
        """Error of a peak force that the work determines."""
        return -self.passed_on * self.unequal, 0.0

    def spring(self) -> Interval | None:
        """Error of a peak by the spring, which omits the mass of the sprags: an error of any sign.

        None if contacts slide first.
        """
        (low, _), inertia = self.energy(), self.inertia
        return None if self.turns else (low - inertia, inertia)

    def both(self) -> Interval | None:
        """Error of a ratio of two such peaks: the difference of their errors."""
        one = self.spring()
        return one and (one[0] - one[1], one[1] - one[0])

    def either_way(self, times: float) -> Interval:
        """Error of either sign, a multiple of N_e/N_i - 1."""
        return -times * self.unequal, times * self.unequal

    def radially(self) -> Interval:
        """Error of the work: the steps rotate less, because the centroid moves outwards."""
        u = BOOKED + PART * abs(self.left_out)
        return self.left_out - u, self.left_out + u
