"""What a run leaves behind is read back by the programs that will read it."""

import csv
import io
import json
import xml.etree.ElementTree as ET
from dataclasses import replace
from html.parser import HTMLParser

import jsonschema
import meshio
import numpy as np
import pytest
import pyvista

from reports.html import page
from reports.junit import junit
from reports.records import report_record
from reports.vtu import vtu
from reports.write import write
from verify.cases.registry import CASES
from verify.commands import make_report
from verify.results import Field, Kind, Report, Row, Status

HOSTILE = "<script>alert(\"1\")</script> & 'x' \x07"
VOID = {"meta", "link", "br", "img", "input", "hr", "path", "circle", "rect", "line", "use"}


@pytest.fixture(scope="module")
def report(judged) -> Report:
    cases = [c for c in CASES if c.id != "spring-continuum"]
    return make_report([judged(c) for c in cases], cases, 1.0)


@pytest.fixture(scope="module")
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


class Balanced(HTMLParser):
    """Collects script elements and checks that tags close."""

    def __init__(self):
        super().__init__()
        self.open, self.scripts, self.bad = [], 0, []

    def handle_starttag(self, tag, attrs):
        self.scripts += tag == "script"
        if tag not in VOID:
            self.open.append(tag)
        self.bad += [
            (k, v)
            for k, v in attrs
            if k != "xmlns" and v and v.startswith(("http:", "https:", "//"))
        ]

    def handle_endtag(self, tag):
        if tag not in VOID:
            while self.open and self.open[-1] != tag and self.open[-1] in ("tr", "td", "th", "li"):
                self.open.pop()  # closing tags that HTML lets an author leave out
            assert self.open.pop() == tag


@pytest.mark.parametrize("which", ["report", "hostile"])
def test_results_obey_the_schema(which, request, tmp_path):
    report = request.getfixturevalue(which)
    write(report, tmp_path)
    schema = json.loads((tmp_path / "results.schema.json").read_text())
    results = json.loads((tmp_path / "results.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.validate(results, schema)
    assert len(results["rows"]) == len(report.rows)
    assert len(results["equations"]) == 77  # 22 + 11 + 10 + 13 + 21


def test_a_value_that_is_no_number_becomes_null(report):
    row = replace(report.rows[0], tolerance=float("inf"), difference=float("nan"))
    case = replace(report.cases[0], rows=(row,))
    record = report_record(replace(report, cases=(case,)))
    assert record["rows"][0]["tolerance"] is None
    assert record["rows"][0]["difference"] is None
    json.dumps(record, allow_nan=False)


@pytest.mark.parametrize("which", ["report", "hostile"])
def test_the_page_is_well_formed_self_contained_and_runs_no_foreign_script(which, request):
    text = page(request.getfixturevalue(which))
    parser = Balanced()
    parser.feed(text)
    assert parser.open == []
    assert parser.scripts == 0
    assert parser.bad == []
    assert "<script>" not in text
    assert "@import" not in text


def test_every_status_is_on_the_page(hostile):
    text = page(hostile)
    for status in Status:
        assert f'class="state is-{status.value.lower()}">{status.value}<' in text


def test_every_row_is_on_the_page_once_and_linked(report):
    text = page(report)
    for i in range(len(report.rows)):
        assert text.count(f'id="row-{i}"') == 1


def test_junit_counts_failures_and_skips(hostile):
    suites = ET.fromstring(junit(hostile))
    own = suites.find("testsuite")
    assert (suites.get("failures"), suites.get("skipped")) == ("1", "1")
    assert len(own.findall("testcase")) == len(Status)
    assert own.find("testcase/failure").get("message").startswith("<script>")


def test_the_table_reads_back(report, tmp_path):
    write(report, tmp_path)
    rows = list(csv.DictReader(io.StringIO((tmp_path / "rows.csv").read_text("utf-8-sig"))))
    assert [r["quantity"] for r in rows] == [r.quantity for r in report.rows]
    assert float(rows[0]["analytic"]) == report.rows[0].analytic


def test_fields_open_in_two_readers(report, tmp_path):
    field = report.cases[0].fields[0]
    path = tmp_path / "field.vtu"
    path.write_bytes(vtu(field))
    mesh, grid = meshio.read(path), pyvista.read(path)
    assert len(mesh.cells[0].data) == grid.n_cells == len(field.cells)
    np.testing.assert_allclose(
        grid.point_data["displacement"][:, :2], field.point_data["displacement"]
    )
    np.testing.assert_allclose(grid.cell_data["von_mises"], field.cell_data["von_mises"])


def test_lines_are_fields_too():
    field = Field(name="beam", points=np.eye(2), cells=np.array([[0, 1]]))
    assert b"UnstructuredGrid" in vtu(field)


def test_an_interrupted_write_leaves_the_old_file(report, tmp_path, monkeypatch):
    from reports import write as module

    write(report, tmp_path)
    before = (tmp_path / "report.html").read_bytes()
    monkeypatch.setattr(module.Path, "replace", lambda *_: (_ for _ in ()).throw(KeyboardInterrupt))
    with pytest.raises(KeyboardInterrupt):
        write(report, tmp_path)
    assert (tmp_path / "report.html").read_bytes() == before
    assert not list(tmp_path.glob(".part-*"))
