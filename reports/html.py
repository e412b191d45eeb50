"""The report as one self-contained page: no network; its scripts only move views in space."""

import base64
import hashlib
import re
import weakref
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import jinja2
from markupsafe import Markup

from reports import (
    budget,
    caught,
    crosscheck,
    explorer_tables,
    formats,
    plots,
    readings,
    second,
    signature,
    since,
    validity,
)
from reports.advice import CORRECTED
from reports.bars import bars
from reports.campbell import campbell
from reports.compiled import COMPILED
from reports.curves import curves
from reports.density import density
from reports.drawable import drawable, nothing
from reports.equations import Equations
from reports.erratum_names import erratum_name
from reports.error_map import error_map
from reports.first_page import groups
from reports.frames import Frame
from reports.in_short import cases_in_short, named, where
from reports.overview import overview
from reports.paper_rows import printed_table, used_as_inputs
from reports.parallel import parallel
from reports.refinement import refinement
from reports.row_lines import COMPANION, failed_first, groups_failed_first, lines
from reports.shapes import shapes
from reports.sketch import sketch
from reports.slim import slim
from reports.validity_map import scale_key
from reports.verdicts import (
    MEANING,
    at_paper,
    by_paper,
    errata_in_verdicts,
    given,
    may_be_used,
    not_to_be_used,
    short_words,
    sides,
    slug,
)
from reports.whirl import whirl
from reports.zones import zones
from verify.core.figures import (
    LIMITS_TITLE,
    Bars,
    Campbell,
    Curves,
    Density,
    Dots,
    Figure,
    Map,
    Parallel,
    Profile,
    Refinement,
    Shapes,
    Table,
    Whirl,
    Zones,
)
from verify.core.results import CaseResult, Report, Row, Status

HERE = Path(__file__).parent / "templates"
STYLES = ("palette.css", "report.css", "figures.css")
NAMED_IN_MENU = 3  # cases, at most, that the menu names one by one
LONG_LIST = 18  # inputs; longer lists have two columns
WORDS = {
    Status.FAIL: "outside the tolerance, insufficient sensitivity or not converged",
    Status.SKIP: "not run",
    Status.NOTE: "a printed value proved wrong, with its erratum, or adopted unchanged; not judged",
    Status.CALIBRATED: "agrees with fitted inputs: no evidence",
    Status.SHOWN: "measured, not judged: no stated uncertainty or no expected error",
    Status.PASS: "within a derived tolerance",
}


def page(report: Report, frames: Mapping[str, Sequence[Frame]]) -> str:
    """HTML of the whole run as one page; `frames` are the pictures of each case."""
    equations = Equations()
    script = script_of(report.cases, frames)
    body = environment(equations).get_template("report.html.j2").render(
        **context(report, frames), script=Markup(script),  # noqa: S704 - files of the project
        script_source=script_source(script),
    )  # fmt: skip
    return slim(equations.placed([body])[0])


def context(report: Report, frames: Mapping[str, Sequence[Frame]]) -> dict[str, Any]:
    """Values that the templates of all pages use."""
    groups = [(case, lines(case.rows)) for case in report.cases]
    checks = crosscheck.of_cases(report)
    placed = anchors(report.rows)
    return {
        "report": report, "crosschecks": checks, "seconds": second.seconds(checks),
        "rows": report.rows, "groups": groups, "listed": groups_failed_first(groups),
        "statuses": tuple(Status), "words": WORDS, "title": title(report),
        "partly": partly(report), "counts": _counts(report.rows), "anchors": placed,
        "beside": sum(row.quantity.endswith(COMPANION) for row in report.rows),
        "subjects": validity.subjects(report.validity), "budgets": report.budgets,
        "caught": report.caught,
        "scale_key": scale_key if validity.mapped(report.validity) else None,
        "paired": sum(line.convergence is not None for _, group in groups for line in group),
        "relaxed": sum(row.demand is not None and row.demand > 0.01 for row in report.rows),
        "warnings": warnings(report.cases), "in_short": cases_in_short(report),
        "verdicts_by_paper": by_paper(report), "verdicts_given": given(report),
        "meaning": MEANING, "overview": overview(report.cases),
        "drawn": {c.id: [f for f in frames.get(c.id, ()) if f.svg] for c in report.cases},
        "viewers": {c.id: [f for f in frames.get(c.id, ()) if f.view] for c in report.cases},
        "drawn_by": drawn_by(frames), "names": {p["key"]: cited(p) for p in report.papers},
        "short": named(report.papers), "published": _by_paper(report),
        "css": Markup(styles()),  # noqa: S704 - files of the project
    }  # fmt: skip


