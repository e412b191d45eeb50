"""Intervals of errors (formula/reference - 1) of all freewheels; wind-up and tilt of bodies."""

import math

from analytic.bounds.freewheel.parts import FreewheelParts, Loaded

CURVED = 4.0  # bound of Hertz's error of pressures over (a/r)²; between flats it is 3/16
LEAST = 7e-3  # smallest half-width: 1 % is accepted, the error of meshes is 0.3 %
ROUNDED = 2e-5  # smallest half-width, relative: splines and meshes cause half of it
SMALLEST = 2e-3  # the same for approaches from which other values follow
ASKED = 4e-3  # the same for approaches
TIGHT, LOOSE = 0.8, 1.2  # of the winding of a ring; beyond these there are corners
SIDEWAYS = 0.5, 1.0  # bounds of the tangential over the normal compliance, of like logarithms
STRAIGHT = 0.01  # share of phi: change of the printed angle's ratio along its arc

Interval = tuple[float, float]


def of_contact(parts: FreewheelParts, at: Loaded) -> Interval:
    """Interval of the error of half-widths and pressures, of the order (a/r)² for round bodies."""
    bound = max(CURVED * _wide(parts, at) ** 2, LEAST)
    return -bound, bound


def of_round_bodies(parts: FreewheelParts, at: Loaded) -> float:
    """Bound of the relative error of an approach of round bodies.

    Hertz's error is of the order (a/r)². A second error is of the order psi²: the contact forces of
    a roller act at the angle psi to its diameter, and the roller causes half of an approach.
    """
    return max(_wide(parts, at) ** 2 / 2 + at.psi**2 / 16, SMALLEST)


def _wide(parts: FreewheelParts, at: Loaded) -> float:
    return max(at.a_i, at.a_o) / parts.r


def of_approach(value: float, ends: Interval) -> Interval:
    """Interval of the error of an approach whose reference lies between `ends`.

    >>> of_approach(1.0, (0.8, 1.25))
    (-0.19999999999999996, 0.25)
    """
    low, high = ends
    return min(value / high - 1, -ASKED), max(value / low - 1, ASKED)


def enclosed(value: float, others: list[float]) -> Interval:
    """Interval of the error of a value whose reference lies within the range of `others`."""
    return value / max(others) - 1 - ROUNDED, value / min(others) - 1 + ROUNDED


def times(interval: Interval, ratio: float, spread: float = 0.0) -> Interval:
    """Interval of the error of a formula that equals `ratio` times another formula.

    `interval` is the interval of the other formula, `spread` the relative uncertainty of `ratio`.

    >>> times((-0.5, 0.5), 2.0)
    (0.0, 2.0)
    """
    low, high = interval
    return ratio * (1 - spread) * (1 + low) - 1, ratio * (1 + spread) * (1 + high) - 1


def winding(parts: FreewheelParts, T: float, r_1: float, r_2: float) -> float:
    """Wind-up angle [rad] of a hollow shaft under T between the radii r_1 and r_2 [length]."""
    G = parts.E / (2 * (1 + parts.nu))
    return T / parts.L / (4 * math.pi * G) * (1 / r_1**2 - 1 / r_2**2)


def tilting(parts: FreewheelParts, P: float, wall: float) -> float:
    """Angle [rad] by which a half plane tilts at the depth `wall` [length] under line load P."""
    return 2 * P * (1 - parts.nu**2) / (math.pi * parts.E * wall)
