"""Inputs of a case: SI numbers with unit, symbol and bounds; from defaults or from a file.

A parameter file is TOML:

    case = "ring-lame"
    [inputs]
    r_i = "60 mm"
    nu = 0.3

An input may be a list of tables, [[inputs.supports]]; each entry is an object of a separate
subclass of `Inputs`.
"""

import math
import re
import tomllib
import types
from collections.abc import Mapping, Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Any, ClassVar, Literal, Union, get_args, get_origin

from pydantic import BaseModel, ConfigDict, Field, ValidationError
from pydantic.fields import FieldInfo

from verify.core import units
from verify.core.figures import InputValue

MAX_BYTES = 1_000_000
LARGEST_INTEGER = 10**15
LONGEST_NAME = 120
LONGEST_RULE = 400  # of a case's message on its inputs
ALIKE = 0.6  # of difflib's ratio: an unknown key may be meant as a known one
MOST_ENTRIES = 1000  # of a table
TOP_LEVEL = ("case", "name", "inputs")


class InputError(ValueError):
    """Error for a wrong input; the message is one line with file, key, rule and value."""


class EntryError(ValueError):
    """Error for a rule violated by one entry of a table, raised by the validator of a model.

    `entry` is numbered from 1. `key` is the input, empty if the rule applies to the whole entry.
    """

    def __init__(self, table: str, entry: int, key: str, rule: str) -> None:
        self.place = f"{table}[{entry}]" + (f".{key}" if key else "")
        super().__init__(f"{self.place}: {rule}")


