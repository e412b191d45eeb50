"""The inputs of a file together with those that it leaves out and that have an assumption."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from verify import units
from verify.assumed.registry import ASSUMPTIONS
from verify.assumed.rules import Assumed, Assumption, Given, NotGivenError
from verify.inputs import (
    LARGEST_INTEGER,
    REQUIRED,
    InputError,
    Inputs,
    bounds_of,
    build,
    is_table,
    kind_of,
    meta,
)

DIGITS = 6  # of a derived value, so that what is printed is what is computed with


def complete(
    case_id: str, model: type[Inputs], raw: Mapping[str, Any], where: str
) -> tuple[dict[str, Any], tuple[Assumed, ...]]:
    """Raw inputs with the assumed ones added, and what was assumed; a given value is never changed.

    InputError names the inputs that are missing and have no assumption.
    """
    assumptions = ASSUMPTIONS.get(case_id)
    if assumptions is None:
        return dict(raw), ()
    _refuse_missing(model, raw, {one.name for one in assumptions}, where)
    given, readable = _given(model, raw)
    whole, found = dict(raw), []
    for one in assumptions:
        if one.name in raw:
            continue
        try:
            value = _raw_value(model, one, given) if readable else _placeholder(model, one)
        except (NotGivenError, ValueError, ArithmeticError, TypeError, KeyError) as error:
            if isinstance(error, ValueError):
                raise InputError(f"{where}: inputs: {one.name} does not follow: {error}") from error
            value = _placeholder(model, one)  # `build` refuses the file for another input
        whole[one.name] = value
        given[one.name] = _read(model, one.name, value)
        found.append(_assumed(model, one, value))
    return whole, tuple(found)


def assumed_inputs(
    case_id: str, model: type[Inputs], raw: Mapping[str, Any], where: str = "inputs"
) -> tuple[Assumed, ...]:
    """What is assumed for the raw inputs of a file."""
    return complete(case_id, model, raw, where)[1]


def build_completed(
    case_id: str, model: type[Inputs], raw: Mapping[str, Any], where: str
) -> tuple[Inputs, tuple[Assumed, ...]]:
    """The inputs of a file, and which of them were assumed.

    InputError for the first fault; where it is about assumed inputs, it lists them.
    """
    whole, assumed = complete(case_id, model, raw, where)
    try:
        return build(model, whole, where), assumed
    except InputError as error:
        named = [a for a in assumed if re.search(rf"\b{re.escape(a.name)}\b", str(error))]
        if not named:
            raise
        texts = ", ".join(f"{a.text} ({a.source})" for a in named)
        raise InputError(f"{error}; assumed: {texts}") from error


def _refuse_missing(
    model: type[Inputs], raw: Mapping[str, Any], assumable: set[str], where: str
) -> None:
    """InputError for required inputs that nothing is assumed for, unless a key is unknown."""
    fields = model.model_fields
    if any(key not in fields and key not in assumable for key in raw):
        return  # `build` says what is wrong
    needed = [
        name for name, field in fields.items()
        if meta(field)["omitted"] == REQUIRED and name not in raw and name not in assumable
    ]  # fmt: skip
    if needed:
        raise InputError(f"{where}: inputs: missing {', '.join(needed)}")


def _given(model: type[Inputs], raw: Mapping[str, Any]) -> tuple[Given, bool]:
    """Values in SI units by name, those of omitted inputs too, and whether all could be read."""
    fields, found, readable = model.model_fields, Given(), True
    for name, field in fields.items():
        omitted = meta(field)["omitted"]
        if name in raw:
            try:
                found[name] = _read(model, name, raw[name])
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


def _read(model: type[Inputs], name: str, value: Any) -> Any:
    """A TOML value in SI units; ValueError where it has no or another unit."""
    if name not in model.model_fields or is_table(model.model_fields[name]):
        return value
    field = model.model_fields[name]
    kind, unit = kind_of(field), meta(field)["unit"]
    if kind is float and isinstance(value, str):
        return units.parse(value, unit)
    if kind not in (int, float):
        return value
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise ValueError(f"{name} needs a number")
    if (kind is float and unit != "1") or not abs(value) <= LARGEST_INTEGER:
        raise ValueError(f"{name} needs a number in {unit}")
    return value


def si_value(model: type[Inputs], one: Assumption, rule: Any, given: Given) -> Any:
    """The value [SI] of an assumption by its `value`, or by one end of its `usual` range."""
    return _read(model, one.name, _raw_value(model, replace(one, value=rule), given))


def _raw_value(model: type[Inputs], one: Assumption, given: Given) -> Any:
    """The TOML value of an assumption."""
    if not callable(one.value):
        return one.value
    value = one.value(given)
    field = model.model_fields.get(one.name)
    if not isinstance(value, float) or field is None:
        return value
    unit = meta(field)["unit"]
    shown = float(f"{value / units.factor(unit):.{DIGITS}g}")
    return shown if unit == "1" else f"{shown!r} {unit}"


def _placeholder(model: type[Inputs], one: Assumption) -> Any:
    if not callable(one.value):
        return one.value
    field = model.model_fields.get(one.name)
    unit = "1" if field is None else meta(field)["unit"]
    default = None if field is None else field.default
    if not isinstance(default, float):
        return default if isinstance(default, int) else []
    return default if unit == "1" else f"{default / units.factor(unit)!r} {unit}"


def _assumed(model: type[Inputs], one: Assumption, raw: Any) -> Assumed:
    """The assumption as it is listed, in the display unit of its input."""
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
    """A list or a range in one line."""
    if not isinstance(raw, Sequence) or isinstance(raw, str):
        return str(raw)
    parts = [
        " ".join(f"{k} {v}" for k, v in entry.items()) if isinstance(entry, Mapping) else str(entry)
        for entry in raw
    ]
    return ", ".join(parts)
