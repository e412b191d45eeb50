"""Errors of beam theories that are expected of a shaft at rest, from its inputs alone.

Timoshenko's equation is written anew, so that a slip of the formula that is judged is none of what
it is judged by.
"""

import math

from analytic.rotor.shafts import Theory
from verify.case import Expected, about
from verify.cases.rotor.shaft.inputs import TurningShaft

NEAR = 5e-5  # how well the error of a formula is known beforehand
SMALL = 0.3  # of rotary inertia and shear, up to which their series is used


def shear_coefficient(nu: float, m: float) -> float:
    """Hutchinson's kappa [1] by powers of nu as he prints it, m the bore over the outer diameter.

    J. R. Hutchinson, J. Appl. Mech. 68 (2001) 87-92, Eq. 45, with a = 1 and b = m.
    """
    whole = 7 + 34 * m**2 + 7 * m**4
    by_nu = 12 + 48 * m**2 + 12 * m**4
    by_square = 4 + 16 * m**2 + 4 * m**4
    return 6 * (1 + m**2) ** 2 * (1 + nu) ** 2 / (whole + by_nu * nu + by_square * nu**2)


def frequency(q: TurningShaft, j: int) -> float:
    """Mode j at rest [rad/s]: the square W over Euler's solves 1 - W (1 + e + e s) + s e^2 W^2 = 0.

    e = (k i)^2 with i the radius of gyration of the section is the rotary inertia and
    s = E/(kappa G) what shear adds to it.
    """
    k = j * math.pi / q.L
    e = k**2 * (q.d_o**2 + q.d_i**2) / 16
    s = 2 * (1 + q.nu) / shear_coefficient(q.nu, q.m)
    half = (1 + e + e * s) / 2
    square = 1 / (half + math.sqrt(half**2 - s * e**2))
    return k * math.sqrt(q.E * e * square / q.rho)


def against_elasticity(q: TurningShaft, j: int, exact: float) -> Expected:
    """Timoshenko's error in mode j against the cylinder of elasticity, `exact` [rad/s]."""
    source = "his equation solved anew, over the cylinder of elasticity; ± 5e-5"
    return about(frequency(q, j) / exact - 1, NEAR, source)


def neglected(theory: Theory, e: float, s: float) -> Expected:
    """Error of mode 1 by Timoshenko's equation; `e` rotary inertia, `s` what shear adds to it.

    1 - W (1 + a) + s e^2 W^2 = 0 with a = e (1 + s), W the square over Euler's: Euler's error is
    1/sqrt(W) - 1 = a/2 less a^2/8 + s e^2/2 to second order, Rayleigh's is e s/2 less no more than
    that. Twice the second order is allowed, downwards.
    """
    a = e * (1 + s)
    leading = a / 2 if theory == "euler" else e * s / 2
    source = "what it neglects, in Timoshenko's equation to second order"
    return Expected(leading - a**2 / 4 - s * e**2, leading, source, sharp=a < SMALL)
