"""Outcome of a design for other programs: a JSON record, and a CSV table of all candidates."""

import csv
import io
import math
from typing import Any

import numpy as np

from verify.core import units
from verify.studies.design.limits import Limit
from verify.studies.design.nearest import Relaxation
from verify.studies.design.outcome import Outcome
from verify.studies.design.search import Search

# name, unit; "" for numbers and words
GEOMETRY = 5  # number of columns with geometry, which every candidate has
COLUMNS = (
    ("n", "1"), ("b", "mm"), ("L1", "mm"), ("r", "mm"), ("alpha", "deg"), ("L0", "mm"),
    ("U_w", "mm"), ("Delta", "mm"), ("f", "1"), ("k1", "N/mm"), ("k1_eqs_1_9", "N/mm"),
    ("U_A", "mm"), ("F_A", "N"), ("k2", "N/mm"), ("stress", "MPa"),
)  # fmt: skip


def columns(s: Search) -> dict[str, Any]:
    """Geometry and results of all N candidates in the units of COLUMNS (name: array (N,))."""
    q, g, f = s.task.demands, s.springs, s.formulas
    si = {
        "n": g.n, "b": g.b, "L1": g.L1, "r": g.r, "alpha": g.alpha, "L0": f.L0, "U_w": f.U_w,
        "Delta": f.delta(q.F_w), "f": f.f, "k1": f.k1, "k1_eqs_1_9": f.k1_eqs_1_9, "U_A": f.U_A,
        "F_A": f.F_A, "k2": f.k2, "stress": f.stress,
    }  # fmt: skip
    return {
        name: si[name] if unit == "1" else si[name] / units.factor(unit) for name, unit in COLUMNS
    }


def candidates_csv(s: Search) -> str:
    """CSV text with one line per candidate: geometry, results, states, violated limits.

    The states are 1 or 0: whether the candidate is feasible, and whether it is on the Pareto front.
    A candidate whose shape is impossible violates "shape" and has no results.
    """
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    heads = [name if unit == "1" else f"{name} [{unit}]" for name, unit in COLUMNS]
    writer.writerow([*heads, "feasible", "front", "violated"])
    values = columns(s)
    on_front = np.zeros(len(s.springs), bool)
    on_front[s.front] = True
    texts = [np.char.mod("%.9g", column).astype(object) for column in values.values()]
    for column in texts[GEOMETRY:]:
        column[~s.judged.possible] = ""
    flags = s.judged.feasible.astype(int), on_front.astype(int)
    rows = zip(*texts, *flags, strict=True)
    writer.writerows([*row, " ".join(s.judged.reasons(i))] for i, row in enumerate(rows))
    return out.getvalue()


def record(outcome: Outcome) -> dict[str, Any]:
    """Outcome of a design as a dictionary for JSON."""
    s = outcome.search
    values = columns(s)
    members = []
    for rank, i in enumerate(s.members):
        member: dict[str, Any] = {"member": rank + 1, "candidate": int(i)}
        member |= {
            name: {"value": float(values[name][i]) if name != "n" else int(values[name][i]),
                   "unit": unit}
            for name, unit in COLUMNS
        }  # fmt: skip
        member["distance_to_ideal"] = float(s.distance[rank])
        if outcome.verified:
            v = outcome.verified[rank]
            member["fem"] = {
                "k1": {"value": v.k1 / 1e3, "unit": "N/mm"}, "deviation": v.deviation,
                "limit": v.limit, "mesh": v.mesh, "agrees": v.agrees,
                "Delta": {"value": finite(v.delta * 1e3), "unit": "mm"}, "e_r": finite(v.e_r),
                "fits": v.fits, "solved": not v.unsolved,
                "force_at_U_w": {"value": finite(v.curve.force(v.U_w)), "unit": "N"},
                "height": {"value": v.curve.height * 1e3, "unit": "mm"},
                "stress": {"value": v.stress / 1e6, "unit": "MPa"},
                "touches": {"value": finite(v.curve.touches * 1e3), "unit": "mm"},
            }  # fmt: skip
        members.append(member)
    return {
        "name": s.task.name,
        "candidates": len(s.springs),
        "feasible": int(s.judged.feasible.sum()),
        "violations": violations(s),
        "front": len(s.front),
        "members": members,
        "chosen": None if outcome.chosen is None else outcome.chosen + 1,
        "passed": outcome.passed,
        "curve": None
        if outcome.curve is None
        else {"U_mm": list(outcome.curve.U * 1e3), "F_N": list(outcome.curve.F)},
        "nearest": [relaxed(r) for r in s.nearest],
        "relax_one": [relaxed(r) for r in s.relaxations],
    }


def violations(s: Search) -> dict[str, int]:
    """Number of candidates that violate each limit; key "shape" counts impossible shapes."""
    counts = s.judged.violations.sum(axis=1)
    found = {limit.key: int(c) for limit, c in zip(s.judged.limits, counts, strict=True)}
    return found | {"shape": int((~s.judged.possible).sum())}


def finite(value: float) -> float | None:
    """`value`, or None if it is not finite, because JSON has no NaN."""
    return value if math.isfinite(value) else None


def relaxed(r: Relaxation) -> dict[str, Any]:
    """Required relaxation of one limit as a dictionary, in the unit of its input."""
    factor = units.factor(r.limit.unit)
    return {
        "limit": r.limit.key, "what": r.limit.what, "unit": r.limit.unit, "from": r.given / factor,
        "to": r.needed / factor, "excess": r.excess, "candidate": r.candidate,
    }  # fmt: skip


def shown(limit: Limit, value: float, *, digits: int = 5) -> str:
    """`value` [SI] as text in the unit of `limit`."""
    unit = "" if limit.unit == "1" else f" {limit.unit}"
    return f"{value / units.factor(limit.unit):.{digits}g}{unit}"
