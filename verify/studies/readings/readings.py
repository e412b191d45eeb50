"""Readings for any formula, by the kind of its inputs."""

import math
from collections.abc import Callable

from verify.studies.readings.search import Reading

ROOT = "the number itself"


def doubled(name: str, symbol: str = "") -> Reading:
    """A diameter instead of a radius, a whole length instead of half of it."""
    return _scaled(name, symbol, 2.0, f"2 {symbol or name} for {symbol or name}")


def halved(name: str, symbol: str = "") -> Reading:
    """A radius instead of a diameter, half a length instead of the whole."""
    return _scaled(name, symbol, 0.5, f"{symbol or name}/2 for {symbol or name}")


def _scaled(name: str, symbol: str, factor: float, said: str) -> Reading:
    return Reading(name=said, of=symbol or name, inputs=lambda q: {name: q[name] * factor})


def length(name: str, symbol: str = "") -> list[Reading]:
    """Twice and half."""
    return [doubled(name, symbol), halved(name, symbol)]


def angle(name: str, symbol: str = "") -> list[Reading]:
    """Half and twice an angle in rad, sine and tangent changed, degrees and radians changed."""
    s = symbol or name
    changes: dict[str, Callable[[float], float]] = {
        f"sin {s} for tan {s}": lambda a: math.atan(math.sin(a)),
        f"tan {s} for sin {s}": lambda a: math.asin(math.tan(a)),
        f"degrees taken as radians in {s}": math.degrees,
        f"radians taken as degrees in {s}": math.radians,
    }
    return length(name, symbol) + [
        Reading(name=said, of=s, inputs=lambda q, f=f: {name: f(q[name])})  # type: ignore[misc]
        for said, f in changes.items()
    ]


def count(name: str, symbol: str = "") -> list[Reading]:
    """One less and one more; the total instead of one part, and one part instead of the total."""
    s = symbol or name
    return [
        Reading(name=f"{s} − 1 for {s}", of=s, inputs=lambda q: {name: q[name] - 1}),
        Reading(name=f"{s} + 1 for {s}", of=s, inputs=lambda q: {name: q[name] + 1}),
        Reading(name=f"total of all {s}", of=ROOT, result=lambda v, q: v * q[name]),
        Reading(name=f"each of {s}", of=ROOT, result=lambda v, q: v / q[name]),
    ]


def elastic(E: str, nu: str) -> list[Reading]:
    """Plane strain for plane stress and vice versa, without lateral contraction."""
    return [
        Reading(name="E/(1 − ν²) for E", of=E, inputs=lambda q: {E: q[E] / (1 - q[nu] ** 2)}),
        Reading(name="E for E/(1 − ν²)", of=E, inputs=lambda q: {E: q[E] * (1 - q[nu] ** 2)}),
        Reading(name="ν = 0", of=nu, inputs=lambda _q: {nu: 0.0}),
    ]


def result() -> list[Reading]:
    """Possible factors of a number: both sides, mean instead of largest, per cent."""
    factors = {
        "both sides for one": 2.0,
        "one side for both": 0.5,
        "mean for largest (π/4)": math.pi / 4,
        "largest for mean (4/π)": 4 / math.pi,
        "π times": math.pi,
        "over π": 1 / math.pi,
    }
    return [
        Reading(name=said, of=ROOT, result=lambda v, _q, f=f: v * f)  # type: ignore[misc]
        for said, f in factors.items()
    ]


def switched(name: str, said: str, **values: object) -> Reading:
    """Another choice of the option `name` of the formula."""
    return Reading(name=said, of=name, inputs=lambda _q: values)
