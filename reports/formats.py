"""Format of numbers, symbols and texts on the page."""

import math
import re
from typing import NamedTuple

import numpy as np
from markupsafe import Markup, escape

from reports.erratum_names import erratum_name
from verify.core.differences import difference_texts, divisor, significant
from verify.core.references import reference_name
from verify.core.results import FE, Kind, Row

MINUS = "−"


_INDEX = re.compile(r"(?<![\w.])([A-Za-zΑ-ωΔ])_(\{[^}]*\}|[A-Za-z0-9Α-ω∞]{1,6})(?![\w])")
_LEDGER = re.compile(r"ledger ([a-z]+\d*):([a-zA-Z0-9-]+)")
_POWER = re.compile(r"(?<=[\w)])\^(-?\d+(?:\.\d+)?)")
_POWER_OF_TEN = re.compile(rf"e({MINUS}?\d+)")
_MODULE = re.compile(r"\b(?:analytic|fem|meshes|verify)(?:\.[a-z]\w*)+")
_MINUS = re.compile(r"(?<![\w./^-])-(?=\d)")


def symbol(text: str) -> Markup:
    """HTML of a symbol such as u_r(r_i): italic letters with lowered indices."""
    return Markup("<var>{}</var>").format(
        Markup(re.sub(r"_([^\s()/|^*²³]+)", r"<sub>\1</sub>", str(escape(text))))  # noqa: S704
    )


def prose(text: str) -> Markup:
    """HTML of running text: symbols such as k_1 have a lowered index, m^2 a raised exponent.

    The path of a module may be broken only after its dots.
    """

    def lowered(match: re.Match[str]) -> str:
        return f"<var>{match[1]}<sub>{match[2].strip('{}')}</sub></var>"

    text = re.sub(r"(?<=\d)%", "\u202f%", text)
    raised = _POWER.sub(r"<sup>\1</sup>", str(escape(text)))
    raised = _MODULE.sub(lambda path: path[0].replace(".", ".<wbr>"), raised)
    return Markup(_INDEX.sub(lowered, _MINUS.sub(MINUS, raised)))  # noqa: S704 - escaped before


def spaced(text: str) -> str:
    """Text with a space before each percent sign that follows a digit."""
    return re.sub(r"(?<=\d)%", " %", text)


def linked(text: str) -> Markup:
    """HTML of running text in which "ledger paper:entry" links to that entry."""
    return Markup(  # noqa: S704 - escaped by prose
        _LEDGER.sub(_erratum, str(prose(text)))
    )


def _erratum(entry: re.Match[str]) -> str:
    paper, key = entry.groups()
    return f'<a href="#erratum-{paper}-{key}">erratum: {prose(erratum_name(key))}</a>'


def number(value: float | int | str | None, digits: int = 6) -> str:
    """Text of a number with six significant digits and a true minus; a dash for None."""
    if value is None:
        return "–"
    if isinstance(value, str):
        return value
    if isinstance(value, int):
        return str(value).replace("-", MINUS)
    return f"{value:.{digits}g}".replace("-", MINUS)


def decimal(size: float, digits: int) -> str:
    """Text of a non-negative number with significant digits and without exponent.

    If it has more digits before the point, only its integer part is printed.
    """
    if size >= 10**digits:
        return f"{size:.0f}"
    return np.format_float_positional(size, precision=digits, fractional=False, trim="-")


def written(value: float | int | str | None) -> str | Markup:
    """Text of a number as by `number`; 1.18e-08 becomes a power of ten."""
    mantissa, e, exponent = number(value).partition("e")
    if isinstance(value, str) or not e:
        return number(value)
    power = str(int(exponent.replace(MINUS, "-"))).replace("-", MINUS)
    return Markup("{}<small>×10<sup>{}</sup></small>").format(mantissa, power)


def small(value: float | None, digits: int = 6) -> str | Markup:
    """Text of a number, as a power of ten if it has too many decimals."""
    if value is not None and 0 < abs(value) < 1e-4:
        return power(value)
    return number(value, digits)


class Shown(NamedTuple):
    """Texts of formula and reference, the latter with its uncertainty in brackets: 0.5817896(40).

    `by` is the name of the reference, empty for finite elements.
    """

    formula: str
    fem: str | Markup
    by: str = ""


