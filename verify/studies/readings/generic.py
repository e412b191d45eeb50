"""Readings (interpretations) for the formulas of any case, for each kind of input."""

from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError

from verify.core import units
from verify.core.case import Case
from verify.core.inputs import Inputs, kind_of, meta
from verify.papers.digits import half_last_digit
from verify.papers.ledger import published
from verify.studies.readings.readings import angle, count, elastic, length, result
from verify.studies.readings.search import Reading


def numbers(inputs: Inputs) -> dict[str, Any]:
    """Numerical inputs in SI units (name: value)."""
    return {
        name: value
        for name in type(inputs).model_fields
        if isinstance(value := getattr(inputs, name), int | float) and not isinstance(value, bool)
    }


def readings(inputs: Inputs) -> tuple[Reading, ...]:
    """Readings of lengths, angles, counts and elastic constants in `inputs`, and of the result."""
    found: list[Reading] = []
    known = numbers(inputs)
    for name, field in type(inputs).model_fields.items():
        if name not in known:
            continue
        unit, symbol = meta(field)["unit"], meta(field)["symbol"] or name
        if kind_of(field) is int:
            found += count(name, symbol)
        elif unit in ("deg", "rad"):
            found += angle(name, symbol)
        elif units.dimensions(unit) == units.dimensions("mm"):
            found += length(name, symbol)
    if {"E", "nu"} <= set(known):
        found += elastic("E", "nu")
    return (*found, *result())


def value_of(case: Case, inputs: Inputs, changed: Mapping[str, Any], key: str) -> float:
    """Value [SI] of the formula `key`, evaluated with `inputs` after replacing those in `changed`.

    Raises ValueError if the changed inputs are invalid.
    """
    try:
        model = type(inputs)(**{**dict(inputs), **changed})
    except ValidationError as error:
        raise ValueError(str(error)) from error
    return float(case.analytic(model)[key])


def printed_rounding(inputs: Inputs) -> dict[str, float]:
    """Half a unit of the last printed place [SI], for each input that a paper prints."""
    found = {}
    for name, field in type(inputs).model_fields.items():
        reference = meta(field)["claims"]
        if reference and kind_of(field) is float and getattr(inputs, name) is not None:
            entry = published(reference)
            found[name] = half_last_digit(entry.printed) * units.factor(entry.unit)
    return found
