"""The command `init`: a commented parameter file with the paper's numbers, made from the model."""

import sys
from collections.abc import Sequence
from io import TextIOWrapper
from pathlib import Path
from typing import Any

from pydantic.fields import FieldInfo

from verify import units
from verify.case import Case
from verify.cases.registry import find
from verify.inputs import (
    REQUIRED,
    InputError,
    Inputs,
    bounds_of,
    choices,
    entry_model,
    is_table,
    meta,
)
from verify.published.ledger import cited, published

HEAD = """\
# Parameters of the freewheel case {id}: {title}.
# The numbers are {whose}; put in your own, and then
#   freewheel check my.toml          formulas, with warnings where they leave their range
#   freewheel check --fem my.toml    and judged by finite elements on these parameters
# A value keeps its unit; any other unit of the same kind will do.

case = "{id}"
name = "my {id}"

[inputs]
"""
TASKS = ("design-spring", "design-sprag")
CHOSEN = "not printed, chosen for this suite"


def run_init(case_id: str, out: Path | None) -> int:
    """Print the template of a case, or write it to a file that does not exist yet."""
    try:
        case = find(case_id)
    except ValueError as error:
        raise InputError(f"{error}; tasks of design are {', '.join(TASKS)}") from error
    hand_over(template(case), out)
    return 0


def hand_over(text: str, out: Path | None) -> None:
    """Print a template, or write it to a file that does not exist yet."""
    if out is None:
        if isinstance(sys.stdout, TextIOWrapper):
            sys.stdout.reconfigure(encoding="utf-8")  # TOML is, whatever the terminal takes
        print(text, end="")
        return
    try:
        with out.open("x", encoding="utf-8") as file:
            file.write(text)
    except FileExistsError as error:
        raise InputError(f"{out}: exists already and is not overwritten") from error
    except OSError as error:
        raise InputError(f"{out}: cannot be written: {error.strerror}") from error


def template(case: Case) -> str:
    """A parameter file that builds to the paper's inputs."""
    printed = any(meta(field)["claims"] for field in case.inputs.model_fields.values())
    whose = f"the paper's ({cited(case.paper)})" if printed else "this project's own"
    head = HEAD.format(id=case.id, title=case.title, whose=whose)
    return head + aligned(commented(case.inputs)) + _instead(case.inputs) + _tables(case.inputs)


def _instead(model: type[Inputs]) -> str:
    """The other set of inputs, if any, each behind a #."""
    what, values = model.instead
    if not what:
        return ""
    return f"\n# Or {what}\n" + "".join(f"#   {name} = {text}\n" for name, text in values.items())


def _tables(model: type[Inputs]) -> str:
    """Every table: its first entry with all that may be said, the others in short."""
    found = ""
    for name, field in model.model_fields.items():
        if not is_table(field):
            continue
        own, about = entry_model(field), meta(field)
        optional = "" if about["omitted"] == REQUIRED else " Optional."
        found += f"\n# {about['what']}{optional}\n"
        entries = field.default or (own(),)
        hidden = "" if field.default else "# "
        for k, entry in enumerate(entries):
            lines = [(_assigned(n, f, getattr(entry, n)), _comment(n, f, ""))
                     for n, f in own.model_fields.items()]  # fmt: skip
            if k == 0:
                body = aligned(lines) + _instead(own)
            else:
                body = "".join(f"{line}\n" for line, _ in lines if not line.startswith("#"))
            text = f"[[inputs.{name}]]\n{body}"
            found += "".join(f"{hidden}{line}\n" for line in text.splitlines())
            found += "\n" if k + 1 < len(entries) else ""
    return found


def commented(model: type[Inputs]) -> list[tuple[str, str]]:
    """Every input but tables as its line of TOML, and what is to be said of it."""
    fields = [(n, f) for n, f in model.model_fields.items() if not is_table(f)]
    return [
        (_assigned(name, field, field.default), _comment(name, field)) for name, field in fields
    ]


def aligned(lines: Sequence[tuple[str, str]]) -> str:
    """Lines of TOML with their comments below each other."""
    width = max(len(text) for text, _ in lines)
    return "".join(f"{text:{width}}  # {comment}\n" for text, comment in lines)


def _assigned(name: str, field: FieldInfo, value: Any) -> str:
    """`r_i = "19.44 mm"`; behind a # where leaving it out gives the same inputs as well."""
    about = meta(field)
    unit, left_out = about["unit"], about["omitted"] != REQUIRED and about["omitted"] == value
    if value is None:
        if not about["example"]:
            raise ValueError(f"input {name} has no default: its quantity() needs an example")
        value = units.parse(about["example"], unit)
    return f"{'# ' if left_out else ''}{name} = {_literal(value, unit)}"


def _literal(value: Any, unit: str) -> str:
    """The shortest TOML value that reads as `value` [SI], of six digits or more."""
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, int) or unit == "1":
        return repr(value)
    texts = [f"{value / units.factor(unit):.{digits}g} {unit}" for digits in range(6, 18)]
    return f'"{next((t for t in texts if units.parse(t, unit) == value), texts[-1])}"'


def _comment(name: str, field: FieldInfo, chosen: str = CHOSEN) -> str:
    about = meta(field)
    symbol = f", {about['symbol']}" if about["symbol"] not in ("", name) else ""
    own = "" if field.default is None or field.default == about["omitted"] else chosen
    source = _source(about["claims"]) if about["claims"] else own
    parts = [f"{about['what']}{symbol}", _range(field), _omission(field), source]
    return "; ".join(part for part in parts if part)


def _range(field: FieldInfo) -> str:
    """What the value may be, in the unit of the input."""
    if choice := choices(field):
        return f"one of {', '.join(choice)}"
    if field.annotation is str:
        return "a text"
    unit = meta(field)["unit"]
    kind = "a whole number" if isinstance(field.default, int) else "a number"
    bounds = [f"{word} {_shown(bound, unit)}" for word, bound in bounds_of(field)]
    return " ".join(filter(None, (kind if unit == "1" else "", " and ".join(bounds))))


def _omission(field: FieldInfo) -> str:
    omitted, unit = meta(field)["omitted"], meta(field)["unit"]
    if omitted == REQUIRED:
        return ""
    if omitted is None:
        return "optional, not used if left out"
    meant = _shown(omitted, unit) if isinstance(omitted, float) else omitted
    return f"optional, {meant} if left out"


def _source(claim: str) -> str:
    """Where the paper prints it."""
    value = published(claim)
    unit = "" if value.unit == "1" else f" {value.unit}"
    return f"{claim.partition(':')[0]}, {value.place}: {value.printed}{unit}"


def _shown(value: float, unit: str) -> str:
    return f"{value / units.factor(unit):.6g}" + ("" if unit == "1" else f" {unit}")
