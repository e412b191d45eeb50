"""Conversion of an answer of `check` into the units of a system: values, texts and JSON."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, TypeVar

from verify.answers.assumed.rules import Assumed
from verify.core.case import Output
from verify.core.figures import FormulaValue, InputValue
from verify.core.results import CaseResult, Grid, Row
from verify.core.unit_systems import DISPLAYED, System, converted, ratio, text_in, unit_in
from verify.jobs.dynamic import DynamicResult

OF_ROW = ("analytic", "fem", "difference", "scale", "u_num", "u_ref", "u_input", "tolerance")
SENTENCES = ("reasons", "remarks", "notes", "what", "source", "doubt")  # keys of a record
Displayed = TypeVar("Displayed", FormulaValue, InputValue, Assumed)


def in_units(result: CaseResult, system: System) -> CaseResult:
    """Result of a case with inputs, values, rows and sentences in the units of `system`."""
    if not DISPLAYED[system]:
        return result
    return replace(
        result,
        inputs=tuple(_input(one, system) for one in result.inputs),
        values=tuple(_value(one, system) for one in result.values),
        rows=tuple(_row(one, system) for one in result.rows),
        findings=tuple(text_in(one, system) for one in result.findings),
        warnings=tuple(text_in(one, system) for one in result.warnings),
    )


def dynamic_in_units(found: DynamicResult | None, system: System) -> DynamicResult | None:
    """Results of `check --dynamic` in the units of `system`."""
    if found is None or not DISPLAYED[system]:
        return found
    return replace(
        found, outputs=outputs_in(found.outputs, system),
        findings=tuple(text_in(one, system) for one in found.findings),
        first=tuple(text_in(one, system) for one in found.first),
    )  # fmt: skip


def outputs_in(outputs: Sequence[Output], system: System) -> tuple[Output, ...]:
    """Outputs of a case, in which the units are those of `system`."""
    return tuple(replace(one, unit=unit_in(one.unit, system)) for one in outputs)


def assumed_in(assumed: Sequence[Assumed], system: System) -> tuple[Assumed, ...]:
    """Assumed inputs in the units of `system`."""
    return tuple(_number(one, system) for one in assumed)


def record_in_units(record: Any, system: System) -> Any:
    """JSON record of an answer, with its numbers and sentences in the units of `system`.

    Every `value`, `at` or `limit` with a `unit` is converted, except numbers printed in a paper.
    """
    if isinstance(record, list):
        return [record_in_units(one, system) for one in record]
    if not isinstance(record, dict):
        return record
    found = {
        k: _sentences(v, system) if k in SENTENCES
        else v if k == "published" else record_in_units(v, system)
        for k, v in record.items()
    }  # fmt: skip
    for key in ("value", "at", "limit"):
        if isinstance(found.get("unit"), str) and isinstance(found.get(key), int | float):
            number, unit = converted(found[key], record["unit"], system)
            found |= {key: number, "unit": unit}
    return found


def _sentences(value: Any, system: System) -> Any:
    if isinstance(value, list):
        return [_sentences(one, system) for one in value]
    return text_in(value, system) if isinstance(value, str) else record_in_units(value, system)


def _number(one: Displayed, system: System) -> Displayed:
    if isinstance(one.value, str):
        return replace(one, value=text_in(one.value, system))
    if not isinstance(one.value, float):
        return one
    value, unit = converted(one.value, one.unit, system)
    return replace(one, value=value, unit=unit)


def _value(one: FormulaValue, system: System) -> FormulaValue:
    return _number(replace(one, what=text_in(one.what, system)), system)


def _input(one: InputValue, system: System) -> InputValue:
    """An input in the units of `system`.

    Of a table of inputs, only the description is converted.
    """
    if one.value == "":
        return replace(one, what=text_in(one.what, system))
    return _number(one, system)


def _row(row: Row, system: System) -> Row:
    """A row with its dimensional numbers converted; relative and printed numbers are unchanged."""
    row = replace(row, reason=text_in(row.reason, system))
    target = unit_in(row.unit, system)
    if target == row.unit:
        return row
    factor = ratio(row.unit, target)
    numbers: dict[str, Any] = {
        name: value * factor for name in OF_ROW if (value := getattr(row, name)) is not None
    }
    return replace(
        row, unit=target, **numbers,
        partner=row.partner and replace(row.partner, value=row.partner.value * factor),
        levels=_levels(row.levels, factor), levels_u=tuple(u * factor for u in row.levels_u),
        grid=row.grid and _grid(row.grid, factor, target),
    )  # fmt: skip


def _levels(
    levels: Sequence[tuple[float, float]], factor: float
) -> tuple[tuple[float, float], ...]:
    return tuple((mesh_size, value * factor) for mesh_size, value in levels)


def _grid(grid: Grid, factor: float, unit: str) -> Grid:
    scaled = {name: getattr(grid, name) * factor for name in ("scale", "allowed", "gci", "u_it")}
    return replace(grid, unit=unit, levels=_levels(grid.levels, factor), **scaled)
