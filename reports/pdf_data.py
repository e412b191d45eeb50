"""The whole report as the PDF's template takes it, in the order of the page."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from jinja2 import Template
from markupsafe import Markup

from reports.crosscheck import crosscheck_data, left_out_data, of_cases, told
from reports.frames import Frame
from reports.html import WORDS, anchors, causes, cited, drawn_by, partly, title, warnings
from reports.in_short import cases_in_short, named, where
from reports.overview import overview
from reports.paper_rows import printed_row
from reports.pdf_budget import budget_data
from reports.pdf_case import case_data, maths, value_cells
from reports.pdf_caught import caught_data
from reports.pdf_tables import Data, prose
from reports.pdf_validity import validity_data
from reports.pdf_verdicts import verdict_data
from reports.readings import readings_data
from reports.richtext import runs
from reports.second import seconds
from reports.sheets import Sheets
from reports.since import since_data
from reports.standalone import HERE, standalone
from verify.core.results import PaperCell, PaperTable, Report, Row, Status


def document(report: Report, frames: Mapping[str, Sequence[Frame]]) -> Data:
    """All that templates/report.typ prints; one's own cases or parameters have no ledgers."""
    places, sheets = anchors(report.rows), Sheets(report)
    own, checks = bool(report.name), of_cases(report)
    beside = seconds(checks)
    short = named(report.papers)
    return {
        "title": title(report),
        "kicker": "Check of one’s own parameters" if own else "Verification report",
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
        "crosschecks_told": told(checks),
        "caught": caught_data(report.caught),
        "ledgers": _ledgers(report, places) if report.has_ledgers else None,
    }


def _key(report: Report) -> Markup:
    """How to read a row, without the papers' marks in a report on one's own parameters."""
    drawn = Template((HERE / "key.svg").read_text("utf-8"), autoescape=True)
    return Markup(drawn.render(report=report))  # noqa: S704 - the project's own file


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


def _ledgers(report: Report, places: Mapping[str, str]) -> Data:
    named = {p["key"]: cited(p) for p in report.papers}
    erratum = {(e["paper"], e["id"]): f"erratum-{i}" for i, e in enumerate(report.errata)}
    return {
        "tables": [_paper_table(t, named[t.paper], places, erratum) for t in report.tables],
        "partly": partly(report),
        "errata": len(report.errata),
        "tested": sum(bool(e["test"]) for e in report.errata),
        "papers": [
            {
                "cited": named[p["key"]],
                "title": p["title"],
                "counts": {k: p[k] for k in ("equations", "values", "claimed", *STATES)},
                "errata": [_erratum(e, erratum) for e in _of(report.errata, p)],
                "equations": [_equation(e) for e in _of(report.equations, p)],
                "numbers": [_number(v) for v in _of(report.published, p) if v["claimed"]],
            }
            for p in report.papers
        ],
        "states": [[k, words, sum(p[k] for p in report.papers)] for k, words in STATES.items()],
    }


STATES = {
    "implemented": "implemented, with a check that fails when it is broken",
    "argued": "left out, with the reason",
    "missing": "not yet",
}


def _of(entries: Sequence[Mapping[str, Any]], paper: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    return [entry for entry in entries if entry["paper"] == paper["key"]]


def _paper_table(
    table: PaperTable,
    paper: str,
    places: Mapping[str, str],
    erratum: Mapping[tuple[str, str], str],
) -> Data:
    def linked(names: Sequence[str]) -> list[Data]:
        known = ((name, erratum.get((table.paper, name))) for name in names)
        return [{"id": name, "label": label} for name, label in known if label]

    def row(cells: Sequence[PaperCell]) -> Data:
        found = printed_row(cells)
        return {
            "printed": [prose(cell.text) for cell in cells],
            "claims": [
                {"label": places.get(c.row), "name": prose(c.name), "status": c.status.value,
                 "formulas": [runs(c.formula if k in c.columns else "") for k in range(len(cells))],
                 "fem": runs(c.fem)}
                for c in found.claims
            ],
            "inputs": [{"column": i.column, "words": prose(i.words)} for i in found.inputs],
            "errata": linked(found.errata),
        }  # fmt: skip

    return {
        "name": f"{paper}, {table.name}",
        "caption": prose(table.caption),
        "header": [prose(x) for x in table.header],
        "rows": [row(cells) for cells in table.rows],
        "note": prose(table.note),
        "errata": linked(table.errata),
    }


def _erratum(e: Mapping[str, Any], erratum: Mapping[tuple[str, str], str]) -> Data:
    return {
        "label": erratum[e["paper"], e["id"]],
        "id": e["id"],
        "place": e["place"],
        "printed": maths(e["printed_tex"]) or prose(e["printed"]),
        "right": maths(e["right_tex"]) or prose(e["right"]),
        "evidence": prose(e["evidence"]),
        "test": e["test"],
    }


def _equation(e: Mapping[str, Any]) -> Data:
    return {
        "number": e["number"],
        "what": prose(e["what"]),
        "tex": maths(e["tex"]),
        "status": e["status"],
        "code": e["code"],
        "test": e["test"],
        "note": prose(e["note"]),
    }


def _number(v: Mapping[str, Any]) -> list[list[Any]]:
    unit = v["unit"] if v["unit"] != "1" else ""
    return [
        prose(v["what"]), prose(v["printed"]), prose(unit), runs(v["place"]),
        prose("; ".join(v["claimed"])),
    ]  # fmt: skip
