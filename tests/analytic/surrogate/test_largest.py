"""Regimes whose squares are quadratic functions: kriging of the squares is exact."""

import numpy as np
import pytest
from numpy.typing import NDArray

from analytic.surrogate.box import Box
from analytic.surrogate.designs import full_factorial, random_designs
from analytic.surrogate.gate import PoorSurrogateError, gate, left_level_out, quality
from analytic.surrogate.kriging import Kriging, fit
from analytic.surrogate.largest import Largest, fit_largest

Array = NDArray[np.float64]
BOX = Box((1.0, 0.4), (5.0, 0.7))
X, FRESH = full_factorial(BOX, 5), random_designs(BOX, 200, 2)


def squares(x: Array) -> list[Array]:
    """Of two regimes; the second is silent in a corner."""
    u, v = BOX.to_unit(x).T
    return [4 + 8 * u - 3 * u * v, 9 - 8 * u + v - 14 * (1 - v) * u]


def regimes(x: Array) -> list[Array]:
    return [np.sqrt(np.maximum(square, 0)) for square in squares(x)]


def roughs(x: Array) -> list[Array]:
    """Two regimes no polynomial and no root makes simple."""
    u, v = BOX.to_unit(x).T
    return [2 + np.sin(3 * u + v), 3.4 - np.exp(u) + 0.5 * np.cos(2 * v)]


@pytest.fixture(scope="module")
def rough() -> Largest:
    present = [np.ones(25, dtype=bool), np.arange(25) != 24]
    return fit_largest(X, roughs(X), BOX, power=2.0, present=present)


def test_the_largest_of_two_roots_is_found_where_one_process_has_a_kink() -> None:
    true = np.max(regimes(FRESH), axis=0)
    present = [square > 0 for square in squares(X)]
    assert not np.all(present)
    largest = fit_largest(X, regimes(X), BOX, power=2.0, present=present)
    np.testing.assert_allclose(largest.predict(FRESH), true, rtol=1e-10)
    single = fit(X, np.max(regimes(X), axis=0), BOX)
    assert quality(single.predict(FRESH), true).largest > 0.01


def test_left_out_is_the_result_of_refits_of_every_regime(rough: Largest) -> None:
    true = np.max(roughs(X), axis=0)
    expected = []
    for i in range(len(X)):
        keeps = [np.arange(25) != i, (np.arange(25) != 24) & (np.arange(25) != i)]
        predicted = []
        for y, keep, model in zip(roughs(X), keeps, rough.models, strict=True):
            refit = Kriging(
                box=BOX, designs=X[keep], values=y[keep] ** 2, length_scales=model.length_scales
            )
            predicted.append(float(np.sqrt(max(0, refit.predict(X[i : i + 1])[0]))))
        expected.append(max(predicted) / true[i] - 1)
    np.testing.assert_allclose(rough.left_out(X, roughs(X)), expected, rtol=1e-4, atol=1e-9)
    assert np.max(np.abs(expected)) > 1e-4


def test_the_gate_states_what_is_missed_by_how_much() -> None:
    measured = quality(np.array([1.01, 0.96, 2.0]), np.array([1.0, 1.0, 2.0]))
    assert (measured.mean, measured.largest) == pytest.approx((0.05 / 3, 0.04))
    message = (
        "the errors of the surrogate of pressure at 3 points are too large: mean 1.67%, "
        "largest 4.00%; permissible are 0.50% and 3.00%"
    )
    with pytest.raises(PoorSurrogateError) as refused:
        gate(measured, what="pressure")
    assert str(refused.value) == message
    for limits in ({"mean": 0.02, "largest": 0.039}, {"mean": 0.016, "largest": 0.05}):
        with pytest.raises(PoorSurrogateError):
            gate(measured, **limits, what="pressure")
    gate(measured, mean=0.02, largest=0.05, what="pressure")


def test_levels_are_left_out_one_by_one_of_every_parameter(rough: Largest) -> None:
    true = np.max(roughs(X), axis=0)
    errors = left_level_out(rough, X, true)
    assert errors.shape == (2 * 3 * 5,)  # parameters, inner levels, designs on each
    first = X[:, 0] == 2.0
    predicted = rough.without(X[first]).predict(X[first])
    np.testing.assert_allclose(errors[:5], predicted / true[first] - 1, rtol=1e-12)
    assert np.all(np.abs(errors) > 0)  # what is predicted was indeed not known
