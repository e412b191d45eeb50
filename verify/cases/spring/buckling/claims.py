"""Margins and texts of the claims of case spring-buckling on thickness, length and force."""

from collections.abc import Callable

import numpy as np

from analytic.spring import column
from verify.cases.spring.buckling.inputs import KEYS, MANY, RATIO
from verify.cases.spring.claims import stored
from verify.core.case import Context
from verify.judging.tolerance_checks import Pair

NOISE = 1e-5  # rounding of finite elements of slender springs, with a factor


def spread(context: Context) -> Pair:
    """Pair: largest and smallest U_cr [m] of springs that differ only in thickness."""
    b, U, _ = stored(context, "by_b").T
    spread = float(np.ptp(U) / U.mean())
    z = context.inputs.length / b
    words = f"spread of U_cr {spread:.2%}; L_0/b decreases from {z[0]:.0f} to {z[-1]:.0f}"
    return Pair(float(U.max()), float(U.min()), NOISE * float(U.min()), words)


def by_cube(context: Context) -> Pair:
    """Pair: the exponent of b in F_cr that differs most from 3, and the expected exponent 3."""
    b, _, F = np.log(stored(context, "by_b")).T
    slope = np.diff(F) / np.diff(b)
    worst = float(slope[np.abs(slope - 3).argmax()])
    return Pair(worst, 3.0, NOISE, f"exponent {worst:.5f}")


def one_ratio(context: Context) -> tuple[float, float, str]:
    """Positive margin if U_cr/L_0 of springs with equal L_0/b differs by a factor of more than 5.

    The uncertainty and the text of the row are also returned.
    """
    xi = stored(context, "same_ratio")
    return (float(xi.max() / xi.min() - 5), 0.01,
            f"U_cr/L_0 from {xi.min():.2%} to {xi.max():.1%} at L_0/b = {RATIO:g}")  # fmt: skip


def stays(tail: str) -> Callable[[Context], tuple[float, float, str]]:
    """Function that returns a margin: smallest determinant of the stiffness matrix of a free head.

    It is the smallest over the states of compression. The determinant is divided by that of the
    unloaded spring and vanishes at a critical point. The uncertainty and the text of the row are
    also returned.
    """

    def margin(context: Context) -> tuple[float, float, str]:
        F, U, _, left = stored(context, f"free{KEYS[tail]}").T
        k = int(left.argmin())
        share = U[-1] / context.inputs.length
        return float(left[k]), 1e-3, (
            f"the smallest determinant of the head's stiffness matrix is {left[k]:.1%} of its "
            f"value without load (at {F[k]:.3g} N); there is no critical point up to a "
            f"displacement of {share:.0%} of the length"
        )  # fmt: skip

    return margin


def hinged(tail: str) -> Callable[[Context], tuple[float, float, str]]:
    """Function that returns a margin: smallest determinant of the stiffness matrix, hinged head.

    It is the smallest over the states that are computed with a guided head.
    """

    def margin(context: Context) -> tuple[float, float, str]:
        left = stored(context, f"guided{KEYS[tail]}")[:, 3]
        return float(left.min()), 1e-3, (
            f"the smallest determinant of the head's stiffness matrix is {left.min():.0%} of its "
            "value without load"
        )  # fmt: skip

    return margin


def many_units(context: Context) -> tuple[list[float], list[float], list[float]]:
    """Relative shortenings at buckling, errors of Haringx's column, and uncertainties, shapes (k,).

    The number n of segments increases, so that shortenings and errors tend to zero: the ends of the
    spring, which are not units, are 1/n of its length. The shortening is proportional to 1/n^2.
    """
    q = context.inputs
    xi = column.critical_shortening("free", **q.path | {"n": np.array(MANY)}, b=q.b, nu=q.nu)
    d = xi / stored(context, "many") - 1
    return xi.tolist(), d.tolist(), (NOISE * (np.array(MANY) / 10) ** 2).tolist()
