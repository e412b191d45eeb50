"""What is told of a crown first: which load it suits, and what it makes of the first peak."""

from collections.abc import Sequence
from typing import Any

from verify.cases.freewheel.clutch.numbers import newton, pascal
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.case import Values

EVEN = 1.05  # of an even load's pressure
UM = 1e-6
REACHED = 0.5  # of z_m


def verdict(q: EngagementInputs, v: Values) -> str:
    if "N" not in v:
        return "no state"
    if "N_max" not in v:
        return "rolls over"
    if q.z_m == 0:
        return "no crown"
    if v["p peak"] <= EVEN * v["p even peak"]:
        return "suits"
    return "too shallow" if v["p end peak"] >= v["p peak"] else "uneven"


def findings(q: EngagementInputs, v: Values) -> Sequence[str]:
    state = verdict(q, v)
    if state == "no state":
        return ("no state: no state within the profile bears this torque",)
    if state == "rolls over":
        return ("rolls over: the sprags turn past their profile before the torque's swing ends",)
    over = v["p peak"] / v["p even peak"]
    first = {
        "no crown": "no crown: the ends carry most, and that pressure has no limit",
        "suits": "suits the first peak: its pressure is nearly even",
        "too shallow": "too shallow for the first peak: the ends carry most",
        "uneven": "uneven at the first peak: the middle carries most",
    }[state]
    found = [
        f"{first}; {pascal(v['p peak'])} under {newton(v['N_max'])}, {over:.3g} times that of an "
        f"even load; at rest {pascal(v['p rest'])} under {newton(v['N'])}"
    ]
    if q.z_m == 0:
        return found
    found.append(
        f"the crown is cut for K_1 Q = {newton(v['suits'])}; the first peak asks for K_1 = "
        f"{v['K_1 suits']:.3g} with this Q"
    )
    found.append(
        f"it begins {v['straight'] / 2 * 1e3:.3g} mm from mid-length and drops by "
        f"{v['end slice'] / UM:.3g} µm at the middle of its end slices, {q.z_m / UM:.3g} µm at the "
        f"very ends; 1 % more z_m deepens it by {v['share']:.2g} % on average, 1 % more K_1 "
        f"by {1 - v['share']:.2g} %"
    )
    return found


def warnings(q: EngagementInputs, v: Values) -> Sequence[str]:
    found = []
    if q.z_m > 0 and v["end slice"] < REACHED * q.z_m:
        found.append(
            f"z_m = {q.z_m / UM:.3g} µm is reached at the very ends alone: the end slices drop by "
            f"{v['end slice'] / UM:.3g} µm"
        )
    if v.get("p end peak", 0.0) > 0:
        found.append(
            "the ends carry at the first peak: the largest pressure grows with the number of "
            "slices where it is theirs"
        )
    return found


def summary(q: EngagementInputs, v: Values) -> dict[str, Any]:
    """JSON; `over_even` is the largest pressure over an even load's at the first peak."""
    known = "p peak" in v
    return {
        "verdict": verdict(q, v), "over_even": v["p peak"] / v["p even peak"] if known else None,
        "K_1": v.get("K_1 suits"),
    }  # fmt: skip
