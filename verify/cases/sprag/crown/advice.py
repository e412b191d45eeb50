"""Statements on a crown: its design load, and its pressure at the first force peak."""

import math
from collections.abc import Sequence
from typing import Any

from verify.cases.freewheel.clutch.numbers import newton, pascal

EVEN = 1.05  # over the pressure of a uniform load
UM = 1e-6
REACHED = 0.5  # over z_m


def verdict(q: Any) -> str:
    if not math.isfinite(q.N):
        return "no state"
    if not math.isfinite(q.N_max):
        return "rolls over"
    if q.z_m == 0:
        return "no crown"
    if q.p_peak <= EVEN * q.p_even_peak:
        return "suits"
    return "too shallow" if q.p_end_peak >= q.p_peak else "uneven"


def findings(q: Any) -> Sequence[str]:
    state = verdict(q)
    if state == "no state":
        return ("no state: at this torque, no equilibrium exists within the sprag profile",)
    if state == "rolls over":
        return ("rolls over: the sprags rotate beyond their profile during the first oscillation",)
    over = q.p_peak / q.p_even_peak
    first = {
        "no crown": "no crown: the largest pressure is at the ends and grows with the number of "
        "slices",
        "suits": "suits: with this crown, the pressure at the first force peak is nearly uniform",
        "too shallow": "too shallow: with this crown, the largest pressure at the first force peak "
        "is at the ends",
        "uneven": "uneven: with this crown, the largest pressure at the first force peak is at "
        "mid-length",
    }[state]
    found = [
        f"{first}. At the first force peak, the largest pressure is {pascal(q.p_peak)} under "
        f"{newton(q.N_max)}, {over:.3g} times the pressure of a uniform load; the "
        f"largest pressure at rest is {pascal(q.p_rest)} under {newton(q.N)}"
    ]
    if q.z_m == 0:
        return found
    found.append(
        f"the crown gives a uniform load under K_1 Q = {newton(q.suits)}; with this Q, a uniform "
        f"load at the first force peak requires K_1 = {q.K_1_suits:.3g}"
    )
    found.append(
        f"the crown begins {q.straight / 2 * 1e3:.3g} mm from mid-length; its drop is "
        f"{q.end_slice / UM:.3g} µm at the middle of the end slices and {q.z_m / UM:.3g} µm at the "
        f"ends; 1 % more z_m increases the mean drop by {q.share:.2g} %, 1 % more K_1 by "
        f"{1 - q.share:.2g} %"
    )
    return found


def warnings(q: Any) -> Sequence[str]:
    found = []
    if q.z_m > 0 and q.end_slice < REACHED * q.z_m:
        found.append(
            f"the drop z_m = {q.z_m / UM:.3g} µm is reached only at the ends; the drop of the end "
            f"slices is {q.end_slice / UM:.3g} µm"
        )
    if q.p_end_peak > 0:
        found.append(
            "the ends are loaded at the first force peak: if the largest pressure is at the "
            "ends, it grows with the number of slices"
        )
    return found


def summary(q: Any) -> dict[str, Any]:
    """Results for JSON; `over_even` is the ratio of p_max to the pressure of a uniform load."""
    known = math.isfinite(q.p_peak)
    return {
        "verdict": verdict(q), "over_even": q.p_peak / q.p_even_peak if known else None,
        "K_1": q.K_1_suits if known else None,
    }  # fmt: skip
