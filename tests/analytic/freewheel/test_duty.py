"""Limits of a clutch's loads, remedies, sensitivities and scatter."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import norm

from analytic.freewheel import limits, remedies, state, tolerance
from analytic.freewheel.duty import Duty
from analytic.freewheel.scatter import deviation, scatter, slopes

SIGMA = {"X": 5e-6 / 3, "r": 2e-6 / 3, "R": 5e-6 / 3, "mu": 0.004}


def duty(clutch, **changes):
    given = {"T": 26.0, "F_ax": 600.0, "mu": 0.08, "p_lim": 4e9}
    if clutch.cam.sense < 0:
        given |= {"T": 15.0, "mu": 0.09}
    return Duty(clutch=clutch, **(given | changes))


def required(d, T=None, F_ax=None):
    one = replace(d, T=T or d.T, F_ax=d.F_ax if F_ax is None else F_ax)
    return float(one.required(one.T, state.loaded(one.clutch, one.T).alpha))


@pytest.mark.parametrize("F_ax", [600.0, 1000.0])
def test_friction_is_just_enough_at_the_ends_of_the_range(clutch, F_ax):
    d = duty(clutch, F_ax=F_ax)
    ((low, high),) = d.friction_holds
    for T, inwards in ((low, 1), (high, -1)):
        if 0 < T < math.inf:
            assert required(d, T=T) == pytest.approx(d.mu, rel=1e-6)
            assert required(d, T=T * (1 + 0.01 * inwards)) < d.mu
    assert d.least_torque == low


@pytest.mark.parametrize("p_lim", [None, 2.2e9, 4e9])
def test_the_least_axial_load_of_ends_and_tilt_is_that_over_the_torque(clutch, p_lim):
    d = duty(clutch, p_lim=p_lim)
    least = min(limit.at for limit in d.of_axial_load if limit.key != "slip")
    assert float(d.largest_axial_load(np.array([d.T]))[0]) == pytest.approx(least, rel=1e-12)


@pytest.mark.parametrize("T", [-1.0, 0.0, 1e6])
def test_what_overruns_rests_or_has_no_state_has_no_limit_of_the_axial_load(star, T):
    assert duty(star, T=T).under is None
    assert duty(star, T=T).of_axial_load == []
    with pytest.raises(ValueError, match="no equilibrium exists at T"):
        remedies.friction_for(duty(star, T=T), 1.0)


@pytest.mark.parametrize("goal", [1.0, 1.1])
def test_flats_moved_as_advised_have_the_ratio(star, goal):
    d = duty(star, mu=0.065)
    moved = remedies.shifted(star, "X", remedies.moved_to(d, goal))
    assert float(remedies.ratios(d, moved)) == pytest.approx(goal, rel=2e-4)


def test_the_recommended_width_just_carries_the_torque(cup):
    d = duty(cup, T=60.0)
    found = dict(remedies.bearing(d))
    for share, bears in ((1 + 1e-9, True), (1 - 1e-6, False)):
        wide = replace(cup, L=found["L"] * share)
        assert np.isfinite(state.loaded(wide, d.T).N) == bears


def test_the_scatter_is_the_same_every_time_and_that_of_first_order(star):
    first, again = (scatter(duty(star), SIGMA, "normal").drawn.alpha0 for _ in range(2))
    assert np.array_equal(first, again)
    sigma = {name: s for name, s in SIGMA.items() if name != "mu"}
    assert np.std(again) == pytest.approx(deviation(star.cam, sigma), rel=0.03)
    assert sum(s.share for s in slopes(star.cam, sigma)) == pytest.approx(1)
    assert scatter(duty(star), {}, "normal") is None


def test_sensitivities_are_derivatives_of_the_clamping_angle(clutch):
    cam, h = clutch.cam, 1e-9
    for name, slope in tolerance.clamping_angle_sensitivities(cam).items():
        value = getattr(cam, name)
        up, down = (replace(cam, **{name: value + s * h}).alpha0 for s in (1, -1))
        assert float(slope) == pytest.approx(float(up - down) / (2 * h), rel=1e-5)


def test_a_clutch_that_holds_need_not_move_and_one_that_slips_has_nothing_to_spare(star):
    assert remedies.moved_to(duty(star), 1.0) == 0
    assert math.isnan(remedies.to_spare(duty(star, mu=0.065)))
    assert math.isnan(remedies.until_pop_through(duty(star)))  # of an inner cam there is none


def test_half_of_the_stars_at_their_corners_are_past_them(star):
    T = float(limits.roller_torque_limits(star, mu=2.0, p_lim=1e12).corner)
    load = {"T": T, "F_ax": 0.0, "mu": 2.0}
    under_load = tolerance.draw(star, {"X": 1e-7}, n=4000, seed=3, **load)
    assert under_load.share("past the corners") == pytest.approx(0.5, abs=0.03)
    assert under_load.share("holds") == pytest.approx(1 - under_load.share("past the corners"))


def test_limits_come_in_order(clutch):
    for found in (duty(clutch).of_torque, duty(clutch).of_axial_load):
        assert [x.at for x in found] == sorted(x.at for x in found)


def test_a_softer_clutch_holds_in_the_same_range_of_its_loads(clutch):
    """All forces and the modulus a millionth: torques from 1e-7 of the largest on are tried."""
    less = 2.0**-20

    def softer(part):
        return replace(part, E=part.E * less)

    parts = {name: softer(getattr(clutch, name)) for name in ("roller", "inner", "outer")}
    d, soft = duty(clutch), duty(replace(clutch, **parts), F_ax=600.0 * less)
    assert soft.end == pytest.approx(d.end * less, rel=1e-12)
    for pair, same in zip(soft.friction_holds, d.friction_holds, strict=True):
        assert pair == pytest.approx([less * T for T in same], rel=1e-9)


LOAD = {"T": 10.0, "F_ax": 300.0, "mu": 0.08}


@pytest.mark.parametrize("kind", ["normal", "uniform"])
def test_friction_has_normal_tails_for_any_distribution_of_dimensions(star, kind):
    """P(mu < mean - 2 s): 2.28 % of a normal one, none of a uniform one."""
    drawn = tolerance.draw(star, {"X": 3e-6, "mu": 0.004}, n=20000, seed=5, kind=kind, **LOAD)
    share = np.mean(drawn.drawn["mu"] < LOAD["mu"] - 2 * 0.004)
    assert share == pytest.approx(norm.cdf(-2), abs=4 * np.sqrt(norm.cdf(-2) / 20000))
    inside = np.abs(drawn.drawn["X"] - star.cam.X) <= 3e-6 * np.sqrt(3)
    assert bool(inside.all()) == (kind == "uniform")
