"""Verdicts of the formulas in the PDF: how many of each, then a table for each paper."""

from reports.pdf_tables import Data, prose
from reports.verdicts import MEANING, at_paper, by_paper, given, sides
from verify.core.results import Report
from verify.core.verdicts import FormulaVerdict


def verdict_data(report: Report) -> Data | None:
    """Counts and lines of each paper; None where a run has no verdicts."""
    if not report.verdicts:
        return None
    kinds, papers = given(report), by_paper(report)
    return {
        "kinds": [kind.value for kind in kinds],
        "meaning": [[kind.value, MEANING[kind]] for kind in kinds],
        "papers": [
            {
                "cited": paper.cited,
                "counts": [str(paper.counts[kind] or "") for kind in kinds],
                "lines": [_line(one) for one in paper.verdicts],
            }
            for paper in papers
        ],
    }


def _line(one: FormulaVerdict) -> Data:
    parts = [
        one.words, one.model, f"limited by {one.limited_by}" if one.limited_by else "",
        f"use instead {one.instead}" if one.instead else "",
    ]  # fmt: skip
    return {
        "name": one.name, "form": one.form.value, "what": prose(one.what),
        "verdict": one.verdict.value, "error": at_paper(one), "sides": sides(one),
        "words": prose("; ".join(filter(None, parts))),
    }  # fmt: skip
