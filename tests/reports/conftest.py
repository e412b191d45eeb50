"""Reports for the tests: one case of each subject, all cases, and reports with special texts."""

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
# a point taken away
LOST = ("spring-accordion", "stiffness by Eqs. 1-9 against curved beam elements", 7)
PRINTED = Published(document="d", id="i", place="p", kind="theory", printed="1.97×10^-4",
                    value=1.97e-4, unit="kg m^2")  # fmt: skip


@pytest.fixture(scope="session")
def report(of_paper) -> Report:
    """Report with a case of each subject and a map; tests of every case use `whole`."""
    cases = [find(name) for name in SOME]
    return make_report([of_paper(c) for c in cases], cases, 1.0)


@pytest.fixture(scope="session")
def whole(of_paper) -> Report:
    """Report with every case of the suite."""
    return make_report([of_paper(c) for c in CASES], CASES, 1.0)


@pytest.fixture(scope="session")
def hostile(report) -> Report:
    """Report with markup in every text that a user can write, and with one row for each status."""
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
    """Report with the verdicts of record."""
    return replace(report, verdicts=kept())


@pytest.fixture(scope="session")
def drawn(report) -> dict:
    """Pictures of the cases of `report`."""
    return frames(report.cases, default_folder())


@pytest.fixture(scope="session")
def text(report, drawn) -> str:
    """HTML of `report` on one page."""
    return page(report, drawn)


@pytest.fixture(scope="session")
def explored(recorded) -> Report:
    """Report with the verdicts of record and one stored point without an answer."""
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
    """HTML pages of `explored` by their paths."""
    return pages(explored, {})


@pytest.fixture(scope="session")
def folder(made, tmp_path_factory) -> Path:
    """Folder with the pages of `explored` as files."""
    place = tmp_path_factory.mktemp("pages")
    for name, html in made.items():
        (place / name).parent.mkdir(exist_ok=True)
        (place / name).write_text(unquoted(html), "utf-8")
    return place


@pytest.fixture(scope="session")
def wordy(of_paper) -> Report:
    """Report of one case: long names, values of a second method, every status, printed powers."""
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
    """JSON schema of results.json."""
    return json.loads((Path(reports.__file__).parent / "results.schema.json").read_text("utf-8"))


def first_of(report: Report, count: int) -> Report:
    """Report with the first `count` cases only."""
    cases = report.cases[:count]
    names = {case.id for case in cases}
    return replace(
        report, cases=cases, validity=tuple(v for v in report.validity if v.case in names),
        budgets=tuple(b for b in report.budgets if b.case in names),
        tables=(), studies=(), searches=(),
    )  # fmt: skip


def section(report: Report, name: str) -> str:
    """HTML of the section with the id `name` on the page of the report."""
    return page(report, {}).partition(f'<section id="{name}">')[2].partition("</section>")[0]


def sheets_of(paper: bytes) -> int:
    """Number of pages of a PDF."""
    return int(re.search(rb"/Type/Pages/Count (\d+)", paper)[1])


def plain_text(runs) -> str:
    """Words in a cell of the PDF, without markup."""
    return "".join(run if isinstance(run, str) else plain_text(run[1:]) for run in runs)
