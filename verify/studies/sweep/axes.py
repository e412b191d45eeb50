"""Varied inputs: axes of a grid and tolerances of a sample, from the command line.

z=3:12:10                 ten whole numbers
delta_1=2mm:6mm:9         nine values, evenly spaced
b=0.2mm:2mm:10:log        ten values, logarithmically spaced
E=190GPa,210GPa           these two values
supports[2].k=1e7N/m:1e9N/m:5:log
delta_1=±0.05mm, E=±5%    uniformly distributed within these limits
"""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from pydantic import ValidationError
from pydantic.fields import FieldInfo

from verify.core import units
from verify.core.inputs import InputError, Inputs, broken_rule, entry_model, is_table, kind_of, meta

MOST_VALUES = 1000  # of one axis
_PLACE = re.compile(r"(?P<table>\w+)\[(?P<entry>\d+)\]\.(?P<key>\w+)")
_UNIT = re.compile(r"[A-Za-zµμ°].*$")
_SHARE = re.compile(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*%")


@dataclass(frozen=True)
class Axis:
    """A varied input with its values [SI] in ascending order.

    `name` is the name of the input in the parameter file.
    """

    name: str
    symbol: str
    unit: str
    what: str
    values: tuple[float, ...]
    nominal: float | None
    spacing: str = "even"
    whole: bool = False  # whole numbers only

    def in_unit(self, value: float) -> float:
        """`value` [SI] in the unit of the axis, rounded to 12 digits."""
        return float(f"{value / units.factor(self.unit):.12g}")


@dataclass(frozen=True)
class Tolerance:
    """An input that is uniformly distributed within its nominal value ± `off` [SI]."""

    name: str
    symbol: str
    unit: str
    what: str
    nominal: float
    off: float

    def in_unit(self, value: float) -> float:
        """`value` [SI] in the unit of the input, rounded to 12 digits."""
        return float(f"{value / units.factor(self.unit):.12g}")


def axis(inputs: Inputs, text: str) -> Axis:
    """Axis that a text such as "z=3:12:10" describes.

    Raises InputError if the text describes no valid axis.
    """
    where = f"--vary {text}"
    name, _, given = text.partition("=")
    field, nominal = _field(inputs, name.strip(), where)
    about, whole = meta(field), kind_of(field) is int
    if "," in given:
        parts = _with_units([part.strip() for part in given.split(",")])
        values = [_number(part, about["unit"], where, whole=whole) for part in parts]
        spacing = "as given"
    else:
        values, spacing = _spaced(given, about["unit"], where, whole=whole)
    if len(set(values)) < len(values):
        raise InputError(f"{where}: all values must be different")
    return Axis(
        name=name.strip(), symbol=_symbol(name.strip(), about["symbol"]), unit=about["unit"],
        what=about["what"], values=tuple(sorted(values)), nominal=nominal, spacing=spacing,
        whole=whole,
    )  # fmt: skip


def tolerance(inputs: Inputs, text: str) -> Tolerance:
    """Tolerance that a text such as "b=±0.05mm" describes.

    Raises InputError if the text describes no valid tolerance.
    """
    where = f"--tolerance {text}"
    name, _, given = text.partition("=")
    field, nominal = _field(inputs, name.strip(), where)
    if kind_of(field) is int:
        raise InputError(f"{where}: {name.strip()} is a whole number and cannot have a tolerance")
    if nominal is None:
        raise InputError(f"{where}: the file must give a nominal value of {name.strip()}")
    about = meta(field)
    bare = re.sub(r"^\s*(±|\+-|\+/-)?\s*", "", given)
    if share := _SHARE.fullmatch(bare.strip()):
        off = abs(nominal) * float(share[1]) / 100
    else:
        try:
            off = _number(bare, about["unit"], where, whole=False)
        except InputError as error:
            raise InputError(
                f'{error}, nor a percentage of {name.strip()}, such as "5 %"'
            ) from error
    if not 0 < off < math.inf:
        raise InputError(f"{where}: the tolerance must be positive and finite, got {given.strip()}")
    for end in (nominal - off, nominal + off):
        try:
            changed(inputs, {name.strip(): end})
        except InputError as error:
            raise InputError(f"{where}: the tolerance reaches an invalid value: {error}") from error
    return Tolerance(
        name=name.strip(), symbol=_symbol(name.strip(), about["symbol"]), unit=about["unit"],
        what=about["what"], nominal=nominal, off=off,
    )  # fmt: skip


def _symbol(name: str, symbol: str) -> str:
    """Symbol of the input; in a table, followed by the entry of the table: "k of supports[2]"."""
    if place := _PLACE.fullmatch(name):
        return f"{symbol or place['key']} of {place['table']}[{place['entry']}]"
    return symbol or name


def changed(inputs: Inputs, values: Mapping[str, float], at: str = "inputs") -> Inputs:
    """The inputs with changed values [SI] (name: value).

    Raises InputError if the changed inputs are invalid; `at` states the position of the inputs in
    the message.
    """
    model = type(inputs)
    given: dict[str, Any] = {name: getattr(inputs, name) for name in model.model_fields}
    for name, value in values.items():
        if place := _PLACE.fullmatch(name):
            entries = list(given[place["table"]])
            k = int(place["entry"]) - 1
            there = f"{at}.{place['table']}[{place['entry']}]"
            entries[k] = changed(entries[k], {place["key"]: value}, there)
            given[place["table"]] = tuple(entries)
        else:
            whole = kind_of(model.model_fields[name]) is int
            given[name] = round(value) if whole else float(value)
    try:
        return model(**given)
    except ValidationError as error:
        raise InputError(broken_rule(model, error, at)) from error


def _field(inputs: Inputs, name: str, where: str) -> tuple[FieldInfo, float | None]:
    """Field of the numerical input `name`, and its value in the file or None.

    Raises InputError if there is no such input or if it is not a number.
    """
    if not name:
        raise InputError(f"{where}: the name of the input is missing, such as z in z=3:12:10")
    place = _PLACE.fullmatch(name)
    holder: Inputs = inputs
    if place:
        entries = getattr(inputs, place["table"], None)
        if not isinstance(entries, tuple) or not 1 <= int(place["entry"]) <= len(entries):
            raise InputError(f"{where}: the file contains no {name.partition('.')[0]}")
        holder = entries[int(place["entry"]) - 1]
    key = place["key"] if place else name
    fields = type(holder).model_fields
    if key not in fields or is_table(fields[key]):
        known = ", ".join(names(inputs))
        raise InputError(f"{where}: unknown input {name}; inputs that can be varied: {known}")
    if kind_of(fields[key]) not in (int, float):
        raise InputError(f"{where}: {name} takes a word; only inputs with numbers can be varied")
    value = getattr(holder, key)
    return fields[key], None if value is None else float(value)


def names(inputs: Inputs) -> Sequence[str]:
    """Names of the inputs that are numbers.

    For a table, the list contains the keys of the first entry, as "table[1].key".
    """
    found: list[str] = []
    for name, field in type(inputs).model_fields.items():
        if is_table(field):
            keys = entry_model(field).model_fields
            if getattr(inputs, name):
                found += [f"{name}[1].{k}" for k, f in keys.items() if kind_of(f) in (int, float)]
        elif kind_of(field) in (int, float):
            found.append(name)
    return found


def _spaced(given: str, unit: str, where: str, *, whole: bool) -> tuple[list[float], str]:
    parts = [part.strip() for part in given.split(":")]
    if not 3 <= len(parts) <= 4 or (len(parts) == 4 and parts[3] != "log"):
        raise InputError(
            f"{where}: write NAME=a:b:n, NAME=a:b:n:log or NAME=a,b,c, such as z=3:12:10"
        )
    if not parts[2].isdecimal() or not 2 <= int(parts[2]) <= MOST_VALUES:
        raise InputError(f"{where}: n must be an integer from 2 to {MOST_VALUES}, got {parts[2]!r}")
    ends = _with_units(parts[:2])
    a, b = (_number(part, unit, where, whole=whole) for part in ends)
    if len(parts) == 4 and min(a, b) <= 0:
        raise InputError(f"{where}: with log, both ends must be positive")
    spread = np.geomspace if len(parts) == 4 else np.linspace
    values = [float(v) for v in spread(a, b, int(parts[2]))]
    values[0], values[-1] = a, b
    if whole and any(abs(v - round(v)) > 1e-9 for v in values):
        raise InputError(
            f"{where}: this input takes whole numbers only, but {parts[2]} values from {a:g} "
            f"to {b:g} include fractions: change the number of values"
        )
    return [float(round(v)) if whole else v for v in values], "log" if len(parts) == 4 else "even"


def _with_units(parts: Sequence[str]) -> Sequence[str]:
    """Numbers with units; the unit of the last number is the default: 2:6mm is 2mm:6mm."""
    of_last = _UNIT.search(parts[-1])
    return [part if _UNIT.search(part) or not of_last else part + of_last[0] for part in parts]


def _number(text: str, unit: str, where: str, *, whole: bool) -> float:
    try:
        value = units.parse(text.strip(), unit)
    except ValueError as error:
        raise InputError(f"{where}: {error}") from error
    if whole and value != round(value):
        raise InputError(f"{where}: values must be whole numbers, got {text.strip()}")
    return value
