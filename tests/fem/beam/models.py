"""Straight members for the tests of frames, by both linear solvers."""

import numpy as np
import pytest

from fem.beam.curved import solve_curved_frame
from fem.beam.straight import solve_frame


def with_middles(points, elements, **problem):
    """`solve_curved_frame` on straight members: a middle node on every pair."""
    points, elements = np.asarray(points, float), np.asarray(elements)
    numbers = len(points) + np.arange(len(elements))
    return solve_curved_frame(
        np.vstack([points, points[elements].mean(axis=1)]), np.column_stack([elements, numbers]),
        **problem,
    )  # fmt: skip


both_solvers = pytest.mark.parametrize("solve", [solve_frame, with_middles])
