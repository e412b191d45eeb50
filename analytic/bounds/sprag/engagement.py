"""Expected errors of formulas of an engagement against time integration of the motion.

In Eqs. 14-16, N_e = N_i, but for a strut under two forces, N_e/N_i = cos(omega)/cos(nu). At a given
rotation, time integration gives the same N as the formulas; its torque is smaller than theirs by a
fraction between 0 and N_e/N_i - 1.
"""

from dataclasses import dataclass

Interval = tuple[float, float]

ENERGY = 1e-5  # relative to the work: error of the cubics of a table
BOOKED = 2 * ENERGY  # also for the rotation of the outer race against its inertia only
PART = 0.1  # relative to the centroid's outward travel, from the trapezia of 401 states


@dataclass(frozen=True, kw_only=True)
class Bounds:
    """Intervals of the errors, from the terms in which formulas and time integration differ.

    All numbers are relative. `unequal` is N_e/N_i - 1, `passed_on` the relative change of the peak
    of N per relative change of torque, `inertia` the ratio of the inertia of the sprags to that of
    the race, `left_out` the relative work of the outward motion of the centroid. If `turns`, races
    rotate at the start, and contacts slide first.
    """

    unequal: float
    passed_on: float
    inertia: float
    left_out: float
    turns: bool

    def statics(self) -> Interval:
        """Interval of the error of the force at rest."""
        return -self.unequal, 0.0

    def energy(self) -> Interval:
        """Interval of the error of a peak force that is determined by the work balance."""
        return -self.passed_on * self.unequal, 0.0

    def spring(self) -> Interval | None:
        """Interval of the error of a peak force by the spring model; None if contacts slide first.

        The spring model neglects the mass of the sprags, which causes an error of either sign.
        """
        (low, _), inertia = self.energy(), self.inertia
        return None if self.turns else (low - inertia, inertia)

    def both(self) -> Interval | None:
        """Interval of the error of a ratio of two peak forces by the spring model.

        The error is the difference of the errors of the two forces. None if contacts slide first.
        """
        one = self.spring()
        return one and (one[0] - one[1], one[1] - one[0])

    def either_way(self, times: float) -> Interval:
        """Interval of an error of either sign, at most `times` x (N_e/N_i - 1) in magnitude."""
        return -times * self.unequal, times * self.unequal

    def radially(self) -> Interval:
        """Interval of the error of the work, due to the outward motion of the centroid."""
        u = BOOKED + PART * abs(self.left_out)
        return self.left_out - u, self.left_out + u
