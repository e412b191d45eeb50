"""Content of junit.xml for continuous integration: one suite per case, one test per row."""

from collections.abc import Iterable
from xml.sax.saxutils import escape, quoteattr

from reports.xml_text import clean
from verify.core.results import CaseResult, Report, Row, Status


def junit(report: Report) -> str:
    """XML of the whole run; FAIL is a failure, SKIP is skipped, every other status passes."""
    suites = "\n".join(_suite(case) for case in report.cases)
    seconds = sum(case.seconds for case in report.cases)
    head = f"<testsuites {_counts(report.rows, seconds)}>"
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{head}\n{suites}\n</testsuites>\n'


def _suite(case: CaseResult) -> str:
    """XML of a case; its time is divided equally among its rows, which are computed together."""
    tests = "\n".join(_test(row, case.seconds / len(case.rows)) for row in case.rows)
    head = f"<testsuite name={_attribute(case.id)} {_counts(case.rows, case.seconds)}>"
    return f"{head}\n{tests}\n</testsuite>"


def _test(row: Row, seconds: float) -> str:
    """XML of a row; servers use the part before the last dot of the class name as its package."""
    head = (
        f"<testcase classname={_attribute(f'freewheel.{row.case}')} "
        f'name={_attribute(row.quantity)} time="{seconds:.6f}">'
    )
    return f"{head}{_outcome(row)}</testcase>"


def _outcome(row: Row) -> str:
    if row.status is Status.FAIL:
        message = _attribute(row.reason)
        return (
            f'<failure type="{row.kind.value}" message={message}>{_escaped(row.reason)}</failure>'
        )
    if row.status is Status.SKIP:
        return f"<skipped message={_attribute(row.reason)}/>"
    note = f"{row.status.value}: {row.reason}" if row.reason else row.status.value
    return f"<system-out>{_escaped(note)}</system-out>"


def _counts(rows: Iterable[Row], seconds: float) -> str:
    states = [row.status for row in rows]
    return (
        f'tests="{len(states)}" failures="{states.count(Status.FAIL)}" errors="0" '
        f'skipped="{states.count(Status.SKIP)}" time="{seconds:.3f}"'
    )


def _attribute(text: str) -> str:
    return quoteattr(clean(text))


def _escaped(text: str) -> str:
    return escape(clean(text))
