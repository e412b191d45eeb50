"""What `check --json` prints: one's own parameters and what follows from them, for programs."""

from collections.abc import Sequence
from typing import Any

from verify import units
from verify.case import Case, Output, Values
from verify.dynamic import DynamicResult
from verify.inputs import Inputs
from verify.results import CaseResult, Row


def check_record(
    case: Case,
    inputs: Inputs,
    values: Values,
    result: CaseResult,
    rows: Sequence[Row],
    dynamic: DynamicResult | None,
) -> dict[str, Any]:
    """Inputs and values in display units, the rows; `dynamic` is None where it did not run.

    The verdict, and the findings with it, are those of both parts together where there are.
    """
    from reports.records import row_record  # only the command line knows reports

    return {
        "name": result.name,
        "case": case.id,
        **case.summary(inputs, values),
        **({"verdict": dynamic.verdict} if dynamic and dynamic.verdict else {}),
        "inputs": inputs.record(),
        "values": _values(case.outputs, values),
        "findings": list(_findings(result, dynamic)),
        "warnings": list(result.warnings),
        "rows": [row_record(row) for row in rows],
        "dynamic": None if dynamic is None else _dynamic(dynamic),
    }


def _findings(result: CaseResult, dynamic: DynamicResult | None) -> Sequence[str]:
    """Those of the formulas, whose first the dynamic part may have replaced."""
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
        {"key": o.key, "symbol": o.symbol, "what": o.what, "unit": o.unit,
         "value": values[o.key] / units.factor(o.unit)}
        for o in outputs if o.key in values
    ]  # fmt: skip
