import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import minimize
from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import ConstantKernel, DotProduct, Matern

from analytic.surrogate.box import Box
from analytic.surrogate.designs import full_factorial, random_designs
from analytic.surrogate.kriging import Kriging, fit

Array = NDArray[np.float64]
BOX = Box((1.0, 0.4), (5.0, 0.7))
CUBE = Box((1.0, 0.4, 5e-6), (5.0, 0.7, 25e-6))
X, FRESH = random_designs(BOX, 30, 1), random_designs(BOX, 60, 2)


def wavy(x: Array) -> Array:
    u, v = BOX.to_unit(x).T
    return np.asarray(3 + u - 2 * v**2 + np.sin(5 * u) * np.cos(3 * v))


@pytest.fixture(scope="module")
def fitted() -> Kriging:
    return fit(X, wavy(X), BOX)


@pytest.fixture(scope="module")
def partner(fitted: Kriging, bordered: Any) -> Any:
    return bordered(BOX.to_unit(X), wavy(X), fitted.length_scales)


@pytest.fixture(scope="module")
def given() -> Kriging:
    """Of given length scales, as well conditioned as a partner may ask."""
    return Kriging(box=BOX, designs=X, values=wavy(X), length_scales=np.array([0.3, 0.5]))


def test_a_quadratic_is_reproduced_and_nothing_is_uncertain() -> None:
    def quadratic(x: Array) -> Array:
        u, v, w = CUBE.to_unit(x).T
        return np.asarray(2 + u - 3 * v + w + u * v - 2 * v * w + 4 * u * w + u**2 - 5 * w**2)

    x, fresh = full_factorial(CUBE, 3), random_designs(CUBE, 100, 3)
    model = fit(x, quadratic(x), CUBE)
    np.testing.assert_allclose(model.predict(fresh), quadratic(fresh), atol=1e-12)
    assert model.deviation(fresh).max() < 1e-12
    assert np.abs(model.left_out()).max() < 1e-12


@pytest.mark.parametrize("value", [0.0, 7.0, 3e9])
def test_a_constant_stays_one(value: float) -> None:
    model = fit(X, np.full(len(X), value), BOX)
    np.testing.assert_allclose(model.predict(FRESH), value, rtol=1e-13)
    assert model.deviation(FRESH).max() <= 1e-13 * value


def test_designs_are_met_where_nothing_is_uncertain(fitted: Kriging) -> None:
    np.testing.assert_allclose(fitted.predict(X), wavy(X), rtol=1e-7)
    # a nugget of 1e-10 leaves its root of the process's deviation, times a factor near 1
    assert fitted.deviation(X).max() < 1.1e-5 * np.sqrt(fitted.variance)
    assert fitted.deviation(FRESH).min() > 1e-4 * np.sqrt(fitted.variance)


def test_a_smooth_function_is_met_between_designs_within_the_deviation(fitted: Kriging) -> None:
    error = np.abs(fitted.predict(FRESH) - wavy(FRESH))
    assert error.mean() < 0.02 * np.ptp(wavy(X))
    assert np.mean(error < 2 * fitted.deviation(FRESH)) > 0.9


@pytest.mark.parametrize("which", ["fitted", "given"])
def test_the_bordered_system_predicts_the_same(
    which: str, bordered: Any, request: pytest.FixtureRequest
) -> None:
    model = request.getfixturevalue(which)
    partner = bordered(BOX.to_unit(X), wavy(X), model.length_scales)
    predicted, share = partner.predict(BOX.to_unit(FRESH))
    np.testing.assert_allclose(model.predict(FRESH), predicted, rtol=1e-7)
    np.testing.assert_allclose(model.variance, partner.variance, rtol=1e-6)
    expected = np.sqrt(partner.variance * share)
    np.testing.assert_allclose(model.deviation(FRESH), expected, rtol=1e-5)


def test_a_process_with_hardly_bounded_polynomials_predicts_the_same(given: Kriging) -> None:
    matern = Matern([0.3, 0.5], "fixed", nu=2.5)
    trend = ConstantKernel(1e6, "fixed") * DotProduct(1.0, "fixed") ** 2  # (1 + u·v)²
    process = GaussianProcessRegressor(matern + trend, alpha=1e-10, optimizer=None)
    process.fit(BOX.to_unit(X), wavy(X))
    predicted, deviation = process.predict(BOX.to_unit(FRESH), return_std=True)
    np.testing.assert_allclose(given.predict(FRESH), predicted, rtol=1e-5)
    np.testing.assert_allclose(
        given.deviation(FRESH) / np.sqrt(given.variance), deviation, rtol=1e-4
    )


