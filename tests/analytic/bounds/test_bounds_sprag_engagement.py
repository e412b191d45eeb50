"""Expected errors of an engagement: none where both models are one, and what adds to what."""

import pytest

from analytic.bounds.sprag.engagement import BOOKED, Bounds


def bounds(**changes):
    sizes = {"unequal": 1e-3, "passed_on": 1.2, "inertia": 5e-4, "left_out": 2e-4, "turns": False}
    return Bounds(**(sizes | changes))


def test_equal_forces_and_massless_sprags_leave_nothing():
    one = bounds(unequal=0.0, inertia=0.0, left_out=0.0)
    for interval in (one.statics(), one.energy(), one.spring(), one.both(), one.either_way(2)):
        assert interval == (0.0, 0.0)
    assert one.radially() == (-BOOKED, BOOKED)


def test_the_mass_of_sprags_adds_either_way_to_what_unequal_forces_take():
    low, high = bounds().spring()
    assert (low, high) == pytest.approx((-1.2e-3 - 5e-4, 5e-4))
    assert bounds().both() == pytest.approx((low - high, high - low))


def test_races_that_turn_at_the_start_have_no_interval():
    assert bounds(turns=True).spring() is None
    assert bounds(turns=True).both() is None
