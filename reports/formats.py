"""Format of numbers, symbols and equations on the page."""

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
    """u_r(r_i) as italic letters with lowered indices."""
    return Markup("<var>{}</var>").format(
        Markup(re.sub(r"_([^\s()/|^*²³]+)", r"<sub>\1</sub>", str(escape(text))))  # noqa: S704
    )


def prose(text: str) -> Markup:
    """Running text in which symbols such as k_1 have a lowered index, m^2 a power.

    The path of a module may be broken only behind its dots.
    """

    def lowered(match: re.Match[str]) -> str:
        return f"<var>{match[1]}<sub>{match[2].strip('{}')}</sub></var>"

    text = re.sub(r"(?<=\d)%", "\u202f%", text)
    raised = _POWER.sub(r"<sup>\1</sup>", str(escape(text)))
    raised = _MODULE.sub(lambda path: path[0].replace(".", ".<wbr>"), raised)
    return Markup(_INDEX.sub(lowered, _MINUS.sub(MINUS, raised)))  # noqa: S704 - escaped before


def linked(text: str) -> Markup:
    """Running text in which "ledger paper:entry" links to that entry."""
    return Markup(  # noqa: S704 - escaped by prose
        _LEDGER.sub(_erratum, str(prose(text)))
    )


def _erratum(entry: re.Match[str]) -> str:
    paper, key = entry.groups()
    return f'<a href="#erratum-{paper}-{key}">erratum of {prose(erratum_name(key))}</a>'


def number(value: float | int | str | None, digits: int = 6) -> str:
    """Six significant digits, a true minus, a dash for nothing."""
    if value is None:
        return "–"
    if isinstance(value, str):
        return value
    if isinstance(value, int):
        return str(value).replace("-", MINUS)
    return f"{value:.{digits}g}".replace("-", MINUS)


def decimal(size: float, digits: int) -> str:
    """Significant digits of a number that is not negative, or its whole part; no exponent."""
    if size >= 10**digits:
        return f"{size:.0f}"
    return np.format_float_positional(size, precision=digits, fractional=False, trim="-")


def written(value: float | int | str | None) -> str | Markup:
    """A number formatted by `number`; 1.18e-08 as a power of ten."""
    mantissa, e, exponent = number(value).partition("e")
    if isinstance(value, str) or not e:
        return number(value)
    power = str(int(exponent.replace(MINUS, "-"))).replace("-", MINUS)
    return Markup("{}<small>×10<sup>{}</sup></small>").format(mantissa, power)


def small(value: float | None, digits: int = 6) -> str | Markup:
    """A number, as a power of ten if its decimals are too many to read."""
    if value is not None and 0 < abs(value) < 1e-4:
        return power(value)
    return number(value, digits)


class Shown(NamedTuple):
    """Formula, and reference with its standard uncertainty in brackets: 0.5817896(40).

    `by` names the reference unless it is finite elements.
    """

    formula: str
    fem: str | Markup
    by: str = ""


def values(row: Row) -> Shown:
    """Formula and reference with as many decimals as u has: 0.5820205 and 0.5817896(40).

    The digits in brackets are u in units of the last decimal.
    """
    u = row.u_num
    if row.kind == "fact" and row.formal_order is not None:  # observed order and order of theory
        return Shown(number(row.analytic, 3), "–" if row.fem is None else f"{row.fem:.2f}")
    name = reference_name(row)
    told = name != FE and row.reference is not None and not _is_printed(row)
    by = name if told else ""
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
    """A value with two digits of its uncertainty in brackets, and its number of decimals.

    No more than nine digits of the value, which a table has room for: the last one's bracket is
    then no less than u.
    """
    size = math.floor(math.log10(abs(value))) if value else 0
    decimals = max(min(1 - int(f"{u:.1e}".partition("e")[2]), 8 - size), 0)
    last = max(round(u * 10.0**decimals), 1)
    return f"{value:.{decimals}f}({last})".replace("-", MINUS), decimals


def difference(row: Row) -> Markup:
    """Formula less reference in percent of the reference, or of the scale that is named."""
    return _cell(difference_texts(row)[0])


def tolerance(row: Row) -> Markup:
    """The ends of the expected interval, or the uncertainty that is allowed, as `difference`."""
    text = difference_texts(row)[1]
    if not text and row.tolerance is not None and row.kind is not Kind.FACT:
        return relative(row, "tolerance")
    return _cell(text.removeprefix("±"))


def relative(row: Row, name: str) -> Markup:
    """An uncertainty of the row in percent of the divisor of its difference."""
    value, size = getattr(row, name), divisor(row)
    return fraction(row, value / size) if value is not None and size else Markup("–")


def fraction(row: Row, value: float | None, *, signed: bool = False) -> Markup:
    """A fraction in percent; of a balance or an order unchanged."""
    if row.kind in (Kind.EXACT, Kind.TREND):
        return power(value)
    return percents(value, signed=signed)


def percents(value: float | None, *, signed: bool = False) -> Markup:
    """A fraction as a percentage with two significant digits, a dash for none."""
    if value is None or not math.isfinite(value):
        return Markup("–")
    return _cell(f"{significant(100 * value, 2, signed=signed)} %")


def _cell(text: str) -> Markup:
    """A text of numbers with true minuses and powers of ten; an interval, a scale on two lines."""
    if not text:
        return Markup("–")
    value, of, name = text.partition(" of ")
    parts = [_POWER_OF_TEN.sub(_raised, part.replace(" %", "\u202f%").replace("-", MINUS))
             for part in value.split(" to ")]  # fmt: skip
    shown = Markup(" to<br>").join(Markup(part) for part in parts)  # noqa: S704 - numbers alone
    return (
        shown + Markup('<br><small class="by">of {}</small>').format(prose(name)) if of else shown
    )


def _raised(match: re.Match[str]) -> str:
    return f"<small>×10<sup>{match[1]}</sup></small>"


def order(row: Row) -> str:
    """Observed order of convergence, or the word for why there is none."""
    found = row.fem if row.kind == "fact" else row.order
    if isinstance(found, str):
        return found
    return "–" if found is None else f"{found:.2f}"


def power(value: float | None, *, signed: bool = False, digits: int = 1) -> Markup:
    """2.1e-8 as 2.1×10⁻⁸, with the given digits after the point; 2.5 unchanged."""
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
