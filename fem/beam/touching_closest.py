"""Closest points of straight and quadratic line elements."""

from collections.abc import Callable

import numpy as np

from fem.beam.section import Array, Indices
from fem.beam.touching_points import shapes

ITERATIONS = 30
BRACKETINGS = 80
CONVERGED = 1e-14
SETTLED = 1e-11  # of a place: the distance there is stationary


def closest(corners: Array, at: Array) -> Array:
    """Place (k,) in 0..1 on each element (k, p, 2) that is nearest to the point `at` (k, 2).

    Newton's method on the distance, from the projection on the chord; where the distance isn't
    convex (beyond the centre of curvature) a step of the chord's own length scale replaces it.
    """
    chord = corners[:, 1] - corners[:, 0]
    along = np.einsum("kd,kd->k", at - corners[:, 0], chord)
    xi = np.clip(along / np.einsum("kd,kd->k", chord, chord), 0.0, 1.0)
    rows = np.arange(len(xi))
    for _ in range(ITERATIONS):
        N, slope, second = shapes(xi[rows], corners.shape[1])
        own = corners[rows]
        d = at[rows] - np.einsum("kp,kpd->kd", N, own)
        x1 = np.einsum("kp,kpd->kd", slope, own)
        stretch = np.einsum("kd,kd->k", x1, x1)
        bend = np.einsum("kd,kpd,kp->k", d, own, second)
        H = np.where(bend < 0.7 * stretch, stretch - bend, stretch)
        moved = np.clip(xi[rows] + np.einsum("kd,kd->k", d, x1) / H, 0.0, 1.0)
        change = np.abs(moved - xi[rows])
        xi[rows] = moved
        rows = rows[change > CONVERGED]
        if not rows.size:
            break
    return xi


def least(
    lower: Array,
    upper: Array,
    rise: Callable[[Array, Indices], tuple[Array, Array]],
    below: float = np.inf,
) -> Array:
    """Place (k,) between `lower` and `upper` where a function is least.

    `rise(places, rows)` are values and slopes at places of the functions of the given numbers.
    Within a cell the function is taken to have one minimum, at an end where the slope doesn't
    change from - to +. False position with halved weights (the Illinois method) finds the
    others, roughly where both ends' tangents tell that they stay above `below`.
    """
    every = np.arange(len(lower))
    low, first = rise(lower, every)
    high, last = rise(upper, every)
    found = np.where(high > low, lower, upper)
    inside = (first < 0) & (last > 0)
    at = lower + (high - low - last * (upper - lower)) / np.where(inside, first - last, 1.0)
    found = np.where(inside, at, found)  # where the tangents meet
    rows = np.flatnonzero(inside & (low + first * (at - lower) < below))
    a, b, at_a, at_b = lower[rows], upper[rows], first[rows], last[rows]
    for _ in range(BRACKETINGS):
        if not rows.size:
            break
        place = (a * at_b - b * at_a) / (at_b - at_a)
        _, value = rise(place, rows)
        found[rows] = place
        crossed = value * at_b < 0
        a, at_a = np.where(crossed, b, a), np.where(crossed, at_b, at_a / 2)
        moved, b, at_b = np.abs(place - b), place, value
        going = (moved > SETTLED) & (value != 0)
        rows, a, b, at_a, at_b = (part[going] for part in (rows, a, b, at_a, at_b))
    return found
