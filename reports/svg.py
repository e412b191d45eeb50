"""Elements of SVG drawings; labels are escaped, colours and fonts come from CSS classes."""

import math
import re
from collections.abc import Iterable, Sequence

from markupsafe import Markup

MINUS = "−"
_PERCENT = re.compile(r"(?<=\d)%")
_INDEX = re.compile(r"_(\{[^}]*\}|[^\s()/\[\]|^,;:·=*]+)")


def drawing(width: float, height: float, body: Iterable[Markup], label: str, css: str) -> Markup:
    """SVG image; `label` is the text for a screen reader."""
    return Markup(
        '<svg class="{}" xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {:g} {:g}" role="img" '
        'aria-label="{}">{}</svg>'
    ).format(css, width, height, label, Markup("").join(body))


def text(x: float, y: float, words: str, css: str = "", anchor: str = "start") -> Markup:
    """SVG text at a point, with lowered indices for symbols such as u_r(r_i)."""
    return Markup('<text class="{}" x="{}" y="{}" text-anchor="{}">{}</text>').format(
        css, short(x), short(y), anchor, lowered(words)
    )


def lowered(words: str) -> Markup:
    """SVG text spans with lowered indices for symbols such as u_r(r_i)."""
    parts, end, words = [], 0, _PERCENT.sub("\u202f%", words)
    for match in _INDEX.finditer(words):
        index = match[1].strip("{}")
        parts += [
            Markup("{}").format(words[end : match.start()]),
            Markup('<tspan class="sub" dy="3">{}</tspan><tspan dy="-3">&#8203;</tspan>').format(
                index
            ),
        ]
        end = match.end()
    return Markup("").join([*parts, Markup("{}").format(words[end:])])


def polyline(points: Iterable[Sequence[float]], css: str, *, closed: bool = False) -> Markup:
    """SVG path through points of the image."""
    d = "L".join(f"{short(x)},{short(y)}" for x, y in points)
    return Markup('<path class="{}" d="M{}{}"/>').format(css, d, "z" if closed else "")


def short(x: float) -> str:
    """Text of a coordinate with one decimal, without ".0", to save space on the page."""
    return f"{x:.1f}".removesuffix(".0")


def line(x0: float, y0: float, x1: float, y1: float, css: str) -> Markup:
    """SVG of a straight line."""
    return polyline([(x0, y0), (x1, y1)], css)


def circle(x: float, y: float, r: float, css: str) -> Markup:
    """SVG of a circle."""
    return Markup('<circle class="{}" cx="{}" cy="{}" r="{:g}"/>').format(
        css, short(x), short(y), r
    )


def marker(x: float, y: float, r: float, css: str, shape: int) -> Markup:
    """SVG of a mark with about the area of a circle of radius r.

    The shapes are circle, square, triangle, rhombus, inverted triangle and star; `shape` is any
    number from 0 on, and the shapes repeat.
    """
    shape %= 1 + len(_MARKS)
    if shape == 0:
        return circle(x, y, r, css)
    return polyline([(x + r * a, y + r * b) for a, b in _MARKS[shape - 1]], css, closed=True)


_MARKS: tuple[tuple[tuple[float, float], ...], ...] = (
    ((-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)),
    ((0.0, -1.4), (1.3, 0.9), (-1.3, 0.9)),
    ((0.0, -1.45), (1.2, 0.0), (0.0, 1.45), (-1.2, 0.0)),
    ((0.0, 1.4), (1.3, -0.9), (-1.3, -0.9)),
    tuple(
        (1.75 * k * math.sin(i * math.pi / 4), -1.75 * k * math.cos(i * math.pi / 4))
        for i, k in enumerate((1.0, 0.4) * 4)
    ),
)


def cross(x: float, y: float, r: float, css: str) -> Markup:
    """SVG of two crossing strokes, 2r wide."""
    d = f"M{short(x - r)},{short(y - r)}l{2 * r:g},{2 * r:g}m0,{-2 * r:g}l{-2 * r:g},{2 * r:g}"
    return Markup('<path class="{}" d="{}"/>').format(css, d)


def rectangle(x: float, y: float, width: float, height: float, css: str) -> Markup:
    """SVG of a filled rectangle."""
    return Markup('<rect class="{}" x="{}" y="{}" width="{}" height="{}"/>').format(
        css, short(x), short(y), short(max(width, 0.0)), short(max(height, 0.0))
    )


def arrow_head(x: float, y: float, dx: float, dy: float, css: str, size: float = 7.0) -> Markup:
    """SVG of a filled triangle with its tip at (x, y), pointing along (dx, dy)."""
    length = math.hypot(dx, dy) or 1.0
    c, s = dx / length * size, dy / length * size
    return polyline(
        [(x, y), (x - c + 0.4 * s, y - s - 0.4 * c), (x - c - 0.4 * s, y - s + 0.4 * c)],
        css, closed=True,
    )  # fmt: skip


def plain(value: float) -> str:
    """Text of the number of a tick, with a true minus."""
    return f"{value + 0.0:.6g}".replace("-", MINUS)


def decade(exponent: int) -> Markup:
    """SVG text of a power of ten."""
    sign = MINUS if exponent < 0 else ""
    return Markup('10<tspan class="sup" dy="-4">{}{}</tspan>').format(sign, abs(exponent))


def log_ticks(low: float, high: float, apart: float = 0.09) -> list[float]:
    """Numbers in [low, high] for a logarithmic axis, no two closer than `apart` of its length.

    Powers of ten come first, then 2 and 5 times these powers. A range with fewer than three such
    numbers has round numbers.
    """
    if not high > low > 0:
        return [low]
    decades = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    nearest = apart * math.log(high / low)
    taken: list[float] = []
    for factor in (1, 2, 5):
        for v in (float(f"{factor}e{k}") for k in decades):
            if low * (1 - 1e-9) <= v <= high * (1 + 1e-9) and all(
                abs(math.log(v / other)) >= nearest for other in taken
            ):
                taken.append(v)
    return sorted(taken) if len(taken) > 2 else ticks(low, high)


def ticks(low: float, high: float, about: int = 5) -> list[float]:
    """Round numbers in [low, high], about `about` of them."""
    if not high > low:
        return [low]
    raw = (high - low) / about
    unit = 10.0 ** math.floor(math.log10(raw))
    step = next(s * unit for s in (1, 2, 2.5, 5, 10) if s * unit >= raw * (1 - 1e-9))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [k * step for k in range(first, last + 1)]
