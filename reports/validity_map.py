"""Map of a formula's signed error over one or two inputs, with its error bar."""

import numpy as np
from markupsafe import Markup
from numpy.typing import NDArray

from reports import svg
from reports.axes import WIDTH
from reports.error_cells import Cells
from reports.error_map import percent
from reports.error_scale import UNSOLVED, classes, css, scale
from reports.measured import LIMITS, Measured, all_within, undecided
from reports.validity_line import validity_line
from verify.core.figures import Array

SMALL = 320.0, 200.0
LINE, LETTER = 18.0, 6.2
TALL = 236.0  # of a map's cells
LIGHT = 6  # the last class that black letters can be read on
LEAST = 5  # rows and columns; smaller maps have no lines of equal error
MANY = 16  # cells; with more cells not every one is labelled
DIGIT = 6.4  # about the width of a digit in a cell


def validity_map(m: Measured) -> Markup:
    """SVG of a small figure without a key: cells for two inputs, a curve with band for one."""
    if m.y is None:
        return validity_line(m, *SMALL)
    wide, tall = SMALL
    cells = Cells((52.0, 20.0, wide - 8.0, tall - 34.0), *m.error.shape)
    return svg.drawing(wide, tall, _drawn(m, m.y, cells), m.title, "chart validity")


def measured(m: Measured) -> Markup:
    """SVG of the figure at full size, with the key of its colours and marks."""
    if m.y is None:
        return validity_line(m, WIDTH, 330.0)
    n = m.error.shape[1]
    tall = n * min(28.0, TALL / n)
    cells = Cells((62.0, 26.0, WIDTH - 8.0, 26.0 + tall), *m.error.shape)
    key, height = _key(m, cells.box[3] + 46)
    return svg.drawing(
        WIDTH, height, [*_drawn(m, m.y, cells), *key], m.title, "chart validity"
    )  # fmt: skip


def scale_key(limits: tuple[float, ...] = LIMITS, *, marked: bool = True) -> Markup:
    """SVG of the common key of the colours and marks of several small figures.

    `marked` is True if one of them contains the inputs of the file.
    """
    empty = np.zeros((2, 2))
    m = Measured(title="Key", x=empty[0], y=empty[0], x_label="", error=empty, U=empty,
                 limits=limits)  # fmt: skip
    key, height = _key(m, 16.0, every=True, marked=marked)
    return svg.drawing(
        WIDTH, height, key, "Colours: formula minus finite elements", "chart validity"
    )


def _drawn(m: Measured, y: Array, cells: Cells) -> list[Markup]:
    """SVG elements: cells, their numbers, lines of equal error, marks, and the axes."""
    left, top, right, bottom = cells.box
    number = classes(m.error, m.limits)
    body = [cells.filled(number == k, css(int(k))) for k in np.unique(number)]
    body.append(cells.filled(m.unsafe, "unsafe"))
    body.append(cells.hatched(undecided(m.error, m.U, m.limits)))
    body.append(cells.crossed(number == UNSOLVED))
    if min(m.error.shape) >= LEAST:
        body += [
            cells.line(m.error, sign * limit, f"iso i{k}")
            for k, limit in enumerate(m.limits) for sign in (1, -1)
        ]  # fmt: skip
    body.append(svg.rectangle(left, top, right - left, bottom - top, "border"))
    numbers = _numbers(m, cells, number)
    body += numbers
    if m.box is not None:
        body.append(_outlined(m, y, cells))
    if at := _nominal(m, y):
        r = 9.0 if len(numbers) > 1 else 4.2  # round a number, not across it
        body.append(svg.circle(cells.X(at[0] + 0.5), cells.Y(at[1] + 0.5), r, "at"))
    return [*body, *_axes(m, y, cells)]


def _numbers(m: Measured, cells: Cells, number: NDArray[np.int64]) -> list[Markup]:
    """SVG of the error in each cell, in per cent, if there is space for every number."""
    words = [[percent(v) if np.isfinite(v) else "" for v in row] for row in m.error]
    if within := all_within(m.error, m.U):
        x, y = (m.error.shape[0] / 2, m.error.shape[1] / 2)
        return [svg.text(cells.X(x), cells.Y(y) + 4, within, "label", "middle")]
    longest = max(len(w) for row in words for w in row)
    if cells.high < 12 or cells.wide < DIGIT * longest + 3:
        return []
    return [
        svg.text(cells.X(i + 0.5), cells.Y(j + 0.5) + 3.5, words[i][j],
                 "cell" if abs(number[i, j]) <= LIGHT else "cell deep", "middle")
        for i, j in np.argwhere(number != UNSOLVED)
    ]  # fmt: skip


def _outlined(m: Measured, y: Array, cells: Cells) -> Markup:
    assert m.box is not None
    (x0, x1), (y0, y1) = m.box
    i, k = sorted(int(np.abs(m.x - v).argmin()) for v in (x0, x1))
    j, n = sorted(int(np.abs(y - v).argmin()) for v in (y0, y1))
    corners = [
        (cells.X(a), cells.Y(b)) for a, b in ((i, j), (k + 1, j), (k + 1, n + 1), (i, n + 1))
    ]
    return svg.polyline(corners, "region", closed=True)


