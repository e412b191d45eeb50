"""The command `search`: finds the reading that reproduces a printed number."""

import json
import time
from collections.abc import Iterable
from dataclasses import asdict
from pathlib import Path
from typing import Any

from verify.app.commands import load
from verify.cases.registry import CASES, find
from verify.core import units
from verify.core.case import Case
from verify.core.console import aligned, raised
from verify.core.inputs import InputError, Inputs
from verify.core.progress import Show, State, shown
from verify.core.suggestions import nearest
from verify.core.terminal import print_wrapped
from verify.papers.digits import is_number
from verify.papers.ledger import published
from verify.studies.readings.generic import numbers, printed_rounding, readings, value_of
from verify.studies.readings.problem import Problem
from verify.studies.readings.registry import PROBLEMS, WITHOUT_FORMULA
from verify.studies.readings.search import EVIDENCE, Outcome, Progress, search

MOST = 3  # changes at once
SHOWN = 12  # hits


def run_search(
    name: str,
    *,
    key: str,
    printed: str,
    unit: str,
    file: Path | None,
    changes: int,
    rounded: bool,
    as_json: bool,
) -> int:
    """Search and print the result; returns 0 if a reading gives the number, otherwise 1."""
    if not 0 <= changes <= MOST:
        raise InputError(f"--changes must be 1 to {MOST}, got {changes}")
    known = {problem.reference: problem for problem in PROBLEMS}
    if name in known and not (key or printed or file):
        problem = known[name]
        outcome, about = problem.search(changes), _about(problem)
    else:
        with shown(quiet=as_json) as show:
            outcome, about = _generic(
                name, key, printed, unit, file, most=changes or 2, rounded=rounded, show=show
            )
    if as_json:
        print(json.dumps(_record(outcome, about), ensure_ascii=False))
    else:
        print_wrapped(*map(raised, _lines(outcome, about)))
    return 0 if outcome.met or outcome.hits else 1


def _about(problem: Problem) -> dict[str, Any]:
    return {"name": problem.reference, "case": problem.case, "what": problem.what,
            "printed": problem.printed, "unit": problem.printed_unit, "place": problem.place,
            "errata": list(problem.errata)}  # fmt: skip


def _generic(
    name: str,
    key: str,
    printed: str,
    unit: str,
    file: Path | None,
    *,
    most: int,
    rounded: bool,
    show: Show,
) -> tuple[Outcome, dict[str, Any]]:
    """Result of a search on a formula value of a case, with the usual readings of all inputs."""
    case, key, reference = _asked(name, key)
    inputs = case.inputs() if file is None else _of_file(file, case)
    values = case.analytic(inputs)
    if key not in values:
        raise InputError(
            f"--key {key}: case {case.id} has no such key; its keys are {_keys(key, values)}"
        )
    if reference and not printed:
        printed, unit = published(reference).printed, unit or published(reference).unit
    if not is_number(printed):
        raise InputError(
            "--printed must be a number with all its printed digits, such as "
            f"12.30, got {printed!r}"
        )
    natural = next((o.unit for o in case.outputs if o.key == key), unit or "1")
    unit = unit or natural
    if units.dimensions(unit) != units.dimensions(natural):
        raise InputError(f"--unit {unit}: the unit of {key} must have the dimension of {natural}")
    factor = units.factor(unit)
    try:
        outcome = search(
            lambda q: value_of(case, inputs, q, key) / factor, numbers(inputs), printed,
            readings(inputs), rounding=printed_rounding(inputs) if rounded else {}, most=most,
            progress=_progress(show, case.id),
        )  # fmt: skip
    except ValueError as error:
        raise InputError(f"--printed {printed}: {error}") from error
    about = {"name": reference or f"{case.id}, {key}", "case": case.id, "what": key,
             "printed": printed, "unit": unit, "place": "", "errata": []}  # fmt: skip
    return outcome, about


def _progress(show: Show, name: str) -> Progress:
    """Function that displays the progress of a search."""
    start = time.monotonic()

    def show_state(done: int, total: int) -> None:
        left = (time.monotonic() - start) * (total - done) / max(done, 1)
        show(State(done, total, (name,), left, "combinations"))

    return show_state


def _of_file(file: Path, case: Case) -> Inputs:
    _, other, inputs, _ = load(file)
    if other is not case:
        raise InputError(f"{file}: is a file for case {other.id}, but must be a file for {case.id}")
    return inputs


