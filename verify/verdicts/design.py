"""Design ranges: ranges of inputs in which engineers use a formula, with sources.

`ranges.toml` contains the design ranges. A verdict over a range requires a study of each design
range over its complete length.
"""

import tomllib
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from math import prod
from pathlib import Path

import numpy as np
from pydantic import Field

from verify.cases.registry import find
from verify.core.inputs import Inputs
from verify.core.verdicts import DesignRange, Side
from verify.papers.entries import Entry, Words
from verify.studies.sweep.axes import Axis, axis
from verify.studies.validity.messages import span
from verify.verdicts.evidence import Study

FILE = Path(__file__).parent / "ranges.toml"
SAME = 1e-9  # relative: ends of ranges that differ by less are equal


class Declared(Entry):
    """A design range with its source; `ends` is a text such as "T=6.5N m,52N m".

    `ratio` names the dimensionless form of the input. Its divisor is a product of powers of the
    default inputs; `per` contains the exponents.
    """

    case: str
    ends: Words
    source: Words
    ratio: str = ""
    per: dict[str, float] = Field(default_factory=dict)


class Table(Entry):
    """All entries of `ranges.toml`."""

    ranges: tuple[Declared, ...]


@cache
def declared() -> tuple[Declared, ...]:
    """Entries of `ranges.toml`.

    Raises ValueError if an entry is incomplete.
    """
    return Table.model_validate(tomllib.loads(FILE.read_text("utf-8"))).ranges


def design(cases: Sequence[str], studies: Sequence[Study]) -> tuple[DesignRange, ...]:
    """Design ranges of `cases`; each states whether the solved points of `studies` cover it."""
    return tuple(_one(entry, studies) for entry in declared() if entry.case in cases)


def _one(entry: Declared, studies: Sequence[Study]) -> DesignRange:
    wanted = axis_of(entry)
    low, high = wanted.values[0], wanted.values[-1]
    room = SAME * max(abs(low), abs(high))
    spanned = any(
        values.size and values.min() <= low + room and values.max() >= high - room
        for plan, course in studies if plan.case.id == entry.case
        for k, one in enumerate(plan.axes) if one.name == wanted.name
        for values in [plan.points[np.isfinite(course.error + course.U_error), k]]
    )  # fmt: skip
    return DesignRange(
        case=entry.case, words=span(wanted, low, high), source=entry.source, spanned=spanned,
        side=side(entry.case, wanted, low, high),
    )  # fmt: skip


def axis_of(entry: Declared) -> Axis:
    """Axis from one end of a design range to the other; other inputs have their default values.

    Raises InputError if the case has no such input.
    """
    return axis(find(entry.case).inputs(), entry.ends)


def side(case: str, of: Axis, low: float, high: float) -> Side:
    """Range `low` to `high` [SI] in the unit of the input and, if declared, also as a ratio."""
    scale = ratio_of(case, of.name)
    found = Side(name=of.name, symbol=of.symbol, unit=of.unit, low=of.in_unit(low),
                 high=of.in_unit(high))  # fmt: skip
    if scale is None:
        return found
    ends = (float(f"{x / divisor(scale):.3g}") for x in (low, high))
    return replace(found, ratio=scale.ratio, ratio_ends=tuple(ends))


def ratio_of(case: str, name: str) -> Declared | None:
    """The entry that declares a ratio for an input, or None."""
    return next(
        (e for e in declared() if e.case == case and e.ratio and e.ends.startswith(f"{name}=")),
        None,
    )


def divisor(entry: Declared) -> float:
    """Divisor [SI] of the declared ratio, from the default inputs of the case."""
    inputs: Inputs = find(entry.case).inputs()
    return float(prod(getattr(inputs, name) ** power for name, power in entry.per.items()))
