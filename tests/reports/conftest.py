"""One judged run for all report tests, and the same with hostile texts and every status."""

from dataclasses import replace

import pytest

from verify.cases.registry import CASES
from verify.commands import make_report
from verify.results import Kind, Partner, Published, Report, Row, Status

HOSTILE = "<script>alert(\"1\")</script> & 'x' \x07"
NAME = " ".join(["word"] * 18)  # 90 letters
PRINTED = Published(document="d", id="i", place="p", kind="theory", printed="1.97×10^-4",
                    value=1.97e-4, unit="kg m^2")  # fmt: skip


@pytest.fixture(scope="session")
def report(of_paper) -> Report:
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
