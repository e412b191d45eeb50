"""Whether a stored number was stated by a person or computed, determined from its digits.

Stated figures have one or two significant digits; computed figures have all nine digits that are
stored. A number with up to four digits is considered stated, and must be repeated exactly. One in
ten thousand computed numbers has so few digits and is treated in the same manner.

Ends of intervals and acceptance limits are stored directly, not as a quotient. They are considered
stated if they have up to six digits, which happens for one in a thousand computed numbers.
"""

import math

STATED_DIGITS = 4  # significant digits of a number that a person writes, at most
LITERAL_DIGITS = 6  # largest number of digits of a number that is stored as written
RECORDED_TOL = 1e-8  # relative: nine significant digits are stored


def is_stated(value: float | None, rounding: float = 0.0) -> bool:
    """Whether a non-zero number has at most STATED_DIGITS digits, as numbers that a person writes.

    >>> is_stated(0.025), is_stated(3.59745921e-07)
    (True, False)
    """
    if not value:
        return False
    nearest = float(f"{value:.{STATED_DIGITS}g}")
    return math.isclose(value, nearest, rel_tol=RECORDED_TOL, abs_tol=rounding)


def is_literal(value: float | None) -> bool:
    """Whether a number, which is not a quotient, has few digits, as if stated by a person.

    >>> is_literal(0.0), is_literal(0.512345), is_literal(0.512345678)
    (True, True, False)
    """
    if value is None:
        return False
    return is_stated(value) or value == float(f"{value:.{LITERAL_DIGITS}g}")


def is_printed(u: float | None) -> bool:
    """Whether an uncertainty is stated, or is half a unit of the last digit divided by √3."""
    return u is not None and (is_stated(u) or is_stated(u * math.sqrt(12)))
