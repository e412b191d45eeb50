"""Conversion of texts such as "11.6 mm" to SI numbers, and back.

The registry contains only the units in use, so that it is built within milliseconds. An angle is a
separate dimension here: a plain number is not an angle.
"""

import math
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import cast


@contextmanager
def _without(package: str) -> Iterator[None]:
    """Context in which a package that is not imported yet cannot be found by imports."""
    if package in sys.modules:
        yield
        return
    sys.modules[package] = None  # type: ignore[assignment]
    try:
        yield
    finally:
        del sys.modules[package]


with _without("dask"):  # pint would import it for dask arrays, which are not used here: 0.15 s
    import pint

DEFINITIONS = """
nano- = 1e-9 = n-
micro- = 1e-6 = µ- = μ- = u-
milli- = 1e-3 = m-
centi- = 1e-2 = c-
kilo- = 1e3 = k-
mega- = 1e6 = M-
giga- = 1e9 = G-
meter = [length] = m = metre
second = [time] = s = sec
gram = [mass] = g
kelvin = [temperature] = K
radian = [angle] = rad
revolution = 2 * 3.14159265358979323846 * radian = r = rev
degree = 3.14159265358979323846 / 180 * radian = deg = °
minute = 60 * second = min
rpm = revolution / minute
inch = 0.0254 * meter = in = inches
foot = 0.3048 * meter = ft = feet
mil = 2.54e-5 * meter = thou
newton = 1000 * gram * meter / second ** 2 = N
newton_meter = newton * meter = Nm
newton_millimeter = 1e-3 * newton_meter = Nmm
newton_meter_second = newton_meter * second = Nms
newton_second = newton * second = Ns
pascal = newton / meter ** 2 = Pa
bar = 1e5 * pascal
joule = newton * meter = J
watt = joule / second = W
hertz = 1 / second = Hz
pound = 453.59237 * gram = lb = lbm
ounce = pound / 16 = oz
pound_force = 4.4482216152605 * newton = lbf
slug = pound_force * second ** 2 / foot
kilogram_force = 9.80665 * newton = kgf
psi = pound_force / inch ** 2
ksi = 1000 * psi
kip = 1000 * pound_force
percent = 0.01 = %
""".strip().splitlines()

# Names of the dimensions for messages, by a unit of the dimension.
DIMENSIONS = {
    "mm": "a length", "MPa": "a pressure or stress", "N": "a force", "deg": "an angle",
    "N/mm": "a stiffness", "kg/m^3": "a density", "1": "a number", "s": "a time",
    "J/m": "an energy per length", "N m": "a torque", "r/min": "a speed of rotation",
    "rad/s": "a speed of rotation", "m/s": "a speed", "s/m": "a reciprocal speed",
    "kg": "a mass", "kg m^2": "a moment of inertia", "N m/rad": "a torsional stiffness",
    "N m s/rad": "a torsional damping", "1/mm": "a curvature", "Hz": "a frequency",
    "GPa": "a pressure or stress", "µm": "a length", "rad": "an angle",
    "N/m": "a stiffness", "N/µm": "a stiffness", "N s/m": "a damping",
    "g mm": "an unbalance, mass times eccentricity",
    "kg m": "an unbalance, mass times eccentricity", "%": "a share", "K": "a temperature",
    "MPa m^0.5": "a stress intensity",
}  # fmt: skip

# Units that people write for these, for messages; all of them with n, µ, m, c, k, M, G before.
TAKEN = {
    "mm": "mm, m, in, ft or mil", "MPa": "MPa, Pa, bar, psi or ksi", "N": "N, lbf or kgf",
    "GPa": "GPa, MPa, psi or ksi", "deg": "deg or rad", "rad": "deg or rad",
    "µm": "µm, mm, m, in, ft or mil",
    "r/min": "r/min, rpm, rad/s or deg/s", "rad/s": "r/min, rpm, rad/s or deg/s",
    "N m": "N m, N mm, kN m, lbf in or lbf ft",
    "kg": "kg, g, lb, oz or slug", "kg m^2": "kg m^2, g mm^2, lb in^2 or lb ft^2",
    "N m/rad": "N m/rad, N m/deg or lbf in/rad", "N m s/rad": "N m s/rad or lbf in s/rad",
    "N/m": "N/m, N/mm, N/µm, MN/m or lbf/in", "N/µm": "N/m, N/mm, N/µm, MN/m or lbf/in",
    "N/mm": "N/m, N/mm, N/µm, MN/m or lbf/in",
    "N s/m": "N s/m, N s/mm or lbf s/in", "g mm": "g mm, kg m or oz in",
    "kg/m^3": "kg/m^3, g/cm^3 or lb/in^3", "Hz": "Hz, kHz or 1/s",
    "m/s": "m/s, mm/s or ft/s", "s/m": "s/m, s/mm or s/ft", "s": "s, ms or min",
    "K": "K or mK", "MPa m^0.5": "MPa m^0.5, MPa mm^0.5 or ksi in^0.5",
}  # fmt: skip

