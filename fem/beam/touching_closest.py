"""Closest points of straight and quadratic line elements."""

from collections.abc import Callable

import numpy as np

from fem.beam.section import Array, Indices

ITERATIONS = 30
BRACKETINGS = 80
CONVERGED = 1e-14
SETTLED = 1e-11  # relative to a place: the distance there is stationary


def closest(curve: Array, at: Array) -> Array:
    """Parameters (k,), 0 to 1, of the points on k curves that are nearest to the points `at`.

    `at` is (k, 2). The curves are given by their coefficients from `powers`, (k, 2, 3). Newton's
    method for the squared distance begins with the projection on the chord. Where this function is
    not sufficiently convex (near and beyond the centre of curvature), Gauss-Newton steps are used.
    """
    x0, x1, x2 = curve[..., 0], curve[..., 1], curve[..., 2]
    chord = x1 + x2
    away = at - x0
    xi = np.clip(_dot(away, chord) / _dot(chord, chord), 0.0, 1.0)
    # half the distance squared has the slope p0 + p1 xi + p2 xi^2 + p3 xi^3
    bent, along, squared = 2 * _dot(away, x2), _dot(x1, x2), _dot(x2, x2)
    p1 = _dot(x1, x1) - bent
    own = np.stack([-_dot(away, x1), p1, 3 * along, 2 * squared, p1 + bent, 4 * along, 4 * squared])
    rows, place = np.arange(len(xi)), xi.copy()
    for _ in range(ITERATIONS):
        p0, p1, p2, p3, s0, s1, s2 = own
        slope = ((p3 * place + p2) * place + p1) * place + p0
        H = (3 * p3 * place + 2 * p2) * place + p1
        stretch = (s2 * place + s1) * place + s0
        H = np.where(0.3 * stretch < H, H, stretch)
        moved = np.clip(place - slope / H, 0.0, 1.0)
        xi[rows] = moved
        going = np.abs(moved - place) > CONVERGED
        if not going.any():
            break
        rows, place, own = rows[going], moved[going], own[:, going]
    return xi


def _dot(a: Array, b: Array) -> Array:
    return a[:, 0] * b[:, 0] + a[:, 1] * b[:, 1]


def least(
    lower: Array,
    upper: Array,
    rise: Callable[[Array, Indices], tuple[Array, Array]],
    below: float = np.inf,
) -> Array:
    """Positions (k,) of the minima of k functions between `lower` and `upper`.

    `rise(places, rows)` returns values and slopes of the functions `rows` at `places`. Each
    function is assumed to have one minimum. It is at an end if the slope does not change from - to
    +; otherwise, the Illinois method (false position with halved weights) finds it. If the tangents
    at both ends show that the minimum is above `below`, the result is only approximate.
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
