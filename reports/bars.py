"""Bar chart of contributions: bars from zero, each with its name and value."""

import textwrap

from markupsafe import Markup

from reports import svg
from reports.axes import WIDTH, Axes
from verify.core.figures import Bars

LINE, THICK = 13.0, 12.0  # of text, of a bar
GAP = 11.0  # between bars
RIGHT, TOP, BELOW = 96.0, 14.0, 44.0
LETTER = 6.2  # about the width of a letter beside a bar
NAME, WORDS = 24, 20  # the longest lines of a name, and of the words beyond a bar [letters]


def bars(b: Bars) -> Markup:
    """SVG of horizontal bars; the text of a bar is beyond its end, wrapped if it is long."""
    values = [value for _, value, _ in b.items]
    names = [textwrap.wrap(name, NAME) for name, _, _ in b.items]
    words = [textwrap.wrap(text_of_bar, WORDS) for _, _, text_of_bar in b.items]
    low, high = min(0.0, *values), max(0.0, *values)
    row = LINE * max(map(len, names + words), default=1) + GAP
    height = TOP + row * len(values) + BELOW
    axes = Axes(
        (_room(names) + 14, TOP, WIDTH - max(RIGHT, _room(words) + 18), height - BELOW),
        (low, high if high > low else low + 1.0), (float(len(values)), 0.0),
    )  # fmt: skip
    for i, value in enumerate(values):
        y = axes.Y(i + 0.5)
        ends = sorted((axes.X(0.0), axes.X(value)))
        axes.body += [
            *_lines(axes.box[0] - 8, y, names[i], "end"),
            svg.rectangle(ends[0], y - THICK / 2, ends[1] - ends[0], THICK, ""),
            *_lines(ends[1] + 6, y, words[i], "start"),
        ]
    axes.base(svg.ticks(*axes.x, max(2, round((axes.box[2] - axes.box[0]) / 40))), svg.plain)
    axes.titles(b.label, "")
    return svg.drawing(WIDTH, height, axes.body, b.title, "chart bars")


def _room(texts: list[list[str]]) -> float:
    """Width of the longest line of text."""
    return LETTER * max((len(line) for lines in texts for line in lines), default=0)


def _lines(x: float, y: float, lines: list[str], anchor: str) -> list[Markup]:
    """SVG of lines of text, vertically centred at y."""
    first = y + 4 - LINE * (len(lines) - 1) / 2
    return [svg.text(x, first + LINE * k, line, "tick", anchor) for k, line in enumerate(lines)]
