"""Kriging of crowns' pressures in two regimes, and the search that knows no surrogate."""

import numpy as np
import pytest

from analytic.sprag.best_crown import Answer, fit_regimes, recorded, simplex
from analytic.sprag.crown_surrogate import axes, held, over_box
from analytic.surrogate.box import Box
from analytic.surrogate.designs import full_factorial

BOX = Box((1.0, 0.4, 5e-6), (5.0, 0.7, 25e-6))


def test_without_ends_that_carry_one_regime_is_kriged():
    x = full_factorial(BOX, 3)
    known = [Answer(0.0, 1e9 * (1 + p), 1.0) for p in BOX.to_unit(x).sum(axis=1)]
    surrogate = fit_regimes(x, known, BOX)
    assert len(surrogate.models) == 1
    assert surrogate.predict(x) == pytest.approx([a.largest for a in known], rel=1e-6)
    whole = over_box(surrogate, BOX)
    assert whole[0, 0, 0] == pytest.approx(1e9, rel=1e-3)
    assert whole[-1, -1, -1] == pytest.approx(4e9, rel=1e-3)


def bowl(crowns):
    return float(((BOX.to_unit(crowns)[0] - [0.4, 0.6, 0.5]) ** 2).sum())


def test_the_simplex_goes_down_and_every_engagement_is_recorded():
    seen = simplex(bowl, BOX, np.array([4.6, 0.42, 7e-6]))
    assert len(seen) <= 40
    assert [bowl(row[None, :3]) for row in seen] == pytest.approx(seen[:, 3])
    assert seen[:, 3].min() < 0.05 * seen[0, 3]


def test_crowns_outside_the_box_are_asked_on_its_side():
    pressure, seen = recorded(bowl, BOX)
    pressure(np.array([2.0, -1.0, 0.5]))
    assert seen[0][:3] == pytest.approx([5.0, 0.4, 15e-6])


def test_a_map_holds_the_paper_s_values_where_the_box_has_them():
    assert (held(BOX, 1), held(BOX, 2)) == (0.5, 10e-6)
    assert held(Box((1.0, 0.6, 5e-6), (5.0, 0.7, 25e-6)), 1) == pytest.approx(0.65)
    assert [(a[0], a[-1]) for a in axes(BOX)] == [(1.0, 5.0), (0.4, 0.7), (5e-6, 25e-6)]
