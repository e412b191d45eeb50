"""Units of an answer: those of the case (mm, N, MPa), SI base units, or inch and pound-force."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, Literal, TypeVar

from verify import units
from verify.assumed.rules import Assumed
from verify.case import Output
from verify.dynamic import DynamicResult
from verify.results import CaseResult, Grid, Row
from verify.shown import FormulaValue, InputValue

System = Literal["si", "mm", "inch"]
Shown = TypeVar("Shown", FormulaValue, InputValue, Assumed)

# No unit on the right of a map stands on its left: converting twice changes nothing.
DISPLAYED: Mapping[System, Mapping[str, str]] = {
    "mm": {},
    "si": {
        "mm": "m", "µm": "m", "nm": "m", "MPa": "Pa", "GPa": "Pa", "kN": "N", "N/mm": "N/m",
        "N/µm": "N/m", "1/mm": "1/m", "deg": "rad", "deg/mm": "rad/m", "ms": "s",
        "r/min": "rad/s", "g mm": "kg m", "µJ/m": "J/m",
    },
    "inch": {
        "mm": "in", "µm": "mil", "nm": "mil", "MPa": "ksi", "GPa": "ksi", "N": "lbf", "kN": "lbf",
        "N m": "lbf in", "N/mm": "lbf/in", "N/m": "lbf/in", "N/µm": "lbf/in",
        "N m/rad": "lbf in/rad", "N m s/rad": "lbf in s/rad", "N s/m": "lbf s/in",
        "kg": "lb", "kg m^2": "lb in^2", "kg/m^3": "lb/in^3", "g mm": "oz in", "kg m": "oz in",
        "m/s": "ft/s", "s/m": "s/ft", "1/mm": "1/in", "deg/mm": "deg/in", "J": "lbf in",
        "J/m": "lbf", "µJ/m": "lbf",
    },
}  # fmt: skip
INCH_WORDS = frozenset((
    "in", "inch", "inches", "ft", "foot", "feet", "mil", "thou", "lbf", "psi",
    "ksi", "lb", "pound", "oz", "ounce", "slug", "pound_force",
))  # fmt: skip
LENGTH = units.dimensions("mm")
NUMBER = r"[-+±]?\d[\d,]*(?:\.\d+)?(?:e[-+]?\d+)?"
OF_ROW = ("analytic", "fem", "difference", "scale", "u_num", "u_ref", "u_input", "tolerance")
FEWEST_DIGITS, MOST_DIGITS = 3, 5  # of a number in a sentence


def system_of(raw: Any) -> System:
    """The system of a file's inputs: inch where most of its lengths, or else most units, are."""
    given = list(_units_in(raw))
    lengths = [unit for unit in given if units.dimensions(unit) == LENGTH]
    inch = [bool(INCH_WORDS & set(re.findall(r"[A-Za-z_]+", u))) for u in lengths or given]
    return "inch" if 2 * sum(inch) > len(inch) else "mm"


def _units_in(raw: Any) -> Iterator[str]:
    """Every unit that a TOML value holds."""
    if isinstance(raw, Mapping):
        for value in raw.values():
            yield from _units_in(value)
    elif isinstance(raw, list):
        for value in raw:
            yield from _units_in(value)
    elif isinstance(raw, str):
        for part in raw.split(":"):
            if (match := re.fullmatch(rf"\s*{NUMBER}\s*(\D.*?)\s*", part)) and _known(match[1]):
                yield match[1]


def _known(unit: str) -> bool:
    try:
        units.dimensions(unit)
    except ValueError:
        return False
    return True


def unit_in(unit: str, system: System) -> str:
    """The unit that shows quantities of `unit` in a system."""
    return DISPLAYED[system].get(unit, unit)


def converted(value: float, unit: str, system: System) -> tuple[float, str]:
    """A value in `unit` as value and unit of a system.

    >>> value, unit = converted(25.4, "mm", "inch")
    >>> round(value, 12), unit
    (1.0, 'in')
    """
    target = unit_in(unit, system)
    return (value, unit) if target == unit else (value * _ratio(unit, target), target)


def _ratio(unit: str, target: str) -> float:
    return units.factor(unit) / units.factor(target)


def in_units(result: CaseResult, system: System) -> CaseResult:
    """The result with inputs, values, rows and sentences in the units of a system."""
    if not DISPLAYED[system]:
        return result
    return replace(
        result,
        inputs=tuple(_input(one, system) for one in result.inputs),
        values=tuple(_value(one, system) for one in result.values),
        rows=tuple(_row(one, system) for one in result.rows),
        findings=tuple(text_in(one, system) for one in result.findings),
        warnings=tuple(text_in(one, system) for one in result.warnings),
    )


