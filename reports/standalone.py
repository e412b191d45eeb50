"""The page's drawings as SVG that stands alone: with its colours, sizes and fonts inside."""

import html
import re
from functools import cache
from pathlib import Path
from typing import TypedDict


HERE = Path(__file__).parent / "templates"
FONT = "Libertinus Serif"
OWN = (  # paper has its own size of letters, and one font for text and symbols
    f'text {{ font-family: "{FONT}"; }} .overview text {{ font-size: 17px; }} '
    ".chart .tick, .chart .label, .frame text { font-size: 12.5px; } "
    f'.sketch .sym {{ font-family: "{FONT}"; font-size: 15px; }}'
)


class Drawing(TypedDict):
    """An image and what it shows, in words."""

    svg: str
    alt: str


def standalone(svg: str) -> Drawing | None:
    """A drawing of the page with the rules it needs; None where there is none."""
    if not svg:
        return None
    label = re.search(r'aria-label="([^"]*)"', svg)
    styled = str(svg).replace(">", f"><style>{_rules()}</style>", 1)
    return {"svg": styled, "alt": html.unescape(label[1]) if label else ""}


@cache
def _rules() -> str:
    """The style sheet of drawings with the light palette put in: an image knows no variables."""
    palette = (HERE / "palette.css").read_text("utf-8")
    light = palette[: palette.index("@media")]
    colours = dict(re.findall(r"(--[\w-]+):\s*([^;]+);", light))
    rules = (HERE / "figures.css").read_text("utf-8")
    return re.sub(r"var\((--[\w-]+)\)", lambda match: colours[match[1]], rules) + OWN
