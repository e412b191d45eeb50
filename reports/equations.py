"""Equations of a page as SVG: typst draws all at once, and the page contains each glyph once."""

import json
import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise
from string import ascii_letters
from xml.etree import ElementTree as ET

from markupsafe import Markup, escape

from reports.mathematics import Node, tree
from reports.typesetting import NotSet, typeset

SYMBOLS = "<!--glyphs-->"  # place of the glyphs that the equations of a page share
SVG = "{http://www.w3.org/2000/svg}"
LINK = "{http://www.w3.org/1999/xlink}href"
PIXELS = 4 / 3  # of a point
FINE = 100  # steps of a point [1/pt] of outlines
FEW = 5  # glyphs, whose heights are shorter than a group
_NUMBER = re.compile(r"-?[\d.]+")
NEAR = 5.75  # advance of a digit [pt] at most: wider steps separate numbers from signs and units
_GLYPH = re.compile(r'<use href="#([gn]\d+)"')
_NUMERAL = re.compile(r'<use href="#(n\d+)"(?: x="([\d.]+)")?/>')
_PLACE = re.compile(r"<!--equation (\d+)-->")


Placed = tuple[str, float]  # name of a glyph and its place on a line [pt]
Run = tuple[Placed, ...]


class Equations:
    """The equations of one page: collected by `maths`, drawn by `placed`."""

    def __init__(self) -> None:
        self._numbers: dict[str, int] = {}
        self._names: dict[str, str] = {}  # of glyphs, by their outlines
        self._numerals: dict[Run, str] = {}  # names of glyphs close together, as in a number

    def maths(self, tex: str) -> Markup:
        """The place of an equation in a page."""
        number = self._numbers.setdefault(tex, len(self._numbers))
        return Markup(f"<!--equation {number}-->")  # noqa: S704 - a number

    def placed(self, pages: Sequence[str]) -> list[str]:
        """Pages with their equations in the colour of the text, read aloud as their source.

        Each page contains the glyphs that it uses.
        """
        drawn = self._drawn()
        return [self._with(_PLACE.sub(lambda place: drawn[int(place[1])], page)) for page in pages]

    def _with(self, page: str) -> str:
        """A page with its glyphs, named by their frequency, independent of other pages."""
        numerals = {name: run for run, name in self._numerals.items()}
        times = Counter(_NUMERAL.findall(_NUMERAL.sub(r'<use href="#\1"/>', page)))

        def spelled(use: re.Match[str]) -> str:
            run = numerals[use[1]]
            return use[0] if times[use[1], ""] > 1 else _uses(run, float(use[2] or 0))

        page = _NUMERAL.sub(spelled, page)
        groups = {name: _uses(numerals[name]) for name in numerals if f'"#{name}"' in page}
        used = Counter(_GLYPH.findall(page + "".join(groups.values()))).most_common()
        names = {name: _letters(i) for i, (name, _) in enumerate(used)}
        outlines = {name: outline for outline, name in self._names.items()}
        scale = f"scale({1 / FINE:g} -{1 / FINE:g})"
        glyphs = "".join(
            f'<g id="{own}">{groups[name]}</g>' if name in groups
            else f'<path id="{own}" transform="{scale}" d="{outlines[name]}"/>'
            for name, own in names.items()
        )  # fmt: skip
        named = page.replace(SYMBOLS, f"<defs>{glyphs}</defs>")
        return _GLYPH.sub(lambda use: f'<use href="#{names[use[1]]}"', named)

    def _drawn(self) -> list[str]:
        """Every equation, in the order of the requests; its source if it cannot be drawn."""
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
            f'width="{wide * PIXELS:.1f}" height="{high * PIXELS:.1f}">'
            f"{self._shapes(parts, outlines)}</svg>"
        )

    def _shapes(self, parts: Iterable[ET.Element], outlines: dict[str, str]) -> str:
        """Rules of fractions and roots, and glyphs, each in its place [pt].

        Glyphs on one line have its height once.
        """
        rules, glyphs = "", []
        for part in parts:
            *_, left, top = _numbers(part.attrib["transform"])
            if part.tag == f"{SVG}path":
                length = part.attrib["d"].removeprefix("M 0 0")
                width = part.attrib["stroke-width"]
                rules += (
                    f'<path d="M{left:.2f} {top:.2f}{_tight(length)}" '
                    f'stroke="currentColor" stroke-width="{width}"/>'
                )
            elif uses := list(part):
                x, y = left + float(uses[0].attrib["x"]), top - float(uses[0].attrib["y"])
                glyphs.append((self._name(_run(uses, outlines)), x, round(y, 1)))
        lines = dict.fromkeys(y for *_, y in glyphs)
        return rules + "".join(self._line(y, [g[:2] for g in glyphs if g[2] == y]) for y in lines)

    def _line(self, y: float, glyphs: Sequence[Placed]) -> str:
        """Glyphs of one height: in a group where that is shorter."""
        if len(glyphs) < FEW:
            return "".join(f'<use href="#{name}"{_at("x", x)}{_at("y", y)}/>' for name, x in glyphs)
        uses = _uses([self._numeral(run) for run in _close(glyphs)])
        return f'<g transform="translate(0 {_short(y, 1)})">{uses}</g>'

    def _numeral(self, run: Sequence[Placed]) -> Placed:
        """A single glyph as it is, several close ones under a name."""
        if len(run) == 1:
            return run[0]
        start = run[0][1]
        key = tuple((name, round(x - start, 1)) for name, x in run)
        return self._numerals.setdefault(key, f"n{len(self._numerals)}"), start

    def _name(self, outline: str) -> str:
        """The name of a glyph or of a run of glyphs, as of "mm", by its outline."""
        return self._names.setdefault(outline, f"g{len(self._names)}")


