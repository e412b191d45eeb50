"""JSON output of `check`: the answer to a user's parameters, for programs."""

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from verify.answers.keys import identifier
from verify.answers.record import answer_record
from verify.app.check_console import Checked
from verify.core import units
from verify.core.case import Output, Values
from verify.core.inputs import Inputs
from verify.core.results import CaseResult
from verify.jobs.dynamic import DynamicResult

SCHEMA_VERSION = 3  # version 1 had no answer, and keys with spaces; version 2 had no verdicts


def check_record(checked: Checked, inputs: Inputs, values: Values) -> dict[str, Any]:
    """JSON record of the answer and its evidence, in display units.

    `check.schema.json` describes the record. `dynamic` is None if the simulation in time did not
    run; `rows` is empty without finite elements.
    """
    from reports.records import row_record  # only the command line may import reports

    case, result, dynamic = checked.case, checked.result, checked.dynamic
    return {
        "schema": SCHEMA_VERSION,
        "name": result.name,
        "case": case.id,
        "answer": answer_record(checked.answer),
        "notes": list(checked.notes),
        "assumed": [one.record() for one in checked.assumed],
        "shared": [asdict(one) for one in checked.shared],
        "verdicts": [one.record() for one in checked.verdicts],
        "details": {
            **case.summary(inputs, values),
            **({"verdict": dynamic.verdict} if dynamic and dynamic.verdict else {}),
        },
        "inputs": inputs.record(),
        "values": _values(case.outputs, values),
        "findings": list(_findings(result, dynamic)),
        "warnings": list(result.warnings),
        "rows": [row_record(row) for row in result.rows] if checked.used_fem else [],
        "dynamic": None if dynamic is None else _dynamic(dynamic),
    }


def _findings(result: CaseResult, dynamic: DynamicResult | None) -> Sequence[str]:
    """Findings, of which the first is that of the simulation in time if this is available."""
    if dynamic is None or not dynamic.first:
        return result.findings
    return dynamic.first + result.findings[1:]


def _dynamic(found: DynamicResult) -> dict[str, Any]:
    return {
        "what": found.what,
        **found.summary,
        "values": _values(found.outputs, found.raw),
        "findings": list(found.findings),
    }


def _values(outputs: Sequence[Output], values: Values) -> list[dict[str, Any]]:
    return [
        {"key": identifier(o.key), "symbol": o.symbol, "what": o.label, "unit": o.unit,
         "value": values[o.key] / units.factor(o.unit)}
        for o in outputs if o.key in values
    ]  # fmt: skip
