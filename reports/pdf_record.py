"""The PDF for archiving: status, verdicts by paper, tables of the papers, one page per case."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict

from reports.first_page import PaperPart, groups, paper_parts
from reports.frames import Frame
from reports.html import partly
from reports.in_short import cases_in_short, named, where
from reports.links import FIRST, FOLDER
from reports.pdf_data import head
from reports.pdf_ledgers import erratum_data, paper_table
from reports.pdf_one_page import one_page
from reports.pdf_tables import Data, prose
from reports.pdf_verdicts import counts_data, group_data
from reports.verdicts import not_to_be_used
from verify.core.results import Report
from verify.core.verdicts import Form, FormulaVerdict, Verdict

PAGES = 70  # at most, of the suite's cases
BYTES = 5_000_000

Labels = Mapping[tuple[str, str], str]  # of errata, by paper and id


def record(
    report: Report, frames: Mapping[str, Sequence[Frame]], *, single_file: bool = False
) -> Data:
    """All data that templates/record.typ prints; with `single_file`, no case has an HTML page."""
    places = {row.id: f"case-{row.case}" for row in report.rows}
    parts, short = paper_parts(report), named(report.papers)
    changed = [(e["paper"], e["id"]) for part in parts for e in part.errata]
    errata = {key: f"erratum-{i}" for i, key in enumerate(changed)}
    return head(report, frames, places) | {
        "is_record": True,
        "relaxed": 0,  # demands and their reasons are not in it
        "drift": len(report.drift.unexplained) if report.drift else 0,
        "partly": partly(report),
        "counted": counts_data(report),
        "papers": [_paper(part, report, places, errata) for part in parts if _has(part)],
        "in_short": [
            asdict(line) | {"what": case.title}
            for line, case in zip(cases_in_short(report), report.cases, strict=True)
        ],
        "cases": [
            one_page(
                case, report, frames.get(case.id, ()), where(case, short),
                FIRST if single_file else f"{FOLDER}/{case.id}.html",
            )
            for case in report.cases
        ],
    }  # fmt: skip


def _has(part: PaperPart) -> bool:
    """Whether a partial run has a verdict or a compared number of a paper."""
    return bool(part.verdicts or part.tables)


def _named(one: FormulaVerdict) -> str:
    return f"{one.name}{' corrected' * (one.form is Form.CORRECTED)}"


def _paper(part: PaperPart, report: Report, places: Mapping[str, str], errata: Labels) -> Data:
    here = {case.id for case in report.cases}
    definitions = [v for v in part.verdicts if v.verdict is Verdict.DEFINITION]
    return {
        "label": f"paper-{part.key}",
        "cited": part.cited, "part": part.part, "title": prose(part.title),
        "claim": prose(part.claim), "place": prose(part.place),
        "cases": [case.id for case in part.cases],
        "unusable": [_named(v) for v in not_to_be_used(part.verdicts)],
        "lines": [group_data(group, here) for group in groups(part.verdicts)],
        "definitions": prose("; ".join(f"{_named(v)}, {v.what}" for v in definitions)),
        "tables": [
            _compared(paper_table(t, part.cited, places, errata, shortened=True))
            for t in part.tables
        ],
        "errata": [erratum_data(e, errata) for e in part.errata],
    }  # fmt: skip


def _compared(data: Data) -> Data:
    """Printed rows that rows of the suite compare."""
    rows = [row | {"inputs": []} for row in data["rows"] if row["claims"]]
    return data | {"rows": rows, "left_out": len(data["rows"]) - len(rows)}
