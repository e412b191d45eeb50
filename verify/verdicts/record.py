"""Recorded verdicts, from the last complete run that a maintainer accepted.

The commands `check`, `list` and `explain` read this record, because a verdict depends on all cases
and takes minutes to compute.
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
    """The recorded verdicts; empty if there is no record."""
    try:
        text = FILE.read_bytes()
    except OSError:
        return ()
    return TypeAdapter(tuple[FormulaVerdict, ...]).validate_json(text)


def keep(verdicts: Sequence[FormulaVerdict], file: Path = FILE) -> None:
    """Write the record of verdicts, one verdict per line.

    Raises OSError if the file cannot be written.
    """
    lines = [json.dumps(_short(asdict(one)), ensure_ascii=False) for one in verdicts]
    text = "[\n" + ",\n".join(lines) + "\n]\n"
    write_whole(file, lambda target: target.write(text.encode()))


def moved(verdicts: Sequence[FormulaVerdict]) -> list[str]:
    """Lines about formulas whose verdict differs from the recorded one.

    The verdict, the accuracy class, the safe side, the ranges and the errors are compared.
    """
    before = {one.id: one for one in kept()}
    lines = []
    for one in verdicts:
        was = before.pop(one.id, None)
        if was is None:
            lines.append(f"verdict of {one.id}: {one.words}; not in the record")
        elif (was.verdict, was.within) != (one.verdict, one.within):
            lines.append(f"verdict of {one.id}: {one.words}; {was.words} in the record")
        elif was.safe is not one.safe:
            lines.append(f"verdict of {one.id}: the safe side differs from the record")
        elif (was.ranges, was.design) != (one.ranges, one.design):
            lines.append(f"verdict of {one.id}: the ranges differ from the record")
        elif any(_differs(getattr(was, name), getattr(one, name)) for name in ERRORS):
            lines.append(f"verdict of {one.id}: the errors differ from the record")
    return lines + [f"verdict of {name}: only in the record" for name in before]


def _differs(was: float | None, now: float | None) -> bool:
    if was is None or now is None:
        return was is not now
    return not math.isclose(was, now, rel_tol=ERROR_TOLERANCE, abs_tol=SMALLEST_ERROR)


def of_case(case: Case) -> tuple[FormulaVerdict, ...]:
    """Recorded verdicts on equations that a case contains, or for which its rows are evidence."""
    names = {f"Eq. {number}" for number in equations(case)}
    return tuple(
        one for one in kept()
        if (one.paper == case.paper and one.name in names) or case.id in one.cases
    )  # fmt: skip


def equations(case: Case) -> frozenset[int]:
    """Numbers of the equations of the paper that the quantities of a case name."""
    declared: Sequence[Any] = getattr(case.inputs, "quantities", tuple)()
    texts = [f"Eqs. {q.equation}" for q in declared if q.equation]
    return frozenset().union(*map(numbers, texts))


def _short(value: Any) -> Any:
    """`value` with numbers rounded to DIGITS digits, so that records agree between machines."""
    if isinstance(value, float):
        return float(f"{value:.{DIGITS}g}") if math.isfinite(value) else None
    if isinstance(value, dict):
        return {k: v if k in ("low", "high") else _short(v) for k, v in value.items()}
    if isinstance(value, list | tuple):
        return [_short(v) for v in value]
    return value
