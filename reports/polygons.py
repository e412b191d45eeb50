"""Cells as coloured quadrilaterals in pixels; cells in front come last."""

import math

import numpy as np
from numpy.typing import NDArray

from reports.outlines import Indices, edges
from verify.core.figures import Array

STROKE = 5.0  # pixels across a line
THINNEST = 4.0  # pixels across a strip
GRID_CELLS, GRID_PIXELS = 5000, 9.0  # edges of cells show below this count, above this length
GRID = (16, 20, 24, 80)
PIECE, MOST = 8.0, 16  # pixels across a piece of a cell, pieces along its edge
Coloured = tuple[Array, NDArray[np.uint8]]  # corners (m, 4, 3) and RGBA (m, 4)


def shaded(corners: Array, colours: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Colours (m, 4), darker for faces that are seen from the side."""
    normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, -1] - corners[:, 1])
    if corners.shape[1] == 3:
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    facing = np.abs(normal[:, 2]) / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)
    shaded = colours.copy()
    shaded[:, :3] = np.rint(colours[:, :3] * (0.75 + 0.25 * facing[:, None]))
    return shaded


def pieces(corners: Array, values: Array) -> tuple[Array, Array]:
    """Corners (k, 4, 3) of pieces of quadrilaterals (m, 4, 3), and values (k,) at their centres.

    The pieces are so small that the bilinear values (m, 4) look continuous.
    """
    sides = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2).max(axis=1)
    counts = np.clip(np.ceil(sides / PIECE), 1, MOST).astype(np.int64)
    cut: list[Array] = []
    found: list[Array] = []
    for n in np.unique(counts).tolist():
        mine = counts == n
        s, t = (ends.ravel() for ends in np.meshgrid(np.arange(n) / n, np.arange(n) / n))
        step = 1 / n
        places = [(s, t), (s + step, t), (s + step, t + step), (s, t + step)]
        weights = np.stack([_bilinear(*place) for place in places], axis=1)
        cut.append(np.einsum("pqc,mcx->mpqx", weights, corners[mine]).reshape(-1, 4, 3))
        middle = _bilinear(s + step / 2, t + step / 2)
        found.append((values[mine] @ middle.T).ravel())
    return np.concatenate(cut), np.concatenate(found)


def _bilinear(s: Array, t: Array) -> Array:
    """Weights (p, 4) of the corners at positions 0 <= s, t <= 1 of a quadrilateral."""
    return np.column_stack([(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t])


def polygons(
    at: Array, cells: Indices, colours: NDArray[np.uint8], fill: Coloured | None = None
) -> tuple[Array, Indices, NDArray[np.uint8]]:
    """Corners, faces and colours of lines (with round joints) or of surfaces with their grid.

    Thin surfaces are widened at their rim to THINNEST pixels. `fill` contains corners and
    colours that fill a surface; without it, each cell has one colour.
    """
    if cells.shape[1] == 2:
        parts = [_strokes(at, cells, colours, STROKE), _joints(at, cells, colours)]
    else:
        quads = cells if cells.shape[1] == 4 else cells[:, [0, 1, 2, 2]]
        parts = [fill or (at[quads], colours)]
        pairs, counts, owner = edges(cells)
        rim = counts == 1
        thickness = _thickness(at[cells], at[pairs[rim]])
        if thickness < THINNEST:
            parts.insert(0, _strokes(at, pairs[rim], colours[owner[rim]], THINNEST - thickness))
        length = np.linalg.norm(at[pairs[:, 1]] - at[pairs[:, 0]], axis=1)
        if len(cells) <= GRID_CELLS and np.median(length) >= GRID_PIXELS:
            grey = np.tile(np.array(GRID, dtype=np.uint8), (len(pairs), 1))
            parts.append(_strokes(at + np.array([0, 0, 1]), pairs, grey, 1.0))
    corners = np.concatenate([corner for corner, _ in parts])
    rgba = np.concatenate([colour for _, colour in parts])
    order = np.argsort(corners[..., 2].mean(axis=1).round(6), kind="stable")
    faces = np.arange(4 * len(corners), dtype=np.int64).reshape(-1, 4)
    return corners[order].reshape(-1, 3), faces, rgba[order]


def _thickness(corners: Array, rim: Array) -> float:
    """Mean thickness [pixels] of a plane body: twice its area divided by its outline's length."""
    x, y = corners[..., 0], corners[..., 1]
    area = np.abs((x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum(axis=1)) / 2
    around = float(np.linalg.norm(rim[:, 1] - rim[:, 0], axis=1).sum())
    return 2 * float(area.sum()) / around if around else math.inf


def _strokes(
    at: Array, pairs: Indices, colours: NDArray[np.uint8], width: float
) -> tuple[Array, NDArray[np.uint8]]:
    """A quadrilateral of the given width [pixels] along each pair of points."""
    a, b = at[pairs[:, 0]], at[pairs[:, 1]]
    along = b - a
    length = np.maximum(np.linalg.norm(along[:, :2], axis=1), 1e-12)[:, None]
    across = np.column_stack([-along[:, 1], along[:, 0], np.zeros(len(a))]) / length * width / 2
    return np.stack([a - across, b - across, b + across, a + across], axis=1), colours


def _joints(
    at: Array, cells: Indices, colours: NDArray[np.uint8]
) -> tuple[Array, NDArray[np.uint8]]:
    """An octagon (three quadrilaterals) at each point of a line, in the colour of a neighbour."""
    points, first = np.unique(cells, return_index=True)
    angles = np.arange(8) * math.pi / 4
    disc = STROKE / 2 * np.column_stack([np.cos(angles), np.sin(angles), np.zeros(8)])
    fans = disc[[[0, 1, 2, 3], [0, 3, 4, 7], [4, 5, 6, 7]]]
    corners = at[points][:, None, None, :] + fans[None]
    return corners.reshape(-1, 4, 3), np.repeat(colours[first // 2], 3, axis=0)
