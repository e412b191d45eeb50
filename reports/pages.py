"""The report as pages: a first page, one for each case, and those of rows, papers and records."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup

from reports import explorer
from reports.equations import Equations
from reports.first_page import paper_parts, tasks
from reports.frames import Frame
from reports.html import HERE, context, environment, script_of, script_source
from reports.row_lines import Line
from reports.slim import slim
from verify.core.results import CaseBudget, CaseResult, Kind, Report, Row, Status, Validity
from verify.core.verdicts import FormulaVerdict

FIRST = "report.html"
LEAST = 3  # rows of a main table; with fewer all rows stand in it
FOLDER = "report"  # of all other pages, beside the first one
SECTIONS = {
    "explorer": "Validity explorer",
    "rows": "All rows", "papers": "Papers' tables", "errata": "Errata",
    "solvers": "Second solvers", "faults": "Fault detection", "since": "Since the last release",
    "provenance": "Provenance",
}  # fmt: skip
# a place on the page of a section, to which the menu leads
PLACES = {
    "explorer": "explorer",
    "rows": "summary", "papers": "tables", "errata": "errata", "solvers": "crosscheck",
    "faults": "caught", "since": "since", "provenance": "provenance",
}  # fmt: skip
_RECORDS = frozenset(f"{FOLDER}/{name}.html" for name in SECTIONS)
SCRIPTS = {  # of sections
    "rows": ("search.js",),
    "explorer": ("interpolation.js", "explorer_charts.js", "explorer.js"),
}
_LINK = re.compile(r'href="#([^"]+)"')
_ID = re.compile(r'\bid="([^"]+)"')


@dataclass(frozen=True)
class OfCase:
    """What the page of a case shows."""

    case: CaseResult
    lines: Sequence[Line]
    main: Sequence[Line]
    rest: Sequence[Line]  # balances, identities and statements that hold
    verdicts: Sequence[FormulaVerdict]
    validity: Validity | None
    budget: CaseBudget | None


def is_paged(report: Report) -> bool:
    """Whether a run has several pages: of more than one case, on their own inputs."""
    return not report.name and len(report.cases) > 1


def pages(report: Report, frames: Mapping[str, Sequence[Frame]]) -> dict[str, str]:
    """HTML of each page by its path; links between them work in a folder without a server."""
    equations = Equations()
    env = environment(equations)
    shared = context(report, frames)
    env.globals["explored"] = explorer.places(report, shared["anchors"])
    made = {
        name: env.get_template(template).render(**shared, **own)
        for name, template, own in _templates(report, shared, frames)
    }
    bodies = equations.placed(list(made.values()))
    return linked({name: slim(body) for name, body in zip(made, bodies, strict=True)})


def _templates(
    report: Report, shared: Mapping[str, Any], frames: Mapping[str, Sequence[Frame]]
) -> Iterator[tuple[str, str, dict[str, Any]]]:
    """Path, template and own values of each page."""
    sections = [name for name in SECTIONS if _has(report, shared, name)]
    menu = [("first", "Papers"), ("design", "Designer's index"), ("cases", "Cases"),
            *((PLACES[name], SECTIONS[name]) for name in sections)]  # fmt: skip
    still: dict[str, Any] = {"menu": menu} | _scripted("")
    own = {"heading": shared["title"], "parts": paper_parts(report), "tasks": tasks(report)}
    yield FIRST, "first.html.j2", still | own
    for name in sections:
        script = "\n".join((HERE / file).read_text("utf-8") for file in SCRIPTS.get(name, ()))
        more = _explored(report, shared) if name == "explorer" else {}
        yield (
            f"{FOLDER}/{name}.html", "section.html.j2",
            still | {"heading": SECTIONS[name], "name": name} | more | _scripted(script),
        )  # fmt: skip
    for case, lines in shared["groups"]:
        yield (
            f"{FOLDER}/{case.id}.html", "paged_case.html.j2",
            still | {"heading": case.title, "mine": _of_case(report, case, lines)}
            | _scripted(script_of([case], frames)),
        )  # fmt: skip


def _explored(report: Report, shared: Mapping[str, Any]) -> dict[str, Any]:
    """Tables and data of the validity explorer, and the cases that it leaves out."""
    return {
        "studied": explorer.of_cases(report),
        "points": explorer.data(report, shared["anchors"]),
        "unstudied": [v for v in report.validity if v.missing and not v.cards and not v.exact],
    }


def _scripted(script: str) -> dict[str, Any]:
    """A script of the project and what lets it run."""
    return {
        "script": Markup(script),  # noqa: S704 - the project's own files
        "script_source": script_source(script),
    }


def _has(report: Report, shared: Mapping[str, Any], name: str) -> bool:
    """Whether a run has something for a section."""
    return bool({
        "explorer": report.studies,
        "rows": report.rows, "papers": report.has_ledgers, "errata": report.has_ledgers,
        "solvers": shared["crosschecks"], "faults": report.caught, "since": report.drift,
        "provenance": True,
    }[name])  # fmt: skip


def _of_case(report: Report, case: CaseResult, lines: Sequence[Line]) -> OfCase:
    main = [line for line in lines if not _is_settled(line.row)]
    if len(main) < LEAST:
        main = list(lines)
    return OfCase(
        case, lines, main=main, rest=[line for line in lines if line not in main],
        verdicts=[v for v in report.verdicts if case.id in v.cases],
        validity=next((v for v in report.validity if v.case == case.id), None),
        budget=next((b for b in report.budgets if b.case == case.id), None),
    )  # fmt: skip


def _is_settled(row: Row) -> bool:
    """A balance, an identity or a statement that holds."""
    return row.status is Status.PASS and row.kind in (Kind.EXACT, Kind.IDENTITY, Kind.FACT)


def linked(made: Mapping[str, str]) -> dict[str, str]:
    """Pages whose links to places on others name the page, as it is reached from here."""
    home = {"first": FIRST}
    # a row stands on the page of its case and among all rows: links lead to its case
    for name in sorted(made, key=lambda name: (name != FIRST, name in _RECORDS)):
        for place in _ID.findall(made[name]):
            home.setdefault(place, name)
    return {name: _linked(name, page, home) for name, page in made.items()}


def _linked(name: str, page: str, home: Mapping[str, str]) -> str:
    here = set(_ID.findall(page))

    def link(found: re.Match[str]) -> str:
        place = found[1]
        if place in here or place not in home:
            return found[0]
        target = home[place]
        path = _path(name, target)
        return f'href="{path}"' if place == "first" else f'href="{path}#{place}"'

    return _LINK.sub(link, page)


def _path(here: str, there: str) -> str:
    """The relative path from one page to another, both in the folder of the report."""
    if here == FIRST:
        return there
    return there.removeprefix(f"{FOLDER}/") if there.startswith(f"{FOLDER}/") else f"../{there}"
