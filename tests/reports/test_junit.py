"""junit.xml as Jenkins and GitLab read it: classname, name, time, failure, skipped."""

import xml.etree.ElementTree as ET

import pytest

from reports.junit import junit
from verify.core.results import Status


def test_failures_and_skips_are_counted(hostile):
    suites = ET.fromstring(junit(hostile))
    own = suites.find("testsuite")
    assert (suites.get("failures"), suites.get("skipped")) == ("1", "1")
    assert (own.get("tests"), own.get("errors")) == (str(len(Status)), "0")
    assert len(own.findall("testcase")) == len(Status)


def test_messages_hold_no_markup_and_no_control_character(hostile):
    text = junit(hostile)
    failure = ET.fromstring(text).find("testsuite/testcase/failure")
    assert failure.get("message").startswith("<script>")
    assert failure.text == failure.get("message")
    assert "\x07" not in text


def test_every_row_is_a_test_with_a_name_of_its_own_and_a_share_of_the_time(report):
    suites = ET.fromstring(junit(report))
    tests = suites.findall("testsuite/testcase")
    assert len({(t.get("classname"), t.get("name")) for t in tests}) == len(report.rows)
    assert tests[0].get("classname") == "freewheel.ring-lame"
    for suite, case in zip(suites, report.cases, strict=True):
        assert float(suite.get("time")) == pytest.approx(case.seconds, abs=1e-3)
        total = sum(float(t.get("time")) for t in suite)
        assert total == pytest.approx(case.seconds, abs=1e-6 * len(case.rows))