@dataclass(frozen=True)
class Cause:
    """Rows of one case that failed, or were not run, for one reason."""

    reason: str
    rows: Sequence[Row]


def causes(rows: Sequence[Row], status: Status) -> list[Cause]:
    """Failures, listed once for each cause."""
    found: dict[tuple[str, str], list[Row]] = {}
    for row in rows:
        if row.status is status:
            found.setdefault((row.case, row.reason), []).append(row)
    return [Cause(reason, group) for (_, reason), group in found.items()]


def columns(table: Table) -> list[list[tuple[str, bool]]]:
    """Cells as text and whether they are numbers, each column with one number of decimals."""
    shown = []
    for column in zip(*table.rows, strict=True):
        numbers = [formats.number(x) for x in column if isinstance(x, float)]
        decimals = max((len(x.partition(".")[2]) for x in numbers if "e" not in x), default=0)
        shown.append([
            (f"{x:.{decimals}f}".replace("-", formats.MINUS), True)
            if isinstance(x, float) and "e" not in formats.number(x)
            else (formats.number(x), isinstance(x, int | float))
            for x in column
        ])  # fmt: skip
    return [list(row) for row in zip(*shown, strict=True)]


def warnings(cases: Sequence[CaseResult]) -> Mapping[str, list[str]]:
    """Each warning once, with the cases that give it."""
    found: dict[str, list[str]] = {}
    for case in cases:
        for text in case.warnings:
            found.setdefault(text, []).append(case.id)
    return found


def partly(report: Report) -> str:
    """Statement which results of the papers a partial run omits; empty for a complete run."""
    without = report.provenance.get("left_out", 0)
    if without <= 0:
        return ""
    count = f"{len(report.cases)} of {len(report.cases) + without} cases"
    return f"This run holds {count}: numbers claimed by other cases count as unclaimed here."


def title(report: Report) -> str:
    """Title of the report."""
    if report.name or not report.cases or report.has_ledgers:
        return report.name or "Freewheel clutches: formulas against finite elements"
    return "; ".join(dict.fromkeys(case.title for case in report.cases))


def styles() -> str:
    """All style sheets of the page, without blanks that no browser needs."""
    text = "\n".join((HERE / name).read_text("utf-8") for name in STYLES)
    bare = re.sub(r"\s+", " ", re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL))
    blank = re.compile(r'("[^"]*")| ?([{};]) ?|([:,]) ')  # those in texts remain
    return blank.sub(lambda found: found[1] or found[2] or found[3], bare)


def anchors(rows: Sequence[Row]) -> Mapping[str, str]:
    """The anchor of each row by its id: case and number, the same in every run of the case."""
    count: dict[str, int] = {}
    cases = {case: i for i, case in enumerate(dict.fromkeys(row.case for row in rows))}
    found: dict[str, str] = {}
    for row in rows:
        count[row.case] = count.get(row.case, -1) + 1
        found[row.id] = f"row-{cases[row.case]}-{count[row.case]}"
    return found


_plots: dict[int, Markup] = {}  # of the figures that are in use, by their identity


def plot(figure: Figure) -> Markup:
    """The drawing of a figure, or a note where it has no points; made once for page and PDF."""
    key = id(figure)
    if key not in _plots:
        _plots[key] = _plot(figure)
        weakref.finalize(figure, _plots.pop, key).atexit = False
    return _plots[key]


def _plot(figure: Figure) -> Markup:
    if not drawable(figure):
        return nothing(figure.title)
    match figure:
        case Profile():
            return plots.profile(figure)
        case Refinement():
            return refinement(figure)
        case Dots():
            return plots.dots(figure)
        case Curves():
            return curves(figure)
        case Map():
            return error_map(figure)
        case Shapes():
            return shapes(figure)
        case Zones():
            return zones(figure)
        case Density():
            return density(figure)
        case Bars():
            return bars(figure)
        case Whirl():
            return whirl(figure)
        case Campbell():
            return campbell(figure)
        case Parallel():
            return parallel(figure)


