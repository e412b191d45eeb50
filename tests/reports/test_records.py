"""Files written by a run are read back by the programs that use them."""

import csv
import io
import json
import re
import xml.etree.ElementTree as ET
from dataclasses import replace

import jsonschema
import pytest

from reports.html import anchors, page
from reports.junit import junit
from reports.pdf_case import case_data
from reports.records import report_record, text_of
from reports.row_lines import failed_first, lines
from reports.rows import rows_csv
from verify.core.results import Kind, Row, Status


def test_results_obey_the_schema_with_odd_texts_and_values_too(report, hostile, schema):
    jsonschema.Draft202012Validator.check_schema(schema)
    row = replace(report.rows[0], tolerance=float("inf"), difference=float("nan"))
    odd = replace(report.cases[0], rows=(row,))
    odd_report = replace(hostile, cases=(odd, hostile.cases[0]))
    whole, other = (json.loads(text_of(report_record(one))) for one in (report, odd_report))
    for record in (whole, other):
        jsonschema.validate(record, schema)
    assert len(whole["rows"]) == len(report.rows)
    for case, record in zip(report.cases, whole["cases"], strict=True):
        assert [v["what"] for v in record["values"]] == [v.what for v in case.values]
    assert other["rows"][0]["tolerance"] is other["rows"][0]["difference"] is None


def test_every_row_is_a_junit_test_with_a_share_of_the_time_and_holds_no_markup(report, hostile):
    suites = ET.fromstring(junit(report))
    tests = suites.findall("testsuite/testcase")
    assert len({(t.get("classname"), t.get("name")) for t in tests}) == len(report.rows)
    assert tests[0].get("classname") == "freewheel.ring-lame"
    for suite, case in zip(suites, report.cases, strict=True):
        total = sum(float(t.get("time")) for t in suite)
        assert float(suite.get("time")) == pytest.approx(case.seconds, abs=1e-3)
        assert total == pytest.approx(case.seconds, abs=1e-6 * len(case.rows))
    text = junit(hostile)
    suites = ET.fromstring(text)
    own = suites.find("testsuite")
    assert (suites.get("failures"), suites.get("skipped")) == ("1", "1")
    assert (own.get("tests"), own.get("errors")) == (str(len(Status)), "0")
    failure = own.find("testcase/failure")
    assert failure.text == failure.get("message")
    assert failure.text.startswith("<script>")
    assert "\x07" not in text


def read(text):
    return list(csv.DictReader(io.StringIO(text.removeprefix("\ufeff"))))


def test_texts_of_a_table_are_no_formulas_and_numbers_remain_numbers(report):
    for start in ("=1+1", "-2+3", "@SUM(A1)"):
        row = replace(report.rows[0], quantity=start, reason=f"{start}\rtwo\nthree\x07")
        (cells,) = read(rows_csv([row]))
        assert cells["quantity"] == f"'{start}"
        assert cells["reason"] == f"'{start} two\nthree\ufffd"
    (cells,) = read(rows_csv([replace(row, analytic=-1.5, fem=-1.0, scale_name="")]))
    assert float(cells["analytic"]) == -1.5
    assert float(cells["difference"]) == -0.5  # formula less reference
    assert float(cells["difference_percent"]) == 50.0  # the formula has the larger magnitude
    assert cells["percent_of"] == "reference"


PASS, NOTE, SKIP, FAIL = Status.PASS, Status.NOTE, Status.SKIP, Status.FAIL


def row(quantity, status=PASS):
    return Row(case="c", quantity=quantity, symbol="x", unit="1", kind=Kind.IDENTITY, status=status)


def test_failed_rows_come_first_then_those_not_run_and_convergence_shares_its_quantity_s_line():
    states = {"a": PASS, "b": SKIP, "c": NOTE, "d": FAIL, "e": FAIL, "f": SKIP}
    given = [row(*item) for item in states.items()]
    assert [r.quantity for r in failed_first(given)] == ["d", "e", "b", "f", "a", "c"]
    assert [line.row.quantity for line in lines(given)] == ["d", "e", "b", "f", "a", "c"]
    a, good, b = row("a"), row("a: convergence"), row("b")
    bad = row("b: convergence", FAIL)  # a separate line, as one that is alone
    assert [(x.row, x.convergence) for x in lines([a, good, b, bad])] == [
        (bad, None), (a, good), (b, None),
    ]  # fmt: skip
    assert [x.row for x in lines([good])] == [good]


def test_page_and_pdf_begin_with_failed_rows_and_files_of_data_keep_the_order(report):
    """The last row of the second case fails, one of the third is not run."""
    first, second, third = report.cases[:3]
    last = max(i for i, r in enumerate(second.rows) if r.grid and r.levels)
    rows = [replace(r, status=FAIL) if i == last else r for i, r in enumerate(second.rows)]
    broken = replace(second, rows=tuple(rows))
    left_out = replace(third, rows=(*third.rows[:-1], replace(third.rows[-1], status=SKIP)))
    cases = (first, broken, left_out)
    planted = replace(report, cases=cases, tables=(), validity=(), budgets=())

    text, where = page(planted, {}), anchors(planted.rows)
    table = text[text.index('<table class="rows') :]
    found = re.findall(r'<tr role="row" id="(row-[\d-]+)" class="row is-(\w+)"', table)
    assert found[:2] == [(where[rows[last].id], "fail"), (where[left_out.rows[-1].id], "skip")]
    assert {status for _, status in found[2:]}.isdisjoint({"fail", "skip"})
    rest = [tuple(map(int, name.split("-")[1:])) for name, _ in found[2:]]
    assert rest == sorted(rest)
    data = case_data(broken, (), where, ["s"] * len(broken.tables), "p")
    assert data["lines"][0]["status"] == "FAIL"
    ids = [row.id for row in planted.rows]
    assert [r["id"] for r in report_record(planted)["rows"]] == ids
    table = read(rows_csv(planted.rows))
    assert [f"{r['case']}/{r['quantity']}" for r in table] == ids
    assert float(table[0]["analytic"]) == planted.rows[0].analytic