_WORD = "[A-Za-zµμ°%]"
_TEXT = re.compile(
    r"\s*(?P<number>[-+]?(?:\d++(?:\.\d*+)?|\.\d++)(?:[eE][-+]?\d{1,3})?)"
    rf"(?:\s*(?P<unit>{_WORD}[^\"']{{0,39}})|\s+(?P<reciprocal>1\s*/[^\"']{{1,39}}))?\s*"
)
_NOT_FINITE = re.compile(r"\s*[-+]?(?:nan|inf(?:inity)?)\b", re.IGNORECASE)
MISTAKEN = {
    re.compile(r"\blbs?\b"): '; "lb" is a mass, a force is "lbf"',
    re.compile(r"\bnm\b"): '; "nm" is nanometre, newton metre is "N m"',
    re.compile(r"\bNm\b"): '; "Nm" is newton metre, nanometre is "nm"',
}
_COMMA = re.compile(r"\s*[-+]?\d+,\d")
_FACTOR = re.compile(
    rf"\s*([*/·]?)\s*({_WORD}+|1)"
    r"(?:\s*(?:\^|\*\*)\s*(-?\d(?:\.5)?)|(?<!1)([2-4])(?!\d))?"  # mm^2, or mm2
)


@cache
def registry() -> "pint.UnitRegistry[float]":
    """Registry of the project's units, with SI base units; the kilogram is defined by the gram."""
    units: pint.UnitRegistry[float] = pint.UnitRegistry(None, preprocessors=[])
    for line in DEFINITIONS:
        units.define(line)
    return units


@cache
def factor(unit: str) -> float:
    """Value of one `unit` in SI units: factor("mm") = 0.001, factor("1") = 1.

    >>> factor("N/mm"), round(factor("deg"), 6)
    (1000.0, 0.017453)
    """
    if unit == "1":
        return 1.0
    magnitude, _ = registry().get_root_units(_parsed(unit))
    # the root units end at grams: an SI mass is a thousand of them, to the power it appears with
    mass = dict(dimensions(unit)).get("[mass]", 0.0)
    return float(cast("float", magnitude)) * float(1e-3**mass)


def parse(text: str, unit: str) -> float:
    """SI value of `text`, which must have the dimension of `unit`.

    Raises ValueError for a missing, unknown or unsuitable unit, and for a value that is not finite.

    >>> parse("11.6 mm", "mm")
    0.0116
    """
    if unit not in DIMENSIONS:
        dimensions(unit)  # raises for an unknown unit
    needed = DIMENSIONS.get(unit, f"a quantity in {unit}")
    example = "" if unit == "1" else f', such as "1.5 {unit}"'
    match = _TEXT.fullmatch(text)
    if match is None and _COMMA.match(text):
        raise ValueError(f'"{_short(text)}" has a comma: decimals follow a point, as in 3.5')
    if match is None and _NOT_FINITE.match(text):
        raise ValueError(f'"{_short(text)}" is not finite')
    if match is None:
        raise ValueError(f'"{_short(text)}" is not {needed}{example}')
    number, given = float(match["number"]), (match["unit"] or match["reciprocal"] or "1").strip()
    if not math.isfinite(number):
        raise ValueError(f'"{_short(text)}" is not finite')
    if given == "1" and unit != "1":
        raise ValueError(
            f'"{_short(text)}" has no unit: needs {needed}, such as "{_short(text)} {unit}"'
        )
    try:
        fits = dimensions(given) == dimensions(unit)
    except ValueError as error:
        taken = f": {needed} takes {TAKEN[unit]}, with spaces, * or / between units" \
            if unit in TAKEN else ""  # fmt: skip
        raise ValueError(f"{error}{taken}") from error
    if not fits:
        hint = next((words for one, words in MISTAKEN.items() if one.search(given)), "")
        raise ValueError(f'"{_short(text)}" is not {needed}{example}{hint}')
    value = number * factor(given)
    if not math.isfinite(value):
        raise ValueError(f'"{_short(text)}" is not finite')
    return value


def is_bare(text: str) -> bool:
    """Whether `text` is a number without a unit.

    >>> is_bare("300"), is_bare("300 N m"), is_bare("3,5")
    (True, False, False)
    """
    match = _TEXT.fullmatch(text)
    return match is not None and not (match["unit"] or match["reciprocal"])


@cache
def dimensions(unit: str) -> frozenset[tuple[str, float]]:
    """Dimensions of a unit with their powers; empty for plain numbers."""
    if unit == "1":
        return frozenset()
    found = registry().Quantity(1.0, _parsed(unit)).dimensionality
    return frozenset((str(name), float(cast("float", p))) for name, p in found.items())


def _parsed(unit: str) -> "pint.Unit":
    """Unit from a text such as `N m`, `kg/m^3` or `1/mm`.

    The text is parsed factor by factor, so that no text takes a long time.
    """
    parts: list[str] = []
    at, unit = 0, unit.replace("²", "^2").replace("³", "^3")
    if unit.count("%") > 1:
        raise ValueError(f'"{_short(unit)}" is not a unit')
    while at < len(unit):
        match = _FACTOR.match(unit, at)
        if match is None or (match[1] == "" and match[2] == "1" and at > 0):
            raise ValueError(f'"{_short(unit)}" is not a unit')
        parts.append(f"{match[1].replace('·', '*') or ('*' if parts else '')}{match[2]}")
        power = match[3] or match[4]
        parts[-1] += f"**{power}" if power else ""
        at = match.end()
    if not parts or parts[0][0] in "*/":
        raise ValueError(f'"{_short(unit)}" is not a unit; a plain number has the unit "1"')
    try:
        return registry().Unit("".join(parts))
    except (pint.errors.PintError, AttributeError, ValueError, TypeError) as error:
        raise ValueError(f'"{_short(unit)}" is not a known unit') from error


def _short(text: str) -> str:
    line = " ".join("".join(c if c.isprintable() else " " for c in text).split())
    return line if len(line) <= 40 else line[:39] + "…"
