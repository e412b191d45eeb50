"""Glyphs that the equations of pages share: a page contains each outline and number once."""

import re
from collections import Counter
from collections.abc import Sequence
from itertools import pairwise
from string import ascii_letters

SYMBOLS = "<!--glyphs-->"  # place of the glyphs that the equations of a page share
FINE = 100  # steps of a point [1/pt] of outlines
FEW = 5  # glyphs, whose heights are shorter than a group
NEAR = 5.75  # advance of a digit [pt] at most: wider steps separate numbers from signs and units
_GLYPH = re.compile(r'<use href="#([gn]\d+)"')
_NUMERAL = re.compile(r'<use href="#(n\d+)"(?: x="([\d.]+)")?/>')

Placed = tuple[str, float]  # name of a glyph and its place on a line [pt]
Run = tuple[Placed, ...]


class Glyphs:
    """Outlines of glyphs by name, and numbers as groups of glyphs."""

    def __init__(self) -> None:
        self._names: dict[str, str] = {}  # of glyphs, by their outlines
        self._numerals: dict[Run, str] = {}  # names of glyphs close together, as in a number

    def name(self, outline: str) -> str:
        """Name of a glyph, or of a run of glyphs such as "mm", by its outline."""
        return self._names.setdefault(outline, f"g{len(self._names)}")

    def line(self, y: float, glyphs: Sequence[Placed]) -> str:
        """SVG of glyphs on one line; in a group if that is shorter."""
        if len(glyphs) < FEW:
            return "".join(f'<use href="#{name}"{_at("x", x)}{_at("y", y)}/>' for name, x in glyphs)
        uses = _uses([self._numeral(run) for run in _close(glyphs)])
        return f'<g transform="translate(0 {short(y, 1)})">{uses}</g>'

    def on(self, page: str) -> str:
        """The page with its glyphs; the most frequent ones have the shortest names."""
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

    def _numeral(self, run: Sequence[Placed]) -> Placed:
        """A single glyph without change; several close glyphs under a common name."""
        if len(run) == 1:
            return run[0]
        start = run[0][1]
        key = tuple((name, round(x - start, 1)) for name, x in run)
        return self._numerals.setdefault(key, f"n{len(self._numerals)}"), start


def _letters(number: int) -> str:
    """Short name for a number: a to z, A to Z, aa to ZZ and so on."""
    rest, last = divmod(number, len(ascii_letters))
    return (_letters(rest - 1) if rest else "") + ascii_letters[last]


def _close(glyphs: Sequence[Placed]) -> list[list[Placed]]:
    """Glyphs of a line, split where the distance between two glyphs exceeds a digit."""
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
    """A coordinate as an attribute; empty at zero."""
    text = short(value, 1)
    return "" if text == "0" else f' {name}="{text}"'


def short(number: float, decimals: int) -> str:
    """Text of a number as short as possible: 2.5, 3, .4 and -.4."""
    text = f"{number:.{decimals}f}".rstrip("0").rstrip(".")
    return re.sub(r"^(-?)0\.", r"\1.", text) if text not in ("-0", "") else "0"
