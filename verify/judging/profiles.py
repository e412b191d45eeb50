"""Profiles for plots: finite-element values along a line, with one uncertainty for all values."""

import math

import numpy as np

from verify.core.case import Context
from verify.core.figures import Array
from verify.judging.convergence import grid_convergence
from verify.judging.judge import numerical_uncertainty


def along(context: Context, key: str, *, formal: float, scale: float) -> tuple[Array, Array]:
    """Values (m,) of the finest level at fixed points, and their standard uncertainty (m,).

    `key` is the name of arrays (m,) that every level evaluated at the same points. `formal` is the
    order of convergence of their largest error. From mesh to mesh, the position of a fixed point in
    its cell changes; therefore, the differences between meshes at one point have no order. The
    largest difference over all points has an order. One uncertainty, from the grid convergence of
    this difference, is used for the whole profile.
    """
    h = [result.h for result in context.fem]
    values = np.array([result.arrays[key] for result in context.fem])
    u_it = max(result.u_it.get(key, 0.0) for result in context.fem)
    change = np.abs(np.diff(values, axis=0)).max(axis=1)
    series = np.concatenate([[0.0], np.cumsum(change)]).tolist()
    grid = grid_convergence(h, series, formal=formal, scale=scale, u_it=u_it)
    u = numerical_uncertainty(grid, u_it)
    if not math.isfinite(u):  # growing differences: three times their sum over the last levels
        u = 1.5 * (series[-1] - series[-3])
    return values[-1], np.full(values.shape[1], u)
