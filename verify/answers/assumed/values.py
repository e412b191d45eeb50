"""Conversion of input values: from a file to SI units, and of assumptions to the file format."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from verify.answers.assumed.rules import Assumed, Assumption, Given
from verify.core import units
from verify.core.inputs import LARGEST_INTEGER, REQUIRED, Inputs, bounds_of, is_table, kind_of, meta

DIGITS = 6  # of a derived value, so that the printed value is the one used


def given_values(model: type[Inputs], raw: Mapping[str, Any]) -> tuple[Given, bool]:
    """Inputs in SI units, with the defaults of omitted inputs, and whether all values are valid."""
    fields, found, readable = model.model_fields, Given(), True
    for name, field in fields.items():
        omitted = meta(field)["omitted"]
        if name in raw:
            try:
                found[name] = read_value(model, name, raw[name])
            except ValueError:
                readable = False
        elif omitted != REQUIRED:
            found[name] = omitted
    return found, readable and _within_bounds(model, found)


def _within_bounds(model: type[Inputs], given: Given) -> bool:
    rules = {"greater than": float.__gt__, "at least": float.__ge__, "less than": float.__lt__,
             "at most": float.__le__}  # fmt: skip
    return all(
        rules[word](float(given[name]), float(bound))
        for name, field in model.model_fields.items()
        if isinstance(given.get(name), int | float)
        for word, bound in bounds_of(field)
    )


def read_value(model: type[Inputs], name: str, value: Any) -> Any:
    """A TOML value in SI units. Raises ValueError if the unit is missing or wrong."""
    if name not in model.model_fields or is_table(model.model_fields[name]):
        return value
    field = model.model_fields[name]
    kind, unit = kind_of(field), meta(field)["unit"]
    if kind is float and isinstance(value, str):
        return units.parse(value, unit)
    if kind not in (int, float):
        return value
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise ValueError(f"{name} must be a number")
    if (kind is float and unit != "1") or not abs(value) <= LARGEST_INTEGER:
        raise ValueError(f"{name} must be a number with a unit, such as {unit}")
    return value


def si_value(model: type[Inputs], one: Assumption, rule: Any, given: Given) -> Any:
    """Value [SI] that results from `rule`: an assumed value, or a limit of its usual range."""
    return read_value(model, one.name, raw_value(model, replace(one, value=rule), given))


def raw_value(model: type[Inputs], one: Assumption, given: Given) -> Any:
    """TOML value of an assumption; None if nothing can be assumed."""
    if not callable(one.value):
        return one.value
    with np.errstate(all="ignore"):
        value = one.value(given)
    if isinstance(value, float) and not math.isfinite(value):
        raise ValueError(f"{one.source}: the assumed value is not finite; give a value in the file")
    field = model.model_fields.get(one.name)
    if not isinstance(value, float) or field is None:
        return value
    unit = meta(field)["unit"]
    rounded = float(f"{value / units.factor(unit):.{DIGITS}g}")
    return rounded if unit == "1" else f"{rounded!r} {unit}"


def placeholder(model: type[Inputs], one: Assumption) -> Any:
    """TOML value that is used if a wrong input prevents the evaluation of the assumption `one`."""
    if not callable(one.value):
        return one.value
    field = model.model_fields.get(one.name)
    unit = "1" if field is None else meta(field)["unit"]
    default = None if field is None else field.default
    if not isinstance(default, float):
        return default if isinstance(default, int) else []
    return default if unit == "1" else f"{default / units.factor(unit)!r} {unit}"


def listed(model: type[Inputs], one: Assumption, raw: Any) -> Assumed:
    """Assumed input as lists display it, with its value in the display unit."""
    field = model.model_fields.get(one.name)
    about = {"symbol": "", "unit": "1"} if field is None else meta(field)
    value, unit = raw, about["unit"]
    if field is None or is_table(field):
        value, unit = _in_words(raw), "1"
    elif isinstance(raw, str) and kind_of(field) is float:
        value = float(f"{units.parse(raw, unit) / units.factor(unit):.15g}")
    return Assumed(name=one.name, symbol=about["symbol"] or one.name, value=value, unit=unit,
                   source=one.source)  # fmt: skip


def _in_words(raw: Any) -> str:
    """A list or a table as one line of text."""
    if not isinstance(raw, Sequence) or isinstance(raw, str):
        return str(raw)
    parts = [
        " ".join(f"{k} {v}" for k, v in entry.items()) if isinstance(entry, Mapping) else str(entry)
        for entry in raw
    ]
    return ", ".join(parts)
