"""Eqs. 12 and 13."""

import numpy as np
import pytest

from analytic.sprag.friction import coefficient, static_limit


def test_eq_13_by_hand_for_many_speeds():
    found = coefficient([0.0, 1.0, -1.0, 1e3], mu_c=0.08, mu_s=0.12, gamma_b=1.0)
    fall = 0.04 * np.exp(-1)
    assert found.tolist() == pytest.approx([0.12, 0.08 + fall, 0.08 + fall, 0.08], rel=1e-12)


def test_the_branches_of_eq_12_join_at_the_static_limit():
    at_rest = coefficient(0.0, mu_c=0.08, mu_s=0.12, gamma_b=1.0) * 250.0
    assert float(static_limit(N=250.0, mu_s=0.12)) == pytest.approx(float(at_rest))


@pytest.mark.parametrize(("mu_c", "mu_s"), [(0.0, 0.1), (0.2, 0.1), (0.1, 1.0), (np.nan, 0.1)])
def test_coefficients_out_of_order_are_refused(mu_c, mu_s):
    with pytest.raises(ValueError, match="0 < mu_c <= mu_s < 1"):
        coefficient(0.0, mu_c=mu_c, mu_s=mu_s, gamma_b=1.0)
