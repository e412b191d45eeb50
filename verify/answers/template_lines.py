"""Lines of a template: each input with its value, description, range and source."""

import re
from collections.abc import Mapping, Sequence
from textwrap import wrap
from typing import Any

from pydantic.fields import FieldInfo

from verify.answers.assumed.rules import Assumption
from verify.core import units
from verify.core.inputs import REQUIRED, Inputs, bounds_of, choices, is_table, meta
from verify.papers.ledger import published

WIDTH = 98  # of 100: each line of a table without a default begins with a further #
NUMBER_AND_UNIT = re.compile(r"(?<=\d) (?=[^\W\d])")
UNBROKEN = "\N{NO-BREAK SPACE}"
CHOSEN = "not printed, chosen for this suite"
OPTIONAL = "# Optional: if omitted, this value, unless the line states another; {whose} numbers"
UNUSED = "optional; if left out: not used, or a standard value that the answer states"
EXAMPLES = "# Also optional: examples of inputs that are not among {whose} numbers"


def sections(
    model: type[Inputs],
    assumptions: Sequence[Assumption],
    whose: str,
    *,
    also: Sequence[str] = (),
    more: Sequence[tuple[str, str]] = (),
) -> str:
    """Lines with the required inputs; then, each after a #, the optional inputs and the examples.

    `whose` states the origin of the numbers, such as "the paper's". `also` names optional inputs
    that are listed with the required ones; `more` contains further optional lines.
    """
    known = {one.name: one for one in assumptions}
    fields = {n: f for n, f in model.model_fields.items() if not is_table(f)}
    needed = [
        n for n, f in fields.items()
        if n in also or (meta(f)["omitted"] == REQUIRED and n not in known)
    ]  # fmt: skip
    optional = [n for n, f in fields.items() if n not in needed and f.default is not None]
    examples = [n for n, f in fields.items() if n not in needed and f.default is None]

    def hidden(names: Sequence[str]) -> list[tuple[str, str]]:
        return [_hidden(n, fields[n], known) for n in names]

    text = aligned([_line(n, fields[n], known) for n in needed])
    text += f"\n{OPTIONAL.format(whose=whose)}\n{aligned([*hidden(optional), *more])}"
    if examples:
        text += f"\n{EXAMPLES.format(whose=whose)}\n{aligned(hidden(examples))}"
    return text


def _line(name: str, field: FieldInfo, known: Mapping[str, Assumption]) -> tuple[str, str]:
    text, about = assigned(name, field, field.default), comment(name, field)
    if name in known:
        assumed = if_left_out(known[name])
        match meta(field)["omitted"]:
            case None:
                about = about.replace(UNUSED, assumed)
            case omitted if omitted == REQUIRED:
                about += f"; {assumed}"
            case _:  # `comment` has stated the value
                about += f"; assumed: {known[name].source}"
    return text, about


def _hidden(name: str, field: FieldInfo, known: Mapping[str, Assumption]) -> tuple[str, str]:
    """Assignment of an input, after a #, and its comment."""
    text, about = _line(name, field, known)
    return f"# {text.removeprefix('# ')}", about


def if_left_out(one: Assumption) -> str:
    """Comment for an optional input: its assumed value and the source."""
    value = "" if callable(one.value) else f" {one.value}"
    return f"optional; if left out{value}: {one.source}"


def commented(model: type[Inputs], chosen: str = CHOSEN) -> list[tuple[str, str]]:
    """Assignment and comment of every input that is not a table."""
    fields = [(n, f) for n, f in model.model_fields.items() if not is_table(f)]
    return [
        (assigned(name, field, field.default), comment(name, field, chosen))
        for name, field in fields
    ]


def aligned(lines: Sequence[tuple[str, str]]) -> str:
    """Lines of TOML with aligned comments; a long comment continues on the next line.

    If a line begins with a #, its continuation also begins with a #, so that an editor can
    uncomment all lines at once.
    """
    width = max(len(text) for text, _ in lines)
    found = ""
    for text, about in lines:
        first, *rest = _wrapped(about, WIDTH - width - len("  #   "))
        found += f"{text:{width}}  # {first}\n"
        hidden = "#" if text.startswith("#") else ""
        found += "".join(f"{hidden:{width}}  #   {line}\n" for line in rest)
    return found


def remark(text: str) -> str:
    """A comment as separate lines of at most `WIDTH` columns."""
    return "".join(f"# {line}\n" for line in _wrapped(text, WIDTH - len("# ")))


def _wrapped(text: str, width: int) -> list[str]:
    """Lines of at most `width` columns; a number and its unit are not separated."""
    lines = wrap(NUMBER_AND_UNIT.sub(UNBROKEN, text), width, break_on_hyphens=False)
    return [line.replace(UNBROKEN, " ") for line in lines]


def assigned(name: str, field: FieldInfo, value: Any) -> str:
    """Assignment such as `r_i = "19.44 mm"`; after a # if `value` is that of an omitted input."""
    about = meta(field)
    unit, left_out = about["unit"], about["omitted"] != REQUIRED and about["omitted"] == value
    if value is None:
        if not about["example"]:
            raise ValueError(f"input {name} has no default: give its quantity() an example")
        value = units.parse(about["example"], unit)
    return f"{'# ' if left_out else ''}{name} = {_literal(value, unit)}"


def _literal(value: Any, unit: str) -> str:
    """Shortest TOML value that is read as `value` [SI], rounded to six or more digits."""
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, int) or unit == "1":
        return repr(value)
    texts = [f"{value / units.factor(unit):.{digits}g} {unit}" for digits in range(6, 18)]
    return f'"{next((t for t in texts if units.parse(t, unit) == value), texts[-1])}"'


def comment(name: str, field: FieldInfo, chosen: str = CHOSEN) -> str:
    about = meta(field)
    symbol = f", {about['symbol']}" if about["symbol"] not in ("", name) else ""
    own = "" if field.default is None or field.default == about["omitted"] else chosen
    source = _source(about["claims"]) if about["claims"] else own
    parts = [f"{about['what']}{symbol}", _range(field), _omission(field), source]
    return "; ".join(part for part in parts if part)


def _range(field: FieldInfo) -> str:
    """Text of the permitted values, in the unit of the input."""
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
        return UNUSED
    meant = _shown(omitted, unit) if isinstance(omitted, float) else omitted
    return f"optional, {meant} if left out"


def _source(claim: str) -> str:
    """Text of the place in the paper where the input is printed."""
    value = published(claim)
    unit = "" if value.unit == "1" else f" {value.unit}"
    return f"{claim.partition(':')[0]}, {value.place}: {value.printed}{unit}"


def _shown(value: float, unit: str) -> str:
    return f"{value / units.factor(unit):.6g}" + ("" if unit == "1" else f" {unit}")
