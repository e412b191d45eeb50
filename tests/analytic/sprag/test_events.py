"""The engagement by events, which knows no band and no step, against the compiled one."""

import numpy as np
import pytest

from analytic.sprag.history import Phase
from analytic.sprag.motion import Speeds


@pytest.mark.parametrize("torque", [25.0, 40.0])
def test_rolling_engagements_agree_to_1e_7(engaged, by_events, torque):
    run, partner = engaged(torque), by_events(torque)
    assert run.N_max == pytest.approx(partner.N_max, rel=1e-7)
    assert run.peak[0] == pytest.approx(float(partner.peaks[0, 0]), abs=2e-8)
    between = partner.t <= run.t[-1]
    np.testing.assert_allclose(
        np.interp(partner.t[between], run.t, run.T_i), partner.T_i[between], atol=1.0
    )
    assert bool(partner.rolls.all())


@pytest.mark.parametrize(
    ("torque", "other"),
    [
        (40.0, {"alpha_max": 0.02}),  # what the band's guard protects
        (25.0, {"alpha_max": 0.02, "mu_s": 0.06, "mu_c": 0.05}),
    ],
)
def test_engagements_that_slip_at_the_start_agree_to_1e_4(engaged, by_events, torque, other):
    run, partner = engaged(torque, **other), by_events(torque, **other)
    assert not partner.rolls.all()
    assert run.N_max == pytest.approx(partner.N_max, rel=1e-4)
    slid = run.t[np.flatnonzero(run.phases[:, 0] == Phase.SLIP)[-1]]
    freed = partner.t[np.flatnonzero(~partner.rolls[:, 0])[-1]]
    assert slid == pytest.approx(freed, abs=3e-5)


def test_a_race_that_arrives_with_speed_agrees_to_1e_3(engaged, by_events):
    run = engaged(25.0, speeds=Speeds(inner=10.0))
    partner = by_events(25.0, speeds=Speeds(inner=10.0))
    assert run.N_max == pytest.approx(partner.N_max, rel=1e-3)


def test_a_slipping_clutch_slips_in_both(engaged, by_events):
    low = {"mu_s": 0.05, "mu_c": 0.04}
    run, partner = engaged(25.0, **low), by_events(25.0, duration=0.006, **low)
    assert not partner.rolls[-1].all()
    assert run.N_max == pytest.approx(partner.N_max, rel=1e-3)


def test_pure_rolling_asks_for_the_wedge_angle_s_friction(by_events, table):
    """Xu's and Liu's assumption: the clutch never slips; this is the friction it takes."""
    partner = by_events(25.0, unlimited=True, mu_s=0.01, mu_c=0.01)
    assert bool(partner.rolls.all())
    top = table.static_ratio(float(partner.states[:, 3].max()))
    assert partner.asked == pytest.approx(float(top), rel=2e-3)


def test_past_the_profile_the_events_end(by_events):
    partner = by_events(400.0)
    assert partner.over
    assert partner.N_max == pytest.approx(40e3, rel=1e-6)
