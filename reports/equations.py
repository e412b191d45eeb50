"""Equations of a page as SVG; typst draws all at once, and a page contains each glyph once."""

import json
import re
from collections.abc import Iterable, Mapping, Sequence
from xml.etree import ElementTree as ET

from markupsafe import Markup, escape

from reports.glyphs import FINE, Glyphs, short
from reports.mathematics import Node, tree
from reports.typesetting import NotSet, typeset

SVG = "{http://www.w3.org/2000/svg}"
LINK = "{http://www.w3.org/1999/xlink}href"
PIXELS = 4 / 3  # of a point
LONG = 500  # pixels of an equation that a phone scrolls: one shrunk to its width is illegible
_NUMBER = re.compile(r"-?[\d.]+")
_PLACE = re.compile(r"<!--equation (\d+)-->")


class Equations:
    """Equations of one page: `maths` collects them, `placed` inserts their drawings."""

    def __init__(self) -> None:
        self._numbers: dict[str, int] = {}
        self._glyphs = Glyphs()

    def maths(self, tex: str) -> Markup:
        """Placeholder of an equation in a page."""
        number = self._numbers.setdefault(tex, len(self._numbers))
        return Markup(f"<!--equation {number}-->")  # noqa: S704 - a number

    def placed(self, pages: Sequence[str]) -> list[str]:
        """Pages with the drawings of their equations; screen readers read the TeX source.

        Each page contains the glyphs that it uses.
        """
        drawn = self._drawn()
        return [
            self._glyphs.on(_PLACE.sub(lambda place: drawn[int(place[1])], page)) for page in pages
        ]

    def _drawn(self) -> list[str]:
        """SVG of every equation in the order of the requests; its source if it cannot be drawn."""
        trees = [_tree_or_none(tex) for tex in self._numbers]
        pages = iter(_pages([found for found in trees if found]))
        return [
            self._svg(tex, page) if found and (page := next(pages, None))
            else f"<code>{escape(tex)}</code>"
            for tex, found in zip(self._numbers, trees, strict=True)
        ]  # fmt: skip

    def _svg(self, tex: str, page: bytes) -> str:
        root = ET.fromstring(page)  # noqa: S314 - made by typst
        square, *parts = (part for part in root if part.tag != f"{SVG}defs")
        outlines = {one.attrib["id"]: one[0].attrib["d"] for one in root.iter(f"{SVG}symbol")}
        wide, high = _numbers(root.attrib["viewBox"])[2:]
        below = high - _numbers(square.attrib["transform"])[1]
        return (
            f'<svg class="maths" role="img" aria-label="{escape(tex)}" '
            f'style="vertical-align:{-below * PIXELS:.1f}px" viewBox="0 0 {wide:.1f} {high:.1f}" '
            f'width="{wide * PIXELS:.1f}" height="{high * PIXELS:.1f}"'
            f"{' data-long' if wide * PIXELS > LONG else ''}>"
            f"{self._shapes(parts, outlines)}</svg>"
        )

    def _shapes(self, parts: Iterable[ET.Element], outlines: dict[str, str]) -> str:
        """SVG of rules (of fractions and roots) and of glyphs at their positions [pt].

        Glyphs on one line are placed together, because they have the same vertical position.
        """
        drawn, glyphs = "", []
        for part in parts:
            *_, left, top = _numbers(part.attrib["transform"])
            if part.tag == f"{SVG}path":
                length = part.attrib["d"].removeprefix("M 0 0")
                width = part.attrib["stroke-width"]
                drawn += (
                    f'<path d="M{left:.2f} {top:.2f}{_tight(length)}" '
                    f'stroke="currentColor" stroke-width="{width}"/>'
                )
            elif uses := list(part):
                x, y = left + float(uses[0].attrib["x"]), top - float(uses[0].attrib["y"])
                glyphs.append((self._glyphs.name(_run(uses, outlines)), x, round(y, 1)))
        lines = dict.fromkeys(y for *_, y in glyphs)
        return drawn + "".join(
            self._glyphs.line(y, [g[:2] for g in glyphs if g[2] == y]) for y in lines
        )


def _run(uses: Sequence[ET.Element], outlines: Mapping[str, str]) -> str:
    """Outline of a run of glyphs, relative to the first glyph, in steps of 1/`FINE` pt.

    The glyphs are side by side, as in "mm", or one above the other, as the pieces of a large
    bracket.
    """
    places = [(float(use.attrib["x"]), float(use.attrib["y"])) for use in uses]
    (left, low), *_ = places
    return "".join(
        _in_steps(outlines[use.attrib[LINK].removeprefix("#")], x - left, y - low)
        for use, (x, y) in zip(uses, places, strict=True)
    )


def _tree_or_none(tex: str) -> Node | None:
    try:
        return tree(tex)
    except (ValueError, LookupError):  # of a user's case: not supported by the converter
        return None


def _pages(trees: Sequence[Node]) -> list[bytes]:
    """SVG pages with a drawing of each tree; empty if typst is missing or fails."""
    if not trees:
        return []
    try:
        drawn = typeset(
            "equations.typ", {"trees": json.dumps(trees)}, ignore_system_fonts=True, format="svg"
        )
    except NotSet:
        return []
    return drawn if isinstance(drawn, list) else [drawn]


def _numbers(text: str) -> list[float]:
    return [float(number) for number in _NUMBER.findall(text)]


def _tight(path: str) -> str:
    """A path rounded to hundredths of a point, without unnecessary blanks."""
    rounded = _NUMBER.sub(lambda number: short(float(number[0]), 2), path)
    return re.sub(r"(\.\d+) (?=\.)", r"\1", _joined(rounded))


def _in_steps(outline: str, right: float, up: float) -> str:
    """An outline shifted by a distance [pt], in integer steps of 1/`FINE` pt."""
    moved = outline.replace("M 0 0", f"M {right:f} {up:f}", 1)
    return _joined(_NUMBER.sub(lambda number: str(round(FINE * float(number[0]))), moved))


def _joined(path: str) -> str:
    """A path without blanks at letters and signs; its first move is absolute."""
    tight = re.sub(r" ?([A-Za-z]) ?", r"\1", path).replace(" -", "-").strip()
    return tight.replace("M0 0m", "M", 1)
