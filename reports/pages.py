"""The report as several pages: a first page, one per case, and pages for rows and records."""

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup

from reports import explorer
from reports.advice import advised, of_case
from reports.environment import HERE, environment
from reports.equations import Equations
from reports.first_page import paper_parts, tasks
from reports.frames import Frame
from reports.html import context, script_of, script_source
from reports.links import FIRST, PLACES, Places, linked, path_of
from reports.origins import page_of, section
from reports.row_lines import Line
from reports.slim import cells, slim
from reports.used_rules import used_rules
from verify.core.results import CaseBudget, CaseResult, Kind, Report, Row, Status, Validity
from verify.core.verdicts import FormulaVerdict

LEAST = 3  # rows of a main table; with fewer all rows are in it
SECTIONS = {
    "explorer": "Validity explorer",
    "rows": "All rows", "papers": "Papers' tables", "errata": "Errata",
    "solvers": "Second solvers", "faults": "Fault detection", "since": "Since the last release",
    "provenance": "Provenance",
}  # fmt: skip
SCRIPTS = {  # of sections
    "rows": ("search.js",),
    "explorer": ("interpolation.js", "explorer_charts.js", "explorer.js"),
}
Frames = Mapping[str, Sequence[Frame]]


@dataclass(frozen=True)
class OfCase:
    """Content of the page of a case."""

    case: CaseResult
    lines: Sequence[Line]
    main: Sequence[Line]
    rest: Sequence[Line]  # balances, identities and statements that hold
    verdicts: Sequence[FormulaVerdict]
    validity: Validity | None
    budget: CaseBudget | None
    before: str  # and after it: neighbours in the list of cases
    after: str


def is_paged(report: Report) -> bool:
    """Whether a run has several pages: more than one case, with the default inputs."""
    return not report.name and len(report.cases) > 1


def pages(report: Report, frames: Frames, unchanged: Container[str] = ()) -> dict[str, str]:
    """HTML of each page by its path; links between pages work in a folder without a server.

    The result has no pages of parts in `unchanged` (see `reports.origins`). `frames` are the
    pictures of the cases that have any.
    """
    equations = Equations()
    env = environment(equations)
    shared = context(report, frames)
    env.globals["explored"] = explorer.places(report, shared["anchors"])
    made = {
        name: env.get_template(template).render(**shared, **own)
        for name, template, own in _templates(report, shared, frames, unchanged)
    }
    places = Places(report)
    bodies = equations.placed(list(made.values()))
    return {
        name: used_rules(cells(slim(linked(name, body, places))))
        for name, body in zip(made, bodies, strict=True)
    }


def _templates(
    report: Report, shared: Mapping[str, Any], frames: Frames, unchanged: Container[str]
) -> Iterator[tuple[str, str, dict[str, Any]]]:
    """Path, template and values of each page that must be made."""
    sections = [name for name in SECTIONS if _has(report, shared, name)]
    menu = [("first", "Papers"), ("design", "Designer's index"), ("cases", "Cases"),
            *((PLACES[name], SECTIONS[name]) for name in sections)]  # fmt: skip
    still: dict[str, Any] = {"menu": menu} | _scripted("")
    own = {"heading": shared["title"], "parts": paper_parts(report), "tasks": tasks(report)}
    yield FIRST, "first.html.j2", still | own
    for name in sections:
        if section(name) not in unchanged:
            script = "\n".join((HERE / file).read_text("utf-8") for file in SCRIPTS.get(name, ()))
            more = _explored(report, shared) if name == "explorer" else {}
            yield (
                path_of(name), "section.html.j2",
                still | {"heading": SECTIONS[name], "name": name} | more | _scripted(script),
            )  # fmt: skip
    for case, lines in shared["groups"]:
        if page_of(case.id) not in unchanged:
            yield (
                path_of(case.id), "paged_case.html.j2",
                still | {"heading": case.title, "mine": _of_case(report, case, lines)}
                | _scripted(script_of([case], frames)),
            )  # fmt: skip


def _explored(report: Report, shared: Mapping[str, Any]) -> dict[str, Any]:
    """Tables and data of the validity explorer, and cases without measured errors."""
    return {
        "studied": explorer.of_cases(report),
        "points": explorer.data(report, shared["anchors"]),
        "unstudied": [v for v in report.validity if v.missing and not v.cards and not v.exact],
    }


def _scripted(script: str) -> dict[str, Any]:
    """A script of the project, and its permission in the security policy."""
    return {
        "script": Markup(script),  # noqa: S704 - files of the project
        "script_source": script_source(script),
    }


def _has(report: Report, shared: Mapping[str, Any], name: str) -> bool:
    """Whether a run has content for a section."""
    return bool({
        "explorer": report.studies,
        "rows": report.rows, "papers": report.has_ledgers, "errata": report.has_ledgers,
        "solvers": shared["crosschecks"], "since": report.drift, "provenance": True,
        "faults": report.caught and not report.caught.missing,
    }[name])  # fmt: skip


def _of_case(report: Report, case: CaseResult, lines: Sequence[Line]) -> OfCase:
    main = [line for line in lines if not _is_settled(line.row)]
    if len(main) < LEAST:
        main = list(lines)
    names = ["", *(one.id for one in report.cases), ""]
    at = names.index(case.id)
    return OfCase(
        case, lines, main=main, rest=[line for line in lines if line not in main],
        verdicts=of_case(advised(report.verdicts), case.id, case.rows),
        validity=next((v for v in report.validity if v.case == case.id), None),
        budget=next((b for b in report.budgets if b.case == case.id), None),
        before=names[at - 1], after=names[at + 1],
    )  # fmt: skip


def _is_settled(row: Row) -> bool:
    """Whether a row is a passed balance, identity or statement."""
    return row.status is Status.PASS and row.kind in (Kind.EXACT, Kind.IDENTITY, Kind.FACT)
