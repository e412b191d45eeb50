"""Constants of rings by transfer over ln r against those of the formulas, by series of powers."""

import math

import numpy as np
import pytest

from analytic.bounds.freewheel import ring_constants
from analytic.freewheel import series

RATIOS = (1.1, 1.52, 3.0, 50.0)


@pytest.mark.parametrize("n", [3, 8, 14])
@pytest.mark.parametrize("nu", [0.2, 3 / 7])
def test_a_clamped_disc_is_the_star_of_the_formulas(n, nu):
    """The series of the star is cut at 400 waves, its rest summed to about 2e-7."""
    star = series.star_constant(ratio=RATIOS, n=n, nu=nu)
    again = [ring_constants.clamped_disc(ratio=x, n=n, nu=nu) for x in RATIOS]
    np.testing.assert_allclose(again, star, atol=3e-7)


@pytest.mark.parametrize("n", [3, 8, 14])
@pytest.mark.parametrize("nu", [0.2, 3 / 7])
def test_a_free_ring_is_the_ring_of_the_formulas(n, nu):
    """The formulas' constant is read off a patch of a = 2e-3 r; (a/wall)² of it is left out."""
    ring = series.race_constant(ratio=RATIOS, n=n, nu=nu, loaded="bore")
    again = [ring_constants.free_ring(ratio=x, n=n, nu=nu) for x in RATIOS]
    np.testing.assert_allclose(again, ring, rtol=3e-5)


def test_a_thin_ring_bends_as_a_curved_beam_that_two_opposite_forces_pull():
    """Its diameter grows by (pi/4 - 2/pi) P R³/(E I); shear and stretch are of (t/R)²."""
    t = 2e-3
    bent = (1 + t / 2) ** 3 / (t**3 / 12) * (math.pi / 4 - 2 / math.pi) / 2
    found = ring_constants.free_ring(ratio=1 + t, n=2, nu=0.0) / math.pi
    assert found == pytest.approx(bent, rel=1e-4)


@pytest.mark.parametrize("m", [3, 5, 40])
def test_waves_that_do_not_reach_the_other_wall_are_those_of_a_body_without_it(m):
    far, nu = 16 / m, 0.3
    clamped = ring_constants._transfer(m, far, nu)[:, 2:].reshape(2, 2, 2)
    free = ring_constants._transfer(m, -far, nu)[:, :2].reshape(2, 2, 2)
    disc, hole = ring_constants._answer(m, *clamped), -ring_constants._answer(m, *free)
    assert disc == pytest.approx((1 + nu) / 2 / (m - 1) + (3 - nu) / 2 / (m + 1), rel=1e-7)
    assert hole == pytest.approx((3 - nu) / 2 / (m - 1) + (1 + nu) / 2 / (m + 1), rel=1e-7)
