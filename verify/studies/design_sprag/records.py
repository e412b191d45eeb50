"""Outcome of a crown design for other programs: JSON, the profile to grind, all crowns."""

import csv
import io
import json
from collections.abc import Sequence
from typing import Any

import numpy as np

from verify.cases.sprag.inputs import EngagementInputs
from verify.core import units
from verify.core.figures import Array
from verify.core.inputs import meta
from verify.studies.design_sprag.outcome import Outcome
from verify.studies.design_sprag.verified import LIMIT, Check

CHOSEN = "clutch.toml"
DIGITS = 10  # of a crown: more digits are round-off of unit conversion
POINTS = 181  # of the profile
MPa, mm, um = 1e6, 1e-3, 1e-6


def record(outcome: Outcome) -> dict[str, Any]:
    """Outcome as a dictionary for JSON: pressures in MPa, forces in N, other units in the keys."""
    task, model = outcome.task, outcome.search.model
    near, whole = outcome.search.judged[-1]
    q = task.clutch
    unit = 1.0 if outcome.relative else MPa  # unit of the objective
    return {
        "name": task.name,
        "aim": task.wishes.aim,
        "contacts": task.wishes.contacts,
        "method": task.wishes.method,
        "seed": task.wishes.seed,
        "Q_N": model.Q,
        "best": crown(outcome.crown),
        "now": crown(np.array([q.K_1, q.K_2, q.z_m])),
        "torques": [_torque(outcome, k) for k in range(len(task.torques))],
        "flat": {
            "share": 0.005,
            "alone": {"low": crown(outcome.alone[:, 0]), "high": crown(outcome.alone[:, 1])},
            "together": {
                "low": crown(outcome.together[:, 0]), "high": crown(outcome.together[:, 1])
            },
        },
        "bounds": [
            {"parameter": ("K_1", "K_2", "z_m")[b.parameter], "gain": b.gain,
             "at": _digits(b.beyond / (um if b.parameter == 2 else 1)),
             "unit": "µm" if b.parameter == 2 else "1"} for b in outcome.bounds
        ],
        "kriging": {
            "crowns": len(model.known), "rounds": outcome.rounds,
            "predicted": outcome.predicted / unit, "true": outcome.true / unit,
            "unit": "1" if outcome.relative else "MPa",
            "near": {"count": near.count, "mean": near.mean, "largest": near.largest},
            "all": {"count": whole.count, "mean": whole.mean, "largest": whole.largest},
        },
        "half_space": {"limit": LIMIT, "checks": [_check(c) for c in outcome.checks]},
        "unloaded_from_um": None if outcome.free_from is None else outcome.free_from / um,
        "p_lim_exceeded_at": list(outcome.exceeded),
        "verified": outcome.verified if outcome.checks else None,
        "passed": outcome.passed,
    }  # fmt: skip


def crown(values: Array) -> dict[str, float]:
    """Parameters of a crown (name: value)."""
    names = ("K_1", "K_2", "z_m_um")
    return dict(zip(names, map(_digits, values / [1, 1, um]), strict=True))


def _digits(value: float) -> float:
    return float(f"{value:.{DIGITS}g}")


def _torque(outcome: Outcome, k: int) -> dict[str, Any]:
    p = outcome.largest(outcome.chosen)[:, k]
    N = float(outcome.chosen.N_max[0, k])
    return {
        "T": outcome.task.torques[k],
        "N_max": N,
        "N_max_over_Q": N / outcome.search.model.Q,
        "slices": outcome.task.clutch.slices,
        "strips": outcome.search.model.counts[k],
        "p_now": float(outcome.largest(outcome.now)[0, k]) / MPa,
        "p_without": float(outcome.largest(outcome.without)[0, k]) / MPa,
        "p_best": float(outcome.best[k]) / MPa,
        "best": crown(outcome.best_crowns[k]),
        "p": float(outcome.pressures[k]) / MPa,
        "p_slices": float(outcome.chosen.slices[0, k].max()) / MPa,
        "p_least": float(p.min()) / MPa,
        "p_worst": float(p.max()) / MPa,
        "excess": float(outcome.excess[k]),
    }


def _check(c: Check) -> dict[str, Any]:
    return {
        "T": c.T, "crown": c.which, **crown(c.crown), "N_max": c.N,
        "slices": float(c.slices.max()) / MPa, "twice_the_slices": c.twice / MPa,
        "strips": float(c.strips.max()) / MPa, "half_space": c.peak / MPa,
        "coarser": c.coarse / MPa, "end": c.end / MPa, "mid": c.half.mid_pressure / MPa,
        "off": c.off(c.judged), "off_mid": c.mid_off, "agrees": c.agrees,
    }  # fmt: skip


def profile_csv(outcome: Outcome) -> str:
    """CSV text of the profile to grind: position, nominal drop, smallest and largest drop."""
    model = outcome.search.model
    y = (np.linspace(-0.5, 0.5, POINTS)) * model.q.l
    drops = model.drop(outcome.chosen.crowns, y)
    rows = zip(y / mm, drops[0] / um, drops.min(axis=0) / um, drops.max(axis=0) / um, strict=True)
    return _csv(
        ("y [mm]", "z [µm]", "z least [µm]", "z largest [µm]"),
        [tuple(f"{x:.6g}" for x in row) for row in rows],
    )


def designs_csv(outcome: Outcome) -> str:
    """CSV text of all evaluated crowns: forces, and largest pressures by slices and by strips."""
    known, task = outcome.search.model.known, outcome.task
    heads = ["K_1", "K_2", "z_m [µm]"]
    for T in task.torques:
        columns = ("N_max [N]", "p slices [MPa]", "p strips [MPa]", "p end strip [MPa]")
        heads += [f"{what} at {T:g} N m" for what in columns]
    rows = []
    for i, x in enumerate(known.crowns):
        row = [x[0], x[1], x[2] / um]
        for k in range(len(task.torques)):
            along = known.strips[k][i]
            row += [known.N_max[i, k], known.slices[i, k].max() / MPa, along.max() / MPa,
                    along[0] / MPa]  # fmt: skip
        rows.append(tuple(f"{value:.8g}" for value in row))
    return _csv(heads, rows)


def _csv(heads: Sequence[str], rows: Sequence[tuple[str, ...]]) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(heads)
    writer.writerows(rows)
    return out.getvalue()


def chosen_file(outcome: Outcome) -> str:
    """Text of a parameter file with the optimal crown, for `freewheel check --dynamic`."""
    K_1, K_2, z_m = map(_digits, outcome.crown)
    q = outcome.task.clutch.model_copy(
        update={"K_1": K_1, "K_2": K_2, "z_m": z_m, "Q": outcome.search.model.Q}
    )
    lines = [
        "# The clutch of a design task with its optimal crown. Next step:",
        f"#   freewheel check --dynamic {CHOSEN}",
        "",
        'case = "sprag-clutch"',
        f"name = {json.dumps(outcome.task.name, ensure_ascii=False)}",
        "",
        "[inputs]",
    ]
    for name, field in EngagementInputs.model_fields.items():
        value, unit = getattr(q, name), meta(field)["unit"]
        if value is None:
            continue
        if unit == "1":
            lines.append(f"{name} = {value!r}")
        else:
            lines.append(f'{name} = "{value / units.factor(unit):.12g} {unit}"')
    return "\n".join([*lines, ""])
