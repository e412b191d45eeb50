"""Expected errors of beam theories for a uniform, simply supported shaft at rest.

Timoshenko's equation is written here a second time, so that an error in the verified formula is not
in its reference.

J. R. Hutchinson, J. Appl. Mech. 68 (2001) 87-92; S. P. Timoshenko, Phil. Mag. 41 (1921) 744-746.
"""

import math
from typing import Literal

SMALL = 0.3  # of rotary inertia and shear, up to which their series is used


def shear_coefficient(nu: float, m: float) -> float:
    """Hutchinson's shear coefficient kappa [1] as printed; m is bore over outer diameter.

    The equation is his Eq. 45 with a = 1 and b = m; 0 <= m < 1.

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
    """Natural frequency [rad/s] of mode j at rest, by Timoshenko's equation.

    The ratio W of its square to Euler's is a root of 1 - W (1 + e + e s) + s e^2 W^2 = 0.
    e = (k i)^2, with the radius of gyration i of the section, is the effect of rotary inertia, and
    s = E/(kappa G) its increase by shear. `L` is the length between the supports, `d_o` and `d_i`
    [m] are the diameters.
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
    """Smallest and largest error [1] of the frequency of mode 1 by `theory`.

    The reference is Timoshenko's equation. `e` is the effect of rotary inertia, `s` its increase by
    shear. The ratio W of the squared frequency to Euler's is a root of 1 - W (1 + a) + s e^2 W^2 =
    0 with a = e (1 + s). To second order, Euler's error is 1/sqrt(W) - 1 = a/2 - (a^2/8 + s e^2/2).
    Rayleigh's error is e s/2, reduced by at most the same terms. The interval extends downwards by
    twice the terms of second order. None if `a` is not below SMALL, because the series is not valid
    there.

    >>> low, high = neglected("euler", e=0.01, s=3.0)
    >>> round(low, 6), high
    (0.0193, 0.02)
    """
    a = e * (1 + s)
    if a >= SMALL:
        return None
    leading = a / 2 if theory == "euler" else e * s / 2
    return leading - a**2 / 4 - s * e**2, leading
