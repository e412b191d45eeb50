"""Conversion of an answer into JSON, which check.schema.json describes."""

import math
from typing import Any

from verify.answers.answer import Answer, Criterion, Quantity
from verify.core import units


def answer_record(answer: Answer) -> dict[str, Any]:
    """JSON record of an answer, with numbers in display units."""
    worst = None if answer.failures else answer.limiting
    return {
        "verdict": str(answer.verdict),
        "reasons": list(answer.reasons),
        "remarks": list(answer.remarks),
        "design": None if answer.design is None else _quantity(answer.design),
        "margin": None if worst is None else finite(worst.margin),
        "limited_by": None if worst is None else worst.key,
        "criteria": [_criterion(c) for c in answer.criteria],
    }


def finite(value: float) -> float | None:
    """The value, or None for a value that JSON cannot represent (infinity or nan)."""
    return value if math.isfinite(value) else None


def _quantity(quantity: Quantity) -> dict[str, Any]:
    return {
        "key": quantity.key, "symbol": quantity.symbol, "what": quantity.what,
        "value": quantity.value / units.factor(quantity.unit), "unit": quantity.unit,
    }  # fmt: skip


def _criterion(c: Criterion) -> dict[str, Any]:
    factor = units.factor(c.unit)
    return {
        "key": c.key, "what": c.what, "value": finite(c.value / factor),
        "limit": finite(c.limit / factor), "unit": c.unit,
        "kind": "minimum" if c.minimum else "maximum", "margin": finite(c.margin),
        "is_met": c.is_met, "source": c.source, "assumed": c.assumed,
        "doubt": c.doubt,
    }  # fmt: skip
