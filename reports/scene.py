"""A picture as coloured polygons in pixels, so that every way of drawing it looks the same."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from reports import ramps
from reports.bodies import Body, body
from reports.outlines import Indices, edges, polylines
from verify.results import Array, Field, Picture

WIDTH, HEIGHT = 1300, 860  # pixels at most
MARGIN = 0.025  # of the larger side of what is shown
READABLE = 0.065  # displacement drawn, as a share of the body's size
TRUE_SCALE = (0.05, 0.25)  # shares that need no exaggeration
STROKE = 5.0  # pixels across a line
THINNEST = 4.0  # pixels across a strip
GRID_CELLS, GRID_PIXELS = 5000, 9.0  # edges of cells show below this count, above this length
GRID = (16, 20, 24, 80)
OUTLINE_OFF = 0.3  # pixels


@dataclass(frozen=True, kw_only=True)
class Scene:
    """Polygons `faces` (m, 4) over `vertices` (k, 3): pixels right and up, and towards the viewer.

    Triangles repeat their last corner; `colours` is RGBA (m, 4); what comes later lies in front.
    `rectangle` (left, bottom, right, top) is what the picture shows in the model's length, or for
    points with three coordinates in the plane of `view`. `outline` is the undeformed body there.
    """

    width: int
    height: int
    vertices: Array
    faces: Indices
    colours: NDArray[np.uint8]
    rectangle: tuple[float, float, float, float]
    scale: ramps.Scale
    exaggeration: float
    outline: tuple[Array, ...]


def compose(field: Field, picture: Picture) -> Scene:
    """The deformed body in colours; ValueError for what can't be drawn (see `bodies.body`)."""
    whole = body(field, picture)
    turned = Body(points=view(field, whole.points), displacement=view(field, whole.displacement),
                  cells=whole.cells, values=whole.values)  # fmt: skip
    window = picture.window
    shown = turned if window is None else _inside(turned, window, field.name)
    factor = exaggeration(shown, window)
    moved = shown.points + factor * shown.displacement
    width, height, rectangle = _layout(np.concatenate([shown.points, moved]), window)
    left, bottom, right, _ = rectangle
    pixels = width / (right - left)
    values = shown.values
    scale = ramps.plain() if values is None else ramps.scale(values)
    colours = scale.colours(np.zeros(len(shown.cells)) if values is None else values)
    at = (moved - (left, bottom, 0)) * pixels
    if field.points.shape[1] == 3 and shown.cells.shape[1] > 2:
        colours = _shaded(at[shown.cells], colours)
    vertices, faces, rgba = _polygons(at, shown.cells, colours)
    return Scene(
        width=width, height=height, vertices=vertices, faces=faces, colours=rgba,
        rectangle=rectangle, scale=scale, exaggeration=factor,
        outline=polylines(turned.cells, turned.points[:, :2], OUTLINE_OFF / pixels),
    )  # fmt: skip


def view(field: Field, vectors: Array) -> Array:
    """Vectors (n, 3) along right, up and towards the viewer; plane fields are seen as they are."""
    if field.points.shape[1] == 2:
        return vectors
    yaw, pitch = math.radians(-35), math.radians(25)
    cy, sy, cp, sp = math.cos(yaw), math.sin(yaw), math.cos(pitch), math.sin(pitch)
    turn = np.array([[cy, 0, sy], [sp * sy, cp, -sp * cy], [-cp * sy, sp, cp * cy]])
    return np.asarray(vectors @ turn.T)


def exaggeration(shown: Body, window: tuple[float, float, float, float] | None = None) -> float:
    """1, 2 or 5 times a power of ten that makes displacements readable, 0 where there are none.

    Measured on what is shown: the largest displacement comes near 6.5 % of the window's or the
    body's size. Displacements of 5 to 25 % are drawn as they are.
    """
    largest = float(np.linalg.norm(shown.displacement, axis=1).max())
    size = shown.size if window is None else max(window[2] - window[0], window[3] - window[1])
    share = largest / size
    if share < 1e-15:
        return 0.0
    if TRUE_SCALE[0] <= share <= TRUE_SCALE[1]:
        return 1.0
    wanted = math.log10(READABLE / share)
    decade = math.floor(wanted)
    round_ones = [(math.log10(d) + e, d, e) for e in (decade, decade + 1) for d in (1, 2, 5)]
    _, digit, exponent = min(round_ones, key=lambda candidate: abs(candidate[0] - wanted))
    return float(f"{digit}e{exponent}")


