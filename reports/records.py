"""A run as plain records: the content of results.json, described by `results.schema.json`."""

import json
import math
from collections.abc import Mapping
from dataclasses import is_dataclass
from typing import Any

from reports.second import records, seconds
from verify.core.results import SCHEMA_VERSION, CaseResult, Drift, Report, Row, Validity


def report_record(report: Report) -> dict[str, Any]:
    """Record of the whole run for results.json."""
    beside = seconds(report.crosschecks)
    return {
        "schema": SCHEMA_VERSION,
        "rows": [
            row_record(row) | {"second_solvers": list(records(beside.of(row)))}
            for row in report.rows
        ],
        "cases": [_case(case) for case in report.cases],
        "papers": list(report.papers),
        "equations": list(report.equations),
        "errata": list(report.errata),
        "published": list(report.published),
        "paper_tables": [_plain(table) for table in report.tables],
        "validity": [_validity(one) for one in report.validity],
        "drift": None if report.drift is None else _drift(report.drift),
        "readings_tried": [_plain(one) for one in report.searches],
        "budgets": [_plain(one) for one in report.budgets],
        "crosschecks": [_plain(one) for one in report.crosschecks],
        "verdicts": [_plain(one) for one in report.verdicts],
        "caught": None if report.caught is None else _plain(report.caught),
        "provenance": report.provenance,
    }


def _drift(drift: Drift) -> dict[str, Any]:
    """Record of changes since a release; it counts requirements loosened without a reason."""
    return dict(_plain(drift), unexplained=len(drift.unexplained))


def row_record(row: Row) -> dict[str, Any]:
    """Record of one row; numbers that are not finite become null, because JSON has none."""
    record = {"id": row.id, **_plain(row)}
    error = row.difference / row.scale if row.difference is not None and row.scale else None
    return record | {"kind": row.kind.value, "status": row.status.value, "error": _plain(error)}


def _case(case: CaseResult) -> dict[str, Any]:
    return {
        "id": case.id, "title": case.title, "paper": case.paper, "place": case.place,
        "inputs": _plain(case.inputs),
        "values": _plain(case.values), "assumptions": list(case.assumptions),
        "readings": list(case.readings), "findings": list(case.findings),
        "warnings": list(case.warnings),
        "tables": _plain(case.tables), "command": case.command,
    }  # fmt: skip


def _validity(one: Validity) -> dict[str, Any]:
    """Record of the validity of a case's formulas; measured errors are in separate files."""
    record: dict[str, Any] = _plain(one)
    for card in record["cards"]:
        for region in card["regions"]:
            for drawn in ("axes", "error", "U"):
                del region[drawn]
    return record


def _plain(value: Any) -> Any:
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, str) or value is None:
        return value
    if isinstance(value, list | tuple):
        return [_plain(v) for v in value]
    if isinstance(value, Mapping):
        return {k: _plain(v) for k, v in value.items()}
    return _plain(vars(value)) if is_dataclass(value) else value


def text_of(record: Mapping[str, Any]) -> str:
    """JSON text of a record, with a line for each entry of its lists."""
    parts = [f"{_json(key)}: {_lines(value)}" for key, value in record.items()]
    return "{\n" + ",\n".join(parts) + "\n}"


def _lines(value: Any) -> str:
    if not isinstance(value, list) or not value:
        return _json(value)
    return "[\n" + ",\n".join(map(_json, value)) + "\n]"


def _json(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)
