"""Validity explorer: points of stored studies as data for its script, and anchors on its page."""

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup

from reports.formats import prose, symbol
from reports.verdicts import slug
from verify.core.results import (
    FE,
    CaseResult,
    Report,
    ScaleInput,
    StoredStudy,
    StudiedFormula,
    StudyAxis,
)
from verify.core.verdicts import FormulaVerdict, Safe

SIGN = {Safe.ABOVE: 1, Safe.BELOW: -1, Safe.NEITHER: 0}  # of errors on the safe side

DECIMALS = 7  # of errors, which are relative; the page has them as whole numbers of the last one


@dataclass(frozen=True)
class OfCase:
    """Stored studies of a case."""

    case: CaseResult
    studies: tuple[StoredStudy, ...]

    @property
    def quantities(self) -> tuple[str, ...]:
        """Names of the compared formulas, each once."""
        return tuple(dict.fromkeys(f.quantity for s in self.studies for f in s.formulas))


def of_cases(report: Report) -> list[OfCase]:
    """Cases that have stored studies, in the order of the run."""
    found = {
        case.id: tuple(s for s in report.studies if s.case == case.id) for case in report.cases
    }
    return [OfCase(case, found[case.id]) for case in report.cases if found[case.id]]


def places(report: Report, anchors: Mapping[str, str]) -> dict[str, str]:
    """Anchors of tables on the page: of each case by its id, of each formula by its row."""
    found = {}
    for one in of_cases(report):
        found[one.case.id] = f"explore-{one.case.id}"
        rows = [f"{one.case.id}/{quantity}" for quantity in one.quantities]
        found |= {row: f"explore-{anchors[row]}" for row in rows if row in anchors}
    return found


def data(report: Report, anchors: Mapping[str, str]) -> Markup:
    """All stored points as JSON, for a script element of the page."""
    known = [v for v in report.verdicts if v.rows or v.model_rows]
    content = {
        "decimals": DECIMALS,
        "cases": [_case(one, anchors, known) for one in of_cases(report)],
        "verdicts": [_verdict(one) for one in known],
    }
    text = json.dumps(content, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return Markup(text.replace("<", "\\u003c"))  # noqa: S704 - cannot end the element


def _case(
    one: OfCase, anchors: Mapping[str, str], verdicts: Sequence[FormulaVerdict]
) -> dict[str, Any]:
    return {
        "id": one.case.id, "title": one.case.title,
        "studies": [
            {"star": s.is_star, "held": s.held, "at": dict(s.at), "date": s.date,
             "axes": [_axis(axis) for axis in s.axes], "points": s.points}
            for s in one.studies
        ],
        "formulas": [_formula(one, q, anchors, verdicts) for q in one.quantities],
    }  # fmt: skip


def _axis(axis: StudyAxis) -> dict[str, Any]:
    choices = _without_empty({
        "unit": unit(axis), "log": axis.log, "whole": axis.whole, "scales": axis.scales,
        "ratio": symbol(axis.ratio) if axis.ratio else "",
        "per": [
            {"name": one.name, "symbol": symbol(one.symbol), "unit": unit(one),
             "nominal": one.own, "power": one.power}
            for one in axis.per
        ],
    })  # fmt: skip
    return {
        "name": axis.name, "symbol": symbol(axis.symbol), "what": axis.what, "nominal": axis.own,
        "factor": axis.factor, **choices,
    }  # fmt: skip


def unit(of: StudyAxis | ScaleInput) -> str:
    """Unit of an input; empty for a plain number."""
    return "" if of.unit == "1" else of.unit


def _formula(
    one: OfCase, quantity: str, anchors: Mapping[str, str], verdicts: Sequence[FormulaVerdict]
) -> dict[str, Any]:
    """Record of a formula with its errors in each study that compares it."""
    row = f"{one.case.id}/{quantity}"
    found = [
        (n, f) for n, s in enumerate(one.studies) for f in s.formulas if f.quantity == quantity
    ]
    first = found[0][1]
    return _without_empty({
        "name": quantity, "row": anchors.get(row, ""), "by": "" if first.by == FE else first.by,
        "of": first.of, "no_factor": bool(first.of) or not first.is_positive,
        "safe": SIGN[first.safe],
        "verdicts": [n for n, v in enumerate(verdicts) if row in v.rows + v.model_rows],
        "at": [[n, *_errors(f)] for n, f in found],
    })  # fmt: skip


def _errors(formula: StudiedFormula) -> list[Any]:
    """List of errors, list of error bars, and problems by index of the point, if there are any.

    Errors and error bars are null at points without a value.
    """
    problems = {n: problem for n, problem in enumerate(formula.problems) if problem}
    return [_numbers(formula.error), _numbers(formula.U), *([problems] if problems else [])]


def _numbers(values: Sequence[float]) -> list[int | None]:
    return [round(v * 10**DECIMALS) if math.isfinite(v) else None for v in values]


def _without_empty(content: Mapping[str, Any]) -> dict[str, Any]:
    """Record without zeros, false and empty values, which are the defaults of the script."""
    return {key: value for key, value in content.items() if value}


def _verdict(one: FormulaVerdict) -> dict[str, Any]:
    form = " corrected" if one.form == "corrected" else ""
    return {
        "name": f"{one.source}, {one.name}{form}", "verdict": one.verdict.value,
        "css": one.verdict.name.lower(), "place": f"verdict-{slug(one.id)}",
        "instead": prose(one.instead),
    }  # fmt: skip