def _inside(turned: Body, window: tuple[float, float, float, float], name: str) -> Body:
    """The cells that the window touches, moving with their mean displacement."""
    corners = turned.points[turned.cells][..., :2]
    low, high = corners.min(axis=1), corners.max(axis=1)
    seen = ((high >= window[:2]) & (low <= window[2:])).all(axis=1)
    if not seen.any():
        raise ValueError(f"field {name!r} has no cells in the window {window}")
    used, cells = np.unique(turned.cells[seen], return_inverse=True)
    moving = turned.displacement[used]
    return Body(
        points=turned.points[used], displacement=moving - moving.mean(axis=0),
        cells=cells.reshape(-1, turned.cells.shape[1]),
        values=None if turned.values is None else turned.values[seen],
    )  # fmt: skip


def _layout(
    points: Array, window: tuple[float, float, float, float] | None
) -> tuple[int, int, tuple[float, float, float, float]]:
    """Width and height in whole pixels, and the rectangle that exactly fills them."""
    if window is None:
        low, high = points[:, :2].min(axis=0), points[:, :2].max(axis=0)
        air = MARGIN * (high - low).max()
        low, high = low - air, high + air
    else:
        low, high = np.array(window[:2]), np.array(window[2:])
    span, centre = high - low, (low + high) / 2
    pixels = min(WIDTH / span[0], HEIGHT / span[1])
    width, height = (max(math.ceil(side * pixels - 1e-6), 1) for side in span)
    half = np.array([width, height]) / (2 * pixels)
    (left, bottom), (right, top) = (centre - half).tolist(), (centre + half).tolist()
    return width, height, (left, bottom, right, top)


def _shaded(corners: Array, colours: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Darker where a face is seen from the side."""
    normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, -1] - corners[:, 1])
    if corners.shape[1] == 3:
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    facing = np.abs(normal[:, 2]) / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)
    shaded = colours.copy()
    shaded[:, :3] = np.rint(colours[:, :3] * (0.75 + 0.25 * facing[:, None]))
    return shaded


def _polygons(
    at: Array, cells: Indices, colours: NDArray[np.uint8]
) -> tuple[Array, Indices, NDArray[np.uint8]]:
    """Lines as strokes with round joints; surfaces with their grid, thin ones with a rim."""
    if cells.shape[1] == 2:
        parts = [_strokes(at, cells, colours, STROKE), _joints(at, cells, colours)]
    else:
        quads = cells if cells.shape[1] == 4 else cells[:, [0, 1, 2, 2]]
        parts = [(at[quads], colours)]
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
    """Mean pixels across a plane body: twice its area by its outline's length."""
    x, y = corners[..., 0], corners[..., 1]
    area = np.abs((x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum(axis=1)) / 2
    around = float(np.linalg.norm(rim[:, 1] - rim[:, 0], axis=1).sum())
    return 2 * float(area.sum()) / around if around else math.inf


def _strokes(
    at: Array, pairs: Indices, colours: NDArray[np.uint8], width: float
) -> tuple[Array, NDArray[np.uint8]]:
    """A quadrilateral of so many pixels across along each pair of points."""
    a, b = at[pairs[:, 0]], at[pairs[:, 1]]
    along = b - a
    length = np.maximum(np.linalg.norm(along[:, :2], axis=1), 1e-12)[:, None]
    across = np.column_stack([-along[:, 1], along[:, 0], np.zeros(len(a))]) / length * width / 2
    return np.stack([a - across, b - across, b + across, a + across], axis=1), colours


def _joints(
    at: Array, cells: Indices, colours: NDArray[np.uint8]
) -> tuple[Array, NDArray[np.uint8]]:
    """An octagon, as three quadrilaterals, at each point of a line, in a neighbour's colour."""
    points, first = np.unique(cells, return_index=True)
    angles = np.arange(8) * math.pi / 4
    disc = STROKE / 2 * np.column_stack([np.cos(angles), np.sin(angles), np.zeros(8)])
    fans = disc[[[0, 1, 2, 3], [0, 3, 4, 7], [4, 5, 6, 7]]]
    corners = at[points][:, None, None, :] + fans[None]
    return corners.reshape(-1, 4, 3), np.repeat(colours[first // 2], 3, axis=0)
