"""Tables of a sweep as CSV: points, ranges of validity, causes of the scatter.

The tables do not depend on run times or machines.
"""

import csv
import io
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from verify.core import units
from verify.studies.sweep.axes import Axis, Tolerance
from verify.studies.sweep.indices import Indices, Scatter, indices
from verify.studies.sweep.outcome import Course, Outcome
from verify.studies.sweep.pairs import Pair
from verify.studies.sweep.region import NAMES, Region, regions

ALIKE = 1e-9  # relative to the largest error: round-off of an input without effect
SOLVED, REFUSED, FAILED = "solved", "refused", "failed"
Cell = str | int | float | None


def statuses(found: Outcome) -> tuple[str, ...]:
    """State of each point: "solved", "refused" (wrong inputs), or "failed"."""
    return tuple(
        SOLVED if not problem else REFUSED if problem.startswith(f"{REFUSED}:") else FAILED
        for problem in found.problems
    )


def reasons(found: Outcome) -> tuple[str, ...]:
    """For each point, why some or all rows cannot be compared; empty for most points."""
    texts = []
    for n, problem in enumerate(found.problems):
        rows = Counter(course.problems[n] for course in found.courses if course.problems[n])
        some = (f"{problem} in {count} of {len(found.courses)} rows" if len(found.courses) > 1
                else problem for problem, count in rows.items())  # fmt: skip
        texts.append(problem.removeprefix(f"{REFUSED}: ") or "; ".join(some))
    return tuple(texts)


def largest(course: Course) -> int | None:
    """Index of the point with the largest error; None if no error was computed.

    Of several points with equal errors, the first is returned.
    """
    size = np.abs(course.error)
    if not np.isfinite(size).any():
        return None
    return int(np.argmax(size >= (1 - ALIKE) * np.nanmax(size)))


def points_csv(found: Outcome) -> str:
    """CSV text with one line per point: inputs, status, reason; formula, FE and error of each row.

    Inputs and values are in their units. U is the expanded uncertainty of FE, error is (formula -
    FE)/scale, and U_error its expanded uncertainty.
    """
    plan = found.solved.plan
    heads = [with_unit(one.name, one.unit) for one in plan.axes or plan.tolerances]
    for course in found.courses:
        pair = course.pair
        heads += [
            *(with_unit(f"{pair.name}: {what}", pair.unit)
              for what in ("formula", pair.by or "FE", "U")),
            f"{pair.name}: error [%]", f"{pair.name}: U_error [%]",
        ]  # fmt: skip
    columns = [
        column
        for one in found.courses
        for column in (
            *(v / units.factor(one.pair.unit) for v in (one.formula, one.fe, one.U)),
            100 * one.error, 100 * one.U_error,
        )
    ]  # fmt: skip
    varied: Sequence[Axis | Tolerance] = plan.axes or plan.tolerances
    lines = (
        [*(one.in_unit(v) for one, v in zip(varied, row, strict=True)), status, reason, *values]
        for row, status, reason, *values in zip(
            plan.points, statuses(found), reasons(found), *columns, strict=True
        )
    )
    return _written([*heads[: len(varied)], "status", "reason", *heads[len(varied) :]], lines)


def validity_csv(found: Outcome) -> str:
    """CSV text with one line per row and limit: counts of points, largest box, first violation."""
    plan = found.solved.plan
    ends = [with_unit(f"{a.name} {end}", a.unit) for a in plan.axes for end in ("from", "to")]
    heads = [
        "row", "largest error [%]", "U_error of largest error [%]", "limit [%]", "points",
        *NAMES.values(), "points in the box", *ends, "limit first exceeded by",
        "unit", "last inside", "first not inside", "verdict at first not inside",
        "error bar reaches limit at", "reason if unsolved",
    ]  # fmt: skip
    return _written(
        heads,
        (line for course in found.courses for one in regions(plan, course)
         for line in [_of_region(plan.axes, course, one)]),
    )  # fmt: skip


def _of_region(axes: Sequence[Axis], course: Course, one: Region) -> list[Cell]:
    n, ranges = largest(course), {r.axis.name: r for r in one.box}
    worst = (None, None) if n is None else (100 * course.error[n], 100 * course.U_error[n])
    line: list[Cell] = [course.pair.name, *worst, 100 * one.limit, one.points]
    line += [one.inside, one.outside, one.undecided, one.unsolved, one.held]
    for axis in axes:
        r = ranges.get(axis.name)
        line += [None, None] if r is None else [axis.in_unit(r.low), axis.in_unit(r.high)]
    if (by := one.breaks) is None:
        return [*line, *[None] * 7]
    at = None if by.at is None else by.axis.in_unit(by.at)
    return [
        *line, by.axis.name, "" if by.axis.unit == "1" else by.axis.unit,
        by.axis.in_unit(by.last), by.axis.in_unit(by.first), NAMES[by.verdict], at, by.why,
    ]  # fmt: skip


def sensitivity_csv(found: Outcome) -> str:
    """CSV text with one line per row, quantity and input: scatter, and indices with intervals."""
    heads = [
        "row", "quantity", "unit", "points", "mean", "standard deviation", "2.5 %", "50 %",
        "97.5 %", "share of noise in the variance", "input", "rows of the sample",
        *(f"{index}{end}" for index in ("S1", "ST") for end in ("", " low", " high")),
        "reason without indices",
    ]  # fmt: skip
    plan = found.solved.plan
    return _written(
        heads,
        (line for course in found.courses
         for line in _of_indices(plan.tolerances, indices(plan, course))),
    )  # fmt: skip


def _of_indices(tolerances: Sequence[Tolerance], one: Indices) -> Iterator[list[Cell]]:
    for what, scatter, unit in quantities(one):
        found = {index.tolerance.name: index for index in scatter.indices}
        size = units.factor(unit)
        moments = (scatter.mean, scatter.sd, scatter.low, scatter.median, scatter.high)
        for tolerance in tolerances:
            index = found.get(tolerance.name)
            ends: list[Cell] = [None] * 6
            if index:
                ends = [v for e in (index.first, index.total) for v in (e.value, e.low, e.high)]
            yield [
                one.pair.name, what, "" if unit == "1" else unit, scatter.n,
                *(v / size for v in moments), scatter.noise, tolerance.name, one.rows, *ends,
                scatter.why,
            ]  # fmt: skip


def quantities(one: Indices) -> tuple[tuple[str, Scatter, str], ...]:
    """Names, scatters and units of the formula, the reference and the error of a pair."""
    return (
        ("formula", one.formula, one.pair.unit), (_reference(one.pair), one.fe, one.pair.unit),
        ("error", one.error, "%"),
    )  # fmt: skip


def _reference(pair: Pair) -> str:
    return pair.by or "FE"


def with_unit(name: str, unit: str) -> str:
    """Column head with the unit in brackets; without brackets for dimensionless values."""
    return name if unit == "1" else f"{name} [{unit}]"


def _written(heads: Sequence[str], lines: Iterable[Sequence[Cell]]) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(heads)
    writer.writerows([_text(cell) for cell in line] for line in lines)
    return out.getvalue()


def _text(cell: Cell) -> str:
    """Text of a cell: a number with ten digits, empty for None or NaN."""
    if isinstance(cell, float):  # numpy's are such
        return f"{cell + 0.0:.10g}" if np.isfinite(cell) else ""  # -0 is 0
    return "" if cell is None else str(cell)
