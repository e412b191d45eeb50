"""Tables of stored points for pages without a script."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

from markupsafe import Markup

from reports.explorer import unit
from reports.formats import MINUS, decimal, number, symbol
from verify.core.results import StoredStudy, StudyAxis

LEAST = 0.001  # per cent: smallest value that is printed
TINY = f"<{LEAST}"
NO_DIGIT = 0.005  # of an error: a smaller bar changes none of its three digits


@dataclass(frozen=True)
class Line:
    """A line with the errors of a formula in per cent.

    For a grid, the errors belong to one `value` of the first axis. In the first line of a formula,
    `lines` is the number of lines of this formula; in its other lines, `lines` is zero. If `errors`
    has a single text, this applies to all points.
    """

    quantity: str
    lines: int
    value: Markup
    errors: tuple[str, ...]


def head(study: StoredStudy) -> list[Markup]:
    """Column heads: the varied value of each point, or the values of the last axis of a grid."""
    if not study.is_star:
        return [_value(study.axes[-1], v) for v in _values(study, -1)]
    own = study.points[0]
    return [Markup("of the case")] + [
        Markup(", ").join(
            _value(axis, v) for axis, v, o in zip(study.axes, point, own, strict=True) if v != o
        )
        for point in study.points[1:]
    ]


def lines(study: StoredStudy) -> Iterator[Line]:
    """Lines of the table; for a grid, one for each value of the first axis."""
    for f in study.formulas:
        errors = tuple(in_percent(e, U) for e, U in zip(f.error, f.U, strict=True))
        if set(errors) == {TINY}:
            yield Line(f.quantity, 1, Markup(""), (f"all errors within {LEAST} %",))
        elif study.is_star:
            yield Line(f.quantity, 1, Markup(""), errors)
        else:
            yield from _of_grid(study, f.quantity, errors)


def _of_grid(study: StoredStudy, quantity: str, errors: tuple[str, ...]) -> Iterator[Line]:
    values, width = _values(study, 0), len(_values(study, -1))
    for k, value in enumerate(values):
        yield Line(
            quantity, 0 if k else len(values), _value(study.axes[0], value),
            errors[k * width : (k + 1) * width],
        )  # fmt: skip


def in_percent(error: float, U: float) -> str:
    """Text of an error with its bar, such as "−17.2 ± 0.3".

    A bar that changes no digit is omitted.
    """
    if not math.isfinite(error + U):
        return "–"
    size = 100 * abs(error)
    if size + 100 * U < LEAST:
        return TINY
    sign = "" if size < LEAST / 10 else "+" if error > 0 else MINUS
    bar = f" ± {_digits(100 * U, 1)}" if abs(error) * NO_DIGIT < U else ""
    return f"{sign}{_digits(size, 3)}{bar}"


def _digits(value: float, count: int) -> str:
    """Text of a number with the given significant digits; "0" far below LEAST."""
    return decimal(value, count) if value >= LEAST / 10 else "0"


def _values(study: StoredStudy, axis: int) -> list[float]:
    return sorted({point[axis] for point in study.points})


def _value(axis: StudyAxis, value: float) -> Markup:
    return Markup("{} = {}{}").format(
        symbol(axis.symbol), number(value), f" {unit(axis)}" if unit(axis) else ""
    )
