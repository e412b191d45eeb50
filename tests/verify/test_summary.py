"""The summary of a run for the page of a CI job."""

from dataclasses import replace

import pytest

from verify.app.summary import LISTED, summary
from verify.core.results import CaseResult, Kind, Report, Row, Status
from verify.verdicts.record import kept

ROW = Row(case="c", quantity="q", symbol="q", unit="1", kind=Kind.FACT, status=Status.PASS)
CASE = CaseResult(id="c", title="", paper="P", place="", lead="", inputs=(), equations=(),
                  assumptions=(), readings=(), rows=(ROW,))  # fmt: skip
MADE = {"commit": "abc-dirty", "python": "3.11.7", "machine": "Linux x86_64",
        "made": "2026-01-01 00:00 UTC", "seconds": {"total": 1.6}}  # fmt: skip
REPORT = Report(cases=(CASE,), papers=(), equations=(), errata=(), published=(), provenance=MADE)


def of(*rows, **more):
    return replace(REPORT, cases=(replace(CASE, rows=rows),), **more)


def test_it_counts_rows_by_status_and_ends_with_the_version():
    text = summary(of(ROW, ROW, replace(ROW, status=Status.SHOWN)), status=0)
    assert text.splitlines()[:7] == [
        "## freewheel verify: passed", "", "3 rows of 1 case", "",
        "| FAIL | SKIP | NOTE | CALIBRATED | SHOWN | PASS |", "|---|---|---|---|---|---|",
        "| 0 | 0 | 0 | 0 | 1 | 2 |",
    ]  # fmt: skip
    assert text.endswith("commit abc-dirty, Python 3.11.7, Linux x86_64; "
                         "2026-01-01 00:00 UTC, 2 s\n")  # fmt: skip
    assert "###" not in text


@pytest.mark.parametrize("status", [Status.FAIL, Status.SKIP])
def test_a_reason_keeps_to_its_cell(status):
    text = summary(of(ROW, replace(ROW, status=status, reason="|a| above 10^-5\nof b")), status=1)
    assert text.startswith("## freewheel verify: failed\n")
    assert f"\n| `c` | q | {status.value} | \\|a\\| above 10⁻⁵ of b |\n" in text


def test_of_very_many_failing_rows_the_first_are_listed():
    text = summary(of(*[replace(ROW, status=Status.FAIL)] * (LISTED + 3)), status=1)
    assert text.count("| `c` |") == LISTED
    assert "\n\nand 3 more rows\n" in text


def test_verdicts_and_changes_are_those_of_a_whole_run():
    papers = [{"key": one, "title": "t", "authors": f"A {one}", "year": 2020} for one in
              dict.fromkeys(v.paper for v in kept())]  # fmt: skip
    text = summary(of(ROW, papers=tuple(papers), verdicts=kept()), status=1,
                   changes=["verdict of P Eq. 1: unsafe; exact in the record"])  # fmt: skip
    assert "### Verdicts of the formulas\n\n| formulas of | exact |" in text
    assert "\n- verdict of P Eq. 1: unsafe; exact in the record\n" in text
