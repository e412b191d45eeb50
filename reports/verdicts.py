"""Verdicts of the formulas: numbers by paper, and each verdict with its error and evidence."""

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from reports.advice import advised
from reports.formats import MINUS
from reports.in_short import named
from verify.core.results import Report
from verify.core.verdicts import SHARED, FormulaVerdict, Verdict

HEAD = "| paper | equation | form | what it gives | verdict | in words |\n|---|---|---|---|---|---|"
NBSP = "\u00a0"  # a narrow column does not separate a sign from its number
SMALLEST = 1e-4  # relative: smallest error or uncertainty that is printed
MEANING = {
    Verdict.EXACT: "solves its idealisation exactly; the detection limit of the row is at most 1 %",
    Verdict.ACCURATE: "error plus uncertainty is within 1, 2, 5 or 10 % over the compared range",
    Verdict.PART: "accurate only in the stated part of the range",
    Verdict.CONSERVATIVE: "errors above 10 % occur; errors on the unsafe side are at most 2 %",
    Verdict.UNSAFE: "errors above 10 % occur on the unsafe side",
    Verdict.WRONG: "an erratum changes the result; the corrected form has a separate verdict",
    Verdict.DEFINITION: "the equation is a definition: there is nothing to verify",
    Verdict.UNVERIFIABLE: "a value that the formula needs is not printed, or no reference exists",
    Verdict.NONE: "the evidence has failed or was not run",
}


@dataclass(frozen=True)
class PaperVerdicts:
    """Verdicts of the formulas of one paper."""

    key: str
    cited: str
    verdicts: tuple[FormulaVerdict, ...]

    @property
    def counts(self) -> Mapping[Verdict, int]:
        """Number of formulas by verdict; each form of an equation is counted separately."""
        return Counter(one.verdict for one in self.verdicts)


def by_paper(report: Report) -> list[PaperVerdicts]:
    """Verdicts grouped by paper, in the order of the ledgers."""
    short = named(report.papers)
    return [
        PaperVerdicts(key, short[key], tuple(v for v in advised(report.verdicts) if v.paper == key))
        for key in dict.fromkeys(v.paper for v in report.verdicts)
    ]


def given(report: Report) -> list[Verdict]:
    """Verdicts that occur in the report; "no verdict" is included only if a formula has it."""
    found = {one.verdict for one in report.verdicts}
    return [verdict for verdict in Verdict if verdict in found or verdict is not Verdict.NONE]


def at_paper(one: FormulaVerdict) -> str:
    """Text of the error at the inputs of the case with its uncertainty, such as "+24 ± 0.03 %".

    A dash if there is none.
    """
    if one.error is None or one.U is None:
        return "–"
    if abs(one.error) + one.U < SMALLEST:
        return f"<{NBSP}0.01{NBSP}%"
    bar = f" ±{NBSP}{100 * one.U:.1g}" if one.U >= SMALLEST else ""
    sign = "+" if one.error >= 0 else MINUS
    return f"{sign}{_percents(abs(one.error))}{bar}{NBSP}%"


def sides(one: FormulaVerdict) -> str:
    """Text of the largest positive and negative error over all points, such as "+5 / −34 %".

    A dash if there are none.
    """
    if one.above is None or one.below is None:
        return "–"
    high, low = (
        f"{sign}{_percents(size)}" if size >= SMALLEST else "0"
        for sign, size in (("+", one.above), (MINUS, one.below))
    )
    return f"{high} / {low}{NBSP}%"


def _percents(size: float) -> str:
    """Text of a percentage with two digits; 100 and larger values have no decimals."""
    return f"{100 * size:.0f}" if size >= 1 else f"{100 * size:.2g}"


def short_words(one: FormulaVerdict) -> str:
    """Sentences of a verdict without the verdict itself, which has a separate column."""
    text = one.words.replace(f". The formula is {SHARED}", "").removeprefix(f"{one.verdict}: ")
    first = text[0].upper() if text[0].isascii() else text[0]  # a symbol stays as it is
    return f"{first}{text[1:]}."


def slug(name: str) -> str:
    """Anchor for a name: letters and digits, with hyphens for all other characters."""
    return re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")


def may_be_used(verdicts: Sequence[FormulaVerdict]) -> list[FormulaVerdict]:
    """Formulas that are exact, or accurate over their design range."""
    return [v for v in verdicts if v.verdict in (Verdict.EXACT, Verdict.ACCURATE)]


def not_to_be_used(verdicts: Sequence[FormulaVerdict]) -> list[FormulaVerdict]:
    """Formulas that are unsafe or wrong in this form."""
    return [v for v in verdicts if v.verdict in (Verdict.UNSAFE, Verdict.WRONG)]


def errata_in_verdicts(
    report: Report,
) -> list[tuple[str, Mapping[str, Any], list[FormulaVerdict]]]:
    """Errata that change the result of a formula, with their paper and these formulas."""
    short = named(report.papers)
    found = (
        (e, [v for v in report.verdicts if v.paper == e["paper"] and e["id"] in v.errata])
        for e in report.errata
    )
    return [(short[e["paper"]], e, verdicts) for e, verdicts in found if verdicts]


def counts_in_markdown(report: Report) -> str:
    """Markdown table with the number of verdicts of each kind by paper."""
    kinds, papers = given(report), by_paper(report)
    lines = [f"| formulas of | {' | '.join(kinds)} |", f"|---|{'---|' * len(kinds)}"]
    lines += [_counted(paper.cited, [paper.counts[kind] for kind in kinds]) for paper in papers]
    lines.append(_counted("all", [sum(p.counts[kind] for p in papers) for kind in kinds]))
    return "\n".join(lines)


def markdown(report: Report) -> str:
    """Markdown table of all verdicts."""
    lines = (
        f"| {paper.cited} | {v.name} | {v.form} | {v.what} | **{v.verdict}** | {v.words}. |"
        for paper in by_paper(report)
        for v in paper.verdicts
    )
    return "\n".join([HEAD, *lines])


def _counted(name: str, numbers: Sequence[int]) -> str:
    return f"| {name} | {' | '.join(str(n or '') for n in numbers)} |"
