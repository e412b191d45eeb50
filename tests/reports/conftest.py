"""One judged run for all report tests, and the same with hostile texts and every status."""

from dataclasses import replace

import pytest

from verify.cases.registry import CASES
from verify.commands import make_report
from verify.results import Kind, Report, Row, Status

HOSTILE = "<script>alert(\"1\")</script> & 'x' \x07"


@pytest.fixture(scope="session")
def report(judged) -> Report:
    return make_report([judged(c) for c in CASES], CASES, 1.0)


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
