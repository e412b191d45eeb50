"""Criteria of rotors: separation of critical speeds from the operating speeds."""

import math
from collections.abc import Sequence
from typing import Any

from analytic.rotor.rotor_study import opposite_criticals
from verify.answers.answer import Quantity
from verify.answers.assessment import Assessment
from verify.cases.rotor.clutch.advice import open_slices
from verify.cases.rotor.system.advice import criticals, distance, limits
from verify.core.case import Values

SEPARATION = 0.15
RPM = math.pi / 30
OPPOSITE = "backward (opposite)"
MODES = 3  # whose whirl frequencies the formulas of a shaft give


def link(q: Any, _: Values, part: Assessment) -> None:
    """Criterion of a sprag clutch between rotors: every slice of its sprags must be in contact."""
    if count := open_slices(q, "together"):
        part.failures.append(f"{count} slices of the sprags are without contact")
    part.unknowns.append("a stiffness has no limit: use the stiffnesses as a link in a rotor model")


def shaft(q: Any, v: Values, part: Assessment) -> None:
    """Criterion of a shaft: separation of its speed from the critical speeds."""
    higher = [v[f"whirl_{k}_forward"] for k in range(2, MODES + 1)]
    _separated(q.n, [v["critical"], *higher], part)


def stepped(q: Any, v: Values, part: Assessment) -> None:
    """Criterion of a stepped shaft: separation of its speed from the critical speeds (45° rule)."""
    higher = [v[f"whirl_{k}_forward_cone"] for k in range(2, MODES + 1)]
    _separated(q.n, [v["critical_cone"], *higher], part)


def system(q: Any, _: Values, part: Assessment) -> None:
    """Criterion of a rotor: separation of every critical speed from the operating range."""
    found = criticals(q)
    if not found:
        part.unknowns.append("no critical speed was found in the searched range")
        return
    nearest = min(found, key=lambda c: abs(distance(q, c.speed)))
    part.design = Quantity(
        key="nearest_critical_speed", symbol="n_c", value=nearest.speed, unit="r/min",
        what=f"critical speed nearest to the operating range, excited by unbalance of shaft "
        f"{nearest.shafts}",
    )  # fmt: skip
    _distance(q.speed_from, q.speed_to, q.margin, nearest.speed, part,
              assumed="margin" in part.assumed)  # fmt: skip
    low, high = limits(q)
    for speed in opposite_criticals(q.rotor):
        text = (
            f"critical speed of {OPPOSITE} whirl at {speed / RPM:.5g} r/min, {{}}: unbalance "
            "excites it unless every bearing is equally stiff in both directions"
        )
        if q.speed_from <= speed <= q.speed_to:
            part.unknowns.append(text.format("within the operating range"))
        elif low <= speed <= high:
            part.remarks.append(text.format("within the separation margin"))


def sprag_rotor(q: Any, v: Values, part: Assessment) -> None:
    """Criterion of the test rig: separation of its speed from the forward critical speeds."""
    orders = [v[f"critical_forward_{k}"] for k in (1, 3, 5)]
    _separated(q.rig_speed, orders, part)
    part.unknowns.append(
        "the dimensions of the rotor are fitted to three critical speeds, not measured"
    )


def _separated(speed: float, critical: Sequence[float], part: Assessment) -> None:
    """Add the criterion that `speed` [rad/s] is separated from the nearest critical speed [rad/s].

    `critical` must be in ascending order.
    """
    if not critical:
        part.unknowns.append("no critical speed was found")
        return
    nearest = min(critical, key=lambda w: abs(math.log(max(speed, 1e-9) / w)))
    _distance(speed, speed, SEPARATION, nearest, part, assumed=True)
    if speed > critical[-1]:
        part.unknowns.append(
            f"the speed is above the highest computed critical speed, "
            f"{critical[-1] / RPM:.5g} r/min"
        )


def _distance(low: float, high: float, margin: float, critical: float, part: Assessment,
              *, assumed: bool) -> None:  # fmt: skip
    """Add the criterion that a critical speed is outside `low` to `high`, extended by `margin`.

    `low`, `high` and `critical` are in rad/s; `margin` is relative.
    """
    share = f"separation margin of {100 * margin:.0f} %"
    if critical < low:
        part.at_most("separation", "critical speed below the operating speed", critical,
                     low * (1 - margin), "r/min", f"lowest operating speed less a {share}",
                     assumed=assumed)  # fmt: skip
        return
    part.at_least("separation", "critical speed", critical, high * (1 + margin), "r/min",
                  f"highest operating speed plus a {share}", assumed=assumed)  # fmt: skip
