"""Profiles for plots: finite-element values along a line, with the uncertainty of each point."""

import math
from collections.abc import Sequence

import numpy as np

from verify.case import Context
from verify.convergence import grid_convergence
from verify.judge import numerical_uncertainty
from verify.shown import Array


def along(context: Context, key: str, *, formal: float | None, scale: float) -> tuple[Array, Array]:
    """Values (m,) of the finest level at fixed points and their standard uncertainty (m,).

    `key` names arrays (m,) that every level evaluated at the same points. A point whose
    differences grow takes the spread of its last three values, three times.
    """
    h = [result.h for result in context.fem]
    values = np.array([result.arrays[key] for result in context.fem])
    u = [_uncertainty(h, column.tolist(), formal, scale) for column in values.T]
    return values[-1], np.array(u)


def _uncertainty(
    h: Sequence[float], values: Sequence[float], formal: float | None, scale: float
) -> float:
    u = numerical_uncertainty(grid_convergence(h, values, formal=formal, scale=scale))
    return u if math.isfinite(u) else 1.5 * float(np.ptp(values[-3:]))
