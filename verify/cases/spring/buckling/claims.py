"""Claims of case spring-buckling on sweeps over thickness, length and force."""

from collections.abc import Callable

import numpy as np

from analytic.spring import column
from verify.cases.spring.buckling.inputs import KEYS, MANY, RATIO
from verify.cases.spring.claims import stored
from verify.core.case import Context
from verify.judging.tolerance_checks import Pair

NOISE = 1e-5  # rounding of finite elements of slender springs, with a factor


def spread(context: Context) -> Pair:
    """Largest and least U_cr over thicknesses on a given centre line."""
    b, U, _ = stored(context, "by_b").T
    spread = float(np.ptp(U) / U.mean())
    z = context.inputs.length / b
    words = f"{spread:.2%} while L_0/b falls from {z[0]:.0f} to {z[-1]:.0f}"
    return Pair(float(U.max()), float(U.min()), NOISE * float(U.min()), words)


def by_cube(context: Context) -> Pair:
    """The exponent of b in F_cr with the largest difference from three, and three."""
    b, _, F = np.log(stored(context, "by_b")).T
    slope = np.diff(F) / np.diff(b)
    worst = float(slope[np.abs(slope - 3).argmax()])
    return Pair(worst, 3.0, NOISE, f"slope {worst:.5f}")


def one_ratio(context: Context) -> tuple[float, float, str]:
    """Excess over a factor of five of the range of U_cr/L_0 of springs with equal L_0/b."""
    xi = stored(context, "same_ratio")
    return (float(xi.max() / xi.min() - 5), 0.01,
            f"U_cr/L_0 from {xi.min():.2%} to {xi.max():.1%} at L_0/b = {RATIO:g}")  # fmt: skip


def stays(tail: str) -> Callable[[Context], tuple[float, float, str]]:
    """The least determinant of a free head's path over that at rest: zero at a critical point."""

    def margin(context: Context) -> tuple[float, float, str]:
        F, U, _, left = stored(context, f"free{KEYS[tail]}").T
        k = int(left.argmin())
        share = U[-1] / context.inputs.length
        return float(left[k]), 1e-3, (
            f"{left[k]:.1%} of the determinant is left at {F[k]:.3g} N, none is lost up to "
            f"{share:.0%} of the length"
        )  # fmt: skip

    return margin


def hinged(tail: str) -> Callable[[Context], tuple[float, float, str]]:
    """Margin for a hinged head on the guided path."""

    def margin(context: Context) -> tuple[float, float, str]:
        left = stored(context, f"guided{KEYS[tail]}")[:, 3]
        return float(left.min()), 1e-3, f"{left.min():.0%} of the determinant is left"

    return margin


def many_units(context: Context) -> tuple[list[float], list[float], list[float]]:
    """Haringx over finite elements with more and more units, over the shortening itself.

    The ends that are no units are 1/n of the spring, and the shortening is as 1/n^2.
    """
    q = context.inputs
    xi = column.critical_shortening("free", **q.path | {"n": np.array(MANY)}, b=q.b, nu=q.nu)
    d = xi / stored(context, "many") - 1
    return xi.tolist(), d.tolist(), (NOISE * (np.array(MANY) / 10) ** 2).tolist()
