"""Recorded verdicts as lines that the commands print."""

import re
from dataclasses import dataclass

from verify.core.case import Case
from verify.core.inputs import Inputs
from verify.core.verdicts import Form, FormulaVerdict, Verdict, VerdictRange
from verify.verdicts.place import Place, place
from verify.verdicts.record import kept, of_case
from verify.verdicts.words import percent

_NAMED = re.compile(
    r"(?P<paper>[a-z]+(?: ?20\d\d)?)[ /,:]*(?:eqs?\.?|equation)? *(?P<number>\d{1,2})"
)
_FIRST = re.compile(r";|\. (?=[A-Z])")  # end of the first clause


@dataclass(frozen=True)
class Placed:
    """A verdict, and the position of a user's inputs relative to its compared ranges."""

    verdict: FormulaVerdict
    place: Place

    @property
    def line(self) -> tuple[str, ...]:
        """Cells with the equation, its verdict, a short text, and the position of the inputs."""
        one = self.verdict
        return f"{one.source}, {_short(one)}", one.verdict.value, _brief(one), self.place.words

    def record(self) -> dict[str, str]:
        """Verdict and position of the inputs as a dictionary for other programs."""
        one = self.verdict
        return {
            "id": one.id, "verdict": one.verdict.value, "words": one.words, "safe": one.safe.value,
            "instead": one.instead, "where": self.place.where.value, "place": self.place.words,
        }  # fmt: skip


def named(words: str) -> tuple[FormulaVerdict, ...]:
    """Verdicts on all forms of the equation that `words` names ("Belcin Eq. 20"), or none."""
    match = _NAMED.fullmatch(" ".join(words.lower().split()))
    if match is None:
        return ()
    paper = match["paper"].replace(" ", "")
    return tuple(
        one for one in kept()
        if one.paper.startswith(paper) and one.name == f"Eq. {match['number']}"
    )  # fmt: skip


def explained(one: FormulaVerdict) -> list[str]:
    """Lines that explain a verdict with its evidence."""
    head = f"{one.source}, {one.name}, {one.form}: {one.what}"
    parts = [
        ("verdict", one.verdict.value), ("in words", one.words), ("model", one.model),
        ("safe side", _safe(one)), ("limited by", one.limited_by), ("use instead", one.instead),
        *_ranges(one), *_design(one),
        ("shared", "; ".join(one.shares)), ("against", ", ".join(one.methods)),
        *(("row", row) for row in one.rows),
        *(("row, idealisation", row) for row in one.model_rows),
        ("row of caution", one.caution_row),
        *(("erratum", erratum) for erratum in one.errata),
    ]  # fmt: skip
    width = max(len(label) for label, text in parts if text)
    return [head, *(f"  {label:{width}}  {text}" for label, text in parts if text)]


def _ranges(one: FormulaVerdict) -> list[tuple[str, str]]:
    equal: dict[str, list[str]] = {}
    for r in one.ranges:
        text = f"{r.case}: {r.words} (of {r.over}){_straight(r)}"
        equal.setdefault(text, []).append(f"{100 * r.limit:g}")
    return [(f"within {', '.join(limits)} %", text) for text, limits in equal.items()]


def _straight(one: VerdictRange) -> str:
    """Text on the accuracy of linear interpolation between the points; empty if unknown."""
    if one.interpolation is None:
        return ""
    return f"; between points the error is within {percent(one.interpolation)} of a straight line"


def _design(one: FormulaVerdict) -> list[tuple[str, str]]:
    spanned = {
        True: "a study covers the complete range",
        False: "no study covers the complete range",
    }
    return [
        ("design range", f"{d.case}: {d.words}, {d.source}; {spanned[d.spanned]}")
        for d in one.design
    ]


def of_part(case: Case, inputs: Inputs) -> tuple[Placed, ...]:
    """Verdicts on the formulas of a case, except wrong printed forms, with the inputs' position."""
    return tuple(
        Placed(one, place(one, case.id, inputs)) for one in of_case(case)
        if one.form is Form.CORRECTED or one.verdict is not Verdict.WRONG
    )  # fmt: skip


def in_list(case: Case) -> str:
    """Text with the equations of a case, grouped by verdict: "unsafe: Eq. 6; exact: Eq. 8"."""
    names: dict[Verdict, list[str]] = {}
    for one in of_case(case):
        paper = "" if one.paper == case.paper else f"{one.source}, "
        names.setdefault(one.verdict, []).append(f"{paper}{_short(one)}")
    return "; ".join(f"{verdict}: {', '.join(same)}" for verdict, same in names.items())


def _short(one: FormulaVerdict) -> str:
    return f"{one.name} {one.form}" if one.form is Form.CORRECTED else one.name


def _brief(one: FormulaVerdict) -> str:
    return _FIRST.split(one.words.removeprefix(f"{one.verdict}: "), maxsplit=1)[0]


def _safe(one: FormulaVerdict) -> str:
    return f"{one.safe}: {one.safe_reason}" if one.safe_reason else ""