def dynamic_in_units(found: DynamicResult | None, system: System) -> DynamicResult | None:
    """The same of what --dynamic adds."""
    if found is None or not DISPLAYED[system]:
        return found
    return replace(
        found, outputs=outputs_in(found.outputs, system),
        findings=tuple(text_in(one, system) for one in found.findings),
        first=tuple(text_in(one, system) for one in found.first),
    )  # fmt: skip


def outputs_in(outputs: Sequence[Output], system: System) -> tuple[Output, ...]:
    """Outputs of a case with the units of a system."""
    return tuple(replace(one, unit=unit_in(one.unit, system)) for one in outputs)


def assumed_in(assumed: Sequence[Assumed], system: System) -> tuple[Assumed, ...]:
    """Assumed inputs in the units of a system."""
    return tuple(_number(one, system) for one in assumed)


def record_in_units(record: Any, system: System) -> Any:
    """JSON in which every `value` or `at` beside a `unit` is converted; printed numbers stay."""
    if isinstance(record, list):
        return [record_in_units(one, system) for one in record]
    if not isinstance(record, dict):
        return record
    found = {
        k: v if k == "published" else record_in_units(v, system) for k, v in record.items()
    }  # fmt: skip
    for key in ("value", "at"):
        if isinstance(found.get("unit"), str) and isinstance(found.get(key), int | float):
            number, unit = converted(found[key], record["unit"], system)
            found |= {key: number, "unit": unit}
    return found


def text_in(text: str, system: System) -> str:
    """A sentence whose numbers with a unit, lists and ranges of them too, are converted.

    >>> text_in("d is 25.4 mm; 10 to 20 MPa", "inch")
    'd is 1 in; 1.45 to 2.9 ksi'
    """
    names = sorted(DISPLAYED[system], key=len, reverse=True)
    if not names:
        return text
    between = r"(?: to | and | or |, |/)"
    unit = "|".join(re.escape(name) for name in names)
    pattern = rf"(?<![\w.]){NUMBER}(?:{between}{NUMBER})* (?:{unit})(?![\w/^²·]| (?:m|s)\b|\.\w)"
    return re.sub(pattern, lambda match: _phrase(match[0], names, system), text)


def _phrase(phrase: str, names: Sequence[str], system: System) -> str:
    """Numbers and their unit, each number with at least as many digits as before."""
    unit = next(name for name in names if phrase.endswith(f" {name}"))
    target = unit_in(unit, system)
    numbers = phrase.removesuffix(f" {unit}")
    return re.sub(NUMBER, lambda n: _text(n[0], _ratio(unit, target)), numbers) + f" {target}"


def _text(number: str, ratio: float) -> str:
    """A number of a sentence, converted, with as many digits as it had within some bounds."""
    sign, bare = ("±", number[1:]) if number[0] == "±" else ("", number)
    value = float(bare.replace(",", "")) * ratio
    digits = len(re.sub(r"e.*|[-+.,]", "", bare).lstrip("0"))
    digits = min(max(FEWEST_DIGITS, digits), MOST_DIGITS)
    whole = f"{value:.0f}" if abs(value) >= 10**digits else f"{value:.{digits}g}"
    return sign + whole


def _number(one: Shown, system: System) -> Shown:
    if not isinstance(one.value, float):
        return one
    value, unit = converted(one.value, one.unit, system)
    return replace(one, value=value, unit=unit)


def _value(one: FormulaValue, system: System) -> FormulaValue:
    return _number(one, system)


def _input(one: InputValue, system: System) -> InputValue:
    """An input; that of a table is a sentence."""
    if one.value == "":
        return replace(one, what=text_in(one.what, system))
    return _number(one, system)


def _row(row: Row, system: System) -> Row:
    """A row with its dimensional numbers converted; relative ones stay, and printed values."""
    row = replace(row, reason=text_in(row.reason, system))
    target = unit_in(row.unit, system)
    if target == row.unit:
        return row
    ratio = _ratio(row.unit, target)
    numbers: dict[str, Any] = {
        name: value * ratio for name in OF_ROW if (value := getattr(row, name)) is not None
    }
    return replace(
        row, unit=target, **numbers,
        partner=row.partner and replace(row.partner, value=row.partner.value * ratio),
        levels=_levels(row.levels, ratio), levels_u=tuple(u * ratio for u in row.levels_u),
        grid=row.grid and _grid(row.grid, ratio, target),
    )  # fmt: skip


def _levels(levels: Sequence[tuple[float, float]], ratio: float) -> tuple[tuple[float, float], ...]:
    return tuple((mesh_size, value * ratio) for mesh_size, value in levels)


def _grid(grid: Grid, ratio: float, unit: str) -> Grid:
    scaled = {name: getattr(grid, name) * ratio for name in ("scale", "allowed", "gci", "u_it")}
    return replace(grid, unit=unit, levels=_levels(grid.levels, ratio), **scaled)
