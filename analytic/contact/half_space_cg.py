r"""Contact pressures without tension or overlap, by preconditioned conjugate gradients.

.. math::
    p \ge 0, \qquad g = Kp + z - \delta \ge 0, \qquad p\,g = 0

with K from `half_space_convolution`. Either the approach δ or the sum of p is given. Cells with
p > 0 carry load; other cells are added as soon as they overlap. Each step moves to the minimum
along the search direction; negative pressures are then set to zero. If the sum of p is given,
every step conserves the sum, and δ is the mean of Kp + z over the loaded cells.

References
----------
.. [1] I. A. Polonsky, L. M. Keer, Wear 231 (1999) 206-219.
.. [2] E. A. H. Vollebregt, J. Optim. Theory Appl. 162 (2014) 931-953.
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from analytic.contact.checks import Array
from analytic.contact.half_space_convolution import Convolution

Mask = NDArray[np.bool_]


@dataclass(frozen=True, kw_only=True)
class Pressed:
    """Pressures and displacements of the solved part of the grid (see `Convolution.half`).

    `residual` is the largest violation of the gap condition, relative to the largest displacement.
    """

    pressure: Array
    displacement: Array
    approach: float
    iterations: int
    residual: float


@dataclass
class _State:
    """Fields of the iteration between two steps."""

    pressure: Array
    displacement: Array
    free: Mask
    direction: Array
    downhill: Array = field(default_factory=lambda: np.zeros(()))
    slope: float = 0.0


def solve(
    K: Convolution,
    gap: Array,
    *,
    total: float | None,
    approach: float,
    start: Array,
    tolerance: float,
    limit: int,
) -> Pressed:
    """Pressures for the `gap`, with a given sum of the pressures (`total`) or a given `approach`.

    Raises ArithmeticError if the residual exceeds `tolerance` after `limit` iterations.
    """
    pressure = _kept(start, total)
    now = _State(pressure, K.displacement(pressure), pressure > 0, np.zeros_like(gap))
    residual = np.inf
    for iteration in range(limit):
        carries = now.pressure > 0
        overlap = -gap - now.displacement
        delta = approach if total is None else -float(overlap[carries].mean())
        overlap += delta
        free = carries | (overlap > 0)
        overlap *= free
        wrong = float(np.abs(overlap).max())
        residual = wrong / float(np.abs(now.displacement).max(initial=abs(delta))) if wrong else 0.0
        if residual <= tolerance:
            return Pressed(
                pressure=now.pressure, displacement=now.displacement, approach=delta,
                iterations=iteration, residual=residual,
            )  # fmt: skip
        _step(K, now, overlap, free, total)
    raise ArithmeticError(
        f"the half-space contact did not converge: the residual is {residual:.1e} of the largest "
        f"displacement after {limit} iterations, required {tolerance:.1e}"
    )


def _step(K: Convolution, now: _State, overlap: Array, free: Mask, total: float | None) -> None:
    """Change `now` by one step that reduces the overlap on the cells that are `free`."""
    downhill = _balanced(overlap, free, total)
    conditioned = _balanced(K.precondition(downhill), free, total)
    direction = conditioned
    if now.slope > 0:
        keep = float(np.vdot(conditioned, downhill - now.downhill)) / now.slope
        direction = conditioned + max(keep, 0.0) * _balanced(now.direction, free, total)
        if np.vdot(downhill, direction) <= 0:
            direction = conditioned
    response = K.displacement(direction)
    far = float(np.vdot(downhill, direction) / np.vdot(direction, response))
    pressure = now.pressure + far * direction
    if pressure.min() < 0:
        now.pressure = _kept(pressure, total)
        now.displacement = K.displacement(now.pressure)
    else:
        now.pressure = pressure
        now.displacement = now.displacement + far * response
    now.slope = float(np.vdot(conditioned, downhill))
    now.free, now.direction, now.downhill = free, direction, downhill


def _balanced(values: Array, free: Mask, total: float | None) -> Array:
    """Return `values` on the free cells; if `total` is given, their mean is subtracted."""
    values = values * free
    if total is not None:
        values -= free * (values.sum() / np.count_nonzero(free))
    return values


def _kept(pressure: Array, total: float | None) -> Array:
    """Return `pressure` without negative values, scaled to the sum `total` if it is given."""
    pressure = np.maximum(pressure, 0.0)
    return pressure if total is None else pressure * (total / pressure.sum())
