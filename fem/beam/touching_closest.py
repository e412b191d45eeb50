"""Closest points of straight and quadratic line elements."""

from collections.abc import Callable

import numpy as np

from fem.beam.section import Array, Indices
from fem.beam.touching_points import shapes

ITERATIONS = 30
BRACKETINGS = 80
CONVERGED = 1e-14


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


def least(lower: Array, upper: Array, slope: Callable[[Array, Indices], Array]) -> Array:
    """Place (k,) between `lower` and `upper` where a function is least.

    `slope(places, rows)` is its slope at places of the functions of the given numbers. Within a
    cell the function is taken to have one minimum, at an end where the slope doesn't change from
    - to +. False position with halved weights (the Illinois method) finds the others.
    """
    rows = np.arange(len(lower))
    first, last = slope(lower, rows), slope(upper, rows)
    found = np.where(first + last > 0, lower, upper)
    rows = np.flatnonzero((first < 0) & (last > 0))
    a, b, at_a, at_b = lower[rows], upper[rows], first[rows], last[rows]
    for _ in range(BRACKETINGS):
        if not rows.size:
            break
        place = (a * at_b - b * at_a) / (at_b - at_a)
        value = slope(place, rows)
        found[rows] = place
        crossed = value * at_b < 0
        a, at_a = np.where(crossed, b, a), np.where(crossed, at_b, at_a / 2)
        moved, b, at_b = np.abs(place - b), place, value
        going = (moved > CONVERGED) & (value != 0)
        rows, a, b, at_a, at_b = (part[going] for part in (rows, a, b, at_a, at_b))
    return found
