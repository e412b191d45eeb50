"""Elastic parts of a sprag clutch: scales, walls, and laws beside each other."""

import numpy as np
import pytest

from analytic.sprag.closure import wedged
from analytic.sprag.elastic import Elastic
from analytic.sprag.geometry import LogSprag
from analytic.sprag.parts import Parts


def made(size=1.0, R_ed=26.23e-3, b=4e-3, r_i=4.02e-3):
    sprag = LogSprag.from_wedge_angle(
        nu_0=0.055, R_i=size * 11.11e-3, R_e=size * 19.44e-3, r_i=size * r_i
    )
    return Elastic(
        Parts(sprag=sprag, n_s=12, l=size * 9e-3, b=size * b, R_id=size * 7.21e-3,
              R_ed=size * R_ed, E=206e9, nu=0.3)
    )  # fmt: skip


def test_a_clutch_twice_as_large_under_four_times_the_force_is_strained_alike():
    small, large = made(), made(size=2.0)
    for kind in ("clutch", "plane"):
        one, other = wedged(getattr(small, kind), 3000.0), wedged(getattr(large, kind), 12000.0)
        assert float(other.yields.H) == pytest.approx(2 * float(one.yields.H), rel=1e-6)
        assert float(other.alpha_b) == pytest.approx(float(one.alpha_b), rel=1e-6)
    assert large.rolls_over_at == pytest.approx(8 * small.rolls_over_at, rel=1e-5)


def test_a_thicker_outer_wall_yields_less_and_the_inner_race_as_before():
    thin, thick = made(R_ed=23e-3).races, made(R_ed=40e-3).races
    assert thick[1].mean < 0.6 * thin[1].mean
    assert thick[0] == thin[0]


def test_a_race_yields_more_under_a_narrow_patch_and_its_middle_more_than_the_patch():
    race = made().races[0]
    assert race.at(np.asarray(1e-5)) > race.at(np.asarray(1e-4)) > race.mean
    assert float(race.at(1e-4) - race.under(1e-4)) == pytest.approx(1 / (2 * np.pi), rel=1e-12)


def test_a_sprag_wider_than_it_is_round_stands_for_a_disc_and_never_rolls_over():
    wide = made(r_i=6e-3, b=5e-3)
    assert wide.column is None
    assert wide.rolls_over_at == np.inf
    assert np.isfinite(float(wedged(wide.clutch, 3000.0).yields.H))


def test_elastic_bodies_yield_less_than_palmgren_s_law_has_it():
    one = made()
    elastic, palmgren = (float(wedged(c, 3000.0).yields.H) for c in (one.clutch, one.composite))
    assert 1.15 < palmgren / elastic < 1.45  # rollers of finite length
