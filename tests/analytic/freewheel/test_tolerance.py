"""Sensitivities against differences, first order against Monte Carlo."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.stats import norm

from analytic.freewheel import criterion, limits, state, tolerance

SIGMA = {"star": {"X": 3e-6, "r": 1e-6, "R": 2e-6}, "cup": {"X_o": 3e-6, "r": 1e-6, "R_s": 2e-6}}
LOAD = {"T": 10.0, "F_ax": 300.0, "mu": 0.08}


def test_sensitivities_are_derivatives_of_the_clamping_angle(clutch):
    cam, h = clutch.cam, 1e-9
    for name, slope in tolerance.sensitivities(cam).items():
        value = getattr(cam, name)
        up, down = (replace(cam, **{name: value + s * h}).alpha0 for s in (1, -1))
        assert float(slope) == pytest.approx(float(up - down) / (2 * h), rel=1e-5)


def test_five_micrometres_on_the_flat_turn_the_angle_by_eight_hundredths_of_a_degree(star):
    slope = tolerance.sensitivities(star.cam)["X"]
    assert float(np.degrees(5e-6 * slope)) == pytest.approx(-0.084, abs=5e-4)


@pytest.mark.parametrize("kind", ["normal", "uniform"])
@pytest.mark.parametrize("name", ["star", "cup"])
def test_first_order_meets_monte_carlo(name, kind, request):
    clutch, n = request.getfixturevalue(name), 40000
    sigma, shares = tolerance.first_order(clutch.cam, SIGMA[name])
    drawn = tolerance.draw(clutch, SIGMA[name], n=n, seed=7, kind=kind, **LOAD)
    assert np.all(drawn.wedging)
    assert drawn.alpha0.std() == pytest.approx(sigma, rel=0.02)
    assert sum(shares.values()) == pytest.approx(1, rel=1e-12)
    for field, share in shares.items():
        seen = np.corrcoef(drawn.drawn[field], drawn.alpha0)[0, 1] ** 2
        assert seen == pytest.approx(share, abs=0.02)


def test_a_seed_draws_the_same_clutches_again(star):
    one, two, other = (
        tolerance.draw(star, {"X": 3e-6, "mu": 0.01}, n=50, seed=seed, **LOAD) for seed in (1, 1, 2)
    )
    np.testing.assert_array_equal(one.mu_req, two.mu_req)
    assert not np.array_equal(one.mu_req, other.mu_req)


def test_clutches_without_deviation_are_all_the_nominal_one(star):
    drawn = tolerance.draw(star, {}, n=3, seed=1, **LOAD)
    now = state.loaded(star, 10.0)
    asked = criterion.required_friction(alpha=now.alpha, T=10.0, F_ax=300.0, R=star.cam.race)
    np.testing.assert_allclose(drawn.mu_req, asked, rtol=1e-12)
    assert drawn.share("holds") == 1


def test_clutches_without_wedge_are_counted_apart_from_those_that_slip(star):
    drawn = tolerance.draw(star, {"X": 5e-5}, n=4000, seed=3, **LOAD)
    lost = np.count_nonzero(drawn.drawn["X"] >= star.cam.R - 2 * star.cam.r)
    assert lost > 0
    assert drawn.share("no wedge") == lost / 4000
    assert drawn.share("slips") == np.count_nonzero(drawn.mu_req > 0.08) / 4000
    assert drawn.share("holds") == np.count_nonzero(drawn.mu_req <= 0.08) / 4000


def test_rollers_of_a_cup_that_go_through_under_load_are_counted_apart(cup):
    load = LOAD | {"T": 0.98 * float(limits.limits(cup, mu=0.08, p_lim=1e12).pop_through)}
    drawn = tolerance.draw(cup, {"X_o": 3e-6}, n=4000, seed=3, **load)
    through = np.count_nonzero(np.isnan(drawn.alpha))
    assert 0 < through < 4000
    assert drawn.share("no state") == through / 4000
    assert drawn.share("no wedge") == 0


def test_half_of_the_stars_at_their_corners_are_past_them(star):
    """At the torque T_c, and without load at the X at which the flats end under the rollers."""
    T = float(limits.limits(star, mu=2.0, p_lim=1e12).corner)
    load = {"T": T, "F_ax": 0.0, "mu": 2.0}
    under_load = tolerance.draw(star, {"X": 1e-7}, n=4000, seed=3, **load)
    assert under_load.share("past the corners") == pytest.approx(0.5, abs=0.03)
    assert under_load.share("holds") == pytest.approx(1 - under_load.share("past the corners"))
    R, r, tan = 16.5e-3, 2.5e-3, np.tan(np.pi / 8)
    X = brentq(lambda X: (R - r) ** 2 - (X + r) ** 2 - (X * tan) ** 2, 0.0, R)
    short = replace(star, cam=replace(star.cam, X=X + 1e-12))
    unloaded = tolerance.draw(short, {"X": 1e-7}, n=4000, seed=3, **load | {"T": 1e-6})
    assert unloaded.share("past the corners") == pytest.approx(0.5, abs=0.03)


def test_the_share_that_slips_is_that_of_the_friction_s_distribution(star):
    """Mu alone varies, about mu_req itself: half of them slip."""
    now = state.loaded(star, 10.0)
    asked = float(criterion.required_friction(alpha=now.alpha, T=10.0, F_ax=300.0, R=16.5e-3))
    load = LOAD | {"mu": asked}
    drawn = tolerance.draw(star, {"mu": 0.005}, n=20000, seed=5, **load)
    assert drawn.share("slips") == pytest.approx(0.5, abs=0.015)


@pytest.mark.parametrize("kind", ["normal", "uniform"])
def test_friction_keeps_the_tails_of_a_normal_one_whatever_dimensions_do(star, kind):
    """P(mu < mean - 2 s): 2.28 % of a normal one, none of a uniform one."""
    drawn = tolerance.draw(star, {"X": 3e-6, "mu": 0.004}, n=20000, seed=5, kind=kind, **LOAD)
    share = np.mean(drawn.drawn["mu"] < LOAD["mu"] - 2 * 0.004)
    assert share == pytest.approx(norm.cdf(-2), abs=4 * np.sqrt(norm.cdf(-2) / 20000))
    inside = np.abs(drawn.drawn["X"] - star.cam.X) <= 3e-6 * np.sqrt(3)
    assert bool(inside.all()) == (kind == "uniform")


def test_unknown_tolerances_and_kinds_are_refused(star):
    with pytest.raises(ValueError, match="'Y'"):
        tolerance.draw(star, {"Y": 1e-6}, n=3, seed=1, **LOAD)
    with pytest.raises(ValueError, match="kind is one of"):
        tolerance.draw(star, {}, n=3, seed=1, kind="flat", **LOAD)
    with pytest.raises(ValueError, match="above 0"):
        tolerance.first_order(star.cam, {"X": 0.0})
