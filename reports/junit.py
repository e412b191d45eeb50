"""junit.xml: one suite a case, one test a row, for continuous-integration servers."""

import re
from xml.sax.saxutils import escape, quoteattr

from verify.results import CaseResult, Report, Row, Status

NOT_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def junit(report: Report) -> str:
    """The whole run; FAIL is a failure, SKIP is skipped, everything else passes."""
    suites = "\n".join(_suite(case) for case in report.cases)
    total, failed, skipped = _counts(report.rows)
    head = f'<testsuites tests="{total}" failures="{failed}" skipped="{skipped}">'
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{head}\n{suites}\n</testsuites>\n'


def _suite(case: CaseResult) -> str:
    total, failed, skipped = _counts(case.rows)
    tests = "\n".join(_test(row) for row in case.rows)
    return (
        f'<testsuite name={_attribute(case.id)} tests="{total}" failures="{failed}" '
        f'skipped="{skipped}" time="{case.seconds:.3f}">\n{tests}\n</testsuite>'
    )


def _test(row: Row) -> str:
    open_tag = f"<testcase classname={_attribute(row.case)} name={_attribute(row.quantity)}"
    if row.status is Status.FAIL:
        return f"{open_tag}><failure message={_attribute(row.reason)}/></testcase>"
    if row.status is Status.SKIP:
        return f"{open_tag}><skipped message={_attribute(row.reason)}/></testcase>"
    note = f"{row.status.value}: {row.reason}" if row.reason else row.status.value
    return f"{open_tag}><system-out>{escape(_clean(note))}</system-out></testcase>"


def _counts(rows: tuple[Row, ...]) -> tuple[int, int, int]:
    states = [row.status for row in rows]
    return len(rows), states.count(Status.FAIL), states.count(Status.SKIP)


def _attribute(text: str) -> str:
    return quoteattr(_clean(text))


def _clean(text: str) -> str:
    return NOT_XML.sub("\ufffd", text)
