"""The verdicts of record, from the last full run that a maintainer accepted.

`check`, `list` and `explain` read them, for a verdict rests on all cases and takes minutes.
"""

import json
import math
from collections.abc import Sequence
from dataclasses import asdict
from functools import cache
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter

from verify.core.case import Case
from verify.core.files import write_whole
from verify.core.verdicts import FormulaVerdict
from verify.papers.numbers import numbers

FILE = Path(__file__).parents[1] / "measured" / "verdicts.json"
DIGITS = 3  # significant, of errors
ERRORS = ("error", "above", "below")
ERROR_TOLERANCE = 0.01  # relative, of an error beside the error of record
SMALLEST_ERROR = 1e-5  # errors below it depend on rounding, so that they are not compared


@cache
def kept() -> tuple[FormulaVerdict, ...]:
    """The verdicts of record; empty if there are none."""
    try:
        text = FILE.read_bytes()
    except OSError:
        return ()
    return TypeAdapter(tuple[FormulaVerdict, ...]).validate_json(text)


def keep(verdicts: Sequence[FormulaVerdict], file: Path = FILE) -> None:
    """Make these the verdicts of record, a line each; OSError."""
    lines = [json.dumps(_short(asdict(one)), ensure_ascii=False) for one in verdicts]
    text = "[\n" + ",\n".join(lines) + "\n]\n"
    write_whole(file, lambda target: target.write(text.encode()))


def moved(verdicts: Sequence[FormulaVerdict]) -> list[str]:
    """A line for each formula whose verdict, class, safe side, ranges or errors differ from it."""
    before = {one.id: one for one in kept()}
    lines = []
    for one in verdicts:
        was = before.pop(one.id, None)
        if was is None:
            lines.append(f"verdict of {one.id}: {one.words}; not on record")
        elif (was.verdict, was.within) != (one.verdict, one.within):
            lines.append(f"verdict of {one.id}: {one.words}; {was.words} on record")
        elif was.safe is not one.safe:
            lines.append(f"verdict of {one.id}: its safe side is not that of record")
        elif (was.ranges, was.design) != (one.ranges, one.design):
            lines.append(f"verdict of {one.id}: its ranges are not those of record")
        elif any(_differs(getattr(was, name), getattr(one, name)) for name in ERRORS):
            lines.append(f"verdict of {one.id}: its errors are not those of record")
    return lines + [f"verdict of {name}: on record only" for name in before]


def _differs(was: float | None, now: float | None) -> bool:
    if was is None or now is None:
        return was is not now
    return not math.isclose(was, now, rel_tol=ERROR_TOLERANCE, abs_tol=SMALLEST_ERROR)


def of_case(case: Case) -> tuple[FormulaVerdict, ...]:
    """The verdicts of record of the equations that a case has, or that rest on its rows."""
    names = {f"Eq. {number}" for number in equations(case)}
    return tuple(
        one for one in kept()
        if (one.paper == case.paper and one.name in names) or case.id in one.cases
    )  # fmt: skip


def equations(case: Case) -> frozenset[int]:
    """The numbered equations of its paper that the quantities of a case state."""
    declared: Sequence[Any] = getattr(case.inputs, "quantities", tuple)()
    texts = [f"Eqs. {q.equation}" for q in declared if q.equation]
    return frozenset().union(*map(numbers, texts))


def _short(value: Any) -> Any:
    """Numbers with DIGITS significant digits, so that a record is the same on every machine."""
    if isinstance(value, float):
        return float(f"{value:.{DIGITS}g}") if math.isfinite(value) else None
    if isinstance(value, dict):
        return {k: v if k in ("low", "high") else _short(v) for k, v in value.items()}
    if isinstance(value, list | tuple):
        return [_short(v) for v in value]
    return value
