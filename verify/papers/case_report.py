"""Contents of the report on a case, except its rows: inputs, formulas, figures, sketch."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from verify.core import units
from verify.core.case import Case, Context, Output, Values
from verify.core.figures import FormulaValue, InputValue
from verify.core.inputs import Inputs, meta
from verify.papers.ledger import published


def described(case: Case, context: Context) -> dict[str, Any]:
    """Fields of `CaseResult` that follow from the case and its formulas."""
    q, values = context.inputs, context.analytic
    return {
        "id": case.id, "title": case.title, "paper": case.paper, "place": case.place,
        "lead": case.lead, "assumptions": case.assumptions, "readings": case.readings,
        "inputs": _inputs(q, is_paper=context.is_paper),
        "values": shown_values(case.outputs, values),
        "equations": tuple(case.equations(q, values)), "warnings": tuple(case.warnings(q, values)),
        "findings": tuple(case.findings(q, values)),
        "tables": tuple(case.tables(context)), "sketch": case.sketch(q),
        "figures": tuple(case.figures(context)), "pictures": tuple(case.pictures(q)),
        "fields": context.fem[-1].fields if context.fem else (),
    }  # fmt: skip


def shown_values(outputs: Sequence[Output], values: Values) -> tuple[FormulaValue, ...]:
    """Outputs that exist for these inputs, in display units."""
    return tuple(
        FormulaValue(
            key=out.key, symbol=out.symbol, what=out.what,
            value=values[out.key] / units.factor(out.unit), unit=out.unit, judged=out.judged,
            equation=out.equation, source=out.source, form=out.form, safe=out.safe,
        )
        for out in outputs if out.key in values
    )  # fmt: skip


def _inputs(q: Inputs, *, is_paper: bool) -> tuple[InputValue, ...]:
    """All inputs of a case; if they are the paper's, each with its place in the paper."""
    if not is_paper:
        return q.display()
    claims = {name: meta(field)["claims"] for name, field in type(q).model_fields.items()}
    return tuple(
        replace(shown, source=published(claims[shown.name]).place if claims.get(shown.name) else "")
        for shown in q.display()
    )
