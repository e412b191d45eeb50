"""Sprag as a bar between the races (Huang 2018, Eq. 7)."""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, not_negative, positive
from analytic.freewheel.rules import require


def sprag_compression(
    *,
    N: ArrayLike,
    R_i: ArrayLike,
    R_e: ArrayLike,
    b: ArrayLike,
    l: ArrayLike,  # noqa: E741
    E: ArrayLike,
) -> Array:
    """Compression delta_g [length] of a bar of length R_e - R_i and section b l under N (Eq. 7).

    The paper does not define b. Its formula is N L/(E S); therefore, S = b l is the cross-section
    of the bar.

    >>> round(float(sprag_compression(N=6.0, R_i=2.0, R_e=5.0, b=1.0, l=3.0, E=2.0)), 12)
    3.0
    """
    R_i, R_e = positive(R_i, "race's radius R_i", "m"), positive(R_e, "bore R_e", "m")
    require(R_i < R_e, "no room for the sprag: R_i must be below R_e", R_i=R_i, R_e=R_e)
    section = positive(b, "sprag's width b", "m") * positive(l, "length l", "m")
    stiffness = positive(E, "Young's modulus", "Pa") * section / (R_e - R_i)
    return np.asarray(not_negative(N, "normal force", "N") / stiffness)