class Inputs(BaseModel):
    """Base class of the inputs of all cases: frozen, no unknown keys, floats in SI units."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    # another set of inputs that templates offer: its title, and the TOML of its values by name
    instead: ClassVar[tuple[str, Mapping[str, str]]] = ("", {})

    def display(self) -> tuple[InputValue, ...]:
        """All inputs in their units, in the order of the class.

        Each entry of a table is one line.
        """
        found: list[InputValue] = []
        for name, field in type(self).model_fields.items():
            value, about = getattr(self, name), meta(field)
            if isinstance(value, tuple):
                found += [_entry(name, k, entry) for k, entry in enumerate(value, start=1)]
            elif value is not None:
                found.append(
                    InputValue(
                        name=name, symbol=about["symbol"] or name, what=about["what"],
                        value=_shown(value, about["unit"]), unit=about["unit"],
                    )
                )  # fmt: skip
        return tuple(found)

    def record(self) -> dict[str, Any]:
        """Inputs for other programs (name: value and unit).

        A table is a list of records.
        """
        found: dict[str, Any] = {}
        for name, field in type(self).model_fields.items():
            value, unit = getattr(self, name), meta(field)["unit"]
            if isinstance(value, tuple):
                found[name] = [entry.record() for entry in value]
            elif value is not None:
                found[name] = {"value": _shown(value, unit), "unit": unit}
        return found


def _entry(table: str, number: int, entry: Inputs) -> InputValue:
    """One entry of a table as a line, without inputs that have the value for omitted inputs."""
    parts = [
        f"{name} {value if isinstance(value, str) else _with_unit(value, meta(field)['unit'])}"
        for name, field in type(entry).model_fields.items()
        if (value := getattr(entry, name)) is not None and value != meta(field)["omitted"]
    ]
    return InputValue(
        name=f"{table}[{number}]", symbol=f"{table}[{number}]", what=", ".join(parts), value="",
        unit="1",
    )  # fmt: skip


REQUIRED = "required"
BOUNDS = {"gt": "greater than", "ge": "at least", "lt": "less than", "le": "at most"}


def quantity(
    default: str | float | None,
    unit: str,
    symbol: str,
    what: str,
    *,
    claims: str = "",
    omitted: float | str | None = REQUIRED,
    example: str = "",
    **bounds: float,
) -> Any:
    """Declaration of a float input in `unit`; the bounds gt, ge, lt, le are also in this unit.

    `default` is the number of the paper as text with its unit (a number if the unit is "1").
    `claims` is the printed value to which the default is equal ("paper:id"). `omitted` is the value
    if a parameter file omits the input; without `omitted`, the input is required. An input without
    a default has an `example` with its unit, for templates.
    """
    if isinstance(default, int | float) and unit != "1":
        raise ValueError(
            f'the default of {symbol} must have a unit: write it as "{default} {unit}"'
        )
    value = units.parse(default, unit) if isinstance(default, str) else default
    limits: dict[str, Any] = {k: bound * units.factor(unit) for k, bound in bounds.items()}
    return Field(
        default=value,
        json_schema_extra=_extra(unit, symbol, what, claims, omitted) | {"example": example},
        **limits,
    )


def count(default: int, symbol: str, what: str, *, claims: str = "", **bounds: int) -> Any:
    """Declaration of an integer input with the bounds gt, ge, lt, le."""
    limits: dict[str, Any] = dict(bounds)
    return Field(
        default=default, json_schema_extra=_extra("1", symbol, what, claims, REQUIRED), **limits
    )


def text(default: str | None, what: str, *, omitted: str | None = REQUIRED) -> Any:
    """Declaration of an input that is a text chosen by the user, printable and short."""
    return Field(default=default, json_schema_extra=_extra("1", "", what, "", omitted))


def table(default: tuple[Inputs, ...], what: str, *, required: bool = False) -> Any:
    """Declaration of an input that is a list of tables; the annotation is tuple[Model, ...].

    A file that omits the table gives an empty list, or an error if the table is `required`.
    """
    omitted: Any = REQUIRED if required else ()
    return Field(default=default, json_schema_extra=_extra("1", "", what, "", omitted))


def word(default: str, what: str) -> Any:
    """Declaration of an input that is one of several words; a file may omit it (then `default`)."""
    return Field(default=default, json_schema_extra=_extra("1", "", what, "", default))


def _extra(unit: str, symbol: str, what: str, claims: str, omitted: Any) -> dict[str, Any]:
    return {"unit": unit, "symbol": symbol, "what": what, "claims": claims, "omitted": omitted}


def meta(field: FieldInfo) -> dict[str, Any]:
    """Unit, symbol, description and other data of one input."""
    extra = field.json_schema_extra
    assert isinstance(extra, dict)
    return dict(extra)


def bounds_of(field: FieldInfo) -> list[tuple[str, float]]:
    """Bounds of an input, each as a word, such as "at least", and a value [SI]."""
    return [
        (word, getattr(bound, rule))
        for bound in field.metadata
        for rule, word in BOUNDS.items()
        if hasattr(bound, rule)
    ]


def read_parameter_file(path: Path) -> tuple[str, str, Mapping[str, Any]]:
    """Case id, name and raw inputs of a parameter file. Raises InputError if it cannot be read."""
    try:
        if path.is_dir():
            raise InputError(f"{path}: is a directory, expected a TOML file")
        if path.exists() and not path.is_file():
            raise InputError(f"{path}: is not a regular file, expected a TOML file")
        if path.stat().st_size > MAX_BYTES:
            raise InputError(
                f"{path}: a parameter file must not be larger than {MAX_BYTES:,} bytes"
            )
        text = path.read_bytes().decode("utf-8-sig")
        data = tomllib.loads(text)
    except (OSError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        reason = getattr(error, "strerror", None) or _one_line(str(error))
        if isinstance(error, UnicodeDecodeError):
            reason = f"not UTF-8 text (byte {error.start})"
        elif isinstance(error, tomllib.TOMLDecodeError):
            reason += _quotes(error, text)
        raise InputError(f"{path}: cannot be read: {reason}") from error
    except RecursionError as error:
        raise InputError(f"{path}: cannot be read: nested too deeply") from error
    if unknown := [key for key in data if key not in TOP_LEVEL]:
        hint = " (inputs belong under [inputs])" if "inputs" not in data else ""
        raise InputError(
            f"{path}: {_one_line(unknown[0])}: unknown key; known are {', '.join(TOP_LEVEL)}{hint}"
        )
    case, name, raw = data.get("case"), data.get("name", path.stem), data.get("inputs")
    if not isinstance(case, str):
        raise InputError(f'{path}: case: needs a line such as case = "ring-lame", {_got(case)}')
    if not isinstance(name, str):
        raise InputError(f"{path}: name: needs a text, {_got(name)}")
    if not name.strip() or len(name) > LONGEST_NAME or not name.isprintable():
        raise InputError(
            f"{path}: name: needs 1 to {LONGEST_NAME} printable characters, {_got(name)}"
        )
    if not isinstance(raw, dict):
        raise InputError(f"{path}: inputs: needs a table [inputs], {_got(raw)}")
    return case, name, raw


def _quotes(error: tomllib.TOMLDecodeError, text: str) -> str:
    """Advice for a value with a unit but without quotes (invalid TOML); "" for other errors."""
    place = re.search(r"at line (\d+)", str(error))
    line = text.split("\n")[int(place[1]) - 1] if place else ""
    bare = re.match(r"\s*([\w-]+)\s*=\s*([-+\d.][-+\d.eE]*\s*[A-Za-zµμ°%][^\"'#]*)", line)
    return f': quotes are missing, {bare[1]} = "{_one_line(bare[2])}"' if bare else ""


def build(model: type[Inputs], raw: Mapping[str, Any], where: str) -> Inputs:
    """Inputs from the raw values of a parameter file. Raises InputError for the first error."""
    return _built(model, raw, where, "inputs")


def _built(model: type[Inputs], raw: Mapping[str, Any], where: str, place: str) -> Inputs:
    """Inputs at `place`: "inputs", or an entry of a table such as "inputs.supports[2]"."""
    fields = model.model_fields
    if unknown := [key for key in raw if key not in fields]:
        raise InputError(
            f"{where}: {place}.{_one_line(unknown[0])}: unknown key; "
            f"{_meant(unknown[0], model)}known are {', '.join(fields)}"
        )
    left_out = {k: meta(f)["omitted"] for k, f in fields.items() if k not in raw}
    if needed := [k for k, omitted in left_out.items() if omitted == REQUIRED]:
        raise InputError(f"{where}: {place}: {missing(model, needed)}")
    values = {
        key: _entries(entry_model(fields[key]), raw[key], where, f"{place}.{key}")
        if is_table(fields[key])
        else value_of(fields[key], raw[key], f"{where}: {place}.{key}")
        for key in raw
    }
    try:
        return model(**values, **left_out)
    except ValidationError as error:
        raise InputError(f"{where}: {broken_rule(model, error, place)}") from error


def missing(model: type[Inputs], needed: Sequence[str]) -> str:
    """Text for required inputs that a file omits: their names, then their descriptions."""
    about = {name: meta(model.model_fields[name]) for name in needed}
    parts = [
        f"{name}: {one['what']}"
        + (f", symbol {one['symbol']}" if one["symbol"] not in ("", name) else "")
        + ("" if one["unit"] == "1" else f", in {one['unit']}")
        for name, one in about.items()
    ]
    return f"missing {', '.join(needed)} ({'; '.join(parts)})"


def _meant(key: str, model: type[Inputs]) -> str:
    """Question "did you mean ...?" about an unknown key; "" if no name or symbol is similar."""
    fields = {name: meta(field) for name, field in model.model_fields.items()}
    known = {one["symbol"].lower(): name for name, one in fields.items() if one["symbol"]}
    known |= {name.lower(): name for name in fields}
    like = get_close_matches(key.lower(), known, n=1, cutoff=ALIKE)
    if not like:
        return ""
    name = known[like[0]]
    return f"did you mean {name} ({fields[name]['what']})? "


def _entries(model: type[Inputs], raw: Any, where: str, place: str) -> tuple[Inputs, ...]:
    """Validated entries of a table; error messages number the entries from 1."""
    if not isinstance(raw, list) or not all(isinstance(entry, dict) for entry in raw):
        raise InputError(f"{where}: {place}: needs tables [[{place}]], {_got(raw)}")
    if len(raw) > MOST_ENTRIES:
        raise InputError(
            f"{where}: {place}: has {len(raw)} entries, but at most {MOST_ENTRIES} are permitted"
        )
    return tuple(
        _built(model, entry, where, f"{place}[{k}]") for k, entry in enumerate(raw, start=1)
    )


def value_of(field: FieldInfo, raw: Any, where: str) -> Any:
    """Convert a raw TOML value to the type of the input, without a check of its bounds.

    Raises InputError if the type, the unit or the dimension is wrong.
    """
    unit, kind = meta(field)["unit"], kind_of(field)
    if kind is float and isinstance(raw, str):
        try:
            return units.parse(raw, unit)
        except ValueError as error:
            raise InputError(f"{where}: {error}") from error
    if isinstance(raw, int) and abs(raw) > LARGEST_INTEGER:
        raise InputError(f"{where}: the integer {_text(raw)} is too large")
    if kind is float:
        if isinstance(raw, bool) or not isinstance(raw, int | float):
            raise InputError(f"{where}: needs {_wanted(unit)}, {_got(raw)}")
        if unit != "1":
            example = raw if math.isfinite(raw) else 1.5
            raise InputError(
                f'{where}: {raw} has no unit: needs {_wanted(unit)}, such as "{example} {unit}"'
            )
        if not math.isfinite(raw):
            raise InputError(f"{where}: {raw} is not finite")
        return float(raw)
    if kind is int and (isinstance(raw, bool) or not isinstance(raw, int)):
        raise InputError(f"{where}: needs a whole number, {_got(raw)}")
    if kind is str and choices(field) and raw not in choices(field):
        raise InputError(f"{where}: needs one of {', '.join(choices(field))}, {_got(raw)}")
    if kind is str and not (isinstance(raw, str) and raw.strip() and raw.isprintable()):
        raise InputError(f"{where}: needs a printable text, {_got(raw)}")
    if kind is str and len(raw) > LONGEST_NAME:
        raise InputError(f"{where}: needs at most {LONGEST_NAME} characters, {_got(raw)}")
    return raw


def is_table(field: FieldInfo) -> bool:
    """Whether an input is a list of tables."""
    return get_origin(field.annotation) is tuple


def entry_model(field: FieldInfo) -> type[Inputs]:
    """Class of the entries of a table, a subclass of `Inputs`."""
    found: type[Inputs] = get_args(field.annotation)[0]
    return found


def kind_of(field: FieldInfo) -> type:
    """Type of an input: float, int, str for words and texts, tuple for tables."""
    annotation = field.annotation
    if get_origin(annotation) is tuple:
        return tuple
    if get_origin(annotation) in (Union, types.UnionType):
        annotation = next(a for a in get_args(annotation) if a is not type(None))
    if get_origin(annotation) is Literal:
        return str
    assert isinstance(annotation, type)
    return annotation


def choices(field: FieldInfo) -> tuple[str, ...]:
    """Permitted words of an input that is a word; empty for other inputs."""
    return tuple(get_args(field.annotation)) if get_origin(field.annotation) is Literal else ()


def broken_rule(model: type[Inputs], wrong: ValidationError, place: str) -> str:
    """Text of the first error in inputs at `place`: `key = value unit: rule`."""
    error: Any = wrong.errors(include_url=False)[0]
    message = str(error["msg"]).removeprefix("Value error, ")
    if not error["loc"]:
        named = isinstance((error.get("ctx") or {}).get("error"), EntryError)
        return f"{place}{'.' if named else ': '}{_one_line(message, longest=LONGEST_RULE)}"
    name = str(error["loc"][0])
    unit = meta(model.model_fields[name])["unit"]
    for rule, bound in (error.get("ctx") or {}).items():
        if rule in BOUNDS:
            return f"{place}.{beyond(name, error['input'], BOUNDS[rule], bound, unit)}"
    return f"{place}.{name} = {_with_unit(error['input'], unit)}: {_one_line(message)}"


def beyond(name: str, value: Any, word: str, bound: float, unit: str) -> str:
    """Text which states that a value [SI] violates a bound [SI]; both are displayed in `unit`."""
    return f"{name} = {_with_unit(value, unit)}: must be {word} {_with_unit(bound, unit)}"


def _with_unit(value: Any, unit: str) -> str:
    if not isinstance(value, int | float):
        return _one_line(repr(value))
    return f"{value / units.factor(unit):.6g}" + ("" if unit == "1" else f" {unit}")


def _shown(value: Any, unit: str) -> Any:
    if isinstance(value, float):
        return float(f"{value / units.factor(unit):.15g}")  # no 19.439999999999998
    return value


def _wanted(unit: str) -> str:
    return units.DIMENSIONS.get(unit, f"a quantity in {unit}")


def _got(value: Any) -> str:
    return "it is missing" if value is None else f"got {_text(value)}"


def _text(value: Any) -> str:
    """A TOML value in one line; for integers with thousands of digits, a description."""
    if isinstance(value, int) and abs(value) > LARGEST_INTEGER:
        return f"an integer of {value.bit_length()} bits"
    try:
        return _one_line(repr(value))
    except ValueError:
        return "a list or table with an integer of thousands of digits"


def _one_line(text: str, *, longest: int = 120) -> str:
    line = " ".join("".join(c if c.isprintable() else " " for c in text).split())
    return line if len(line) <= longest else line[: longest - 1] + "…"
