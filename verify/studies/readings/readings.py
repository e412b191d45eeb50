"""Readings (interpretations) that are possible for any formula, for each kind of input."""

import math
from collections.abc import Callable

from verify.studies.readings.search import Reading

ROOT = "the number itself"


def doubled(name: str, symbol: str = "") -> Reading:
    """Reading: the diameter instead of the radius, or the whole length instead of half of it."""
    return _scaled(name, symbol, 2.0, f"2 {symbol or name} instead of {symbol or name}")


def halved(name: str, symbol: str = "") -> Reading:
    """Reading: the radius instead of the diameter, or half the length instead of the whole."""
    return _scaled(name, symbol, 0.5, f"{symbol or name}/2 instead of {symbol or name}")


def _scaled(name: str, symbol: str, factor: float, description: str) -> Reading:
    return Reading(name=description, of=symbol or name, inputs=lambda q: {name: q[name] * factor})


def length(name: str, symbol: str = "") -> list[Reading]:
    """Readings of a length: twice and half the value."""
    return [doubled(name, symbol), halved(name, symbol)]


def angle(name: str, symbol: str = "") -> list[Reading]:
    """Readings of an angle in rad: half, double, sine and tangent exchanged, units exchanged."""
    s = symbol or name
    changes: dict[str, Callable[[float], float]] = {
        f"sin {s} instead of tan {s}": lambda a: math.atan(math.sin(a)),
        f"tan {s} instead of sin {s}": lambda a: math.asin(math.tan(a)),
        f"{s} in degrees taken as radians": math.degrees,
        f"{s} in radians taken as degrees": math.radians,
    }
    return length(name, symbol) + [
        Reading(name=description, of=s, inputs=lambda q, f=f: {name: f(q[name])})  # type: ignore[misc]
        for description, f in changes.items()
    ]


def count(name: str, symbol: str = "") -> list[Reading]:
    """Readings of a number of parts: one less, one more, result of all parts or of one part."""
    s = symbol or name
    return [
        Reading(name=f"{s} − 1 instead of {s}", of=s, inputs=lambda q: {name: q[name] - 1}),
        Reading(name=f"{s} + 1 instead of {s}", of=s, inputs=lambda q: {name: q[name] + 1}),
        Reading(
            name=f"sum over all {s} parts instead of one part",
            of=ROOT,
            result=lambda v, q: v * q[name],
        ),
        Reading(
            name=f"one of {s} parts instead of the total", of=ROOT, result=lambda v, q: v / q[name]
        ),
    ]


def elastic(E: str, nu: str) -> list[Reading]:
    """Readings of elastic constants: plane strain or plane stress, and no lateral contraction."""
    return [
        Reading(
            name="E/(1 − ν²) instead of E", of=E, inputs=lambda q: {E: q[E] / (1 - q[nu] ** 2)}
        ),
        Reading(
            name="E instead of E/(1 − ν²)", of=E, inputs=lambda q: {E: q[E] * (1 - q[nu] ** 2)}
        ),
        Reading(name="ν = 0", of=nu, inputs=lambda _q: {nu: 0.0}),
    ]


def result() -> list[Reading]:
    """Readings of a result that change it by a factor, such as both sides instead of one."""
    factors = {
        "both sides instead of one": 2.0,
        "one side instead of both": 0.5,
        "mean instead of largest value (factor π/4)": math.pi / 4,
        "largest instead of mean value (factor 4/π)": 4 / math.pi,
        "multiplied by π": math.pi,
        "divided by π": 1 / math.pi,
    }
    return [
        Reading(name=description, of=ROOT, result=lambda v, _q, f=f: v * f)  # type: ignore[misc]
        for description, f in factors.items()
    ]


def switched(name: str, description: str, **values: object) -> Reading:
    """Reading that sets inputs to `values`, which select the option `name` of the formula."""
    return Reading(name=description, of=name, inputs=lambda _q: values)
