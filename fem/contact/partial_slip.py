"""Evaluation of a contact that slips at its edges: stick zone and hysteresis loop of a cycle."""

import numpy as np
from scipy.interpolate import CubicSpline

from fem.contact.solution import ContactSolution, Touch
from fem.plane.discretisation import Array

WINDOW = 0.06  # of Q/(mu P) about a value's, over which a sweep is smoothed


def stick_share(touch: Touch) -> float:
    """Squared ratio (c/a)² of the half-widths of stick zone and contact, from the traction q.

    q is the difference mu p_a - mu p_c of two ellipses. The zeroth and second moments of mu p_a are
    mu P and mu P a²/4; those of mu p_c are smaller by the factors (c/a)² and (c/a)⁴. Therefore the
    moments of q give 4 M_2/(M_0 a²) = (1 - (c/a)⁴)/(1 - (c/a)²) = 1 + (c/a)². M_2 is the second
    moment about the centre of q.
    """
    s, load = touch.along((0.0, 0.0)), touch.q * touch.weight
    M_0 = load.sum()
    M_2 = load @ (s - load @ s / M_0) ** 2
    return float(4 * M_2 / (M_0 * touch.half_width((0.0, 0.0)) ** 2) - 1)


def smoothed(k: Array, v: Array, at: float, window: float = WINDOW) -> tuple[float, float, float]:
    """Value at k = `at` of a cubic fitted to nearby samples, with uncertainty and scatter.

    The scatter is the standard deviation of a single sample from the cubic. As the slip zones grow,
    nodes start to slip one by one. The value therefore depends on the position of the end of the
    zone between two nodes.
    """
    chosen = np.abs(k - at) <= window
    A = np.vander((k[chosen] - at) / window, 4)
    constants = np.linalg.lstsq(A, v[chosen], rcond=None)[0]
    scatter = np.linalg.norm(A @ constants - v[chosen]) / np.sqrt(max(chosen.sum() - 4, 1))
    share = np.sqrt(np.linalg.inv(A.T @ A)[-1, -1])
    return float(constants[-1]), float(scatter * share), float(scatter)


def apart(state: ContactSolution, other: ContactSolution) -> float:
    """Largest difference of the tangential tractions of two states [Pa]."""
    return float(np.abs(state.touches[0].traction - other.touches[0].traction).max())


def loop_area(x: Array, Q: Array) -> float:
    """Area of a loop by Simpson's rule; the loop has equal steps and reverses in the middle."""
    weights = np.full(x.size // 2 + 1, 2.0)
    weights[1::2], weights[[0, -1]] = 4.0, 1.0
    half = x.size // 2
    swings = (Q[: half + 1], Q[half:][::-1])
    return float((swings[1] - swings[0]) @ weights * (x[0] - x[1]) / 3)


def beyond_chord(x: Array, Q: Array, at: Array) -> Array:
    """Deviations (2n,) of `x` from the straight line between the loop's tips at -Q_max and Q_max.

    The first n values belong to the branch with falling Q, the last n to the branch with rising Q,
    both in the order of the loop. `at` (n,) are rising values of Q/Q_max.
    """
    half = x.size // 2
    beyond = x - x[0] / Q[0] * Q
    down = CubicSpline(Q[half::-1], beyond[half::-1])(at[::-1] * Q[0])
    up = CubicSpline(Q[half:], beyond[half:])(at * Q[0])
    return np.concatenate([down, up])


def order_in_steps(x: Array, Q: Array, work: float) -> tuple[float, float]:
    """Order of convergence of a loop area by the trapezoidal rule, and the error of the area.

    The area is computed from every fourth and from every second step; the error is that of the area
    from every second step. The reference is the `work` of friction, which is exact for any step
    size, because the friction force of a slipping node is always mu p.
    """
    coarse, fine = (abs(abs(float(np.trapezoid(Q[::n], x[::n]))) - work) for n in (4, 2))
    return float(np.log2(coarse / fine)), float(fine)
