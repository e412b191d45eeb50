"""Verdicts of the formulas in the PDF: numbers of each verdict, and a table for each paper."""

from reports.first_page import Group
from reports.pdf_tables import Data, prose
from reports.verdicts import MEANING, at_paper, by_paper, given, short_words, sides
from verify.core.results import Report
from verify.core.verdicts import FormulaVerdict, Verdict


def counts_data(report: Report) -> Data | None:
    """Number of verdicts of each kind by paper; None if a run has no verdicts."""
    if not report.verdicts:
        return None
    kinds = given(report)
    return {
        "kinds": [kind.value for kind in kinds],
        "meaning": [[kind.value, MEANING[kind]] for kind in kinds],
        "papers": [
            {"cited": paper.cited, "counts": [str(paper.counts[kind] or "") for kind in kinds]}
            for paper in by_paper(report)
        ],
    }


def verdict_data(report: Report) -> Data | None:
    """Verdicts by paper, with a line for each form of each equation."""
    counted = counts_data(report)
    if counted is None:
        return None
    papers = zip(counted["papers"], by_paper(report), strict=True)
    listed = [data | {"lines": [_line(v) for v in paper.verdicts]} for data, paper in papers]
    return counted | {"papers": listed}


def _line(one: FormulaVerdict) -> Data:
    parts = [
        one.words, f"{one.model[:1].upper()}{one.model[1:]}",
        f"Limited by: {one.limited_by}" if one.limited_by else "",
        f"Use instead: {one.instead}" if one.instead else "",
    ]  # fmt: skip
    return {
        "name": one.name, "form": one.form.value, "what": prose(one.what),
        "verdict": one.verdict.value, "error": at_paper(one), "sides": sides(one),
        "words": prose(". ".join(filter(None, parts))),
    }  # fmt: skip


def group_data(group: Group, here: set[str]) -> Data:
    """Data of equations of one form with the same verdict; `here` are the cases of the report."""
    one = group.first
    return {
        "name": group.name, "form": one.form.value, "what": prose(group.what),
        "verdict": one.verdict.value, "is_of_model": _is_of_model(one),
        "error": at_paper(one), "sides": sides(one), "words": prose(short_words(one)),
        "instead": prose(one.instead or _corrected(one)),
        "cases": [case for case in one.cases if case in here],
    }  # fmt: skip


def _is_of_model(one: FormulaVerdict) -> bool:
    """Whether the reference shares the idealisation of the formula."""
    return one.error is not None and not one.is_of_part and one.verdict is not Verdict.EXACT


def _corrected(one: FormulaVerdict) -> str:
    is_misprint = one.verdict is Verdict.WRONG and one.name.startswith("Eq.")
    return "the corrected form" if is_misprint else ""
