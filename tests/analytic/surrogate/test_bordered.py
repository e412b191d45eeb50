"""Kriging by its bordered system: it returns what it knows, and a quadratic whole."""

import numpy as np
import pytest

from analytic.surrogate.bordered import Bordered, quadratic

X = np.random.default_rng(2).random((30, 3))
SCALES = np.array([0.5, 0.8, 1.5])


def rough(x):
    return np.sin(7 * x[:, 0]) + x[:, 1] ** 3 * x[:, 2]


def test_known_values_come_back_without_doubt():
    one = Bordered(X, rough(X), SCALES)
    assert one.predicted(X) == pytest.approx(rough(X), abs=1e-7)
    assert one.deviation(X).max() < 1e-3 * one.deviation(np.full((1, 3), 2.0))[0]


def test_a_quadratic_is_its_trend_alone():
    far = np.array([[2.0, -1.0, 3.0], [0.5, 0.5, 0.5]])

    def value(x):
        return quadratic(x) @ np.arange(1.0, 11.0)

    one = Bordered(X, value(X), SCALES)
    assert one.predicted(far) == pytest.approx(value(far), rel=1e-6)
    assert abs(one.left_out(4)) < 1e-5


def test_a_value_left_out_is_missed_by_what_others_predict():
    one, others = Bordered(X, rough(X), SCALES), np.arange(30) != 7
    rest = Bordered(X[others], rough(X)[others], SCALES)
    assert one.left_out(7) == pytest.approx(float(rough(X)[7] - rest.predicted(X[[7]])[0]))
