"""Data of a picture: points, displacements and values of cells, with mirror images."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from reports.outlines import Indices
from verify.core.figures import Array, Field, Picture

AXES = "xyz"
SHEAR_XY = 2  # of the columns xx, yy, xy, zz
PIECE = 1 / 200  # of the body's size: data along a line is constant over this length
ON_PLANE = 1e-9  # of the body's size


@dataclass(frozen=True, kw_only=True)
class Body:
    """A body to draw: `points` and `displacement` (n, 3) [model's length], `cells` (m, corners).

    `values` are (m,), one for each cell, or (m, 4), one for each corner with bilinear
    interpolation.
    """

    points: Array
    displacement: Array
    cells: Indices
    values: Array | None

    @property
    def size(self) -> float:
        """Largest extent of the body."""
        return float(np.ptp(self.points, axis=0).max())


def body(field: Field, picture: Picture) -> Body:
    """Body for the picture of a field, with values in the unit of the picture.

    Reflection negates a coordinate: "x" adds the mirror image at the plane x = 0. Normal stresses
    and other scalars keep their sign. A shear stress (column 2 of the four columns xx, yy, xy, zz)
    changes sign at "x" and at "y", and component k of a vector changes sign at axis k. Shear in
    separate data of one column would keep its sign, which is wrong: give shear as the third of four
    columns. Lengths along y are multiplied by the `stretch` of the picture.

    Raises
    ------
    ValueError
        If the field has no cells, if it does not have the data, or if these are not finite.
    """
    if not len(field.cells):
        raise ValueError(f"field {field.name!r} has no cells to draw")
    used, cells = np.unique(field.cells, return_inverse=True)
    u = field.point_data.get(picture.displacement)
    drawn = np.array([1.0, picture.stretch, 1.0])
    points = _solid(field.points)[used] * drawn
    shift = np.zeros_like(points) if u is None else _solid(u)[used] * drawn
    shown = Body(points=points, displacement=shift, cells=cells.reshape(field.cells.shape),
                 values=None)  # fmt: skip
    if picture.data:
        shown = _valued(shown, field, picture, used)
    for array in (shown.points, shown.displacement, shown.values):
        if array is not None and not np.isfinite(array).all():
            raise ValueError(
                f"field {field.name!r}: all values of {picture.data or 'points'} must be finite"
            )
    for axis in picture.mirror:
        shown = _with_image(shown, AXES.index(axis), _sign(field, picture, axis))
    return shown


def _valued(shown: Body, field: Field, picture: Picture, used: Indices) -> Body:
    """The body with one value per cell, or one per corner of plane quadrilaterals.

    Lines are cut into pieces.
    """
    name = picture.data
    if name in field.cell_data:
        return replace(shown, values=_column(field.cell_data[name], picture))
    if name not in field.point_data:
        known = ", ".join([*field.cell_data, *field.point_data])
        raise ValueError(f"field {field.name!r} has no data {name!r}; it has {known or 'none'}")
    at_points = _column(field.point_data[name][used], picture)
    if shown.cells.shape[1] == 2:
        return _in_pieces(shown, at_points)
    at_corners = at_points[shown.cells]
    smooth = shown.cells.shape[1] == 4 and field.points.shape[1] == 2
    return replace(shown, values=at_corners if smooth else at_corners.mean(axis=1))


def _column(data: Array, picture: Picture) -> Array:
    """Selected component of data, or the magnitude of a vector."""
    if data.ndim == 2 and picture.component is not None:
        data = data[:, picture.component]
    elif data.ndim == 2:
        data = np.linalg.norm(data, axis=1)
    return np.asarray(data / picture.factor)


def _in_pieces(shown: Body, at_points: Array) -> Body:
    """The body with lines cut so short that linear data along them looks continuous."""
    start, end = shown.cells.T
    length = np.linalg.norm(shown.points[end] - shown.points[start], axis=1)
    pieces = np.maximum(np.ceil(length / (PIECE * shown.size)), 1).astype(np.int64)
    cell = np.repeat(np.arange(len(pieces)), pieces + 1)
    step = np.arange(len(cell)) - np.repeat(np.cumsum(pieces + 1) - pieces - 1, pieces + 1)
    share = (step / pieces[cell])[:, None]

    def along(data: Array) -> Array:
        return np.asarray(data[start[cell]] * (1 - share) + data[end[cell]] * share)

    first = np.flatnonzero(step < pieces[cell])
    values = along(at_points[:, None])[:, 0]
    points = np.concatenate([along(shown.points), along(shown.displacement)], axis=1)
    joined, index = np.unique(points, axis=0, return_inverse=True)
    cells = index.reshape(-1)[np.column_stack([first, first + 1])]
    return Body(points=joined[:, :3], displacement=joined[:, 3:], cells=cells,
                values=(values[first] + values[first + 1]) / 2)  # fmt: skip


def _sign(field: Field, picture: Picture, axis: str) -> float:
    """Factor of a value in the mirror image at the plane normal to this axis."""
    data = field.cell_data.get(picture.data, field.point_data.get(picture.data))
    if data is None or data.ndim != 2 or picture.component is None:
        return 1.0
    columns, k = data.shape[1], picture.component
    sheared = columns == 4 and k == SHEAR_XY and axis in "xy"
    return -1.0 if sheared or (columns <= 3 and k == AXES.index(axis)) else 1.0


def _with_image(shown: Body, axis: int, sign: float) -> Body:
    """The body with its mirror image, joined at the plane of symmetry."""
    flip = np.ones(3)
    flip[axis] = -1
    count = len(shown.points)
    joined = np.abs(shown.points[:, axis]) <= ON_PLANE * shown.size
    image = np.where(joined, np.arange(count), np.arange(count) + count)
    values = shown.values
    return Body(
        points=np.concatenate([shown.points, shown.points * flip]),
        displacement=np.concatenate([shown.displacement, shown.displacement * flip]),
        cells=np.concatenate([shown.cells, image[shown.cells]]),
        values=None if values is None else np.concatenate([values, sign * values]),
    )


def _solid(values: Array) -> NDArray[np.float64]:
    """Plane points or vectors with a third component of zero."""
    missing = 3 - values.shape[1]
    return np.pad(np.asarray(values, dtype=np.float64), ((0, 0), (0, missing)))
