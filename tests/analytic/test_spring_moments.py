"""The moment diagram against the energy integrals, which were derived in closed form."""

import numpy as np
import pytest

from analytic.spring.energy import apex_moments, flexibility
from analytic.spring.moments import moment_diagram

SPRINGS = [
    {"n": 10, "L1": 11.6, "r": 0.45, "b": 0.1, "alpha": np.radians(80)},
    {"n": 7, "L1": 4.0, "r": 0.6, "b": 0.2, "alpha": np.radians(55)},
]


@pytest.mark.parametrize("spring", SPRINGS)
def test_its_square_integrates_to_the_flexibility(spring):
    s, m = (a.reshape(-1, 65) for a in moment_diagram(**spring, per_piece=65))
    simpson = np.ones(65)
    simpson[1:-1:2], simpson[2:-1:2] = 4, 2
    integral = ((s[:, 1] - s[:, 0]) / 3 * (m**2 @ simpson)).sum()
    assert integral == pytest.approx(float(flexibility(**spring)), rel=1e-8)


@pytest.mark.parametrize("spring", SPRINGS)
def test_pieces_meet_and_reach_the_couples_of_the_apexes(spring):
    s, m = (a.reshape(-1, 9) for a in moment_diagram(**spring))
    assert len(s) == 3 * spring["n"] - 3
    assert pytest.approx(s[:-1, -1]) == s[1:, 0]
    assert pytest.approx(m[:-1, -1]) == m[1:, 0]
    apexes = m[1::3, -1]
    assert pytest.approx([float(T) for T in apex_moments(**spring)]) == apexes
