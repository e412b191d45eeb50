"""Kriging step by step against its bordered system; likelihood, and designs in a box."""

import numpy as np
import pytest

from analytic.surrogate.bordered import Bordered
from analytic.surrogate.box import Box
from analytic.surrogate.designs import full_factorial, random_designs
from analytic.surrogate.kriging import Kriging, fit

BOX = Box((1.0, 0.4), (5.0, 0.7))
CUBE = Box((1.0, 0.4, 5e-6), (5.0, 0.7, 25e-6))
X, FRESH = random_designs(BOX, 30, 1), random_designs(BOX, 60, 2)
U = BOX.to_unit(X)


def wavy(x):
    u, v = BOX.to_unit(x).T
    return 3 + u - 2 * v**2 + np.sin(5 * u) * np.cos(3 * v)


def with_scales(scales):
    return Kriging(box=BOX, designs=X, values=wavy(X), length_scales=np.asarray(scales))


@pytest.fixture(scope="module")
def fitted():
    return fit(X, wavy(X), BOX)


@pytest.fixture(params=["fitted", "given"])
def model(request, fitted):
    return fitted if request.param == "fitted" else with_scales([0.3, 0.5])


def test_a_quadratic_is_reproduced_and_nothing_is_uncertain():
    def quadratic(x):
        u, v, w = CUBE.to_unit(x).T
        return 2 + u - 3 * v + w + u * v - 2 * v * w + 4 * u * w + u**2 - 5 * w**2

    x, fresh = full_factorial(CUBE, 3), random_designs(CUBE, 100, 3)
    found = fit(x, quadratic(x), CUBE)
    np.testing.assert_allclose(found.predict(fresh), quadratic(fresh), atol=1e-12)
    assert found.deviation(fresh).max() < 1e-12
    assert np.abs(found.left_out()).max() < 1e-12


def test_the_bordered_system_predicts_the_same_and_leaves_the_same_residuals(model):
    partner = Bordered(U, wavy(X), model.length_scales)
    at = BOX.to_unit(FRESH)
    np.testing.assert_allclose(model.predict(FRESH), partner.predicted(at), rtol=1e-7)
    np.testing.assert_allclose(model.deviation(FRESH), partner.deviation(at), rtol=1e-5)
    for i, residual in enumerate(model.left_out()):
        assert residual == pytest.approx(partner.left_out(i), rel=1e-4, abs=1e-8)


def likelihood(scales):
    """Logarithm of the largest likelihood over trend and variance, less a constant."""
    system, n = Bordered(U, wavy(X), np.asarray(scales)).system, len(X)
    C, F = system[:n, :n], system[:n, n:]
    weighted = np.linalg.solve(C, F)
    r = wavy(X) - F @ np.linalg.solve(F.T @ weighted, weighted.T @ wavy(X))
    return -n / 2 * np.log(r @ np.linalg.solve(C, r) / n) - np.linalg.slogdet(C)[1] / 2


def test_no_length_scales_are_likelier(fitted):
    assert fitted.likelihood == pytest.approx(likelihood(fitted.length_scales), abs=1e-3)
    for factors in ([1.05, 1.0], [1 / 1.05, 1.0], [1.0, 1.05], [1.0, 1 / 1.05], [3.0, 3.0]):
        assert likelihood(fitted.length_scales * factors) < fitted.likelihood + 1e-3


def test_five_levels_of_three_parameters_are_125_designs_the_last_fastest():
    x = full_factorial(CUBE, 5)
    assert len(np.unique(x, axis=0)) == 125
    np.testing.assert_allclose(x[:5, 2], np.linspace(5e-6, 25e-6, 5), rtol=1e-14)
    np.testing.assert_allclose(x[::25, 0], [1, 2, 3, 4, 5], rtol=1e-14)
    assert CUBE.contains(x).all()
    assert not CUBE.contains(np.add(x, [0, 0.31, 0])).any()
