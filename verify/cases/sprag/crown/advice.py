"""Advice on a crown: the load that it suits, and its pressure in the first peak."""

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
        return ("no state: no equilibrium within the profile exists at this torque",)
    if state == "rolls over":
        return ("rolls over: the sprags rotate past their profile before the first swing ends",)
    over = q.p_peak / q.p_even_peak
    first = {
        "no crown": "no crown: the largest pressure is at the ends and has no limit",
        "suits": "suits the first peak: its pressure is nearly even",
        "too shallow": "too shallow for the first peak: the ends carry most",
        "uneven": "uneven at the first peak: the middle carries most",
    }[state]
    found = [
        f"{first}; {pascal(q.p_peak)} under {newton(q.N_max)}, {over:.3g} times that of an "
        f"even load; at rest {pascal(q.p_rest)} under {newton(q.N)}"
    ]
    if q.z_m == 0:
        return found
    found.append(
        f"the crown is made for K_1 Q = {newton(q.suits)}; the first peak requires K_1 = "
        f"{q.K_1_suits:.3g} with this Q"
    )
    found.append(
        f"it begins {q.straight / 2 * 1e3:.3g} mm from mid-length and drops by "
        f"{q.end_slice / UM:.3g} µm at the middle of its end slices, {q.z_m / UM:.3g} µm at the "
        f"very ends; 1 % more z_m deepens it by {q.share:.2g} % on average, 1 % more K_1 "
        f"by {1 - q.share:.2g} %"
    )
    return found


def warnings(q: Any) -> Sequence[str]:
    found = []
    if q.z_m > 0 and q.end_slice < REACHED * q.z_m:
        found.append(
            f"z_m = {q.z_m / UM:.3g} µm is reached at the very ends alone: the end slices drop by "
            f"{q.end_slice / UM:.3g} µm"
        )
    if q.p_end_peak > 0:
        found.append(
            "the ends carry at the first peak: the largest pressure grows with the number of "
            "slices where it is theirs"
        )
    return found


def summary(q: Any) -> dict[str, Any]:
    """JSON; `over_even` is the largest pressure over an even load's at the first peak."""
    known = math.isfinite(q.p_peak)
    return {
        "verdict": verdict(q), "over_even": q.p_peak / q.p_even_peak if known else None,
        "K_1": q.K_1_suits if known else None,
    }  # fmt: skip
