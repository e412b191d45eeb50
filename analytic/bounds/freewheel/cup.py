"""Expected errors of the formulas of a drawn cup, from its dimensions and from two simple rings.

The torque causes wind-up of cup and shaft. At a given torque, errors increase near the torque
maximum, where a small additional compliance reduces the torque considerably. Therefore, the whole
torque curve is computed with the approaches at the ends of their intervals.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from itertools import product

import numpy as np

from analytic.bounds.freewheel.cup_bracket import expected_approach
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
    winding,
)
from analytic.bounds.freewheel.parts import FreewheelParts, Loaded
from analytic.contact.checks import Array

POINTS = 4000  # of a course
FARTHER = 1.5  # normal force over that at the maximum torque

Factors = tuple[float, float, float]


@dataclass(frozen=True)
class Approaches:
    """Approaches d_i, d_o [length] of a cup; the function `of` computes them from the normal force.

    `top` is N at the torque maximum. `Course` multiplies the approaches by factors; expected errors
    follow from the ratios of two curves.
    """

    of: Callable[[Array], tuple[Array, Array]]
    top: float


@dataclass(frozen=True)
class Course:
    """Torque of a cup as a function of N; `factors` multiply d_i, d_o and the torque."""

    cup: FreewheelParts
    approaches: Approaches
    factors: Factors

    @cached_property
    def states(self) -> tuple[Array, Array, Array, Array]:
        """Arrays N [N], d_i, d_o [m] and T [N m] of all states with an equilibrium."""
        cup, (f_i, f_o, f_T) = self.cup, self.factors
        N = FARTHER * self.approaches.top * np.linspace(0, 1, POINTS) ** 3
        d_i, d_o = self.approaches.of(N)
        d_i, d_o = f_i * d_i, f_o * d_o
        alpha = cup.alpha(d_i=d_i, d_o=d_o)
        known = np.isfinite(alpha)
        T = f_T * cup.z * cup.race * N * np.tan(alpha)
        return N[known], d_i[known], d_o[known], T[known]

    @property
    def summit(self) -> float:
        """Largest torque [N m]."""
        return float(self.states[3].max())

    def at(self, T: float) -> dict[str, float]:
        """Values by name under T [N m]: N [N], alpha [rad], s [m], wind-up phi by rolling [rad].

        If T exceeds the maximum torque, the values are those at the maximum.
        """
        N, d_i, d_o, torque = self.states
        rising = slice(int(torque.argmax()) + 1)
        cup, now = self.cup, min(T, self.summit)
        courses = {
            "N": N, "alpha": cup.alpha(d_i=d_i, d_o=d_o), "s": cup.arc(d_i=d_i, d_o=d_o),
            "phi": cup.rolled(d_i=d_i, d_o=d_o),
        }  # fmt: skip
        return {k: float(np.interp(now, torque[rising], v[rising])) for k, v in courses.items()}

    def force(self, psi: float) -> float:
        """Normal force N [N] at which the angle is psi [rad]."""
        N, d_i, d_o, _ = self.states
        return float(np.interp(-psi / 2, -self.cup.alpha(d_i=d_i, d_o=d_o), N))


class CupBounds:
    """Intervals of the errors (formula/reference - 1) in one state of a cup."""

    def __init__(self, cup: FreewheelParts, at: Loaded, approaches: Approaches) -> None:
        self.cup, self.at, self.approaches = cup, at, approaches
        P, c = at.N / cup.L, of_round_bodies(cup, at)
        low, middle, high = expected_approach(cup, P)
        # not the d_o of the formula: the expectation must not depend on what is verified
        self.own = {"d_i": at.d_i, "d_o": middle}
        x = float(cup.centre(d_i=at.d_i, d_o=at.d_o)[0])
        wound = winding(cup, at.T, cup.flat, cup.R_a) * x
        self.d_i = at.d_i * (1 - c), at.d_i * (1 + c)
        self.d_o = low * (1 - c) + TIGHT * wound, high * (1 + c) + LOOSE * wound
        wall = min(cup.race - cup.r_b, cup.R_a - cup.flat)
        self.tilt = tilting(cup, P, wall) / math.tan(at.alpha)

    @property
    def corners(self) -> tuple[Factors, ...]:
        """Factors of d_i, d_o and torque at all combinations of the limits of their intervals."""
        return tuple(
            (i / self.at.d_i, o / self.at.d_o, 1 + t)
            for i, o, t in product(self.d_i, self.d_o, (-self.tilt, self.tilt))
        )

    @property
    def middle(self) -> Factors:
        """Factors on the formulas of d_i, d_o and torque; only the factor on d_o is not 1."""
        return 1.0, self.own["d_o"] / self.at.d_o, 1.0

    def approach(self, which: str) -> Interval:
        """Interval of the error of the approach `which`, d_i or d_o."""
        return of_approach(self.own[which], getattr(self, which))

    def contact(self) -> Interval:
        """Interval of the error of half-widths and pressures."""
        return of_contact(self.cup, self.at)

    @cached_property
    def _at_torque(self) -> tuple[dict[str, float], list[dict[str, float]]]:
        return self._course(self.middle).at(self.at.T), [
            self._course(f).at(self.at.T) for f in self.corners
        ]

    def under_torque(self, key: str) -> Interval:
        """Interval of the error of N, alpha or s at the torque of the state."""
        own, corners = self._at_torque
        return enclosed(own[key], [c[key] for c in corners])

    def slope(self) -> Interval:
        """Interval of the error of tan(alpha) at the torque of the state."""
        own, corners = self._at_torque
        return enclosed(math.tan(own["alpha"]), [math.tan(c["alpha"]) for c in corners])

    def torsion(self) -> Interval:
        """Interval of the error of the wind-up phi.

        phi contains rolling, tangential displacement at the contacts, and wind-up of shaft and cup.
        """
        cup, T, (own, corners) = self.cup, self.at.T, self._at_torque
        wound = winding(cup, T, cup.flat, cup.R_a) + winding(cup, T, cup.r_b, cup.race)
        tan, tan_0 = math.tan(own["alpha"]), math.tan(float(cup.alpha(d_i=0.0, d_o=0.0)))
        (less, more) = SIDEWAYS[0] * tan**2, SIDEWAYS[1] * tan * tan_0
        low = min(c["phi"] for c in corners) * (1 + less) + TIGHT * wound
        high = max(c["phi"] for c in corners) * (1 + more) + LOOSE * wound
        return enclosed(own["phi"], [low, high])

    def torque(self) -> Interval:
        """Interval of the error of T at the normal force of the state."""

        def tan(i: float, o: float) -> float:
            return math.tan(float(self.cup.alpha(d_i=i * self.at.d_i, d_o=o * self.at.d_o)))

        return enclosed(tan(*self.middle[:2]), [t * tan(i, o) for i, o, t in self.corners])

    def summit(self) -> Interval:
        """Interval of the error of the largest torque."""
        own = self._course(self.middle).summit
        return enclosed(own, [self._course(f).summit for f in self.corners])

    def force_at_angle(self, psi: float) -> Interval:
        """Interval of the error of the normal force that causes the angle psi [rad]."""
        own = self._course(self.middle).force(psi)
        return enclosed(own, [self._course(f).force(psi) for f in self.corners])

    def _course(self, factors: Factors) -> Course:
        return Course(self.cup, self.approaches, factors)
