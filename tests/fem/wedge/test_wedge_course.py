"""Numbers of states over one another: powers are met between the states, and integrated exactly."""

import numpy as np
import pytest

from fem.wedge.course import Course


def course(**powers):
    """Ten states whose quantities are powers of N."""
    made = Course()
    N = np.geomspace(2.0, 800.0, 10)
    made.at_states = {"N": N} | {name: 3.0 * N**power for name, power in powers.items()}
    return made


@pytest.mark.parametrize("N", [2.0, 31.0, 799.0])
def test_a_power_is_met_between_the_states(N):
    one = course(T=1.2, d=0.9)
    assert one.at("T", N) == pytest.approx(3 * N**1.2, rel=1e-12)
    assert one.at("d", 3 * N**1.2, "T") == pytest.approx(3 * N**0.9, rel=1e-12)


def test_what_hardly_changes_or_falls_is_splined_itself():
    one = course(T=1.0)
    one.at_states["tan"] = 0.05 - 1e-3 * np.log(one.at_states["N"])
    assert one.at("tan", 40.0) == pytest.approx(0.05 - 1e-3 * np.log(40.0), rel=1e-12)


def test_nothing_is_said_beyond_the_states():
    for N in (1.99, 801.0):
        with pytest.raises(ArithmeticError, match="lies beyond the states from 2 on"):
            course(T=1.0).at("T", N)


def test_an_integral_of_a_power_begins_without_load():
    N = np.array([5.0, 700.0])
    found = course().integral(lambda t: 4 * np.exp(1.9 * t), "N", np.log(N))
    assert found == pytest.approx(4 / 1.9 * N**1.9, rel=1e-12)
