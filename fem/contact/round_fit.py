"""Evaluation of two rings in contact along a circle about the origin."""

import numpy as np

from fem.contact.solution import Touch
from fem.plane.discretisation import Array
from fem.plane.solution import PlaneSolution


def mean_and_scatter(touch: Touch) -> tuple[float, float]:
    """Mean pressure [Pa], and root mean square deviation of the pressure from the mean [Pa]."""
    p = float(touch.p @ touch.weight / touch.weight.sum())
    return p, float(np.sqrt((touch.p - p) ** 2 @ touch.weight / touch.weight.sum()))


def pressure_at(touch: Touch, turns: Array) -> Array:
    """Pressure (m,) [Pa] at angles `turns` (m,) [rad], interpolated between nodes."""
    turn = np.arctan2(touch.x[1], touch.x[0])
    order = np.argsort(turn)
    return np.interp(turns, turn[order], touch.pressure[order])


def means_on(plane: PlaneSolution, boundary: str) -> tuple[float, float]:
    """Mean radial displacement [m] and mean hoop stress [Pa] along a circle."""
    wall = plane.on_boundary(boundary)
    moved, _, hoop, _ = wall.polar()
    return wall.mean(moved), wall.mean(hoop)
