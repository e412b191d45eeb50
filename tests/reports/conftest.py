"""A judged run of one case of each subject for the report tests, with special texts; and of all."""

import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import reports
from reports.frames import frames
from reports.html import page
from reports.pages import pages
from reports.slim import unquoted
from verify.app.report import make_report
from verify.cases.registry import CASES, find
from verify.core.results import Kind, Partner, Published, Report, Row, Status
from verify.jobs.cache import default_folder
from verify.verdicts.record import kept

HOSTILE = "<script>alert(\"1\")</script> & 'x' \x07"
NAME = " ".join(["word"] * 18)  # 90 letters
SOME = (
    "ring-lame", "polyhedral-ring", "freewheel-torque", "sprag-wedge", "spring-accordion",
    "spring-map", "contact-roller-flat", "rotor-system",
)  # fmt: skip
LOST = ("spring-accordion", "Eqs. 1-9 against the curved beam", 7)  # a point taken away
PRINTED = Published(document="d", id="i", place="p", kind="theory", printed="1.97×10^-4",
                    value=1.97e-4, unit="kg m^2")  # fmt: skip


@pytest.fixture(scope="session")
def report(of_paper) -> Report:
    """A case of each subject and a map; tests of every case take `whole`."""
    cases = [find(name) for name in SOME]
    return make_report([of_paper(c) for c in cases], cases, 1.0)


@pytest.fixture(scope="session")
def whole(of_paper) -> Report:
    """Every case of the suite."""
    return make_report([of_paper(c) for c in CASES], CASES, 1.0)


@pytest.fixture(scope="session")
def hostile(report) -> Report:
    """The same report with markup in every text that a user may bring, and one row per status."""
    first, *others = report.cases
    rows = tuple(
        Row(case=first.id, quantity=f"{status} {HOSTILE}", symbol="<b>_x", unit="mm",
            kind=Kind.IDENTITY, status=status, reason=HOSTILE, analytic=1.0, fem=1.1,
            difference=0.1, scale=1.0, tolerance=0.05, detects=0.15, u_num=0.01)
        for status in Status
    )  # fmt: skip
    case = replace(
        first, rows=rows, title=HOSTILE, lead=HOSTILE, warnings=(HOSTILE,), readings=(HOSTILE,),
        inputs=(replace(first.inputs[0], what=HOSTILE, symbol=HOSTILE),),
    )  # fmt: skip
    return replace(report, cases=(case, *others))


@pytest.fixture(scope="session")
def recorded(report) -> Report:
    """The report with the verdicts of record."""
    return replace(report, verdicts=kept())


@pytest.fixture(scope="session")
def drawn(report) -> dict:
    """The pictures of its cases."""
    return frames(report.cases, default_folder())


@pytest.fixture(scope="session")
def text(report, drawn) -> str:
    """It on one page."""
    return page(report, drawn)


@pytest.fixture(scope="session")
def explored(recorded) -> Report:
    """It with one stored point that has no answer."""
    case, quantity, n = LOST

    def without(values, lost):
        return tuple(lost if k == n else v for k, v in enumerate(values))

    studies = list(recorded.studies)
    first = next(k for k, s in enumerate(studies) if s.case == case and not s.is_star)
    formulas = tuple(
        replace(f, error=without(f.error, np.nan), U=without(f.U, np.nan),
                problems=without(f.problems, "does not converge"))
        if f.quantity == quantity else f for f in studies[first].formulas
    )  # fmt: skip
    studies[first] = replace(studies[first], formulas=formulas)
    return replace(recorded, studies=tuple(studies))


@pytest.fixture(scope="session")
def made(explored) -> dict[str, str]:
    """Its pages by their paths."""
    return pages(explored, {})


@pytest.fixture(scope="session")
def folder(made, tmp_path_factory) -> Path:
    """The pages as files, as a report has them."""
    place = tmp_path_factory.mktemp("pages")
    for name, html in made.items():
        (place / name).parent.mkdir(exist_ok=True)
        (place / name).write_text(unquoted(html), "utf-8")
    return place


@pytest.fixture(scope="session")
def wordy(of_paper) -> Report:
    """One case with long names, values of another method, every status and printed powers."""
    result = of_paper(CASES[0])
    row = next(row for row in result.rows if row.grid is not None)
    other = replace(
        row, fem=None, published=(PRINTED,),
        partner=Partner(by="Runge-Kutta steps, compiled and checked", value=row.fem),
    )  # fmt: skip
    rows = tuple(replace(other, quantity=f"{NAME} {s}", status=s) for s in Status)
    case = replace(result, rows=rows, name="mine", figures=(), tables=())
    return replace(make_report([case], CASES[:1], 1.0), name="mine")


@pytest.fixture(scope="session")
def alone(wordy) -> Report:
    """A report of the suite on one case without rows."""
    case = replace(wordy.cases[0], id="polyhedral-ring", name="", rows=(), title="Ring")
    return replace(wordy, name="", cases=(case,), tables=(), errata=(), validity=(), budgets=())


@pytest.fixture(scope="session")
def schema() -> dict:
    """That of results.json."""
    return json.loads((Path(reports.__file__).parent / "results.schema.json").read_text("utf-8"))


def first_of(report: Report, count: int) -> Report:
    """A report of its first cases alone."""
    cases = report.cases[:count]
    names = {case.id for case in cases}
    return replace(
        report, cases=cases, validity=tuple(v for v in report.validity if v.case in names),
        budgets=tuple(b for b in report.budgets if b.case in names),
        tables=(), studies=(), searches=(),
    )  # fmt: skip


def section(report: Report, name: str) -> str:
    """The section of the report's page with this id."""
    return page(report, {}).partition(f'<section id="{name}">')[2].partition("</section>")[0]


def sheets_of(paper: bytes) -> int:
    """How many pages a PDF has."""
    return int(re.search(rb"/Type/Pages/Count (\d+)", paper)[1])


def said(runs) -> str:
    """The words of a cell of the PDF, without its marks."""
    return "".join(run if isinstance(run, str) else said(run[1:]) for run in runs)
