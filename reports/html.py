"""The report as one self-contained page without network access.

Its scripts only rotate views and animate modes.
"""

import base64
import hashlib
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from markupsafe import Markup

from reports import crosscheck, second, validity
from reports.drawable import drawable
from reports.environment import HERE, environment
from reports.equations import Equations
from reports.frames import Frame
from reports.in_short import cases_in_short, named
from reports.overview import overview
from reports.row_lines import COMPANION, groups_failed_first, lines
from reports.slim import slim
from reports.validity_map import scale_key
from reports.verdicts import MEANING, by_paper, given
from verify.core.figures import Whirl
from verify.core.results import CaseResult, Report, Row, Status

STYLES = ("palette.css", "report.css", "figures.css")
WORDS = {
    Status.FAIL: "the check is not met, its sensitivity is insufficient, or the reference has not "
    "converged",
    Status.SKIP: "not run",
    Status.NOTE: "a printed value that is proved wrong (the erratum is stated), or that is used as "
    "printed; not judged",
    Status.CALIBRATED: "agrees, but only with fitted inputs: the agreement is no evidence",
    Status.SHOWN: "measured but not judged: the uncertainty or the expected error is unknown",
    Status.PASS: "the difference is within a derived tolerance",
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


def warnings(cases: Sequence[CaseResult]) -> Mapping[str, list[str]]:
    """Warnings, each listed once, with the cases that give it."""
    found: dict[str, list[str]] = {}
    for case in cases:
        for text in case.warnings:
            found.setdefault(text, []).append(case.id)
    return found


def partly(report: Report) -> str:
    """Statement about results of papers that a partial run omits; empty for a complete run."""
    without = report.provenance.get("left_out", 0)
    if without <= 0:
        return ""
    count = f"{len(report.cases)} of {len(report.cases) + without} cases"
    return (
        f"This run contains {count}: numbers that only other cases compare are listed as not "
        "compared."
    )


def title(report: Report) -> str:
    """Title of the report."""
    if report.name or not report.cases or report.has_ledgers:
        return report.name or "Freewheel clutches: formulas against finite elements"
    return "; ".join(dict.fromkeys(case.title for case in report.cases))


def styles() -> str:
    """All style sheets of the page, without unnecessary blanks."""
    text = "\n".join((HERE / name).read_text("utf-8") for name in STYLES)
    bare = re.sub(r"\s+", " ", re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL))
    blank = re.compile(r'("[^"]*")| ?([{};]) ?|([:,]) ')  # blanks in texts remain
    return blank.sub(lambda found: found[1] or found[2] or found[3], bare)


def anchors(rows: Sequence[Row]) -> Mapping[str, str]:
    """Anchor of each row by its id: number of its case in the run, and its number in the case."""
    count: dict[str, int] = {}
    cases = {case: i for i, case in enumerate(dict.fromkeys(row.case for row in rows))}
    found: dict[str, str] = {}
    for row in rows:
        count[row.case] = count.get(row.case, -1) + 1
        found[row.id] = f"row-{cases[row.case]}-{count[row.case]}"
    return found


def _counts(rows: Sequence[Row]) -> Mapping[str, int]:
    count = Counter(row.status.value for row in rows)
    return {status.value: count[status.value] for status in Status}


def cited(paper: Mapping[str, Any]) -> str:
    return f"{paper['authors']} {paper['year'] or ''}".strip()


def _by_paper(report: Report) -> Mapping[str, list[Mapping[str, Any]]]:
    found: dict[str, list[Mapping[str, Any]]] = {p["key"]: [] for p in report.papers}
    for value in report.published:
        found[value["paper"]].append(value)
    return found


def script_of(cases: Sequence[CaseResult], frames: Mapping[str, Sequence[Frame]]) -> str:
    """Script for the rotatable views and the mode shapes of these cases; empty if not needed."""
    views = any(frame.view for case in cases for frame in frames.get(case.id, ()))
    modes = any(isinstance(f, Whirl) and drawable(f) for case in cases for f in case.figures)
    names = ["viewer.js"] * views + ["whirl.js"] * modes
    return "\n".join((HERE / name).read_text("utf-8") for name in names)


def drawn_by(frames: Mapping[str, Sequence[Frame]]) -> str:
    by = dict.fromkeys(frame.by for group in frames.values() for frame in group if frame.by)
    return f"Pictures: {'; '.join(by)}." if by else ""


def script_source(script: str) -> str:
    """Source that the content security policy permits: this script, or none."""
    if not script:
        return "'none'"
    return f"'sha256-{base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()}'"
