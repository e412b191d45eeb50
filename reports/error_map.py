"""Map of a formula's error over two parameters, shaded by the limits [%] that the error meets."""

import numpy as np
from markupsafe import Markup
from numpy.typing import NDArray

from reports import svg
from reports.axes import WIDTH
from verify.core.figures import Array, Map

LEFT, TOP, RIGHT = 62.0, 26.0, 8.0
CELL = 21.0  # height
SHADES = 3  # classes of cells with a separate shade; beyond the last limit there is none
LINE, SWATCH, LETTER = 18.0, 14.0, 6.2
HUNDRED = 0.995  # larger errors are reported as such: a number of per cent adds nothing


def error_map(m: Map) -> Markup:
    """SVG of cells with the signed error in per cent; lines separate classes of errors."""
    error = np.asarray(m.error, dtype=float)
    rows, columns = error.shape
    width = (WIDTH - LEFT - RIGHT) / columns
    bottom = TOP + CELL * rows
    # dots in every cell distinguish none: they are in the key only
    marked = None if m.checked is None or np.all(m.checked) else m.checked
    body = [svg.text(LEFT - 50, TOP - 10, m.y_label, "label")]
    classes = np.searchsorted(m.limits, np.abs(error), side="left")
    for k in range(rows):
        y = bottom - CELL * (k + 1)
        body.append(svg.text(LEFT - 6, y + CELL / 2 + 4, m.rows[k], "tick", "end"))
        for j in range(columns):
            x = LEFT + width * j
            known = bool(np.isfinite(error[k, j]))
            shade = f"m{min(int(classes[k, j]), SHADES)}" if known else "none"
            body.append(svg.rectangle(x, y, width, CELL, shade))
            words = percent(float(error[k, j])) if known else "·"
            body.append(svg.text(x + width / 2, y + CELL / 2 + 3.5, words, "cell", "middle"))
            if marked is not None and marked[k, j]:
                body.append(svg.circle(x + width - 3.6, y + 3.6, 1.7, "fe"))
    body += _steps(error, classes, width, bottom)
    for j, name in enumerate(m.columns):
        body.append(svg.text(LEFT + width * (j + 0.5), bottom + 15, name, "tick", "middle"))
    body.append(svg.text(WIDTH - RIGHT, bottom + 31, m.x_label, "label", "end"))
    key, lines = _key(m, bottom + 50)
    height = bottom + 50 + LINE * lines
    return svg.drawing(WIDTH, height, [*body, *key], m.title, "chart map")


def percent(error: float) -> str:
    """Text of a signed error in per cent with two digits."""
    if abs(error) >= HUNDRED:
        return f"{'>' if error > 0 else '<' + svg.MINUS}99"
    hundredths = 100 * error
    words = f"{hundredths:.0f}" if abs(hundredths) >= 9.95 else f"{hundredths:.1f}"
    words = "0.0" if words == "-0.0" else words
    return words.replace("-", svg.MINUS)


def _steps(error: Array, classes: NDArray[np.int64], width: float, bottom: float) -> list[Markup]:
    """SVG of lines between neighbouring cells of different classes."""
    rows, columns = error.shape
    shown = np.where(np.isfinite(error), classes, -1)
    found = []
    for k, j in np.ndindex(rows, columns):
        x, y = LEFT + width * j, bottom - CELL * (k + 1)
        if j + 1 < columns and shown[k, j] != shown[k, j + 1]:
            found.append(svg.line(x + width, y, x + width, y + CELL, "step"))
        if k + 1 < rows and shown[k, j] != shown[k + 1, j]:
            found.append(svg.line(x, y, x + width, y, "step"))
    return found


def _key(m: Map, top: float) -> tuple[list[Markup], int]:
    """SVG of the key of shades and dots, as many per line as fit, and the number of lines."""
    named = [(f"m{min(i, SHADES)}", f"within {limit:.0%}") for i, limit in enumerate(m.limits)]
    named.append((f"m{SHADES}", f"beyond {m.limits[-1]:.0%}"))
    if not np.all(np.isfinite(m.error)):
        named.append(("none", f"· {m.without}"))
    if m.checked is not None and np.all(m.checked):
        named.append(("", f"every cell {m.checked_name}"))
    elif m.checked is not None and np.any(m.checked):
        named.append(("fe", m.checked_name))
    drawn: list[Markup] = []
    left, row = 12.0, 0
    for css, words in named:
        wide = SWATCH + 6 + LETTER * len(words) + 14
        if left > 12.0 and left + wide > WIDTH:
            left, row = 12.0, row + 1
        y = top + LINE * row
        if css == "fe":
            drawn.append(svg.circle(left + SWATCH / 2, y - 4, 2.4, "fe"))
        elif css:
            drawn.append(svg.rectangle(left, y - 10, SWATCH, 12, f"{css} swatch"))
        drawn.append(svg.text(left + SWATCH + 6, y, words, "tick"))
        left += wide
    return drawn, row + 1
