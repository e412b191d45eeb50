"""Bodies of revolution: x is the radius r >= 0, y is the axial coordinate, cells are rings."""

import numpy as np
from numpy.typing import NDArray
from skfem.mesh import Mesh2D

from fem.plane.geometry import Array

ON_AXIS = 1e-9  # relative to the largest radius: nearer points lie on the axis within round-off
STATIONS = 9  # per edge: between two points, a parabola dips by less than 1/500 of its curvature
AT_AXIS = 1e-8  # relative to a cell's radius: u_r/r loses as many digits there as its limit misses


def depth(x: Array, turn: bool) -> Array:
    """Thickness at `x` (2, ...): 1, or the circumference 2 pi r if `turn` (body of revolution)."""
    return 2 * np.pi * x[0] if turn else np.ones(x.shape[1:])


def on_axis(mesh: Mesh2D, x: Array) -> NDArray[np.bool_]:
    """True for points of `x` (2, ...) on the axis of revolution."""
    return np.asarray(abs(x[0]) <= ON_AXIS * abs(mesh.p[0]).max())


def has_area(mesh: Mesh2D, facets: NDArray[np.int64]) -> bool:
    """True if at least one of `facets` is off the axis, so that rotation generates an area."""
    return not np.all(on_axis(mesh, mesh.p[:, mesh.facets[:, facets]]))


def check_radii(mesh: Mesh2D) -> None:
    """Raise ValueError if an edge of a cell crosses the axis of revolution.

    Curved and straight edges are tested; the message states the number of the cell.
    """
    r = np.asarray(mesh.mapping().G(np.linspace(0, 1, STATIONS)[None]))[0]
    lowest = r.min(axis=1)
    beyond = np.flatnonzero(lowest < -ON_AXIS * abs(mesh.p[0]).max())
    if beyond.size:
        k = int(mesh.f2t[0, beyond[0]])
        x, y = mesh.p[:, mesh.t[:, k]].mean(axis=1)
        raise ValueError(
            f"cell {k} of {mesh.nelements}, about ({x:.10g}, {y:.10g}), reaches "
            f"r = {lowest[beyond[0]]:.3g}: in a body of revolution, x is the radius, r >= 0"
        )


def hoop_strain(u: Array, slope: Array, r: Array, reach: Array) -> Array:
    """Hoop strain u_r/r, or its limit du_r/dr (`slope`) on the axis.

    Points are on the axis if their radius is negligible compared with `reach`, the largest radius
    of the cell.
    """
    near = r < AT_AXIS * reach
    return np.where(near, slope, u / np.where(near, 1.0, r))
