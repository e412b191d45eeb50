"""Verdicts of one case, with the recommended alternative to each formula."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from verify.core.results import Row
from verify.core.verdicts import Form, FormulaVerdict, Verdict

# the error in a sentence, if it is the error of another case
_STATED = re.compile(
    r"((?:[+−-][\d.]+|under [\d.]+) %(?: ± [\d.]+ %)?) at the default inputs(?! of)"
)
CORRECTED = "the corrected form"
UNUSABLE = (Verdict.WRONG, Verdict.UNVERIFIABLE, Verdict.NONE)  # a corrected form may serve
REFUSED = (Verdict.UNSAFE, *UNUSABLE)  # no corrected form of such a verdict is advised


def advised(verdicts: Sequence[FormulaVerdict]) -> tuple[FormulaVerdict, ...]:
    """The given verdicts; an unusable printed form without advice refers to its corrected form."""
    corrected = {(v.paper, v.name): v for v in verdicts if v.form is Form.CORRECTED}
    return tuple(_advised(v, corrected.get((v.paper, v.name))) for v in verdicts)


def _advised(one: FormulaVerdict, corrected: FormulaVerdict | None) -> FormulaVerdict:
    is_open = one.form is Form.PRINTED and one.verdict in UNUSABLE and not one.instead
    return replace(one, instead=_of_corrected(corrected)) if is_open and corrected else one


def _of_corrected(one: FormulaVerdict) -> str:
    """Text that recommends a corrected form, if it is usable, and the alternatives to this form."""
    form = "" if one.verdict in REFUSED else f"{CORRECTED}{_quality(one)}"
    return "; or ".join(filter(None, (form, one.instead)))


def _quality(one: FormulaVerdict) -> str:
    if one.verdict is Verdict.DEFINITION:
        return ""
    if one.verdict in (Verdict.ACCURATE, Verdict.PART) and one.within:
        part = " in part of the range" if one.verdict is Verdict.PART else ""
        return f", accurate within {100 * one.within:g} %{part}"
    return f", {one.verdict}"


def of_case(
    verdicts: Sequence[FormulaVerdict], case: str, rows: Sequence[Row]
) -> list[FormulaVerdict]:
    """Verdicts whose evidence includes a case, with the largest error of the rows of this case."""
    known = {row.id: row for row in rows}
    return [_at_case(v, known) for v in verdicts if case in v.cases]


def _at_case(one: FormulaVerdict, rows: Mapping[str, Row]) -> FormulaVerdict:
    """Verdict with the largest error among the given rows.

    If rows compare the formula with a model of the real part, only these are used; otherwise, rows
    that compare it with a simplified model are used.
    """
    part = _errors(one.rows if one.is_of_part else (), rows)
    found = part or _errors(one.rows + one.model_rows, rows)
    if one.error is None or not found:
        return replace(one, error=None, U=None)
    error, U, row = max(found, key=lambda one: abs(one[0]) + one[1])
    worst = one.worst_row.partition("/")[0]
    elsewhere = _STATED.sub(rf"\1 at the default inputs of {worst}", one.words)
    words = one.words if error == one.error else elsewhere
    return replace(one, error=error, U=U, worst_row=row, is_of_part=bool(part), words=words)


def _errors(names: Sequence[str], rows: Mapping[str, Row]) -> list[tuple[float, float, str]]:
    """Error, error bar and id of each row that has an error and an error bar."""
    return [
        (row.difference / row.scale, row.tolerance / row.scale, row.id)
        for row in map(rows.get, names)
        if row and row.difference is not None and row.scale and row.tolerance is not None
    ]
