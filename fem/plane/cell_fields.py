"""Evaluation of `PlaneSolution.cells`: selected cells, nodal means, largest shear stress."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from fem.plane.geometry import Array, Indices


def cut_out(cells: Mapping[str, Array], inside: Callable[[Array], Array]) -> dict[str, Any]:
    """Points, cells and data of those cells for which `inside` is True at the centres (m, 2)."""
    corners = cells["cells"].astype(np.int64)
    kept = np.flatnonzero(inside(cells["points"][corners].mean(axis=1)))
    used, corners = np.unique(corners[kept], return_inverse=True)
    return {"points": cells["points"][used], "cells": corners.reshape(kept.size, -1),
            "displacement": cells["displacement"][used],
            "stress": cells["stress"][kept], "von_mises": cells["von_mises"][kept]}  # fmt: skip


def largest_shear(stress: Array) -> Array:
    """Largest shear stress in the plane (m,) from stresses (m, 4): xx, yy, xy, zz.

    >>> largest_shear(np.array([[3.0, -3.0, 4.0, 0.0], [2.0, 2.0, 0.0, 0.0]])).tolist()
    [5.0, 0.0]
    """
    xx, yy, xy, _ = stress.T
    return np.asarray(np.hypot((xx - yy) / 2, xy))


def at_nodes(points: Array, cells: Indices, values: Array) -> Array:
    """Nodal values (n, k): area-weighted means of the values (m, k) of adjacent cells."""
    x, y = points[cells].transpose(2, 0, 1)
    after = np.roll(np.arange(cells.shape[1]), -1)
    area = np.abs((x * y[:, after] - y * x[:, after]).sum(axis=1)) / 2
    total, weight = np.zeros((len(points), values.shape[1])), np.zeros(len(points))
    for corner in cells.T:
        np.add.at(total, corner, values * area[:, None])
        np.add.at(weight, corner, area)
    return total / weight[:, None]
