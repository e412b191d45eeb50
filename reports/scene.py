"""A picture as coloured polygons in pixels, so that it looks the same in every output."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from reports import ramps
from reports.bodies import Body, body
from reports.outlines import Indices, polylines
from reports.polygons import pieces, polygons, shaded
from verify.core.figures import Array, Field, Picture

WIDTH, HEIGHT = 1300, 860  # pixels at most
MARGIN = 0.025  # of the larger side of the window
READABLE = 0.065  # displacement drawn, as a share of the body's size
TRUE_SCALE = (0.05, 0.25)  # shares that need no exaggeration
OUTLINE_OFF = 0.3  # pixels

Box = tuple[float, float, float, float]  # left, bottom, right, top


@dataclass(frozen=True, kw_only=True)
class Scene:
    """A scene of polygons `faces` (m, 4) over `vertices` (k, 3).

    Vertices are in pixels to the right, upwards and towards the viewer. Triangles repeat their last
    corner. `colours` is RGBA (m, 4); later faces are in front. `rectangle` (left, bottom, right,
    top) is the visible region in the length unit of the model or, for points with three
    coordinates, in the plane of `view`. `outline` is the undeformed body in this region.
    """

    width: int
    height: int
    vertices: Array
    faces: Indices
    colours: NDArray[np.uint8]
    rectangle: Box
    scale: ramps.Scale
    exaggeration: float
    outline: tuple[Array, ...]


def compose(field: Field, picture: Picture) -> Scene:
    """Scene of the deformed body in colours.

    Raises ValueError if the field cannot be drawn (see `bodies.body`).
    """
    whole = body(field, picture)
    turned = Body(points=view(field, whole.points), displacement=view(field, whole.displacement),
                  cells=whole.cells, values=whole.values)  # fmt: skip
    window = picture.window
    seen, mean = (turned, np.zeros(3)) if window is None else in_window(turned, window, field.name)
    factor = exaggeration(seen, window, picture.share or READABLE)
    moved = turned.points + factor * (turned.displacement - mean)
    width, height, rectangle = _layout(np.concatenate([turned.points, moved]), window)
    left, bottom, right, _ = rectangle
    pixels = width / (right - left)
    at = (moved - (left, bottom, 0)) * pixels
    inside = _touches(at[turned.cells][..., :2], (0, 0, width, height))
    if window is not None:
        inside &= _touches(turned.points[turned.cells][..., :2], _grown(window))
        if not inside.any():
            raise ValueError(
                f"field {field.name!r}: the window {window} contains no cell after the deformation"
            )
    cells = turned.cells[inside]
    if turned.values is None or seen.values is None:
        scale, values = ramps.plain(), np.zeros(len(cells))
    else:
        scale, values = ramps.scale(seen.values), turned.values[inside]
    fill = None
    if values.ndim == 2:
        corners, at_centres = pieces(at[cells], values)
        fill, values = (corners, scale.colours(at_centres)), values.mean(axis=1)
    colours = scale.colours(values)
    if field.points.shape[1] == 3 and cells.shape[1] > 2:
        colours = shaded(at[cells], colours)
    vertices, faces, rgba = polygons(at, cells, colours, fill)
    return Scene(
        width=width, height=height, vertices=vertices, faces=faces, colours=rgba,
        rectangle=rectangle, scale=scale, exaggeration=factor,
        outline=polylines(turned.cells, turned.points[:, :2], OUTLINE_OFF / pixels),
    )  # fmt: skip


def view(field: Field, vectors: Array) -> Array:
    """Vectors (n, 3) with components right, up and to the viewer; plane fields are not rotated."""
    if field.points.shape[1] == 2:
        return vectors
    yaw, pitch = math.radians(-35), math.radians(25)
    cy, sy, cp, sp = math.cos(yaw), math.sin(yaw), math.cos(pitch), math.sin(pitch)
    turn = np.array([[cy, 0, sy], [sp * sy, cp, -sp * cy], [-cp * sy, sp, cp * cy]])
    return np.asarray(vectors @ turn.T)


def exaggeration(shown: Body, window: Box | None = None, readable: float = READABLE) -> float:
    """Scale factor (1, 2 or 5 times a power of ten) that makes displacements visible.

    It is 0 without displacements. The largest displacement of the visible part becomes about
    `readable` (6.5 %) of the size of the window or the body. If it is already 5 to 25 % of this
    size, the factor is 1.
    """
    largest = float(np.linalg.norm(shown.displacement, axis=1).max())
    size = shown.size if window is None else max(window[2] - window[0], window[3] - window[1])
    share = largest / size
    if share < 1e-15:
        return 0.0
    if TRUE_SCALE[0] <= share <= TRUE_SCALE[1]:
        return 1.0
    wanted = math.log10(readable / share)
    decade = math.floor(wanted)
    round_ones = [(math.log10(d) + e, d, e) for e in (decade, decade + 1) for d in (1, 2, 5)]
    _, digit, exponent = min(round_ones, key=lambda candidate: abs(candidate[0] - wanted))
    return float(f"{digit}e{exponent}")


def in_window(turned: Body, window: Box, name: str) -> tuple[Body, Array]:
    """The cells that touch the window, and the mean displacement (3,) of their points.

    The mean is subtracted from the displacements. ValueError if no cell of the field `name` touches
    the window.
    """
    seen = _touches(turned.points[turned.cells][..., :2], window)
    if not seen.any():
        raise ValueError(f"field {name!r} has no cells in the window {window}")
    used, cells = np.unique(turned.cells[seen], return_inverse=True)
    mean = turned.displacement[used].mean(axis=0)
    part = Body(
        points=turned.points[used], displacement=turned.displacement[used] - mean,
        cells=cells.reshape(-1, turned.cells.shape[1]),
        values=None if turned.values is None else turned.values[seen],
    )  # fmt: skip
    return part, mean


def _touches(corners: Array, box: Box) -> NDArray[np.bool_]:
    """Whether the bounding box of each cell (m, corners, 2) overlaps the box."""
    low, high = corners.min(axis=1), corners.max(axis=1)
    return np.asarray(((high >= box[:2]) & (low <= box[2:])).all(axis=1))


def _grown(window: Box) -> Box:
    """Window with a margin for parts that enter it only due to the exaggeration."""
    left, bottom, right, top = window
    air = READABLE * 2 * max(right - left, top - bottom)
    return left - air, bottom - air, right + air, top + air


def _layout(points: Array, window: Box | None) -> tuple[int, int, Box]:
    """Width and height in integer pixels, and the rectangle that exactly fills them."""
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
