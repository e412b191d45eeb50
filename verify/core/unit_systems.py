"""Unit systems of displayed values: units of the case (mm, N, MPa), SI, or inch and pound-force."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Literal

from verify.core import units

System = Literal["si", "mm", "inch"]

# No unit on the right of a map stands on its left: converting twice changes nothing.
DISPLAYED: Mapping[System, Mapping[str, str]] = {
    "mm": {},
    "si": {
        "mm": "m", "µm": "m", "nm": "m", "MPa": "Pa", "GPa": "Pa", "kN": "N", "N/mm": "N/m",
        "N/µm": "N/m", "1/mm": "1/m", "deg": "rad", "deg/mm": "rad/m", "ms": "s",
        "r/min": "rad/s", "g mm": "kg m", "µJ/m": "J/m", "mm^2": "m^2", "mm^3": "m^3",
        "mm^4": "m^4", "N mm^2": "N m^2", "µm/MPa": "m/Pa", "mm/N": "m/N",
        "MPa m^0.5": "Pa m^0.5",
    },
    "inch": {
        "mm": "in", "µm": "mil", "nm": "mil", "MPa": "ksi", "GPa": "ksi", "N": "lbf", "kN": "lbf",
        "N m": "lbf in", "N/mm": "lbf/in", "N/m": "lbf/in", "N/µm": "lbf/in",
        "N m/rad": "lbf in/rad", "N m s/rad": "lbf in s/rad", "N s/m": "lbf s/in",
        "kg": "lb", "kg m^2": "lb in^2", "kg/m^3": "lb/in^3", "g mm": "oz in", "kg m": "oz in",
        "m/s": "ft/s", "s/m": "s/ft", "1/mm": "1/in", "deg/mm": "deg/in", "J": "lbf in",
        "J/m": "lbf", "µJ/m": "lbf", "1/m": "1/in", "mm^2": "in^2", "mm^3": "in^3",
        "mm^4": "in^4", "N mm^2": "lbf in^2", "µm/MPa": "mil/ksi", "mm/N": "in/lbf",
        "1/N/m": "1/lbf/in", "MPa m^0.5": "ksi in^0.5",
    },
}  # fmt: skip
INCH_WORDS = frozenset((
    "in", "inch", "inches", "ft", "foot", "feet", "mil", "thou", "lbf", "psi",
    "ksi", "lb", "pound", "oz", "ounce", "slug", "pound_force",
))  # fmt: skip
LENGTH = units.dimensions("mm")
NUMBER = r"[-+±]?\d[\d,]*(?:\.\d+)?(?:e[-+]?\d+)?"
FEWEST_DIGITS, MOST_DIGITS = 3, 5  # of a number in a sentence
LARGEST_WHOLE = 1e7  # larger numbers have a power of ten


def system_of(raw: Any) -> System:
    """Unit system for results: "inch" if most lengths in the file are in inches, otherwise "mm".

    If the file contains no length, all quantities are counted.
    """
    given = list(_units_in(raw))
    lengths = [unit for unit in given if units.dimensions(unit) == LENGTH]
    inch = [bool(INCH_WORDS & set(re.findall(r"[A-Za-z_]+", u))) for u in lengths or given]
    return "inch" if 2 * sum(inch) > len(inch) else "mm"


def _units_in(raw: Any) -> Iterator[str]:
    """All units in a TOML value."""
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
    """Unit in which quantities with the unit `unit` are displayed in a system."""
    return DISPLAYED[system].get(unit, unit)


def converted(value: float, unit: str, system: System) -> tuple[float, str]:
    """Value and unit in a system, converted from a value in `unit`.

    >>> value, unit = converted(25.4, "mm", "inch")
    >>> round(value, 12), unit
    (1.0, 'in')
    """
    target = unit_in(unit, system)
    return (value, unit) if target == unit else (value * ratio(unit, target), target)


def ratio(unit: str, target: str) -> float:
    """Value of one `unit`, expressed in the unit `target`."""
    return units.factor(unit) / units.factor(target)


def text_in(text: str, system: System) -> str:
    """Sentence in which all numbers with a unit are converted, also those in lists and ranges.

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


def cells_in(lines: Iterable[Sequence[str]], system: System) -> list[tuple[str, ...]]:
    """Lines of a table, in whose cells numbers with a unit are converted as in `text_in`."""
    return [tuple(text_in(cell, system) for cell in line) for line in lines]


def _phrase(phrase: str, names: Sequence[str], system: System) -> str:
    """Text of converted numbers and their unit, from a `phrase` of numbers with one unit."""
    unit = next(name for name in names if phrase.endswith(f" {name}"))
    target = unit_in(unit, system)
    numbers = phrase.removesuffix(f" {unit}")
    return re.sub(NUMBER, lambda n: _text(n[0], ratio(unit, target)), numbers) + f" {target}"


def _text(number: str, factor: float) -> str:
    """Text of `number` times `factor`, with the same number of digits, at least 3 and at most 5."""
    sign, bare = ("±", number[1:]) if number[0] == "±" else ("", number)
    value = float(bare.replace(",", "")) * factor
    digits = len(re.sub(r"e.*|[-+.,]", "", bare).lstrip("0"))
    digits = min(max(FEWEST_DIGITS, digits), MOST_DIGITS)
    is_whole = 10**digits <= abs(value) < LARGEST_WHOLE
    return sign + (f"{value:.0f}" if is_whole else f"{value:.{digits}g}")
