"""The band of a profile holds what theory says must lie in it."""

import numpy as np
import pytest

from verify.cases.registry import CASES
from verify.core.case import Context, FemResult
from verify.core.figures import Profile
from verify.judging.profiles import along

X = np.linspace(0, 1, 7)


def context(errors, u_it=0.0):
    """Levels whose values are X plus an error that changes place from mesh to mesh."""
    levels = [
        FemResult(h=1 / 2**i, values={}, u_it={"line": u_it}, arrays={"line": X + e})
        for i, e in enumerate(errors)
    ]
    return Context("c", None, {}, levels, is_paper=True)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_every_point_of_the_paper_profiles_lies_in_its_band(case, judged):
    for figure in judged(case).figures:
        if isinstance(figure, Profile) and not figure.neglects:
            assert np.all(np.abs(figure.y_fem - figure.y_ref) <= 2 * figure.u), figure.title


def test_errors_that_change_place_are_covered():
    wandering = [0.3 / 4**i * np.sin((5 + 3 * i) * X + i) for i in range(4)]
    values, u = along(context(wandering), "line", formal=2.0, scale=1.0)
    assert np.all(np.abs(values - X) <= 2 * u)
    assert u[0] < 0.02  # and not by much more than they are


def test_round_off_is_covered_by_what_the_solver_states():
    noise = [1e-9 * np.cos(40 * X + i) for i in range(4)]
    values, u = along(context(noise, u_it=1e-9), "line", formal=2.0, scale=1.0)
    assert np.all(np.abs(values - X) <= 2 * u)


def test_growing_differences_give_a_wide_band_and_no_number_that_is_none():
    growing = [0.1 * 2**i * X for i in range(4)]
    _, u = along(context(growing), "line", formal=2.0, scale=1.0)
    assert np.all(np.isfinite(u))
    assert u[0] > 0.5
