"""Optimal crowns by two regimes, their peaks, and a sprag drawn point by point."""

import math

import numpy as np
import pytest

from analytic.contact import crown
from analytic.sprag.best_crown import Answer, fit_regimes, simplex
from analytic.sprag.closure import wedged
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.compliance import Compliance
from analytic.sprag.crown_surrogate import axes, held, over_box
from analytic.sprag.drawn import Drawn, Sizes, crown_drop, middles
from analytic.sprag.peaks import END, Peaks
from analytic.surrogate.box import Box
from analytic.surrogate.designs import full_factorial
from tests.analytic.sprag.models import SPRAG

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


RADII = {"R_i": 11.11e-3, "R_e": 19.44e-3, "r_i": 4.02e-3}
SIZES = Sizes(
    R_id=7.21e-3, R_ed=26.23e-3, m=float(np.asarray(SPRAG.m)), z=12, l=9e-3, b=4e-3, E=206e9,
    nu=0.3, density=7850.0, omega=0.0, gap=np.zeros(21), **RADII,
)  # fmt: skip


def test_a_drawn_sprag_lies_where_the_triangle_has_it():
    found, d = Drawn(SIZES, 400).under(3000.0), Drawn(SIZES, 400).yields(3000.0)
    compliance = Compliance(
        contact_i=lambda N: 0 * N + d["HI"], contact_e=lambda N: 0 * N + d["HE"],
        race_i=d["BI"] / 3000, race_e=d["BE"] / 3000, sprag=d["g"] / 3000,
    )  # fmt: skip
    at = wedged(SpragClutch(sprag=SPRAG, n_s=12, compliance=compliance), 3000.0)
    assert found.nu == pytest.approx(float(at.nu), rel=2e-5)
    assert found.alpha == pytest.approx(float(at.alpha_b), rel=1e-5)
    assert pytest.approx(float(at.T), rel=2e-5) == found.T


PRESSURE = np.array([[[2.0, 1.0, 2.5, 1.0, 2.0], [0.0, 3.0, 2.0, 3.0, 0.0]]])  # 1 crown, 2 torques


def peaks(by):
    return Peaks(np.ones((1, 3)), np.array([10.0, 25.0]), np.ones((1, 2)), PRESSURE, by)


def test_strips_count_ends_that_carry_for_more():
    assert peaks("strips").objective == pytest.approx(np.array([[END * 2.0, 3.0]]))
    assert peaks("strips").largest.tolist() == [[2.5, 3.0]]
    alone = peaks("strips").of(1)  # of several torques
    assert alone.torques.tolist() == [25.0]
    assert alone.end.tolist() == [[0.0]]
    assert alone.inside.tolist() == [[3.0]]


def test_the_crown_is_eq_1_in_its_range_and_flat_in_the_middle():
    y, A = middles(9e-3, 41), 2 * 3407.0 / (math.pi * 9e-3 * 226e9)
    z = crown_drop(y, length=9e-3, A=A, K_2=0.7, z_m=1e-5)
    other = crown.logarithmic(
        crown.slice_centres(length=9e-3, slices=41), K_1=1.0, K_2=0.7, z_m=1e-5, load=3407.0,
        length=9e-3, E_star=113e9,
    )  # fmt: skip
    assert z == pytest.approx(np.asarray(other), abs=1e-12)
    assert z[20] == 0
    assert z[0] == z[-1] == z.max()


def bowl(crowns):
    return float(((BOX.to_unit(crowns)[0] - [0.4, 0.6, 0.5]) ** 2).sum())


def test_the_simplex_goes_down_and_every_engagement_is_recorded():
    seen = simplex(bowl, BOX, np.array([4.6, 0.42, 7e-6]))
    assert len(seen) <= 40
    assert [bowl(row[None, :3]) for row in seen] == pytest.approx(seen[:, 3])
    assert seen[:, 3].min() < 0.05 * seen[0, 3]


def test_a_map_holds_the_paper_s_values_where_the_box_has_them():
    assert (held(BOX, 1), held(BOX, 2)) == (0.5, 10e-6)
    assert held(Box((1.0, 0.6, 5e-6), (5.0, 0.7, 25e-6)), 1) == pytest.approx(0.65)
    assert [(a[0], a[-1]) for a in axes(BOX)] == [(1.0, 5.0), (0.4, 0.7), (5e-6, 25e-6)]
