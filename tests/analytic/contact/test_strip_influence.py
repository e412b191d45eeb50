"""The influence of a strip with an elliptic pressure across, against quadrature and its limits."""

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.contact.strip_influence import excess, far_coefficients, log_part


def F(v):
    v = np.atleast_1d(v)
    return np.squeeze(excess(np.log(v))[0] + log_part(v))


@pytest.mark.parametrize("v", [1e-5, 1e-3, 0.03, 0.3, 0.5, 1.0, 1.7, 4.0, 7.3, 7.5, 30.0, 1e3, 1e6])
def test_the_table_meets_the_defining_integral(v):
    """Substituting x = sin(pi/2 e^-w) takes the logarithm at x = 0 out."""

    def integrand(w):
        angle = np.pi / 2 * np.exp(-w)
        return 2 * np.cos(angle) ** 2 * np.arcsinh(v / np.sin(angle)) * angle

    exact, _ = quad(integrand, 0, 60, epsabs=1e-14, epsrel=1e-12, limit=500)
    assert float(F(v)) == pytest.approx(exact, rel=2e-11)


def test_between_the_nodes_it_is_as_good_as_on_them():
    """Neighbouring values by Gauss-Legendre from F' = int 2 sqrt(1-x²)/sqrt(x²+v²)."""
    v = np.exp(np.random.default_rng(1).uniform(-3, 3, 12))

    def slope(u):
        return quad(lambda a: 2 * np.cos(a) ** 2 / np.hypot(np.sin(a), u), 0, np.pi / 2, limit=200)[
            0
        ]

    for low in v:
        high = low * 1.003
        step, _ = quad(slope, low, high, epsabs=1e-14)
        assert float(F(high) - F(low)) == pytest.approx(step, abs=2e-11)


def test_its_slope_is_the_derivative():
    log_v = np.linspace(-9, 9, 1001) + 0.0003
    step = 1e-4
    numerical = (excess(log_v + step)[0] - excess(log_v - step)[0]) / (2 * step)
    np.testing.assert_allclose(excess(log_v)[1], numerical, atol=2e-7)


def test_the_series_takes_over_where_the_strips_say_so():
    """From three half-widths on, seven terms (`strip_newton`)."""
    v = np.array([3.0, 5.0, 20.0])
    c = far_coefficients(7)
    series = log_part(v) + (c * v[:, None] ** (-2.0 * np.arange(1, 8))).sum(-1)
    np.testing.assert_allclose(series, F(v), atol=5e-11)
