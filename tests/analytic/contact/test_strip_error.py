"""What the strips neglect: the estimate against Hertz's exact ellipse, and where there is none."""

import numpy as np
import pytest
from scipy.special import ellipe, ellipkm1

from analytic.contact.strip_error import discretisation, neglected
from analytic.contact.strips import press


def ellipse(b, n=161):
    """Strips pressed into Hertz's ellipse with semi-axes 1 and b, and its pressure there."""
    p_0 = 1e-3
    K, E = ellipkm1(b**2), ellipe(1 - b**2)
    along = p_0 * b / (1 - b**2) * (K - E)  # 1/(2 R_y), Johnson 1985, Eqs. 4.26 to 4.28
    across = p_0 * b / (1 - b**2) * (E / b**2 - K)
    y = ((np.arange(n) + 0.5) / n - 0.5) * 2.2
    roller = press(
        along * y**2, length=2.2, R=1 / (2 * across), E_star=1.0, load=2 / 3 * np.pi * b * p_0
    )
    return roller, p_0 * np.sqrt(np.maximum(1 - y**2, 0.0)), y


@pytest.mark.parametrize("b", [0.02, 0.05, 0.1, 0.2, 0.3])
def test_the_estimate_meets_the_deviation_from_hertz_ellipse(b):
    """What is left is of the order of the deviation squared, and of the strips' width."""
    roller, exact, y = ellipse(b)
    estimate = neglected(roller)
    inner = np.abs(y) < 0.8
    deviation = exact[inner] / roller.pressure[inner] - 1
    np.testing.assert_allclose(estimate.pressure[inner], deviation, rtol=0.04)
    assert float(estimate.peak) == pytest.approx(exact.max() / float(roller.peak) - 1, rel=0.04)
    assert float(estimate.mid) == pytest.approx(float(estimate.peak), rel=1e-6)


def test_a_flat_roller_has_no_estimate_at_its_ends_and_nearly_nothing_in_the_middle():
    roller = press(np.zeros(81), length=9e-3, R=3e-3, E_star=1e11, load=3000.0)
    estimate = neglected(roller)
    from_end = (np.arange(81) + 0.5) * 9e-3 / 81
    near = np.minimum(from_end, from_end[::-1]) < 3 * roller.half_width
    assert near.sum() > 2
    np.testing.assert_array_equal(np.isnan(estimate.pressure), near)
    assert np.isnan(estimate.peak)
    assert abs(float(estimate.mid)) < 1e-3


def test_strips_beside_ones_that_carry_nothing_have_no_estimate():
    roller, _, _ = ellipse(0.1)
    edge = np.flatnonzero(roller.carries)[0]
    known = ~np.isnan(neglected(roller).pressure)
    assert not known[: edge + 1].any()
    assert known[edge + 1]


def test_cases_are_estimated_together_as_alone():
    y = ((np.arange(40) + 0.5) / 40 - 0.5) * 9e-3
    gap = y**2 / np.array([[0.2], [1.0]])
    both = neglected(press(gap, length=9e-3, R=3e-3, E_star=1e11, load=[500.0, 3000.0]))
    alone = neglected(press(gap[1], length=9e-3, R=3e-3, E_star=1e11, load=3000.0))
    assert both.peak.shape == (2,)
    assert float(both.mid[1]) == pytest.approx(float(alone.mid), rel=1e-6)


@pytest.mark.parametrize("n", [20, 40])
def test_the_discretisation_estimate_covers_what_more_strips_change(n):
    coarse, fine, exact = (ellipse(0.1, count)[0] for count in (n, 2 * n, 320))
    for estimate, left in zip(
        discretisation(coarse, fine),
        (fine.peak / exact.peak - 1, fine.mid / exact.mid - 1),
        strict=True,
    ):
        assert abs(float(left)) <= float(estimate) < 5e-3


def test_the_discretisation_is_not_estimated_backwards():
    coarse, fine = (ellipse(0.1, n)[0] for n in (20, 40))
    with pytest.raises(ValueError, match="more strips than coarse, got 20 and 40"):
        discretisation(fine, coarse)
