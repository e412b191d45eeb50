"""Criteria of rotors: distance of critical speeds from the operating speeds."""

import math
from typing import Any

from verify.answers.answer import Quantity
from verify.answers.assessment import Assessment
from verify.case import Values
from verify.cases.rotor_clutch_words import open_slices
from verify.cases.rotor_system_words import criticals, distance

SEPARATION = 0.15
SEPARATION_SOURCE = "usual separation margin of 15 % between operating and critical speeds"
RPM = math.pi / 30


def link(q: Any, _: Values, part: Assessment) -> None:
    """All sprags in contact under the uneven load."""
    if count := open_slices(q, "together"):
        part.failures.append(f"{count} slices of the sprags are without contact")
    part.unknowns.append("stiffnesses have no limit by themselves: use them as a link of a rotor")


def shaft(q: Any, v: Values, part: Assessment) -> None:
    """Speed of the shaft beside its first critical speed, Timoshenko's beam."""
    _separated(q.n, v["timoshenko critical"], part)


def stepped(q: Any, v: Values, part: Assessment) -> None:
    """The same with a step in diameter, by the 45° rule, the lower one."""
    _separated(q.n, v["45° critical"], part)


def system(q: Any, _: Values, part: Assessment) -> None:
    """Distance of every critical speed from the operating range."""
    found = criticals(q)
    if not found:
        part.unknowns.append("no critical speed was found in the range that was searched")
        return
    nearest = min(found, key=lambda c: abs(distance(q, c.speed)))
    part.design = Quantity(
        key="nearest_critical_speed", symbol="n_c", value=nearest.speed, unit="r/min",
        what=f"critical speed nearest to the operating range, unbalance of {nearest.shafts}",
    )  # fmt: skip
    what = "distance of the nearest critical speed from the operating range"
    part.at_least("separation", what, abs(distance(q, nearest.speed)), q.margin, "%",
                  "input margin", assumed="margin" in part.assumed)  # fmt: skip


def sprag_rotor(q: Any, v: Values, part: Assessment) -> None:
    """Speed of the test rig beside the forward critical speeds of the central system."""
    orders = [v[f"forward critical {k}"] for k in (1, 3, 5) if f"forward critical {k}" in v]
    nearest = min(orders, key=lambda w: abs(q.rig_speed / w - 1))
    _separated(q.rig_speed, nearest, part)
    part.unknowns.append("the dimensions are fitted to three critical speeds, not measured")


def _separated(speed: float, critical: float, part: Assessment) -> None:
    part.at_least("separation", "distance of the speed from the critical speed",
                  abs(speed / critical - 1), SEPARATION, "%", SEPARATION_SOURCE,
                  assumed=True)  # fmt: skip
