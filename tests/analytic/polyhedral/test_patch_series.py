"""Closed-form sums over the patches' Fourier series against adding up their terms."""

import numpy as np
import pytest

from analytic.polyhedral.patch_series import slow_sums, weights


@pytest.mark.parametrize(("z", "alpha"), [(3, 0.2), (6, 0.05), (24, 0.01)])
def test_the_sums_are_those_of_a_million_terms(z, alpha):
    theta = np.array([0.0, 0.4 * alpha, 1.5 * alpha, np.pi / z])
    m = z * np.arange(1.0, 1e6)
    J = weights(m, alpha)
    first, second = slow_sums(theta, z=z, alpha=alpha)
    for i, t in enumerate(theta):
        waves = J * np.cos(m * t)
        assert first[i] == pytest.approx((waves / (m + 1)).sum(), abs=2e-9)
        assert second[i] == pytest.approx((waves / (m**2 - 1)).sum(), abs=1e-12)


def test_the_sums_go_on_through_the_patches_end():
    ends = np.array([1 - 1e-9, 1 + 1e-9]) * 0.05
    for part in slow_sums(ends, z=6, alpha=0.05):
        assert part[0] == pytest.approx(part[1], rel=1e-7)


def test_the_weights_are_the_semi_ellipses_transform():
    turn = (np.arange(400) + 0.5) * np.pi / 400
    for m in (3.0, 48.0):
        mean = (np.cos(m * 0.1 * np.cos(turn)) * np.sin(turn) ** 2).sum() * 2 / 400
        assert weights(np.array([m]), 0.1)[0] == pytest.approx(mean, rel=1e-12)
