"""Drawing of a grid of cells: filled by class, hatched, crossed, with lines of equal error."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby

import numpy as np
from markupsafe import Markup
from numpy.typing import NDArray

from reports import svg
from verify.core.figures import Array

HATCH = 5.0  # between strokes
MOST = 6000  # pieces of a line of equal error: more is no line but noise


@dataclass(frozen=True)
class Cells:
    """A grid of `columns` times `rows` cells in a box (left, top, right, bottom).

    Row 0 is lowest.
    """

    box: tuple[float, float, float, float]
    columns: int
    rows: int

    @property
    def wide(self) -> float:
        """Width of a cell."""
        return (self.box[2] - self.box[0]) / self.columns

    @property
    def high(self) -> float:
        """Height of a cell."""
        return (self.box[3] - self.box[1]) / self.rows

    def X(self, i: float) -> float:
        """Abscissa of the left edge of column i; i + 1/2 is its centre."""
        return self.box[0] + self.wide * i

    def Y(self, j: float) -> float:
        """Ordinate of the lower edge of row j."""
        return self.box[3] - self.high * j

    def filled(self, member: NDArray[np.bool_], style: str) -> Markup:
        """SVG of the filled cells of `member` (columns, rows), as one path of runs along rows."""
        d = [
            f"M{svg.short(self.X(i))},{svg.short(self.Y(j + 1))}H{svg.short(self.X(i + n))}"
            f"V{svg.short(self.Y(j))}H{svg.short(self.X(i))}z"
            for i, j, n in _runs(member)
        ]
        return Markup('<path class="{}" d="{}"/>').format(style, "".join(d)) if d else Markup("")

    def hatched(self, member: NDArray[np.bool_]) -> Markup:
        """SVG of strokes across the cells of `member`."""
        return self._strokes(member, "hatch", both=False)

    def crossed(self, member: NDArray[np.bool_]) -> Markup:
        """SVG of a small cross in each cell of `member`."""
        return self._strokes(member, "none", both=True)

    def _strokes(self, member: NDArray[np.bool_], style: str, *, both: bool) -> Markup:
        d = []
        for i, j in np.argwhere(member):
            x, y, w, h = self.X(i), self.Y(j), self.wide, self.high
            if both:
                r = min(w, h, 9.0) / 3
                x, y = x + w / 2, y - h / 2
                d.append(f"M{svg.short(x - r)},{svg.short(y - r)}l{svg.short(2 * r)},"
                         f"{svg.short(2 * r)}m0,{svg.short(-2 * r)}l{svg.short(-2 * r)},"
                         f"{svg.short(2 * r)}")  # fmt: skip
            else:
                d += [f"M{svg.short(x + a)},{svg.short(y - b)}L{svg.short(x + c)},"
                      f"{svg.short(y - e)}" for a, b, c, e in _diagonals(w, h)]  # fmt: skip
        return Markup('<path class="{}" d="{}"/>').format(style, "".join(d)) if d else Markup("")

    def line(self, field: Array, level: float, style: str) -> Markup:
        """SVG of the contour at which a field (columns, rows) at cell centres equals `level`."""
        pieces = isoline(field, level) + 0.5
        if not 0 < len(pieces) <= MOST:
            return Markup("")
        d = "".join(
            f"M{svg.short(self.X(a))},{svg.short(self.Y(b))}"
            f"L{svg.short(self.X(c))},{svg.short(self.Y(e))}"
            for (a, b), (c, e) in pieces
        )
        return Markup('<path class="{}" d="{}"/>').format(style, d)


def isoline(field: Array, level: float) -> Array:
    """Straight pieces (k, 2, 2) of the contour of a field at a level, in indices of its points.

    The field is interpolated linearly in the four triangles between the corners of a square and its
    centre, which has their mean value. There is no contour if a corner is not finite.
    """
    z = np.asarray(field, dtype=float) - level
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    n, m = z.shape[0] - 1, z.shape[1] - 1
    if min(n, m) < 1:
        return np.empty((0, 2, 2))
    values = [z[i : i + n, j : j + m] for i, j in corners]
    origin = np.stack(np.meshgrid(np.arange(n), np.arange(m), indexing="ij"), axis=-1)
    points = [origin + np.array(c, dtype=float) for c in corners]
    middle, centre = np.mean(values, axis=0), origin + 0.5
    found = []
    for k in range(4):
        p, q = k, (k + 1) % 4
        found += _through(
            [
                (points[p], values[p], points[q], values[q]),
                (points[q], values[q], centre, middle),
                (centre, middle, points[p], values[p]),
            ]
        )
    return np.concatenate(found)


def _through(sides: list[tuple[Array, Array, Array, Array]]) -> list[Array]:
    """Pieces of the contour between two sides of a triangle.

    Each side is given by two points with their values.
    """
    crossed, places = [], []
    for a, u, b, v in sides:
        with np.errstate(invalid="ignore", divide="ignore"):
            crossed.append(((u > 0) != (v > 0)) & np.isfinite(u) & np.isfinite(v))
            places.append(a + (b - a) * (u / (u - v))[..., None])
    found = []
    for first, second in ((0, 1), (1, 2), (0, 2)):
        both = crossed[first] & crossed[second]
        found.append(np.stack([places[first][both], places[second][both]], axis=1))
    return found


def _runs(member: NDArray[np.bool_]) -> Iterator[tuple[int, int, int]]:
    """Column, row and length of each run of members along a row."""
    for j, row in enumerate(member.T):
        i = 0
        for one, group in groupby(row):
            n = sum(1 for _ in group)
            if one:
                yield i, j, n
            i += n


def _diagonals(w: float, h: float) -> list[tuple[float, float, float, float]]:
    """Strokes at 45 degrees in a cell, from its lower left corner, in steps of HATCH."""
    if max(w, h) < 2 * HATCH:
        return [(0.0, 0.0, w, h)]
    found = []
    for c in np.arange(HATCH - h, w, HATCH):  # y = x - c
        x0, x1 = max(c, 0.0), min(c + h, w)
        found.append((x0, x0 - c, x1, x1 - c))
    return found
