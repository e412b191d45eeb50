"""The whole report as data for the PDF template, in the order of the page."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict

from jinja2 import Template
from markupsafe import Markup

from reports.crosscheck import counts_in_words, crosscheck_data, left_out_data, of_cases
from reports.environment import causes
from reports.frames import Frame
from reports.html import WORDS, anchors, drawn_by, title, warnings
from reports.in_short import cases_in_short, named, where
from reports.overview import overview
from reports.pdf_budget import budget_data
from reports.pdf_case import case_data, value_cells
from reports.pdf_caught import caught_data
from reports.pdf_ledgers import ledgers
from reports.pdf_tables import Data, prose
from reports.pdf_validity import validity_data
from reports.pdf_verdicts import verdict_data
from reports.readings import readings_data
from reports.second import seconds
from reports.sheets import Sheets
from reports.since import since_data
from reports.standalone import HERE, standalone
from verify.core.results import Report, Row, Status


def document(report: Report, frames: Mapping[str, Sequence[Frame]]) -> Data:
    """All data that templates/report.typ prints.

    Reports on user cases or inputs have no ledgers.
    """
    places, sheets = anchors(report.rows), Sheets(report)
    own, checks = bool(report.name), of_cases(report)
    beside = seconds(checks)
    short = named(report.papers)
    return head(report, frames, places) | {
        "is_record": False,
        "warnings": [prose(text) for text in warnings(report.cases)],
        "findings": [prose(text) for case in report.cases for text in case.findings],
        "values": [value_cells(v) for case in report.cases if own for v in case.values],
        "in_short": [asdict(line) for line in cases_in_short(report)] if report.rows else [],
        "verdicts": verdict_data(report),
        "overview": standalone(overview(report.cases)),
        "key": standalone(_key(report)),
        "cases": [
            case_data(
                case, frames.get(case.id, ()), places, sheets.of_case[i], where(case, short), beside
            )
            for i, case in enumerate(report.cases)
        ],
        "since": since_data(report.drift),
        "readings": readings_data(report.searches) if report.searches else None,
        "validity": validity_data(report.validity),
        "budgets": budget_data(report.budgets, {case.id for case in report.cases}),
        "crosschecks": crosscheck_data(checks),
        "crosschecks_left": left_out_data(checks),
        "crosschecks_told": counts_in_words(checks),
        "caught": caught_data(report.caught),
        "ledgers": ledgers(report, places) if report.has_ledgers else None,
    }


def head(report: Report, frames: Mapping[str, Sequence[Frame]], places: Mapping[str, str]) -> Data:
    """First and last part of every PDF: title, counts, failed rows, provenance."""
    return {
        "title": title(report),
        "kicker": "Check of user inputs" if report.name else "Verification report",
        "provenance": report.provenance,
        "drawn_by": drawn_by(frames),
        "rows": len(report.rows),
        "counts": _counts(report.rows),
        "relaxed": sum(row.demand is not None and row.demand > 0.01 for row in report.rows),
        "banners": [
            _banner(report, status, places)
            for status in (Status.FAIL, Status.SKIP)
            if report.count(status)
        ],
    }


def _key(report: Report) -> Markup:
    """SVG that explains the graphic of a row; without the marks of papers for user inputs."""
    drawn = Template((HERE / "key.svg").read_text("utf-8"), autoescape=True)
    return Markup(drawn.render(report=report))  # noqa: S704 - file of the project


def _counts(rows: Sequence[Row]) -> list[Data]:
    count = Counter(row.status for row in rows)
    return [{"status": s.value, "count": count[s], "words": WORDS[s]} for s in Status]


def _banner(report: Report, status: Status, places: Mapping[str, str]) -> Data:
    rows = [row for row in report.rows if row.status is status]
    word = "failed" if status is Status.FAIL else "not run"
    return {
        "status": status.value,
        "head": f"{len(rows)} row{'s' * (len(rows) > 1)} {word}",
        "rows": [
            {"label": places[cause.rows[0].id], "case": cause.rows[0].case,
             "quantity": prose(cause.rows[0].quantity), "more": len(cause.rows) - 1,
             "reason": prose(cause.reason)}
            for cause in causes(rows, status)
        ],
    }  # fmt: skip