def test_no_length_scales_are_likelier(fitted: Kriging, partner: Any, bordered: Any) -> None:
    def unlikely(logarithms: Array) -> float:
        return -float(bordered(partner.u, partner.y, np.exp(logarithms)).likelihood())

    starts = np.log([[0.3, 0.3], [1.0, 1.0], [0.3, 2.0]])
    best = min(
        minimize(unlikely, start, method="Nelder-Mead", options={"xatol": 1e-3}).fun
        for start in starts
    )
    assert partner.likelihood() > -best - 0.01
    np.testing.assert_allclose(fitted.likelihood, partner.likelihood(), atol=1e-3)


@pytest.mark.parametrize("which", ["fitted", "given"])
def test_left_out_residuals_are_those_of_real_refits(
    which: str, bordered: Any, request: pytest.FixtureRequest
) -> None:
    model = request.getfixturevalue(which)
    u, y = BOX.to_unit(X), wavy(X)
    for i, residual in enumerate(model.left_out()):
        others = np.arange(len(X)) != i
        refit = bordered(u[others], y[others], model.length_scales)
        predicted = refit.predict(u[i : i + 1])[0][0]
        assert residual == pytest.approx(y[i] - predicted, rel=1e-4, abs=1e-8)


def test_designs_taken_away_are_not_remembered(given: Kriging, bordered: Any) -> None:
    u, y = BOX.to_unit(X), wavy(X)
    refit = bordered(u[7:], y[7:], given.length_scales)
    less = given.without(np.vstack([X[:7], FRESH[:2]]))
    assert len(less.designs) == len(X) - 7
    np.testing.assert_allclose(less.predict(X[:7]), refit.predict(u[:7])[0], rtol=1e-9)
    assert np.abs(less.predict(X[:7]) - y[:7]).max() > 1e-3


def test_units_of_parameters_and_values_do_not_matter(fitted: Kriging) -> None:
    def moved(x: Array) -> Array:
        return x * [1e-6, 1e3] + [2.0, -500.0]

    low, high = moved(np.array([BOX.low, BOX.high]))
    model = fit(moved(X), 1e9 * wavy(X) - 5e9, Box(tuple(low), tuple(high)))
    np.testing.assert_allclose(model.length_scales, fitted.length_scales, rtol=1e-2)
    scale = 1e9 * np.ptp(wavy(X))
    expected = 1e9 * fitted.predict(FRESH) - 5e9
    np.testing.assert_allclose(model.predict(moved(FRESH)), expected, atol=1e-4 * scale)
    np.testing.assert_allclose(
        model.deviation(moved(FRESH)), 1e9 * fitted.deviation(FRESH), rtol=0.02
    )


def test_one_seed_one_surrogate_and_other_seeds_agree(fitted: Kriging) -> None:
    again, other = fit(X, wavy(X), BOX), fit(X, wavy(X), BOX, seed=5)
    np.testing.assert_array_equal(again.predict(FRESH), fitted.predict(FRESH))
    assert other.likelihood == pytest.approx(fitted.likelihood, abs=0.01)


def test_a_parameter_without_influence_gets_a_long_length_scale() -> None:
    x = full_factorial(CUBE, 4)
    model = fit(x, np.sin(6 * CUBE.to_unit(x)[:, 1]), CUBE)
    assert model.length_scales[1] < 1
    assert np.all(model.length_scales[[0, 2]] > 10)


@pytest.mark.parametrize(
    ("x", "y", "message"),
    [
        (X, lambda x: np.where(x[:, 0] > 3, np.nan, 1.0), "a finite value for each of the 30"),
        (X, lambda x: wavy(x)[:-1], "a finite value for each of the 30"),
        (X[:7], wavy, "a quadratic trend needs at least 8 designs, got 7"),
        (np.vstack([X, X[4]]), wavy, "designs 4 and 30 are one point, [3.19"),
        (np.where([True, False], X, 0.5), wavy, "do not settle a quadratic trend"),
        (X * np.nan, wavy, "points must be finite"),
    ],
)
def test_no_surrogate(x: Array, y: Callable[[Array], Array], message: str) -> None:
    values = np.ones(len(x)) if np.isnan(x).any() else y(x)
    with pytest.raises(ValueError, match=re.escape(message)):
        fit(x, values, BOX)
