"""Messages for all raw inputs whose values are wrong irrespective of the other inputs."""

import operator
from collections.abc import Mapping
from typing import Any

from pydantic.fields import FieldInfo

from verify.core.inputs import (
    REQUIRED,
    InputError,
    Inputs,
    beyond,
    bounds_of,
    entry_model,
    is_table,
    meta,
    value_of,
)

MISSING = "missing"
HOLDS = {"greater than": operator.gt, "at least": operator.ge, "less than": operator.lt,
         "at most": operator.le}  # fmt: skip


def wrong_values(model: type[Inputs], raw: Mapping[str, Any], table: str = "") -> dict[str, str]:
    """Messages by place ("r_i" or "supports[2].k"), worded like the messages of `inputs.build`.

    `table` is the place of an entry, such as "supports[2]."; required inputs that the entry omits
    have the message MISSING. Rules between several inputs are not checked.
    """
    found: dict[str, str] = {}
    for name, value in raw.items():
        field = model.model_fields.get(name)
        if field is None:
            continue
        if not is_table(field):
            if message := _wrong(field, f"{table}{name}", value):
                found[f"{table}{name}"] = message
            continue
        inner = entry_model(field)
        for k, entry in enumerate(value if isinstance(value, list) else (), start=1):
            if isinstance(entry, Mapping):
                place = f"{name}[{k}]."
                found |= _missing(inner, entry, place) | wrong_values(inner, entry, place)
    return found


def _missing(model: type[Inputs], entry: Mapping[str, Any], place: str) -> dict[str, str]:
    return {
        f"{place}{name}": MISSING
        for name, field in model.model_fields.items()
        if meta(field)["omitted"] == REQUIRED and name not in entry
    }


def _wrong(field: FieldInfo, place: str, raw: Any) -> str:
    """Error message for one value; "" if it is correct."""
    try:
        value = value_of(field, raw, place)
    except InputError as error:
        return str(error).removeprefix(f"{place}: ")
    if not isinstance(value, int | float):
        return ""
    unit = meta(field)["unit"]
    broken = [(word, bound) for word, bound in bounds_of(field) if not HOLDS[word](value, bound)]
    return beyond(place, value, *broken[0], unit) if broken else ""
