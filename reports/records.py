"""A run as plain records: what results.json holds and `results.schema.json` describes."""

import math
from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from reports.second import records, seconds
from verify.core.results import SCHEMA_VERSION, CaseResult, Drift, Report, Row, Validity


def report_record(report: Report) -> dict[str, Any]:
    """The whole run for results.json."""
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
        "paper_tables": [_plain(asdict(table)) for table in report.tables],
        "validity": [_validity(one) for one in report.validity],
        "drift": None if report.drift is None else _drift(report.drift),
        "readings_tried": [_plain(asdict(one)) for one in report.searches],
        "budgets": [_plain(asdict(one)) for one in report.budgets],
        "crosschecks": [_plain(asdict(one)) for one in report.crosschecks],
        "verdicts": [_plain(asdict(one)) for one in report.verdicts],
        "caught": None if report.caught is None else _plain(asdict(report.caught)),
        "provenance": report.provenance,
    }


def _drift(drift: Drift) -> dict[str, Any]:
    """What moved since a release, and how many loosened demands lack a reason."""
    return {"unexplained": len(drift.unexplained), **_plain(asdict(drift))}


def row_record(row: Row) -> dict[str, Any]:
    """One row; numbers that are not finite become null, for JSON knows none."""
    record = {"id": row.id} | {k: _plain(v) for k, v in asdict(row).items()}
    error = row.difference / row.scale if row.difference is not None and row.scale else None
    return record | {"kind": row.kind.value, "status": row.status.value, "error": _plain(error)}


def _case(case: CaseResult) -> dict[str, Any]:
    return {
        "id": case.id, "title": case.title, "paper": case.paper, "place": case.place,
        "inputs": [asdict(i) for i in case.inputs],
        "values": [_plain(asdict(v)) for v in case.values], "assumptions": list(case.assumptions),
        "readings": list(case.readings), "findings": list(case.findings),
        "warnings": list(case.warnings),
        "tables": [asdict(t) for t in case.tables], "command": case.command,
    }  # fmt: skip


def _validity(one: Validity) -> dict[str, Any]:
    """What is said of a case's formulas; the measured errors stay in their own files."""
    record: dict[str, Any] = _plain(asdict(one))
    for card in record["cards"]:
        for region in card["regions"]:
            for drawn in ("axes", "error", "U"):
                del region[drawn]
    return record


def _plain(value: Any) -> Any:
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, Mapping):
        return {k: _plain(v) for k, v in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(v) for v in value]
    return value