def _run(uses: Sequence[ET.Element], outlines: Mapping[str, str]) -> str:
    """The outline of glyphs of one part, from the first, in steps of 1/`FINE` pt.

    They stand side by side, as in "mm", or one above the other, as the pieces of a large bracket.
    """
    places = [(float(use.attrib["x"]), float(use.attrib["y"])) for use in uses]
    (left, low), *_ = places
    return "".join(
        _in_steps(outlines[use.attrib[LINK].removeprefix("#")], x - left, y - low)
        for use, (x, y) in zip(uses, places, strict=True)
    )


def _letters(number: int) -> str:
    """A short name: a to z, A to Z, aa to ZZ and so on; no other place of a page has such a one."""
    rest, last = divmod(number, len(ascii_letters))
    return (_letters(rest - 1) if rest else "") + ascii_letters[last]


def _tree_or_none(tex: str) -> Node | None:
    try:
        return tree(tex)
    except (ValueError, LookupError):  # of a user's case: not supported by the converter
        return None


def _pages(trees: Sequence[Node]) -> list[bytes]:
    """A drawing of each tree; none if typst is missing or fails, as for the PDF."""
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
    short = _NUMBER.sub(lambda number: _short(float(number[0]), 2), path)
    return re.sub(r"(\.\d+) (?=\.)", r"\1", _joined(short))


def _in_steps(outline: str, right: float, up: float) -> str:
    """An outline moved [pt], in whole steps of 1/`FINE` pt, which are short."""
    moved = outline.replace("M 0 0", f"M {right:f} {up:f}", 1)
    return _joined(_NUMBER.sub(lambda number: str(round(FINE * float(number[0]))), moved))


def _joined(path: str) -> str:
    """A path without blanks at letters and signs; its first move is absolute."""
    tight = re.sub(r" ?([A-Za-z]) ?", r"\1", path).replace(" -", "-").strip()
    return tight.replace("M0 0m", "M", 1)


def _close(glyphs: Sequence[Placed]) -> list[list[Placed]]:
    """Glyphs of a line, parted where one is farther from the one before than a digit."""
    runs = [[glyphs[0]]]
    for before, one in pairwise(glyphs):
        if 0 < one[1] - before[1] <= NEAR:
            runs[-1].append(one)
        else:
            runs.append([one])
    return runs


def _uses(glyphs: Sequence[Placed], start: float = 0.0) -> str:
    return "".join(f'<use href="#{name}"{_at("x", start + x)}/>' for name, x in glyphs)


def _at(name: str, value: float) -> str:
    """A coordinate as an attribute; none at zero."""
    text = _short(value, 1)
    return "" if text == "0" else f' {name}="{text}"'


def _short(number: float, decimals: int) -> str:
    """2.5, 3, .4 and -.4."""
    text = f"{number:.{decimals}f}".rstrip("0").rstrip(".")
    return re.sub(r"^(-?)0\.", r"\1.", text) if text not in ("-0", "") else "0"
