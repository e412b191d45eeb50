"""Errors of Eqs. 3 to 11 of Huang et al. 2022 expected against struts in exact kinematics.

By Eq. 3 an offset dx compresses a sprag at psi by cos psi dx; a strut inclined by nu is compressed
by (cos psi - tan nu sin psi) dx. The equations therefore underestimate the stiffness by tan^2 nu
and by further terms of each state. Errors are formula/struts - 1; intervals are (least, largest).
"""

import math

POWER = 10 / 9  # of a line contact
SERIES = 4e-3  # largest uncertainty of a series
SHARE = 0.05  # uncertainty of an expected error, as a share of the terms that Eq. 3 omits
Interval = tuple[float, float]


def leading(nu: float) -> Interval:
    """Error of K_xx, K_yy of an even clutch: cos^2 for cos^2 + tan^2 nu sin^2; next term doubled.

    >>> low, high = leading(0.05)
    >>> low < -math.sin(0.05) ** 2 < high
    True
    """
    neglected = math.tan(nu) ** 2
    return -neglected, -neglected + 2 * neglected**2


def around(formula: float, corrected: float, left_out: float, nu: float) -> Interval:
    """Error of an entry of K by the equations, over the same entry with forces along the struts.

    `left_out` is the effect of tilting forces on the `corrected` entry. Common parts of both
    cancel; errors of these parts therefore do not change the interval.

    >>> low, high = around(1.0, 1.01, 0.0, 0.1)
    >>> round((low + high) / 2, 6)
    -0.009901
    """
    width = SHARE * (math.tan(nu) ** 2 + left_out / corrected)
    m = formula / (corrected - left_out) - 1
    return m - width, m + width


def first_order(nu: float, eps: float, Z: int) -> Interval | None:
    """Error of the coupling's first term in eps = dx/delta_0, Z sprags; without squares of eps^2.

    The next term of the sum over cos psi, and the deflection recovered by torque. None if eps
    is too large for a first term, or sprags too few for fourth powers to sum to 3/8 of Z.

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
    """Error of K_xx for struts of a `length` [m] held in both races, that deflect by `delta_0` [m].

    Their forces turn with them, by Q/length; the sum's square is left out.

    >>> low, high = held_ends(0.05, 1e-9, 1.0)
    >>> low < leading(0.05)[0] < high
    True
    """
    terms = (math.tan(nu) ** 2, delta_0 / (POWER * length))
    return terms[1] - terms[0] - sum(terms) ** 2, terms[1] - terms[0] + sum(terms) ** 2
