"""Difference of formula and reference, and the allowed difference, in display format.

The difference is (formula - reference)/reference. A positive difference means that the formula has
the larger magnitude, also if both values are negative. If the scale of a row is not its reference,
the difference is (formula - reference)/scale, with the sign of the values; the name of the scale is
displayed next to it. For balances and orders, the difference is a plain number. Facts have no
difference.
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

    `of` is the name of the scale, empty for the reference. `allowed` contains the limits between
    which a judged row passes. If `percent` is False, the values are plain numbers.
    """

    value: float
    U: float | None
    allowed: tuple[float, float] | None
    of: str = ""
    percent: bool = True


def divisor(row: Row) -> float | None:
    """Positive value by which differences and uncertainties of the row are divided, in its unit."""
    if row.kind in COMPARED and not _scale_name(row) and row.reference:
        return abs(row.reference)
    return 1.0 if row.kind is Kind.TREND else row.scale or None


def sense(row: Row) -> float:
    """Sign by which differences are multiplied: -1 if the reference is negative, otherwise 1.

    A positive difference then means that the formula has the larger magnitude.
    """
    of_reference = row.kind in COMPARED and not _scale_name(row) and row.reference
    return math.copysign(1.0, of_reference) if of_reference else 1.0


def difference(row: Row) -> Difference | None:
    """Difference of a row; None for a statement, or if no number can be compared."""
    found, whole = offset(row), divisor(row)
    if row.kind is Kind.FACT or found is None or whole is None or not math.isfinite(found / whole):
        return None
    U = row.tolerance / whole if row.tolerance is not None else None
    return Difference(
        value=sense(row) * found / whole, U=U, allowed=_allowed(row, U), of=_scale_name(row),
        percent=row.kind in (*COMPARED, Kind.ASYMPTOTIC),
    )  # fmt: skip


def difference_texts(row: Row) -> tuple[str, str]:
    """Texts of difference and allowed difference, such as "+0.0041 %" and "±0.0093 %".

    Both have enough digits to show whether the difference is within its limits. They are empty if
    there is no difference.
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
    """Text of a fraction in percent: 0.0123 gives "1.2 %".

    It has two significant digits, and no decimals from 100 % on.
    """
    return significant(100 * fraction, FEWEST, signed=signed) + " %"


def significant(value: float, digits: int, *, signed: bool = False) -> str:
    """Text of a number with the given significant digits; as 1.2e-8 if it has too many decimals."""
    sign = "+" if signed else ""
    if value == 0:
        return "0"
    text = f"{value:{sign}#.{digits}g}"  # with #, 2.0 keeps its last digit
    if "e+" in text and abs(value) < 1e6:
        return f"{value:{sign}.0f}"
    mantissa, e, exponent = text.partition("e")
    return mantissa.removesuffix(".") + (f"e{int(exponent)}" if e else "")


def largest(rows: list[Row]) -> Row | None:
    """Row with the largest difference, judged or not; None if no row has a difference."""
    compared = [row for row in rows if row.kind in COMPARED and difference(row) is not None]
    return max(compared, key=size, default=None)


def size(row: Row) -> float:
    """Magnitude of the row's difference as a fraction; zero if the row has no difference."""
    found = difference(row)
    return 0.0 if found is None else abs(found.value)


def offset(row: Row) -> float | None:
    """Formula minus reference, in the unit of the row.

    For a balance, it is the residual; for a fact, the margin.
    """
    if row.kind in (Kind.EXACT, Kind.ASYMPTOTIC, Kind.FACT):
        return row.difference
    if row.analytic is None or row.reference is None:
        return None
    return row.analytic - row.reference


def _scale_name(row: Row) -> str:
    """Name of the scale of the row; empty if the scale is the magnitude of the formula's value."""
    itself = row.analytic is not None and row.scale == abs(row.analytic)
    return "" if itself and row.kind in COMPARED and row.reference else row.scale_name


def _allowed(row: Row, U: float | None) -> tuple[float, float] | None:
    """Expected interval of an approximation or of a row that is not judged; otherwise ± `U`."""
    if row.kind is Kind.APPROXIMATION or row.status in UNJUDGED:
        return row.interval
    return None if U is None else (-U, U)


def _shown(fraction: float, found: Difference) -> float:
    return 100 * fraction if found.percent else fraction


def _digits(numbers: list[float]) -> int:
    """Smallest number of significant digits that keeps the order of the numbers (`_order`)."""
    exact = _order(numbers)
    for digits in range(FEWEST, MOST):
        if _order([float(f"{x:.{digits}g}") for x in numbers]) == exact:
            return digits
    return MOST


def _order(numbers: list[float]) -> tuple[bool, ...]:
    """Whether value >= low, value <= high and low < high, for `numbers` = value, low, high.

    The result is empty for a single number.
    """
    if len(numbers) == 1:
        return ()
    value, low, high = numbers
    return low <= value, value <= high, low < high
