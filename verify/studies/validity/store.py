"""What was measured of a case, as a small file of the project that counts while its code stands."""

import json
import math
import time
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from verify.core import units
from verify.core.case import Case, Scan
from verify.core.figures import Array
from verify.core.files import write_whole
from verify.core.inputs import Inputs, meta
from verify.studies.sweep.axes import changed
from verify.studies.sweep.outcome import Course, Outcome
from verify.studies.sweep.pairs import Pair, portion, selected
from verify.studies.sweep.plan import Plan, grid
from verify.studies.sweep.point import code_of

FOLDER = Path(__file__).parents[2] / "measured" / "validity"
DIGITS = 4  # significant, of errors and their bars


@dataclass(frozen=True)
class Measured:
    """The courses of each scan of a case, and the day they were made."""

    date: str
    scans: tuple[tuple[Plan, tuple[Course, ...]], ...]


def plans(case: Case) -> tuple[Plan, ...]:
    """One for each scan of the case, about its default inputs; InputError."""
    return tuple(
        grid(case, case.id, _held(case, scan), selected(case, scan.only), scan.vary, star=scan.star)
        for scan in case.scans
    )


def _held(case: Case, scan: Scan) -> Inputs:
    """The default inputs with what the scan holds elsewhere."""
    inputs, values = case.inputs(), {}
    for text in scan.at:
        name, _, given = text.partition("=")
        values[name] = units.parse(given, meta(type(inputs).model_fields[name])["unit"])
    return changed(inputs, values)


def measured(case: Case, folder: Path | None = None) -> Measured | None:
    """What is kept of `case`; None where nothing is, or other code, inputs or scans made it."""
    try:
        data = json.loads(_path(case, folder).read_text("utf-8"))
        every = plans(case)
        if data["made by"] != _made_by(case, every):
            return None
        return Measured(data["date"], tuple(
            (plan, tuple(_course(pair, kept[pair.name], len(plan.points)) for pair in plan.chosen))
            for plan, kept in zip(every, data["scans"], strict=True)
        ))  # fmt: skip
    except (OSError, ValueError, LookupError, TypeError, AttributeError):
        return None


def keep(case: Case, outcomes: Sequence[Outcome], folder: Path | None = None) -> Path:
    """Write what was measured, one outcome for each scan; the file that has it."""
    data = {
        "case": case.id,
        "date": time.strftime("%Y-%m-%d", time.gmtime()),
        "made by": _made_by(case, [one.solved.plan for one in outcomes]),
        "scans": [
            {course.pair.name: {
                "error": _short(course.error), "U": _short(course.U_error),
                "problems": _reasons(course.problems),
            } for course in one.courses}
            for one in outcomes
        ],
    }  # fmt: skip
    path = _path(case, folder)
    text = json.dumps(data, allow_nan=False, ensure_ascii=False, separators=(",", ":"))
    # a line for each pair: what changed shows
    text = text.replace('},"', '},\n"') + "\n"
    write_whole(path, lambda file: file.write(text.encode("utf-8")))
    return path


def _made_by(case: Case, every: Sequence[Plan]) -> dict[str, Any]:
    """All that numbers depend on: inputs, scans, what is compared how, and both sides' sources."""
    return {
        "inputs": json.loads(json.dumps(case.inputs().model_dump())),
        "scans": [_plain(scan) for scan in case.scans],
        "pairs": [[_signature(pair) for pair in plan.chosen] for plan in every],
        "code": [list(code_of(case, portion(case, plan.chosen))) for plan in every],
    }


def _plain(scan: Scan) -> dict[str, Any]:
    return {k: list(v) if isinstance(v, tuple) else v for k, v in asdict(scan).items()}


def _signature(pair: Pair) -> list[Any]:
    return [pair.name, pair.analytic, pair.fem, pair.scale, pair.claim.formal]


def _path(case: Case, folder: Path | None) -> Path:
    return (folder or FOLDER) / f"{case.id}.json"


def _short(values: Array) -> list[float | None]:
    return [float(f"{v:.{DIGITS}g}") if math.isfinite(v) else None for v in values]


def _reasons(problems: Sequence[str]) -> dict[str, list[int]]:
    """The points that have no error, by the reason."""
    found: dict[str, list[int]] = {}
    for n, reason in enumerate(problems):
        if reason:
            found.setdefault(reason, []).append(n)
    return found


def _course(pair: Pair, kept: Mapping[str, Any], points: int) -> Course:
    """What is kept of a pair; the values that were compared are not."""
    error, U = (
        np.array([math.nan if v is None else float(v) for v in kept[key]])
        for key in ("error", "U")
    )  # fmt: skip
    if not len(error) == len(U) == points:
        raise ValueError(f"{pair.name}: {len(error)} values for {points} points")
    problems = [""] * points
    for reason, rows in dict(kept["problems"]).items():
        for n in rows:
            problems[n] = reason
    none = np.full(points, math.nan)
    return Course(
        pair=pair, formula=none, fe=none, U=none, error=error, U_error=U, problems=tuple(problems)
    )
