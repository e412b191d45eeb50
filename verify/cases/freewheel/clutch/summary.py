"""Results of a freewheel for programs, in addition to its values: class, ratio and limits."""

from typing import Any

from analytic.freewheel.duty import Limit
from verify.cases.freewheel.clutch.classes import light
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.core.case import Values


def summary(q: ClutchInputs, v: Values) -> dict[str, Any]:
    """Class, mu/mu_req (None without equilibrium) and limits of T [N m] and F_ax [N], for JSON."""
    limits = [_limit("T", "N m", q.T, x) for x in q.duty.of_torque] if q.T >= 0 else []
    limits += [_limit("F_ax", "N", q.F_ax, x) for x in q.duty.of_axial_load]
    return {"verdict": light(q, v), "ratio": v.get("safety"), "limits": limits}


def _limit(of: str, unit: str, now: float, limit: Limit) -> dict[str, Any]:
    return {"of": of, "key": limit.key, "what": limit.words, "at": limit.at, "unit": unit,
            "passed": now > limit.at}  # fmt: skip