def environment(equations: Equations) -> jinja2.Environment:
    """The templates of the pages, whose formulas `equations` places."""
    env = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HERE), autoescape=True, trim_blocks=True,
        lstrip_blocks=True, undefined=jinja2.StrictUndefined, bytecode_cache=COMPILED,
        optimized=False,  # constants are not filtered by the equations of another page
    )  # fmt: skip
    env.filters |= {
        "symbol": formats.symbol, "prose": formats.prose, "power": formats.power,
        "maths": equations.maths, "number": formats.number, "written": formats.written,
        "values": formats.values, "difference": formats.difference, "tolerance": formats.tolerance,
        "relative": formats.relative, "fraction": formats.fraction, "percents": formats.percents,
        "order": formats.order, "signature": signature.signature,
        "convergence": plots.convergence, "on_meshes": plots.on_meshes,
        "sketch": sketch, "plot": plot, "printed_table": printed_table,
        "used_as_inputs": used_as_inputs,
        "causes": causes, "failed_first": failed_first,
        "columns": columns,
        "validity_figure": validity.figure, "validity_limits": validity.limits,
        "share": caught.share, "moved": caught.moved, "green": caught.green,
        "only_listed": caught.only_listed, "survivors": caught.survivors,
        "in_words": caught.in_words, "interval": caught.interval, "stale": caught.stale,
        "signed": validity.signed, "validity_over": validity.common,
        "reading_found": readings.found, "chance": readings.chance,
        "drift_summary": since.summary, "drift_shown": since.shown, "drift_more": since.left_out,
        "drift_tighter": since.tighter, "drift_tighter_more": since.tighter_left_out,
        "waterfall": budget.waterfall, "percent": budget.percent,
        "budget_headline": budget.headline, "budget_lines": budget.lines,
        "budget_compact": budget.compact, "budget_identities": budget.identities,
        "budget_outside": budget.outside, "budget_left": budget.left,
        "cross_problems": crosscheck.problems, "cross_solvers": crosscheck.solvers,
        "cross_told": crosscheck.told,
        "cross_left": crosscheck.left_out, "second_value": second.value,
        "second_apart": second.apart, "second_meshes": second.meshes, "linked": formats.linked,
        "printed": printed, "counts": lambda case: present(case.rows), "anchor": _anchor,
        "reproduce": reproduce, "where": where, "at_paper": at_paper, "sides": sides,
        "short_words": short_words, "slug": slug, "not_to_be_used": not_to_be_used,
        "may_be_used": may_be_used,
        "grouped": groups, "erratum_name": erratum_name, "errata_in_verdicts": errata_in_verdicts,
        "study_head": explorer_tables.head, "study_lines": explorer_tables.lines,
    }  # fmt: skip
    env.globals |= {
        "LONG_LIST": LONG_LIST,
        "limits_title": LIMITS_TITLE,
        "NAMED_IN_MENU": NAMED_IN_MENU,
        "CORRECTED": CORRECTED,
        "CHANGED": caught.NAMES,
        "explored": {},  # places on the page of the explorer, which a run of one page has not
    }
    return env


def printed(row: Row, kind: str) -> Markup:
    """Printed entries of one `kind` of the papers."""
    return formats.prose(", ".join(p.printed for p in row.published if p.kind == kind))


def _anchor(case: CaseResult) -> str:
    return f"case-{case.id}"


def reproduce(case: CaseResult) -> str:
    if case.name:
        return case.command
    init = case.command.replace("freewheel verify", "freewheel init", 1)
    return (
        f"{case.command}\n{init} > my.toml    # then edit it for your part\n"
        "freewheel check --fem my.toml"
    )


def _counts(rows: Sequence[Row]) -> Mapping[str, int]:
    count = Counter(row.status.value for row in rows)
    return {status.value: count[status.value] for status in Status}


def present(rows: Sequence[Row]) -> list[tuple[Status, int]]:
    count = Counter(row.status for row in rows)
    return [(status, count[status]) for status in Status if count[status]]


def cited(paper: Mapping[str, Any]) -> str:
    return f"{paper['authors']} {paper['year'] or ''}".strip()


def _by_paper(report: Report) -> Mapping[str, list[Mapping[str, Any]]]:
    found: dict[str, list[Mapping[str, Any]]] = {p["key"]: [] for p in report.papers}
    for value in report.published:
        found[value["paper"]].append(value)
    return found


def script_of(cases: Sequence[CaseResult], frames: Mapping[str, Sequence[Frame]]) -> str:
    """Script that moves the views and the mode shapes of these cases; empty if not needed."""
    views = any(frame.view for case in cases for frame in frames.get(case.id, ()))
    modes = any(isinstance(f, Whirl) and drawable(f) for case in cases for f in case.figures)
    names = ["viewer.js"] * views + ["whirl.js"] * modes
    return "\n".join((HERE / name).read_text("utf-8") for name in names)


def drawn_by(frames: Mapping[str, Sequence[Frame]]) -> str:
    by = dict.fromkeys(frame.by for group in frames.values() for frame in group if frame.by)
    return f"Pictures: {'; '.join(by)}." if by else ""


def script_source(script: str) -> str:
    """Source that the content security policy permits: this script or none."""
    if not script:
        return "'none'"
    return f"'sha256-{base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()}'"