def _nominal(m: Measured, y: Array) -> tuple[float, float] | None:
    """Indices of the file's inputs in the map; None outside the map."""
    if m.nominal is None:
        return None
    spaced = [np.log10 if log else np.asarray for log in m.log]
    i, j = (_place(f(at), float(f(v)))
            for f, at, v in zip(spaced, (m.x, y), m.nominal, strict=True))  # fmt: skip
    return None if i is None or j is None else (i, j)


def _place(values: Array, wanted: float) -> float | None:
    """Interpolated index of a value among `values` in any order; None beyond their ends."""
    order = np.argsort(values)
    if not values[order[0]] <= wanted <= values[order[-1]]:
        return None
    return float(np.interp(wanted, values[order], order))


def _axes(m: Measured, y: Array, cells: Cells) -> list[Markup]:
    left, top, right, bottom = cells.box
    body = [
        svg.text(cells.X(i + 0.5), bottom + 14, words, "tick", "middle")
        for i, words in _ticks(m.x, cells.wide, log=m.log[0])
    ]
    body += [
        svg.text(left - 6, cells.Y(j + 0.5) + 4, words, "tick", "end")
        for j, words in _ticks(y, cells.high, log=m.log[1], upright=True)
    ]
    body.append(svg.text(left - 46, top - 8, m.y_label, "label"))
    body.append(svg.text(right, bottom + 29, m.x_label, "label", "end"))
    return body


def _ticks(
    values: Array, step: float, *, log: bool, upright: bool = False
) -> list[tuple[float, str]]:
    """Positions (as indices) and numbers of ticks: cell values, or round numbers for many cells."""
    if len(values) > MANY and not log:
        about = max(2, round(len(values) * step / 50))
        round_ones = svg.ticks(float(values.min()), float(values.max()), about)
        places = [(_place(values, v), svg.plain(v)) for v in round_ones]
        return [(i, words) for i, words in places if i is not None]
    words = [svg.plain(float(f"{v:.3g}")) for v in values]
    room = 14.0 if upright else 7.0 * max(len(w) for w in words) + 4
    every = max(1, int(np.ceil(room / step)))
    return [(i, words[i]) for i in range(0, len(words), every)]


def has_nominal(m: Measured) -> bool:
    """Whether the inputs of the file are within a map."""
    return m.y is not None and _nominal(m, m.y) is not None


def _key(
    m: Measured, top: float, *, every: bool = False, marked: bool = False
) -> tuple[list[Markup], float]:
    """SVG of the scale and of the meaning of each mark, and the height of the drawing."""
    drawn = scale(12.0, top, WIDTH - 24.0, m.limits)
    entries: list[tuple[str, str]] = []
    names = [f"{100 * limit:.4g}" for limit in m.limits]
    lines = [min(m.error.shape) >= LEAST and _passed(m, limit) for limit in m.limits]
    entries += [(f"iso i{k}", f"{name} %") for k, name in enumerate(names) if lines[k] or every]
    if every or undecided(m.error, m.U, m.limits).any():
        entries.append(("hatch", "error bar across a limit"))
    if m.unsafe.any():
        entries.append(("unsafe", f"more than {100 * m.limits[-1]:.4g} % on the unsafe side"))
    if every or not np.isfinite(m.error).all():
        entries.append(("unsolved", "no solution"))
    if m.box is not None:
        entries.append(("region", m.box_name))
    if marked or has_nominal(m):
        entries.append(("at", "inputs of the file"))
    left, y = 12.0, top + 48
    for style, words in entries:
        wide = 24 + LETTER * len(words) + 14
        if left > 12.0 and left + wide > WIDTH:
            left, y = 12.0, y + LINE
        drawn += [*_swatch(style, left, y), svg.text(left + 24, y, words, "tick")]
        left += wide
    return drawn, y + 8 if entries else top + 32


def _passed(m: Measured, limit: float) -> bool:
    """Whether the errors are on both sides of the positive or of the negative limit."""
    known = m.error[np.isfinite(m.error)]
    return any(0 < int((known > level).sum()) < known.size for level in (limit, -limit))


def _swatch(style: str, x: float, y: float) -> list[Markup]:
    cell = Cells((x, y - 10, x + 18, y + 1), 1, 1)
    one = np.ones((1, 1), dtype=bool)
    if style == "at":
        return [svg.circle(x + 9, y - 4, 4.2, "at")]
    if style.startswith("iso"):
        return [svg.line(x, y - 4, x + 18, y - 4, style)]
    corners = [(x, y - 10), (x + 18, y - 10), (x + 18, y + 1), (x, y + 1)]
    if style == "region":
        return [svg.polyline(corners, style, closed=True)]
    marked = cell.hatched(one) if style == "hatch" else cell.filled(one, style) + cell.crossed(one)
    return [marked, svg.polyline(corners, "border", closed=True)]
