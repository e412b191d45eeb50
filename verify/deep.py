"""What is measured beyond the time of a run: made by `freewheel deep`, kept, and read by reports.

A deep case is a `Case` without rows: its levels are parts of a larger measurement on the default
inputs, each solved and cached like any level, so that an interrupted run goes on where it was. What
was measured is a small file of the project. It counts while the code that made it stands; a changed
source turns it into "not measured".
"""

import json
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from verify import cache, source_code
from verify.case import Case, FemResult
from verify.engines import Where
from verify.files import write_whole
from verify.inputs import InputError
from verify.progress import shown
from verify.results import Status
from verify.run import Job
from verify.solving import solve

FOLDER = Path(__file__).parent / "measured"


@dataclass(frozen=True)
class Measured:
    """Results of all parts, in the order of the case's levels, and the day they were made."""

    date: str
    parts: tuple[FemResult, ...]


def measured(case: Case, folder: Path | None = None) -> Measured | None:
    """What is kept of `case`; None where nothing was measured with the present code."""
    try:
        data = json.loads(((folder or FOLDER) / f"{case.id}.json").read_text("utf-8"))
        if (
            data["code"] != source_code.source_of(case.fem)
            or data["inputs"] != case.inputs().model_dump()
        ):
            return None
        parts = tuple(
            FemResult(
                h=part["h"], values=part["values"], u_it=part["u_it"],
                arrays={name: np.array(array) for name, array in part["arrays"].items()},
            )
            for part in data["parts"]
        )  # fmt: skip
        return Measured(data["date"], parts)
    except (OSError, ValueError, LookupError, TypeError):
        return None


def keep(case: Case, parts: Sequence[FemResult], folder: Path | None = None) -> Path:
    """Write what was measured; the file that has it."""
    data: dict[str, Any] = {
        "case": case.id,
        "date": time.strftime("%Y-%m-%d", time.gmtime()),
        "code": source_code.source_of(case.fem),
        "inputs": case.inputs().model_dump(),
        "parts": [
            {"h": part.h, "values": dict(part.values), "u_it": dict(part.u_it),
             "arrays": {name: array.tolist() for name, array in part.arrays.items()}}
            for part in parts
        ],
    }  # fmt: skip
    path = (folder or FOLDER) / f"{case.id}.json"
    text = json.dumps(data, indent=1, allow_nan=False)
    write_whole(path, lambda file: file.write(text.encode("utf-8") + b"\n"))
    return path


def run_deep(names: Sequence[str], *, jobs: int, again: bool = False) -> int:
    """Measure the named deep cases, or all that are not measured for the present code.

    "validity" and "validity:CASE" measure where formulas hold (verify.validity), "budget" and
    "budget:CASE" of what differences are made (verify.budget); no name measures all. 0 where
    everything was measured, 1 where a part failed.
    """
    from verify.budget import measuring as budget
    from verify.cases.registry import CASES, DEEP, find
    from verify.validity import measuring

    of_validity, of_budget = (
        [name for name in names if name.partition(":")[0] == kind]
        for kind in (measuring.NAME, budget.NAME)
    )
    regions = measuring.chosen(of_validity if names else (measuring.NAME,), CASES)
    differences = budget.chosen(of_budget if names else (budget.NAME,), CASES)
    others = [name for name in dict.fromkeys(names) if name not in {*of_validity, *of_budget}]
    try:
        chosen = [find(name, DEEP) for name in others]
    except ValueError as error:
        raise ValueError(f"{error}, validity[:CASE], budget[:CASE]") from None
    chosen = chosen if names else list(DEEP)
    missing = [case for case in chosen if again or measured(case) is None]
    for case in chosen:
        if case not in missing:
            print(f"{case.id}: measured already, --again measures it anew")
    results = solve([Job(case, case.inputs(), drawn=False) for case in missing], Where(jobs), True)
    failed = False
    for case, result in zip(missing, results, strict=True):
        bad = [row.reason for row in result.rows if row.status is Status.FAIL]
        folder = cache.default_folder()
        parts = [cache.load(folder, case, case.inputs(), level) for level in case.levels]
        whole = [part for part in parts if part is not None]
        if bad or len(whole) < len(parts):
            failed = True
            print(f"{case.id}: {bad[0] if bad else 'the cache could not be written'}")
            continue
        try:
            keep(case, whole)
        except OSError as error:
            raise InputError(f"{FOLDER}: cannot be written: {error.strerror}") from error
        print(f"{case.id}: {len(whole)} parts measured in {result.seconds:.0f} s")
    with shown(quiet=False) as show:
        measuring.measure(regions, Where(jobs), again=again, show=show)
        failed |= not budget.measure(differences, Where(jobs), again=again, show=show)
    return 1 if failed else 0
