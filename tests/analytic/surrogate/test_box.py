import re

import numpy as np
import pytest

from analytic.surrogate.box import Box
from analytic.surrogate.designs import full_factorial, random_designs

BOX = Box((1.0, 0.4, 5e-6), (5.0, 0.7, 25e-6))


def test_corners_of_the_cube_are_corners_of_the_box() -> None:
    corners = BOX.from_unit(np.array([[0.0, 0, 0], [1, 1, 1], [0.25, 0.5, 0.1]]))
    np.testing.assert_array_equal(corners[:2], [BOX.low, BOX.high])
    np.testing.assert_allclose(corners[2], [2, 0.55, 7e-6], rtol=1e-15)
    np.testing.assert_allclose(BOX.to_unit(corners)[2], [0.25, 0.5, 0.1], rtol=1e-14)


def test_a_point_on_a_bound_is_inside_and_one_beyond_any_bound_is_not() -> None:
    x = np.array([BOX.low, BOX.high, [3, 0.39, 1e-5], [3, 0.5, 2.6e-5]])
    assert BOX.contains(x).tolist() == [True, True, False, False]


def test_five_levels_of_three_parameters_are_125_designs_the_last_fastest() -> None:
    x = full_factorial(BOX, 5)
    assert x.shape == (125, 3)
    assert len(np.unique(x, axis=0)) == 125
    np.testing.assert_allclose(x[:5, 2], np.linspace(5e-6, 25e-6, 5), rtol=1e-14)
    np.testing.assert_allclose(x[::25, 0], [1, 2, 3, 4, 5], rtol=1e-14)
    assert np.all(x[:25, 0] == 1)
    assert np.all(BOX.contains(x))


def test_random_designs_fill_the_box_evenly_and_repeat_by_seed() -> None:
    x = random_designs(BOX, 4000, 7)
    assert np.all(BOX.contains(x))
    u = BOX.to_unit(x)
    # a uniform variable: mean 1/2, variance 1/12, no correlation; 4 deviations of the sample's
    np.testing.assert_allclose(u.mean(axis=0), 0.5, atol=4 / np.sqrt(12 * 4000))
    np.testing.assert_allclose(np.cov(u.T), np.eye(3) / 12, atol=4 * 0.1 / np.sqrt(4000))
    np.testing.assert_array_equal(x, random_designs(BOX, 4000, 7))
    assert not np.any(x == random_designs(BOX, 4000, 8))


@pytest.mark.parametrize(
    ("low", "high", "message"),
    [
        ((0.0,), (0.0,), "bounds must be finite, low below high, got 0.0 and 0.0"),
        ((2.0,), (1.0,), "bounds must be finite, low below high, got 2.0 and 1.0"),
        ((0.0,), (np.inf,), "bounds must be finite, low below high, got 0.0 and inf"),
        ((0.0, 0.0), (1.0,), "as many low bounds as high, got 2 and 1"),
        ((), (), "as many low bounds as high, got 0 and 0"),
    ],
)
def test_no_box(low: tuple[float, ...], high: tuple[float, ...], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Box(low, high)


@pytest.mark.parametrize(
    ("x", "message"),
    [
        ([1.0, 0.5, 1e-5], "points must be of shape (n, 3), got (3,)"),
        ([[1.0, 0.5]], "points must be of shape (n, 3), got (1, 2)"),
        ([[1.0, np.nan, 1e-5]], "points must be finite"),
    ],
)
def test_no_points(x: list[object], message: str) -> None:
    with pytest.raises(ValueError, match=re.escape(message)):
        BOX.to_unit(np.array(x))


def test_a_design_needs_levels_and_points() -> None:
    with pytest.raises(ValueError, match="at least 2 levels, got 1"):
        full_factorial(BOX, 1)
    with pytest.raises(ValueError, match="count must be at least 1, got 0"):
        random_designs(BOX, 0, 0)
