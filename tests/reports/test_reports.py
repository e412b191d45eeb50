"""What a run leaves behind is read back by the programs that will read it."""

import csv
import io
import json
from dataclasses import replace

import jsonschema
import pytest

from reports.records import report_record
from reports.write import write
from verify.jobs.cache import default_folder


def test_results_obey_the_schema(report, written):
    schema = json.loads((written / "results.schema.json").read_text())
    results = json.loads((written / "results.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.validate(results, schema)
    assert len(results["rows"]) == len(report.rows)
    for case, record in zip(report.cases, results["cases"], strict=True):
        assert [v["what"] for v in record["values"]] == [v.what for v in case.values]


def test_results_with_odd_texts_obey_the_schema(hostile, written):
    schema = json.loads((written / "results.schema.json").read_text())
    few = replace(hostile, cases=hostile.cases[:1])
    jsonschema.validate(json.loads(json.dumps(report_record(few))), schema)


def test_a_value_that_is_no_number_becomes_null(report):
    row = replace(report.rows[0], tolerance=float("inf"), difference=float("nan"))
    case = replace(report.cases[0], rows=(row,))
    record = report_record(replace(report, cases=(case,)))
    assert record["rows"][0]["tolerance"] is None
    assert record["rows"][0]["difference"] is None
    json.dumps(record, allow_nan=False)


def test_the_table_reads_back(report, written):
    rows = list(csv.DictReader(io.StringIO((written / "rows.csv").read_text("utf-8-sig"))))
    assert [r["quantity"] for r in rows] == [r.quantity for r in report.rows]
    assert float(rows[0]["analytic"]) == report.rows[0].analytic


def test_an_interrupted_write_leaves_the_old_file(report, tmp_path, monkeypatch):
    from reports import write as module

    before = b"the old page"
    (tmp_path / "report.html").write_bytes(before)
    monkeypatch.setattr(module.Path, "replace", lambda *_: (_ for _ in ()).throw(KeyboardInterrupt))
    with pytest.raises(KeyboardInterrupt):
        write(report, tmp_path, cache=default_folder())
    assert (tmp_path / "report.html").read_bytes() == before
    assert not list(tmp_path.glob(".part-*"))
