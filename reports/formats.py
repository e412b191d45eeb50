"""How numbers, symbols and equations are written on the page."""

import hashlib
import math
import re

import ziamath
from markupsafe import Markup, escape

from verify.results import Row

MINUS = "−"


class Glyphs:
    """Equations as SVG; every glyph is stored once a page and shared."""

    def __init__(self) -> None:
        self._known: dict[str, str] = {}

    def maths(self, tex: str, size: int = 15) -> Markup:
        """TeX as inline SVG in the colour of the text; read aloud as its source."""
        drawn = ziamath.Latex(tex, size=size, color="currentColor").svg()
        for name, glyph in re.findall(r'<symbol id="([^"]+)"(.*?)</symbol>', drawn, re.DOTALL):
            # ziamath reuses one id for different glyphs: name them by content
            unique = "g" + hashlib.sha256(glyph.encode()).hexdigest()[:10]
            self._known[unique] = f'<symbol id="{unique}"{glyph}</symbol>'
            drawn = drawn.replace(f'"#{name}"', f'"#{unique}"')
        drawn = re.sub(r"<symbol.*?</symbol>", "", drawn, flags=re.DOTALL)
        box = re.search(r'viewBox="([^"]+)"', drawn)
        assert box is not None
        _, top, _, height = map(float, box[1].split())
        start = (
            f'<svg class="maths" role="img" aria-label="{escape(tex)}" '
            f'style="vertical-align:{-(height + top):.1f}px" '
        )
        return Markup(drawn.replace("<svg ", start, 1))  # noqa: S704 - ziamath's own output

    def symbols(self) -> str:
        """The shared glyphs, for one hidden SVG."""
        return "".join(self._known.values())


def symbol(text: str) -> Markup:
    """u_r(r_i) as italic letters with subscripts."""
    return Markup("<var>{}</var>").format(
        Markup(re.sub(r"_([^\s()/|^]+)", r"<sub>\1</sub>", str(escape(text))))  # noqa: S704
    )


def number(value: float | int | str | None, digits: int = 6) -> str:
    """Six significant digits, a true minus, a dash for nothing."""
    if value is None:
        return "–"
    if isinstance(value, str):
        return value
    if isinstance(value, int):
        return str(value).replace("-", MINUS)
    return f"{value:.{digits}g}".replace("-", MINUS)


def values(row: Row) -> tuple[str, str]:
    """Formula and FE with the decimals that u allows; u in brackets: 0.58179(2)."""
    known = [v for v in (row.analytic, row.fem) if v]
    u = row.u_num
    if row.kind == "fact" and row.formal_order is not None:  # an order beside that of theory
        return number(row.analytic, 3), "–" if row.fem is None else f"{row.fem:.2f}"
    if row.kind == "fact" or not known or not u or not math.isfinite(u):
        digits = 3 if row.kind in ("fact", "exact") else 6
        return number(row.analytic, digits), number(row.fem, digits)
    size = math.floor(math.log10(max(map(abs, known))))
    decimals = min(1 - math.floor(math.log10(u)), 9 - size)  # nobody compares more than ten digits
    if size > 6 or decimals > 12:
        return number(row.analytic, 10), number(row.fem, 10)
    decimals = max(decimals, 0)
    last = math.ceil(u * 10.0**decimals)

    def fixed(value: float | None) -> str:
        return "–" if value is None else f"{value:.{decimals}f}".replace("-", MINUS)

    return fixed(row.analytic), fixed(row.fem) + (f"({last})" if row.fem is not None else "")


def power(value: float | None, *, signed: bool = False) -> Markup:
    """2.1e-8 as 2.1×10⁻⁸."""
    if value is None or not math.isfinite(value):
        return Markup("–")
    if value == 0:
        return Markup("0")
    mantissa, exponent = f"{value:+.1e}".split("e") if signed else f"{value:.1e}".split("e")
    return Markup("{}<small>×10<sup>{}</sup></small>").format(
        mantissa.replace("-", MINUS), str(int(exponent)).replace("-", MINUS)
    )
