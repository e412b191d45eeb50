"""Fields of a finite-element solution as bodies that the page displays in space."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from reports import ramps
from reports.bodies import Body, body
from reports.outlines import edges
from reports.scene import READABLE, Box, exaggeration, in_window
from verify.core.figures import Array, Field, Picture

Indices = NDArray[np.int64]
MM = 1e-3  # m


@dataclass(frozen=True, kw_only=True)
class Shape:
    """A body with a value at each vertex; vertices are not shared by cells.

    `points` and `displacement` (k, 3) [mm]; `cells` (m, 3 or 4) are vertices of triangles or
    quadrilaterals; `values` (k,) in the unit of `label`, None for a body of one colour; `edges`
    (n, 2) are vertices at the ends of free edges. `factor` is the proposed scale of displacements,
    0 without displacements. Lengths along y are drawn `stretch`
    times as large as lengths along x. With `decades`, the values are logarithms to base ten.
    """

    title: str
    label: str
    points: Array
    displacement: Array
    cells: Indices
    values: Array | None
    edges: Indices
    scale: ramps.Scale
    factor: float
    is_plane: bool
    stretch: float = 1.0
    decades: bool = False

    def deformed(self, factor: float) -> Array:
        """Positions (k, 3) [mm] of the vertices, with displacements times `factor`."""
        return self.points + factor * self.displacement


def shapes(fields: Sequence[Field], pictures: Sequence[Picture]) -> tuple[Shape, ...]:
    """One body for each picture whose field is in `fields`, in the order of `pictures`."""
    by_name = {field.name: field for field in fields}
    return tuple(
        _shape(by_name[picture.field], picture)
        for picture in pictures if picture.field in by_name
    )  # fmt: skip


def _shape(field: Field, picture: Picture) -> Shape:
    whole = shown = body(field, picture)
    free = _free_edges(whole)
    if picture.window is not None and field.points.shape[1] == 2:
        shown, _mean = in_window(whole, picture.window, field.name)
        free = _in_part(free, whole, picture.window, field.name)
    factor = exaggeration(shown, picture.window, picture.share or READABLE)
    if shown.cells.shape[1] == 2 and not picture.width:
        raise ValueError(f"field {field.name!r} has lines: its picture needs a width")
    if picture.width and shown.cells.shape[1] == 2:
        shown = _swept(shown, picture.width)
        free = np.concatenate([shown.cells[:, :2], shown.cells[:, 2:]])
    separate = _separate(shown)
    drawn = MM * np.array([1.0, picture.stretch, 1.0])
    unit = "" if picture.unit == "1" else f" [{picture.unit}]"
    return Shape(
        title=picture.caption, label=f"{picture.symbol}{unit}", decades=picture.decades,
        points=separate.points / drawn, displacement=separate.displacement / drawn,
        cells=separate.cells, values=separate.values, edges=_renumbered(free, shown.cells),
        scale=ramps.plain() if shown.values is None else ramps.scale(shown.values),
        factor=factor, is_plane=field.points.shape[1] == 2 and not picture.width,
        stretch=picture.stretch,
    )  # fmt: skip


def _free_edges(shown: Body) -> Indices:
    """Edges that belong to only one cell; none for lines."""
    if shown.cells.shape[1] == 2:
        return np.zeros((0, 2), dtype=np.int64)
    found, counts, _ = edges(shown.cells)
    return np.asarray(found[counts == 1])


def _in_part(pairs: Indices, whole: Body, window: Box, name: str) -> Indices:
    """The edges `pairs` that are inside the window, with the point numbers of the cut body.

    Edges along which the window cuts the body are not included.
    """
    numbered = replace(whole, values=np.arange(len(whole.cells), dtype=float))
    part, _mean = in_window(numbered, window, name)
    assert part.values is not None
    used = np.unique(whole.cells[part.values.astype(np.int64)])
    return np.asarray(np.searchsorted(used, pairs[np.isin(pairs, used).all(axis=1)]))


def _swept(line: Body, width: float) -> Body:
    """The ribbon of a plane line, swept normal to its plane by `width`, half to each side."""
    half, count = np.array([0, 0, width / 2]), len(line.points)
    return Body(
        points=np.concatenate([line.points - half, line.points + half]),
        displacement=np.concatenate([line.displacement] * 2),
        cells=np.hstack([line.cells, line.cells[:, ::-1] + count]), values=line.values,
    )  # fmt: skip


def _separate(shown: Body) -> Body:
    """The body with separate vertices for each cell, so that each vertex has one value."""
    count = shown.cells.shape[1]
    values = shown.values
    if values is not None:
        values = np.ravel(values if values.ndim == 2 else np.repeat(values, count))
    return replace(
        shown, points=shown.points[shown.cells].reshape(-1, 3),
        displacement=shown.displacement[shown.cells].reshape(-1, 3),
        cells=np.arange(shown.cells.size).reshape(shown.cells.shape), values=values,
    )  # fmt: skip


def _renumbered(pairs: Indices, cells: Indices) -> Indices:
    """The edges `pairs` with vertex numbers that are valid if no cells share a vertex."""
    number = np.zeros(int(cells.max()) + 1, dtype=np.int64)
    number[cells.ravel()] = np.arange(cells.size)
    return np.asarray(number[pairs])
