"""Usual ranges of inputs; a value outside its range is permitted and gives a warning."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from verify.core import units
from verify.core.inputs import Inputs, is_table, meta


@dataclass(frozen=True)
class Usual:
    """A usual range [SI], and a description of the parts to which the range applies."""

    low: float
    high: float
    of: str


MODULUS = Usual(60e9, 420e9, "metals and technical ceramics")
POISSON = Usual(0.2, 0.36, "metals and technical ceramics")
FRICTION = Usual(0.03, 0.3, "lubricated to dry steel")
DENSITY = Usual(1500.0, 9000.0, "metals and technical ceramics")
LENGTH = Usual(1e-6, 5.0, "dimensions of clutches, springs and their shafts")
WEDGE_ANGLE = Usual(0.026, 0.105, "wedge angles of sprags, 1.5 to 6 degrees")
STEEL_DENSITY = 7850.0  # kg/m^3
BODY = (0.2, 3.0)  # of a steel block that fills the sprag's width, length and gap

BY_NAME = (
    (re.compile(r"E(_\w)?"), "GPa", MODULUS),
    (re.compile(r"nu(_[12rio])?"), "1", POISSON),
    (re.compile(r"mu(_[sc])?"), "1", FRICTION),
    (re.compile(r"nu_0"), "deg", WEDGE_ANGLE),
    (re.compile(r".*"), "kg/m^3", DENSITY),
    (re.compile(r".*"), "mm", LENGTH),
)


def unusual(inputs: Inputs) -> dict[str, str]:
    """Warnings for inputs outside their usual ranges (name of the input: warning).

    A value of zero gives no warning.
    """
    found = {
        name: _warning(name, value, unit, usual)
        for name, value, unit in _numbers(inputs)
        if (usual := _usual(name, unit)) and value and not usual.low <= abs(value) <= usual.high
    }
    return found | _sprag_body(inputs)


def _numbers(inputs: Inputs, place: str = "") -> Iterator[tuple[str, float, str]]:
    """Names, values [SI] and units of all numerical inputs, including inputs in tables."""
    for name, field in type(inputs).model_fields.items():
        value: Any = getattr(inputs, name)
        if is_table(field):
            for k, entry in enumerate(value, start=1):
                yield from _numbers(entry, f"{place}{name}[{k}].")
        elif isinstance(value, float):
            yield f"{place}{name}", value, meta(field)["unit"]


def _usual(name: str, unit: str) -> Usual | None:
    last = name.rpartition(".")[2]
    return next((u for pattern, of, u in BY_NAME if of == unit and pattern.fullmatch(last)), None)


def _warning(name: str, value: float, unit: str, usual: Usual) -> str:
    value, low, high = (x / units.factor(unit) for x in (value, usual.low, usual.high))
    unit = "" if unit == "1" else f" {unit}"
    return (
        f"{name} = {value:.4g}{unit} is outside the usual range {low:.4g} to {high:.4g}{unit} "
        f"({usual.of}): check value and unit"
    )


def _sprag_body(inputs: Inputs) -> dict[str, str]:
    """Warnings if mass or inertia of a sprag are unusual for a steel block of its size."""
    q: Mapping[str, Any] = dict(inputs)
    if not {"m_g", "I_g", "l", "b", "R_e", "R_i"} <= set(q):
        return {}
    gap = q["R_e"] - q["R_i"]
    mass = STEEL_DENSITY * q["l"] * q["b"] * gap
    inertia = mass * (q["b"] ** 2 + gap**2) / 12
    block = f"{BODY[0]:g} to {BODY[1]:g} times a steel block of the sprag's size"
    return {
        name: _warning(name, q[name], unit, Usual(BODY[0] * steel, BODY[1] * steel, block))
        for name, unit, steel in (("m_g", "kg", mass), ("I_g", "kg m^2", inertia))
        if not BODY[0] * steel <= q[name] <= BODY[1] * steel
    }