def values(row: Row) -> Shown:
    """Texts of formula and reference, such as 0.5820205 and 0.5817896(40).

    The digits in brackets are the uncertainty u in units of the last decimal; u determines the
    number of decimals of both texts.
    """
    u = row.u_num
    if row.kind == "fact" and row.formal_order is not None:  # observed order and order of theory
        return Shown(number(row.analytic, 3), "–" if row.fem is None else f"{row.fem:.2f}")
    name = reference_name(row)
    named = name != FE and row.reference is not None and not _is_printed(row)
    by = name if named else ""
    found = row.reference if by else row.fem
    if row.kind == "fact" or found is None or not u or not math.isfinite(u):
        digits = 3 if row.kind in ("fact", "exact") else 6
        return Shown(number(row.analytic, digits), small(found, digits), by)
    fem, decimals = concise(found, u)
    known = row.analytic
    return Shown("–" if known is None else f"{known:.{decimals}f}".replace("-", MINUS), fem, by)


def _is_printed(row: Row) -> bool:
    """Whether the reference is the printed number itself, which has separate columns."""
    return row.partner is not None and row.fem is None and row.by.startswith("printed")


def concise(value: float, u: float) -> tuple[str, int]:
    """Text of a value with its uncertainty in brackets (two digits), and its number of decimals.

    The value has at most nine digits, for which a table has space. If this limit applies, the
    uncertainty in brackets is rounded up to at least one unit of the last digit.
    """
    size = math.floor(math.log10(abs(value))) if value else 0
    decimals = max(min(1 - int(f"{u:.1e}".partition("e")[2]), 8 - size), 0)
    last = max(round(u * 10.0**decimals), 1)
    return f"{value:.{decimals}f}({last})".replace("-", MINUS), decimals


def difference(row: Row) -> Markup:
    """Text of the difference of a row in per cent of the reference, or of the named scale."""
    return _cell(difference_texts(row)[0])


def tolerance(row: Row) -> Markup:
    """Text of the expected interval or of the tolerance, in the format of `difference`."""
    text = difference_texts(row)[1]
    if not text and row.tolerance is not None and row.kind is not Kind.FACT:
        return relative(row, "tolerance")
    return _cell(text.removeprefix("±"))


def relative(row: Row, name: str) -> Markup:
    """Text of an uncertainty of the row in per cent of the divisor of its difference."""
    value, size = getattr(row, name), divisor(row)
    return fraction(row, value / size) if value is not None and size else Markup("–")


def fraction(row: Row, value: float | None, *, signed: bool = False) -> Markup:
    """Text of a fraction in per cent; the plain number for a balance or an order of convergence."""
    if row.kind in (Kind.EXACT, Kind.TREND):
        return power(value)
    return percents(value, signed=signed)


def percents(value: float | None, *, signed: bool = False) -> Markup:
    """Text of a fraction in per cent with two significant digits; a dash for None."""
    if value is None or not math.isfinite(value):
        return Markup("–")
    return _cell(f"{significant(100 * value, 2, signed=signed)} %")


def _cell(text: str) -> Markup:
    """HTML of a text with numbers, true minuses and powers of ten.

    An interval, or a value with the name of its scale, has two lines.
    """
    if not text:
        return Markup("–")
    value, of, name = text.partition(" of ")
    parts = [_POWER_OF_TEN.sub(_raised, part.replace(" %", "\u202f%").replace("-", MINUS))
             for part in value.split(" to ")]  # fmt: skip
    shown = Markup(" to<br>").join(Markup(part) for part in parts)  # noqa: S704 - numbers alone
    return (
        shown + Markup('<br><small class="by">relative to {}</small>').format(prose(name))
        if of
        else shown
    )


def _raised(match: re.Match[str]) -> str:
    return f"<small>×10<sup>{match[1]}</sup></small>"


def order(row: Row) -> str:
    """Text of the observed order of convergence, or of the reason why there is none."""
    found = row.fem if row.kind == "fact" else row.order
    if isinstance(found, str):
        return found
    return "–" if found is None else f"{found:.2f}"


def power(value: float | None, *, signed: bool = False, digits: int = 1) -> Markup:
    """HTML of a number as a power of ten: 2.1e-8 gives 2.1×10⁻⁸; 2.5 is unchanged.

    `digits` is the number of digits after the point.
    """
    if value is None or not math.isfinite(value):
        return Markup("–")
    if value == 0:
        return Markup("0")
    sign = "+" if signed else ""
    mantissa, exponent = f"{value:{sign}.{digits}e}".split("e")
    if int(exponent) == 0:
        return Markup("{}").format(mantissa.replace("-", MINUS))
    return Markup("{}<small>×10<sup>{}</sup></small>").format(
        mantissa.replace("-", MINUS), str(int(exponent)).replace("-", MINUS)
    )
