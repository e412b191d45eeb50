"""Drawings of the page as separate SVG files with their colours, sizes and fonts."""

import html
import re
from functools import cache
from pathlib import Path
from typing import TypedDict

HERE = Path(__file__).parent / "templates"
FONT = "Libertinus Serif"
ASIDE = 44.0
OWN = (  # on paper: other size of letters, and one font for text and symbols
    f'text {{ font-family: "{FONT}"; }} .overview text {{ font-size: 17px; }} '
    ".chart .tick, .chart .label { font-size: 12.5px; } .frame text { font-size: 15px; } "
    f'.sketch .sym {{ font-family: "{FONT}"; font-size: 15px; }}'
)


class Drawing(TypedDict):
    """An image, its description in words, and the ratio of its height to its width."""

    svg: str
    alt: str
    ratio: float


def standalone(svg: str) -> Drawing | None:
    """A drawing of the page, with the style sheet of drawings; None without a drawing."""
    if not svg:
        return None
    label = re.search(r'aria-label="([^"]*)"', svg)
    left, top, width, height = _box(svg)
    if 'class="sketch"' in svg:  # its labels may be outside the drawing
        left, width = left - ASIDE, width + 2 * ASIDE
    wide = f'viewBox="{left:g} {top:g} {width:g} {height:g}"'
    styled = re.sub(r'viewBox="[^"]*"', wide, svg, count=1)
    return {
        "svg": styled.replace(">", f"><style>{_rules()}</style>", 1),
        "alt": html.unescape(label[1]) if label else "",
        "ratio": height / width,
    }


def _box(svg: str) -> tuple[float, float, float, float]:
    found = re.search(r'viewBox="(\S+) (\S+) (\S+) (\S+)"', svg)
    assert found is not None
    left, top, width, height = map(float, found.groups())
    return left, top, width, height


@cache
def _rules() -> str:
    """Style sheet of drawings with the light palette inserted (an image has no variables)."""
    palette = (HERE / "palette.css").read_text("utf-8")
    light = palette[: palette.index("@media")]
    colours = dict(re.findall(r"(--[\w-]+):\s*([^;]+);", light))
    rules = (HERE / "figures.css").read_text("utf-8")
    return re.sub(r"var\((--[\w-]+)\)", lambda match: colours[match[1]], rules) + OWN
