"""What is expected of a star's formulas, from bodies that enclose the star and from sizes.

The star's approach lies among those of a layer and of two discs (`analytic.freewheel.star_bracket`)
and the torque winds the star up on its bore, which lowers the flat under the roller; everything
else follows from the approaches. Round bodies that Hertz takes for parabolas on half planes err by
some (a/r)². Surfaces tilt under N as far as a half plane does at the depth of its wall. Tangential
forces deform the contacts, too, and turn the ring further by tan² alpha, times the tangential
compliance over the normal one, which is somewhat below 1.
"""

import math
from collections.abc import Callable
from itertools import product

from analytic.freewheel.star_bracket import between_discs, expected_approach
from analytic.freewheel.state import State
from verify.case import Expected
from verify.cases.freewheel.bodies import OneClutch
from verify.cases.freewheel.star import Star

CURVED = 4.0  # bound of what Hertz neglects of pressures, over (a/r)²; between flats it is 3/16
LEAST = 7e-3  # and no less is asked of them: 1 % is accepted, meshes take 0.3
ROUNDED = 2e-5  # of a value: nothing finer is asked, splines and meshes take half of it
SMALLEST = 2e-3  # nor of approaches that others follow from
ASKED = 4e-3  # nor of approaches themselves
TIGHT, LOOSE = 0.8, 1.2  # of the winding of a ring: corners stand beyond it, some without shear
SIDEWAYS = 0.5, 1.0  # bounds of the tangential over the normal compliance, of like logarithms
STRAIGHT = 0.01  # of phi: what the printed angle's ratio changes by along its arc
STEEPER = 1.15  # d ln(N)/d ln(approach) at most
WIDEST = 8e-3  # interval that leaves a row of a user's star sharp enough

BRACKET = "a layer and two discs that enclose the star, its winding up, (a/r)² of Hertz"
TANGENTIAL = f"{BRACKET}, tangential deformation of 0.5 to 1 tan²α"

Interval = tuple[float, float]


class Bounds:
    """Intervals for formula/reference - 1 in a state, from approaches that may be within bounds."""

    def __init__(self, q: Star, state: State) -> None:
        self.q, self.state = q, state
        P = float(state.N) / q.L
        wide = max(float(state.a_i), float(state.a_o)) / q.r
        self.hertz = max(CURVED * wide**2, LEAST)
        # a roller's loads stand psi off its diameter, and the roller is half of an approach
        c = max(wide**2 / 2 + float(state.psi) ** 2 / 16, SMALLEST)
        d_i, d_o = float(state.d_i), float(state.d_o)
        low, high = (float(d) for d in expected_approach(q.clutch, P))
        wound = winding(q, float(state.T), q.r_b, q.X)
        wound *= float(q.cam.centre(d_i=d_i, d_o=d_o)[0])
        low, high = low * (1 - c), high * (1 + c)
        # not the formula's own d_i: what is expected must not move with what is judged
        self.own = {"d_i": float(between_discs(q.clutch, P)), "d_o": d_o}
        self.d_i = low + TIGHT * wound, high + LOOSE * wound
        self.d_o = d_o * (1 - c), d_o * (1 + c)
        wall = min(q.X - q.r_b, q.R_a - q.R)
        self.tilt = tilting(q, P, wall) / math.tan(float(state.alpha))

    def approach(self, which: str) -> Interval:
        """Of d_i or d_o."""
        return of_approach(self.own[which], getattr(self, which))

    def contact(self) -> Interval:
        """Of half-widths and pressures."""
        return -self.hertz, self.hertz

    def angle(self) -> Interval:
        """Of alpha."""
        return self._of(lambda **d: float(self.q.cam.alpha(**d)))

    def way(self) -> Interval:
        """Of s."""
        return self._of(lambda **d: float(self.q.cam.arc(**d)))

    def slope(self, *, tilted: bool = False) -> Interval:
        """Of tan(alpha), where `tilted` also as one contact alone has it."""
        low, high = self._of(lambda **d: math.tan(float(self.q.cam.alpha(**d))))
        more = self.tilt if tilted else 0.0
        return low - more, high + more

    def force(self) -> Interval:
        """Of N at a torque, which goes as 1/tan(alpha)."""
        low, high = self.slope(tilted=True)
        return 1 / (1 + high) - 1, 1 / (1 + low) - 1

    def torsion(self) -> Interval:
        """Of phi, which goes as the way of the rollers and is added to by tangential forces."""
        (low, high), square = self.way(), math.tan(float(self.state.alpha)) ** 2
        less, more = (share * square for share in SIDEWAYS)
        return (1 + low) / (1 + more) - 1, (1 + high) / (1 + less) - 1

    def force_at_angle(self) -> Interval:
        """Of N at an angle, which says what both approaches are together."""
        size = sum(self.own.values())
        low, high = (sum(ends) / size for ends in zip(self.d_i, self.d_o, strict=True))
        return low**STEEPER - 1, high**STEEPER - 1

    def _of(self, value: Callable[..., float]) -> Interval:
        corners = [value(d_i=d_i, d_o=d_o) for d_i, d_o in product(self.d_i, self.d_o)]
        return enclosed(value(**self.own), corners)


def known(q: Star, interval: Interval, source: str = BRACKET) -> Expected:
    """The interval; one's own star may be enclosed too widely by its neighbours to judge by."""
    low, high = interval
    return Expected(low, high, source, sharp=q.is_default or high - low <= WIDEST)


def of_approach(own: float, ends: Interval) -> Interval:
    """Of an approach that may lie between `ends`."""
    low, high = ends
    return min(own / high - 1, -ASKED), max(own / low - 1, ASKED)


def enclosed(own: float, others: list[float]) -> Interval:
    """Of a value that may be any of the `others`."""
    return own / max(others) - 1 - ROUNDED, own / min(others) - 1 + ROUNDED


def winding(q: OneClutch, T: float, r_1: float, r_2: float) -> float:
    """Angle [rad] by which a hollow shaft from one radius [m] to the other is wound up."""
    G = q.E / (2 * (1 + q.nu))
    return T / q.L / (4 * math.pi * G) * (1 / r_1**2 - 1 / r_2**2)


def tilting(q: OneClutch, P: float, wall: float) -> float:
    """Angle [rad] by which a surface tilts at the depth of its wall [m] under P [N/m]."""
    return 2 * P * (1 - q.nu**2) / (math.pi * q.E * wall)


def times(interval: Interval, ratio: float, spread: float = 0.0) -> Interval:
    """The interval of a formula that is `ratio` times another, within `spread` of that."""
    low, high = interval
    return ratio * (1 - spread) * (1 + low) - 1, ratio * (1 + spread) * (1 + high) - 1
