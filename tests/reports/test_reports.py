"""What a run leaves behind is read back by the programs that will read it."""

import csv
import io
import json
import xml.etree.ElementTree as ET
from dataclasses import replace

import jsonschema
import meshio
import numpy as np
import pytest
import pyvista

from reports.junit import junit
from reports.records import report_record
from reports.vtu import vtu
from reports.write import write
from verify.results import Field, Status


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
