"""Expected errors of Eqs. 3 to 11 of Huang et al. 2022 against struts in exact kinematics.

By Eq. 3, an offset dx compresses a sprag at psi by cos psi dx. A strut that is inclined by nu is
compressed by (cos psi - tan nu sin psi) dx. Therefore, the equations underestimate the stiffness by
the fraction tan^2 nu and by additional terms of each state. Errors are formula/struts - 1;
intervals are (smallest, largest).
"""

import math

POWER = 10 / 9  # of a line contact
SERIES = 4e-3  # largest uncertainty of a series
SHARE = 0.05  # uncertainty of an expected error, as a share of the terms that Eq. 3 omits
Interval = tuple[float, float]


def leading(nu: float) -> Interval:
    """Interval of the error of K_xx and K_yy of a clutch with equally spaced sprags.

    The equations have cos^2 psi in place of cos^2 psi + tan^2 nu sin^2 psi. The upper limit
    contains twice the next term of the error.

    >>> low, high = leading(0.05)
    >>> low < -math.sin(0.05) ** 2 < high
    True
    """
    neglected = math.tan(nu) ** 2
    return -neglected, -neglected + 2 * neglected**2


def around(formula: float, corrected: float, left_out: float, nu: float) -> Interval:
    """Interval of the error of an entry of K against a reference whose forces act along the struts.

    `left_out` is the effect of tilting forces, which the entry `corrected` contains and the
    reference does not. Terms that are common to `formula` and `corrected` cancel; therefore, errors
    of these terms do not change the interval.

    >>> low, high = around(1.0, 1.01, 0.0, 0.1)
    >>> round((low + high) / 2, 6)
    -0.009901
    """
    width = SHARE * (math.tan(nu) ** 2 + left_out / corrected)
    m = formula / (corrected - left_out) - 1
    return m - width, m + width


def first_order(nu: float, eps: float, Z: int) -> Interval | None:
    """Interval of the error of a coupling of first order in eps = dx/delta_0, for Z sprags.

    The error contains the next term of the sum over cos psi, and the change of the mean deflection
    at constant torque. Both are proportional to eps^2; terms of order eps^4 are in the tolerance.
    None if eps is too large for the series, or if Z < 5, as sums of powers of cos psi then differ.

    >>> first_order(0.05, 0.5, 12), first_order(0.05, 0.1, 4)
    (None, None)
    """
    n = POWER
    after = ((n - 2) * (n - 3) / 8 + (2 - n) * (n - 1) / 4) * eps**2
    neglected = math.tan(nu) ** 2
    width = (neglected + eps**2) ** 2
    if width > SERIES or Z < 5:
        return None
    return -after - neglected - width, -after - neglected + width


def held_ends(nu: float, delta_0: float, length: float) -> Interval:
    """Interval of the error of K_xx for struts of `length` [m] that are pinned to both races.

    The struts deflect by `delta_0` [m]. Their compressive forces Q rotate with them, which reduces
    the stiffness by Q/length. The error is this term minus tan^2 nu; the tolerance is the square of
    the sum of both terms.

    >>> low, high = held_ends(0.05, 1e-9, 1.0)
    >>> low < leading(0.05)[0] < high
    True
    """
    terms = (math.tan(nu) ** 2, delta_0 / (POWER * length))
    return terms[1] - terms[0] - sum(terms) ** 2, terms[1] - terms[0] + sum(terms) ** 2
