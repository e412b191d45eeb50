r"""Tilt of a roller under its axial forces, which the criterion neglects.

The axial forces F_a at both contacts, at the distance 2 r cos(alpha) (the chord), form a couple.
For equilibrium, the resultants F_n/cos(alpha) along the chord move along the roller in opposite
directions by

.. math:: e = r \cos^2\alpha\,\frac{F_a}{F_n}.

A linear line load then has its peak N/L (1 + 6 e/L) at one end. From e = L/6 on, the other end
lifts off, and the line load is a triangle over the length 3 (L/2 - e). Hertz's pressure is
proportional to the square root of the line load. End effects and crowns are neglected.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, not_negative, positive


def offset(*, F_a: ArrayLike, F_n: ArrayLike, r: ArrayLike, alpha: ArrayLike) -> Array:
    """Shift e [length] of the resultant of the contact along the roller.

    >>> float(offset(F_a=10.0, F_n=100.0, r=2.5, alpha=0.0))
    0.25
    """
    share = not_negative(F_a, "axial force", "N") / positive(F_n, "normal force", "N")
    return np.asarray(positive(r, "roller's r", "m") * np.cos(np.asarray(alpha)) ** 2 * share)


def peak_factor(*, e: ArrayLike, L: ArrayLike) -> Array:
    """Ratio of peak to mean line load; infinite if e reaches the end of the roller.

    >>> peak_factor(e=[0.0, 1.0, 2.0], L=6.0).tolist()  # 1 + 6 e/L, then 4/(3 (1 - 2 e/L))
    [1.0, 2.0, 4.0]
    """
    share = not_negative(e, "offset e", "m") / positive(L, "roller's length L", "m")
    on = np.maximum(1 - 2 * share, 0.0)
    with np.errstate(divide="ignore"):
        return np.where(share <= 1 / 6, 1 + 6 * share, 4 / (3 * on))


def pressure_factor(*, e: ArrayLike, L: ArrayLike) -> Array:
    """Ratio of Hertz's peak pressure to that of a uniform line load: sqrt(`peak_factor`)."""
    return np.asarray(np.sqrt(peak_factor(e=e, L=L)))


def axial_force_at_lift_off(
    *, F_n: ArrayLike, r: ArrayLike, alpha: ArrayLike, L: ArrayLike
) -> Array:
    """Axial force F_a [force] of one roller at which one end lifts off (e = L/6).

    >>> float(axial_force_at_lift_off(F_n=100.0, r=2.5, alpha=0.0, L=3.0))
    20.0
    """
    L = positive(L, "roller's length L", "m")
    return np.asarray(L / 6 / offset(F_a=1.0, F_n=F_n, r=r, alpha=alpha))
