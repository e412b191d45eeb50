"""Errors of beam theories that are expected of a uniform shaft at rest, simply supported.

Timoshenko's equation is written a second time here: a mistake in the verified formula is not in
its reference.

J. R. Hutchinson, J. Appl. Mech. 68 (2001) 87-92; S. P. Timoshenko, Phil. Mag. 41 (1921) 744-746.
"""

import math
from typing import Literal

SMALL = 0.3  # of rotary inertia and shear, up to which their series is used


def shear_coefficient(nu: float, m: float) -> float:
    """Hutchinson's kappa [1] by powers of nu as he prints it, m the bore over the outer diameter.

    His Eq. 45, with a = 1 and b = m; 0 <= m < 1.

    >>> round(shear_coefficient(nu=0.5, m=0.0), 6)  # 13.5/14
    0.964286
    """
    whole = 7 + 34 * m**2 + 7 * m**4
    by_nu = 12 + 48 * m**2 + 12 * m**4
    by_square = 4 + 16 * m**2 + 4 * m**4
    return 6 * (1 + m**2) ** 2 * (1 + nu) ** 2 / (whole + by_nu * nu + by_square * nu**2)


def frequency(
    j: int, *, L: float, d_o: float, d_i: float, E: float, nu: float, rho: float
) -> float:
    """Mode j at rest [rad/s]: the square W over Euler's solves 1 - W (1 + e + e s) + s e^2 W^2 = 0.

    e = (k i)^2 with i the radius of gyration of the section is the rotary inertia and
    s = E/(kappa G) its increase by shear. `L` between the supports, diameters `d_o` and `d_i` [m].
    """
    k = j * math.pi / L
    e = k**2 * (d_o**2 + d_i**2) / 16
    s = 2 * (1 + nu) / shear_coefficient(nu, d_i / d_o)
    half = (1 + e + e * s) / 2
    square = 1 / (half + math.sqrt(half**2 - s * e**2))
    return k * math.sqrt(E * e * square / rho)


def neglected(
    theory: Literal["euler", "rayleigh"], e: float, s: float
) -> tuple[float, float] | None:
    """Least and largest error [1] of mode 1, Timoshenko's equation being exact.

    `e` is the rotary inertia, `s` its increase by shear. 1 - W (1 + a) + s e^2 W^2 = 0 with
    a = e (1 + s), W the square over Euler's: Euler's error is 1/sqrt(W) - 1 = a/2 less
    a^2/8 + s e^2/2 to second order, Rayleigh's is e s/2 less no more than that. Twice the second
    order is allowed, downwards. None if `a` is not SMALL: the series is not valid there.

    >>> low, high = neglected("euler", e=0.01, s=3.0)
    >>> round(low, 6), high
    (0.0193, 0.02)
    """
    a = e * (1 + s)
    if a >= SMALL:
        return None
    leading = a / 2 if theory == "euler" else e * s / 2
    return leading - a**2 / 4 - s * e**2, leading
