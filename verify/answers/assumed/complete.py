"""Completion of the inputs of a file by assumed values for omitted inputs."""

import re
from collections.abc import Mapping
from typing import Any

from verify.answers.assumed.registry import ASSUMPTIONS
from verify.answers.assumed.rules import Assumed, NotGivenError
from verify.answers.assumed.values import given_values, listed, placeholder, raw_value, read_value
from verify.core.inputs import REQUIRED, InputError, Inputs, build, meta, missing


def complete(
    case_id: str, model: type[Inputs], raw: Mapping[str, Any], where: str
) -> tuple[dict[str, Any], tuple[Assumed, ...]]:
    """Raw inputs completed by assumed values, and the assumed inputs.

    Given values are unchanged. Raises InputError with a list of the omitted inputs for which
    nothing can be assumed.
    """
    assumptions = ASSUMPTIONS.get(case_id)
    if assumptions is None:
        return dict(raw), ()
    _refuse_missing(model, raw, {one.name for one in assumptions}, where)
    given, readable = given_values(model, raw)
    whole, found = dict(raw), []
    for one in assumptions:
        if one.name in raw:
            continue
        try:
            value = raw_value(model, one, given) if readable else placeholder(model, one)
        except (NotGivenError, ValueError, ArithmeticError, TypeError, KeyError) as error:
            if isinstance(error, ValueError):
                raise InputError(f"{where}: inputs: {error}") from error
            value = placeholder(model, one)  # `build` refuses the file for another input
        if value is None:  # nothing can be assumed, such as a limit of an unknown material
            continue
        whole[one.name] = value
        given[one.name] = read_value(model, one.name, value)
        found.append(listed(model, one, value))
    return whole, tuple(found)


def assumed_inputs(
    case_id: str, model: type[Inputs], raw: Mapping[str, Any], where: str = "inputs"
) -> tuple[Assumed, ...]:
    """Assumed inputs for the raw inputs of a file."""
    return complete(case_id, model, raw, where)[1]


def build_completed(
    case_id: str, model: type[Inputs], raw: Mapping[str, Any], where: str
) -> tuple[Inputs, tuple[Assumed, ...]]:
    """Validated inputs of a file, and the assumed inputs.

    Raises InputError for the first error. If the error involves assumed inputs, the message lists
    them.
    """
    whole, assumed = complete(case_id, model, raw, where)
    try:
        return build(model, whole, where), assumed
    except InputError as error:
        message = str(error).partition(": unknown key")[0]  # which lists every input
        named = [a for a in assumed if re.search(rf"\b{re.escape(a.name)}\b", message)]
        if not named:
            raise
        texts = ", ".join(f"{a.text} ({a.source})" for a in named)
        raise InputError(f"{error}; assumed: {texts}") from error


def _refuse_missing(
    model: type[Inputs], raw: Mapping[str, Any], assumable: set[str], where: str
) -> None:
    """Raise InputError if the file omits required inputs for which nothing can be assumed.

    If the file contains an unknown key, `build` reports that key instead.
    """
    fields = model.model_fields
    if any(key not in fields and key not in assumable for key in raw):
        return  # `build` reports the error
    needed = [
        name for name, field in fields.items()
        if meta(field)["omitted"] == REQUIRED and name not in raw and name not in assumable
    ]  # fmt: skip
    if needed:
        raise InputError(f"{where}: inputs: {missing(model, needed)}")
