"""Plot of contributions: bars from zero, each with its name and what it amounts to."""

from markupsafe import Markup

from reports import svg
from reports.plots import WIDTH, Axes
from verify.shown import Bars

ROW, THICK = 24.0, 12.0
LEFT, RIGHT, TOP, BELOW = 110.0, 96.0, 14.0, 44.0
LETTER = 6.2  # about the width of a letter beside a bar


def bars(b: Bars) -> Markup:
    """One bar below the other; words stand beyond the end of their bar."""
    values = [value for _, value, _ in b.items]
    low, high = min(0.0, *values), max(0.0, *values)
    height = TOP + ROW * len(values) + BELOW
    room = max(RIGHT, *(LETTER * len(words) + 18 for _, _, words in b.items))
    axes = Axes(
        (LEFT, TOP, WIDTH - room, height - BELOW), (low, high if high > low else low + 1.0),
        (float(len(values)), 0.0),
    )  # fmt: skip
    for i, (name, value, words) in enumerate(b.items):
        y = axes.Y(i + 0.5)
        ends = sorted((axes.X(0.0), axes.X(value)))
        axes.body += [
            svg.text(LEFT - 8, y + 4, name, "tick", "end"),
            svg.rectangle(ends[0], y - THICK / 2, ends[1] - ends[0], THICK, ""),
            svg.text(ends[1] + 6, y + 4, words, "tick"),
        ]
    axes.base(svg.ticks(*axes.x, 5), svg.plain)
    axes.titles(b.label, "")
    return svg.drawing(WIDTH, height, axes.body, b.title, "chart bars")