def _asked(name: str, key: str) -> tuple[Case, str, str]:
    """Case, key and printed number for `name`, which is CASE, CASE/row or paper:id."""
    if ":" in name.partition("/")[0]:
        return _claimed(name)
    case_id, _, row = name.partition("/")
    try:
        case = find(case_id)
    except ValueError as error:
        raise InputError(
            f"{error}; numbers with listed readings are {_references(name)}"
        ) from error
    if not row:
        if not key:
            keys = _keys("", case.analytic(case.inputs()))
            raise InputError(f"case {case.id}: give --key, one of {keys}")
        return case, key, ""
    for check in case.checks:
        if getattr(check, "name", "") == row and (found := getattr(check, "analytic", "")):
            return case, found, getattr(check, "reference", "")
    raise InputError(
        f"{case.id} has no row {row!r} with a formula; "
        f"to list its rows, run: freewheel explain {case.id}"
    )


def _keys(key: str, values: Iterable[str]) -> str:
    """Text with all keys of formula values, beginning with those similar to `key`."""
    every = list(values)
    return nearest(key, every, most=len(every), between="; ")


def _references(name: str) -> str:
    return nearest(name, [p.reference for p in PROBLEMS])


def _claimed(name: str) -> tuple[Case, str, str]:
    """Case and key of the formula that is compared with the printed number `name`, and `name`."""
    try:
        published(name)
    except KeyError as error:
        raise InputError(
            f"there is no printed number {name}; numbers with listed readings are "
            f"{_references(name)}"
        ) from error
    for case in CASES:
        for check in case.checks:
            if getattr(check, "reference", "") == name and (key := getattr(check, "analytic", "")):
                return case, key, name
    why = WITHOUT_FORMULA.get(name, "no row compares a formula with it")
    raise InputError(f"{name}: no search is possible: {why}")


def _record(outcome: Outcome, about: dict[str, Any]) -> dict[str, Any]:
    plain = outcome.as_it_stands
    return about | {
        "as_it_stands": None if plain is None else plain.value, "met": outcome.met,
        "tried": outcome.tried, "without_value": outcome.without_value,
        "hits": [asdict(hit) for hit in outcome.hits], "chance": list(outcome.chance),
        "is_evidence": outcome.is_evidence,
    }  # fmt: skip


def _lines(outcome: Outcome, about: dict[str, Any]) -> list[str]:
    """Lines with the number, the value of the formula, the hits and their significance."""
    unit = "" if about["unit"] == "1" else f" {about['unit']}"
    plain = outcome.as_it_stands
    gives = "has no value" if plain is None else f"gives {plain.value:.6g}{_off(plain.off)}{unit}"
    found = [f"{about['name']}: {about['printed']}{unit}; {about['what']} {gives}"]
    if about["place"]:
        found[0] += f" ({about['place']})"
    if outcome.met:
        found.append("reproduced as printed, within the rounding of the number and of the inputs")
    table = [("changes", "value", "reading")] + [
        (str(hit.changes), f"{hit.value:.6g}{_off(hit.off)}", " and ".join(hit.readings))
        for hit in outcome.hits[:SHOWN]
    ]
    if outcome.hits:
        found += [f"  {line}" for line in aligned(table)]
    if len(outcome.hits) > SHOWN:
        found.append(f"  and {len(outcome.hits) - SHOWN} more")
    lost = f", {outcome.without_value} without a value" if outcome.without_value else ""
    found.append(f"{outcome.tried} combinations tried{lost}; {_weight(outcome)}")
    if about["errata"]:
        found.append(f"ledger: {', '.join(about['errata'])}")
    return found


def _off(off: float) -> str:
    return f" ± {off:.2g}" if off else ""


def _weight(outcome: Outcome) -> str:
    """Text about the significance of a hit."""
    if outcome.best is None:
        return "no other reading is needed" if outcome.met else "no reading reproduces the number"
    chance = f"expected by chance: {outcome.accidental:.2g} hits with as few changes"
    if outcome.met:
        return f"{chance}; no other reading is needed"
    significance = (
        "calibrated: chosen because it fits" if outcome.is_evidence
        else f"not evidence (above {EVIDENCE:g})"
    )  # fmt: skip
    return f"{chance}; {significance}"
