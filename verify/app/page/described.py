"""Data of a case's inputs that a form needs, as plain data."""

import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from verify.answers.assumed.registry import ASSUMPTIONS
from verify.answers.template import template
from verify.app.page.toml_text import as_texts
from verify.cases.registry import find
from verify.core import units
from verify.core.case import Case
from verify.core.inputs import (
    REQUIRED,
    InputError,
    Inputs,
    bounds_of,
    choices,
    entry_model,
    is_table,
    kind_of,
    meta,
)


@dataclass(frozen=True, kw_only=True)
class Field:
    """One input: `rule` states its range; a table has the `fields` of its entries."""

    name: str
    symbol: str
    unit: str
    what: str
    rule: str
    needed: bool
    whole: bool = False
    words: tuple[str, ...] = ()
    takes: str = ""
    fields: tuple["Field", ...] = ()
    is_table: bool = False

    @property
    def is_number(self) -> bool:
        """Whether a sweep can vary the input."""
        return not self.is_table and not self.words and bool(self.takes)


@dataclass(frozen=True, kw_only=True)
class Described:
    """A case as a form shows it.

    `raw` are the inputs of the template of the case. `outputs` are keys and texts of the values of
    its formulas.
    """

    id: str
    title: str
    fields: tuple[Field, ...]
    raw: Mapping[str, Any]
    outputs: tuple[tuple[str, str], ...]
    method: str

    @property
    def whole(self) -> frozenset[str]:
        """Names of the inputs that are whole numbers, including those in tables."""
        every = [f for field in self.fields for f in (field, *field.fields)]
        return frozenset(field.name for field in every if field.whole)

    def entered(self, place: str, text: str) -> str:
        """Text that the user typed for an input; a bare number gets the unit of the form."""
        table, _, key = place.rpartition("].")
        fields = self.fields
        if table:
            fields = next((f.fields for f in fields if f.name == table.partition("[")[0]), ())
        unit = next((f.unit for f in fields if f.name == (key or place)), "1")
        return text if unit == "1" or not units.is_bare(text) else f"{text.strip()} {unit}"

    def refuse_shapes(self, raw: Mapping[str, Any]) -> None:
        """Raise InputError if the raw value of a table is not a list of entries."""
        for table in (f.name for f in self.fields if f.is_table and f.name in raw):
            entries = raw[table]
            if not isinstance(entries, list) or not all(isinstance(e, Mapping) for e in entries):
                raise InputError(f"inputs.{table}: needs tables [[inputs.{table}]]")


def describe(case_name: str, _notify: Callable[[Any], None] = print) -> Described:
    """Form of a case, given by its name or its file. Raises InputError or ValueError."""
    case = find(case_name)
    assumable = {one.name for one in ASSUMPTIONS.get(case.id, ())}
    return Described(
        id=case_name, title=case.title, fields=_fields(case.inputs, assumable),
        raw=as_texts(tomllib.loads(template(case))["inputs"]),
        outputs=tuple((o.key, _named(o.symbol, o.label, o.unit)) for o in case.outputs),
        method=case.method.case,
    )  # fmt: skip


def model_of(case: Case) -> Mapping[str, str]:
    """Names of a case's inputs by symbol; an input without a symbol has its name as key."""
    return {meta(f)["symbol"] or n: n for n, f in case.inputs.model_fields.items()}


def _fields(model: type[Inputs], assumable: set[str]) -> tuple[Field, ...]:
    found = []
    for name, field in model.model_fields.items():
        about = meta(field)
        needed = about["omitted"] == REQUIRED and name not in assumable
        if is_table(field):
            found.append(Field(
                name=name, symbol="", unit="1", what=about["what"], rule="", needed=needed,
                fields=_fields(entry_model(field), set()), is_table=True,
            ))  # fmt: skip
            continue
        kind = kind_of(field)
        found.append(Field(
            name=name, symbol=about["symbol"], unit=about["unit"], what=about["what"],
            rule=_rule(bounds_of(field), about["unit"]), needed=needed, whole=kind is int,
            words=choices(field), takes=_takes(kind, about["unit"]),
        ))  # fmt: skip
    return tuple(found)


def _rule(bounds: list[tuple[str, float]], unit: str) -> str:
    """Text of the permitted range, without a line break between a number and its unit."""
    shown = "" if unit == "1" else f" {unit}".replace(" ", "\u00a0")
    return ", ".join(
        f"{word} {limit / units.factor(unit):.6g}{shown}".replace("e+0", "e")
        for word, limit in bounds
    )


def _takes(kind: type, unit: str) -> str:
    if kind is int:
        return "a whole number"
    if kind is float:
        return units.TAKEN.get(unit, "a number" if unit == "1" else unit)
    return ""


def _named(symbol: str, what: str, unit: str) -> str:
    return f"{symbol}: {what}" + ("" if unit == "1" else f" [{unit}]")
