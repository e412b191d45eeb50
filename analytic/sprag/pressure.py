r"""Contact pressure p(y, t) along a sprag during an engagement.

The slices are solved at a few loads, equally spaced in sqrt(N). The peak pressure of each slice is
interpolated by monotone cubics over sqrt(N). For a slice with a constant share of the load, it is a
straight line, p ~ sqrt(N). Between two loads, a slice that just begins to carry load has an error
of up to 7 % of the largest pressure. The error of the largest pressure is 0.2 % with 41 slices and
0.7 % with 21 slices.
"""

import numpy as np
from numpy.typing import ArrayLike
from scipy.interpolate import PchipInterpolator

from analytic.contact import slices
from analytic.contact.checks import Array, not_negative

LOADS = 41


def along(
    N: ArrayLike, gap: ArrayLike, *, length: float, R: float, E_star: float, loads: int = LOADS
) -> Array:
    """Peak pressure [Pa] of each slice under the normal forces `N` [N], (..., slices).

    `gap` [m], (slices,), is the crown; `length` [m], relative radius R [m], contact modulus [Pa].
    """
    N, gap = not_negative(N, "normal force", "N"), np.asarray(gap, dtype=np.float64)
    most = float(N.max())
    if most == 0:
        return np.zeros((*N.shape, len(gap)))
    root = np.linspace(0.0, np.sqrt(most), loads)
    pressed = slices.press_slices(gap, length=length, R=R, E_star=E_star, load=root[1:] ** 2)
    p = np.concatenate([np.zeros((1, len(gap))), pressed.peak_pressure])
    return np.asarray(PchipInterpolator(root, p)(np.sqrt(N)))
