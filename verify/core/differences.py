"""Difference of formula and reference, and the allowed difference, in display format.

One convention: (formula - reference)/reference. A positive difference is a formula with the larger
magnitude, also if both values are negative; the difference is in the same interval as the expected
model error. If a row has another scale than its reference, the difference is (formula -
reference)/scale, with the sign of the values; the scale is named next to it. Balances and orders
are plain numbers; facts have no difference.
"""

import math
from dataclasses import dataclass

from verify.core.results import Kind, Row, Status

UNJUDGED = (Status.SHOWN, Status.CALIBRATED, Status.NOTE, Status.SKIP)
COMPARED = (Kind.IDENTITY, Kind.APPROXIMATION)
FEWEST, MOST = 2, 8  # significant digits


@dataclass(frozen=True, kw_only=True)
class Difference:
    """A difference `value` with its expanded uncertainty `U`, both as fractions.

    `of` is the name of the scale, empty for the reference. `allowed` are the ends between which a
    judged row passes. Without `percent`, the values are plain numbers.
    """

    value: float
    U: float | None
    allowed: tuple[float, float] | None
    of: str = ""
    percent: bool = True


def divisor(row: Row) -> float | None:
    """What the row's differences and uncertainties are divided by, in its unit; positive."""
    if row.kind in COMPARED and not _scale_name(row) and row.reference:
        return abs(row.reference)
    return 1.0 if row.kind is Kind.TREND else row.scale or None


def sense(row: Row) -> float:
    """-1 if the reference is negative, so that a larger value has a smaller magnitude; else 1."""
    of_reference = row.kind in COMPARED and not _scale_name(row) and row.reference
    return math.copysign(1.0, of_reference) if of_reference else 1.0


def difference(row: Row) -> Difference | None:
    """The difference of a row; None for a statement, or if no number can be compared."""
    found, whole = offset(row), divisor(row)
    if row.kind is Kind.FACT or found is None or whole is None or not math.isfinite(found / whole):
        return None
    U = row.tolerance / whole if row.tolerance is not None else None
    return Difference(
        value=sense(row) * found / whole, U=U, allowed=_allowed(row, U), of=_scale_name(row),
        percent=row.kind in (*COMPARED, Kind.ASYMPTOTIC),
    )  # fmt: skip


def difference_texts(row: Row) -> tuple[str, str]:
    """Difference and allowed difference, such as "+0.0041 %" and "±0.0093 %"; empty for none.

    Both have enough digits to show on which side of an end the difference lies.
    """
    found = difference(row)
    if found is None:
        return "", ""
    unit = " %" if found.percent else ""
    numbers = [found.value, *(found.allowed or ())]
    digits = _digits(numbers)
    value, *ends = (significant(_shown(x, found), digits, signed=True) + unit for x in numbers)
    if found.of:
        value += f" of {found.of}"
    if not ends:
        return value, ""
    return value, f"{ends[0]} to {ends[1]}" if row.interval else f"±{ends[1].removeprefix('+')}"


def percent(fraction: float, *, signed: bool = False) -> str:
    """0.0123 as "1.2 %": two significant digits, whole percents from 100 on."""
    return significant(100 * fraction, FEWEST, signed=signed) + " %"


def significant(value: float, digits: int, *, signed: bool = False) -> str:
    """A number with the given significant digits, as 1.2e-8 if it has too many decimals."""
    sign = "+" if signed else ""
    if value == 0:
        return "0"
    text = f"{value:{sign}#.{digits}g}"  # with #, 2.0 keeps its last digit
    if "e+" in text and abs(value) < 1e6:
        return f"{value:{sign}.0f}"
    mantissa, e, exponent = text.partition("e")
    return mantissa.removesuffix(".") + (f"e{int(exponent)}" if e else "")


def largest(rows: list[Row]) -> Row | None:
    """The row with the largest difference of all rows with a formula value, judged or not."""
    compared = [row for row in rows if row.kind in COMPARED and difference(row) is not None]
    return max(compared, key=size, default=None)


def size(row: Row) -> float:
    """The magnitude of the row's difference as a fraction; zero without one."""
    found = difference(row)
    return 0.0 if found is None else abs(found.value)


def offset(row: Row) -> float | None:
    """Formula less reference in the row's unit; the residual of a balance, a fact's margin."""
    if row.kind in (Kind.EXACT, Kind.ASYMPTOTIC, Kind.FACT):
        return row.difference
    if row.analytic is None or row.reference is None:
        return None
    return row.analytic - row.reference


def _scale_name(row: Row) -> str:
    """The name of the scale of the row, empty if the scale is the compared value."""
    itself = row.analytic is not None and row.scale == abs(row.analytic)
    return "" if itself and row.kind in COMPARED and row.reference else row.scale_name


def _allowed(row: Row, U: float | None) -> tuple[float, float] | None:
    """The expected interval of an approximation, or ± the tolerance of a judged row."""
    if row.kind is Kind.APPROXIMATION or row.status in UNJUDGED:
        return row.interval
    return None if U is None else (-U, U)


def _shown(fraction: float, found: Difference) -> float:
    return 100 * fraction if found.percent else fraction


def _digits(numbers: list[float]) -> int:
    """The fewest digits with which rounded numbers have the order of the exact numbers."""
    exact = _order(numbers)
    for digits in range(FEWEST, MOST):
        if _order([float(f"{x:.{digits}g}") for x in numbers]) == exact:
            return digits
    return MOST


def _order(numbers: list[float]) -> tuple[bool, ...]:
    """Whether the first number lies between the others, and whether the others differ."""
    if len(numbers) == 1:
        return ()
    value, low, high = numbers
    return low <= value, value <= high, low < high
