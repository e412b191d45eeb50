"""Text that pytest prints for a failed row or machine part, instead of a traceback."""

import re
import shlex

from verify.app.extras import PACKAGE, extra_of
from verify.core.results import Kind, Row

CONVERGENCE = ": convergence"
NO_MODULE = re.compile(r"No module named '(\w+)")


class FreewheelError(Exception):
    """Failure of a row or of a machine part; the test prints the message of this error."""


def failure(row: Row, file: str) -> str:
    """Text for a failed row: numbers in its unit, and the recommended next step."""
    lines = [f"{row.status.value}: {row.reason}", _compared(row), *_judged(row)]
    name = row.quantity.removesuffix(CONVERGENCE)
    command = shlex.join(["freewheel", "explain", name, file])
    return "\n".join([*lines, f"next: {_next(row)}", f"each step of the judgement: {command}"])


def _compared(row: Row) -> str:
    unit = "" if row.unit == "1" else f" [{row.unit}]"
    return f"{row.quantity}: {row.symbol}{unit}, {row.kind.value}"


def _judged(row: Row) -> list[str]:
    """Lines with value, reference, difference, tolerance and detection limit, if they exist."""
    unit = "" if row.unit == "1" else f" {row.unit}"
    sides = (("value", row.analytic), ("reference", _reference(row)))
    limits = (("difference", row.difference), ("tolerance", row.tolerance))
    shown = [
        ", ".join(f"{label} {number:.6g}{unit}" for label, number in numbers if number is not None)
        for numbers in (sides, limits)
        if row.kind is not Kind.FACT
    ]
    if row.interval:
        low, high = row.interval
        shown.append(f"expected error {low:+.3%} to {high:+.3%}: {row.interval_source}")
    if row.detects is not None:
        shown.append(f"detection limit {row.detects:.2%}, required {row.demand:.2%}")
    if row.grid:
        levels = ", ".join(f"{value:.6g}" for _, value in row.grid.levels)
        shown.append(f"reference by levels, coarse to fine: {levels} {row.grid.unit}".rstrip(" 1"))
    return [line for line in shown if line]


def _reference(row: Row) -> float | None:
    return row.partner.value if row.partner else row.fem


def _next(row: Row) -> str:
    """Recommended next step for the reason of a failed row."""
    reason = row.reason
    if re.search(r"\.py:\d+", reason):
        return "correct this line of the file"
    if "does not depend on the level" in reason:
        return "use `level` for the mesh size, such as refine=2**level"
    if "insufficient sensitivity" in reason:
        return "use a finer mesh, or state `sensitivity=(value, reason)`"
    if "converge" in reason or row.quantity.endswith(CONVERGENCE):
        return "refine the mesh evenly with `level`, or check singularities and `order`"
    return "check the formula, the reference and the source of the expected error"


def with_extra(message: str) -> str:
    """The message; if an optional library is missing, with the command that installs it."""
    missing = NO_MODULE.search(message)
    extra = extra_of(missing[1]) if missing else ""
    return f"{message}\ninstall it: pip install '{PACKAGE}[{extra}]'" if extra else message
