"""Locking of the rollers: its own equation, its slopes, and where it begins."""

import numpy as np
import pytest

from analytic.contact.hertz_line_approach import approach_to_centre
from analytic.polyhedral.bore_pressure import rim_displacement, stiffness_factors
from analytic.polyhedral.hub_force import hub_force
from analytic.polyhedral.locking import Roller, locked
from analytic.polyhedral.roller_load import roller_load
from analytic.polyhedral.sector import Sector

RING = {"d_e": 80.0, "d_i": 72.0, "rho": 2.0}
STEEL = {"E": 210e3, "nu": 0.3, "assumption": "plane stress"}
ROLLER = Roller(d=10.0, j_D=0.06)


@pytest.mark.parametrize("z", [3, 6, 24])
@pytest.mark.parametrize("assumption", ["plane stress", "plane strain"])
def test_the_rollers_are_reached_at_K_mid_times_p_1(z, assumption):
    ring, given = Sector(z=z, **RING), STEEL | {"assumption": assumption}
    K = stiffness_factors(sector=ring, nu=0.3, assumption=assumption)
    p_1 = 2 * 4 * 210e3 * 0.06 / (72 * 76)
    below = locked(sector=ring, roller=ROLLER, p=K.mid * p_1 * 0.999, **given)
    above = locked(sector=ring, roller=ROLLER, p=K.mid * p_1 * 1.001, **given)
    assert below.touch == pytest.approx(K.mid * p_1, rel=1e-12)
    assert below.N == below.efficiency == 0
    assert above.N > 0


@pytest.mark.parametrize("roller", [ROLLER, Roller(d=10.0, j_D=0.06, E=70e3, nu=0.33)])
def test_growth_dent_and_squeeze_close_the_gap(roller):
    ring = Sector(z=6, **RING)
    state = locked(sector=ring, roller=roller, p=30.0, **STEEL)
    grown = float(rim_displacement(0.0, sector=ring, p=30.0, **STEEL).real[0])
    dent = float(roller_load(sector=ring, a=state.a).rim_displacement(0.0, **STEEL)[0])
    E_star = 210e3 if np.isinf(roller.E) else 1 / (1 / 210e3 + 1 / roller.E)
    R = 1 / (2 / 10.0 + 2 / 80.0)
    assert state.a == pytest.approx(np.sqrt(4 * state.N * R / (np.pi * E_star)), rel=1e-12)
    squeeze = 0.0
    if np.isfinite(roller.E):
        outer = np.sqrt(4 * state.N / (1 / 5.0 - 1 / 50.03) / (np.pi * roller.E))
        ends = approach_to_centre(P=state.N, a=[state.a, outer], R=5.0, E_plane=roller.E)
        squeeze = float(ends.sum())
        assert state.a_race == pytest.approx(outer, rel=1e-12)
    assert (state.a_race > 0) == np.isfinite(roller.E)
    assert grown + state.N * dent - squeeze == pytest.approx(0.03, rel=1e-9)


@pytest.mark.parametrize("z", [3, 6, 24])
def test_the_efficiency_is_the_slope_of_the_force_over_the_sides_share(z):
    ring = Sector(z=z, **RING)
    forces = [locked(sector=ring, roller=ROLLER, p=p, **STEEL).N for p in (29.9, 30.1)]
    slope = (forces[1] - forces[0]) / 0.2
    state = locked(sector=ring, roller=ROLLER, p=30.0, **STEEL)
    assert state.efficiency == pytest.approx(slope / (72 * np.sin(np.pi / z)), rel=2e-4)
    assert 0 < state.efficiency < 1


def test_the_hub_share_is_the_slope_over_the_hubs_force_and_shifts_the_touch():
    ring = Sector(z=6, **RING)
    forces = {}
    for R in (990.0, 1000.0, 1010.0):
        hub = hub_force(sector=ring, e=9.0, normal=0.8 * R, along=0.6 * R)
        forces[R] = locked(sector=ring, roller=ROLLER, p=30.0, hub=hub, **STEEL)
    slope = (forces[1010.0].N - forces[990.0].N) / 20
    assert forces[1000.0].hub_share == pytest.approx(slope, rel=2e-4)
    assert forces[1000.0].touch < locked(sector=ring, roller=ROLLER, p=30.0, **STEEL).touch


def test_a_softer_roller_carries_less():
    ring = Sector(z=6, **RING)
    forces = [
        locked(sector=ring, roller=Roller(d=10.0, j_D=0.06, E=E, nu=0.3), p=30.0, **STEEL).N
        for E in (70e3, 210e3, 210e12)
    ]
    rigid = locked(sector=ring, roller=ROLLER, p=30.0, **STEEL).N
    assert forces[0] < forces[1] < forces[2] == pytest.approx(rigid, rel=1e-7)


def test_it_does_not_notice_units():
    state = locked(sector=Sector(z=6, **RING), roller=ROLLER, p=30.0, **STEEL)
    si = locked(
        sector=Sector(z=6, d_e=0.08, d_i=0.072, rho=0.002), roller=Roller(d=0.01, j_D=6e-5),
        p=30e6, E=210e9, nu=0.3, assumption="plane stress")  # fmt: skip
    assert pytest.approx(state.N, rel=1e-7) == si.N * 1e-3
    assert si.efficiency == pytest.approx(state.efficiency, rel=1e-6)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"p": np.inf}, "the pressure p must be finite"),
        ({"E": -1.0}, "Young's modulus must be positive"),
    ],
)
def test_wrong_input_is_named(change, message):
    given = {"roller": ROLLER, "p": 30.0, **STEEL} | change
    with pytest.raises(ValueError, match=message):
        locked(sector=Sector(z=6, **RING), **given)


def test_rollers_that_cannot_be_are_refused():
    with pytest.raises(ValueError, match="the roller's diameter d must be positive"):
        Roller(d=0.0, j_D=0.06)
    with pytest.raises(ValueError, match="the play j_D must be positive"):
        Roller(d=10.0, j_D=-0.06)


def test_many_rollers_take_what_a_rigid_housing_does():
    limit = 2 * 72 * 80 / (0.7 * 80**2 + 1.3 * 72**2)
    lacking = [
        1 - locked(sector=Sector(z=z, **RING), roller=ROLLER, p=30.0, **STEEL).efficiency / limit
        for z in (100, 200, 400)
    ]
    assert 0 < lacking[2] < lacking[1] < lacking[0] < 0.05
    assert lacking[1] / lacking[2] == pytest.approx(2, rel=0.2)  # the dents' part falls as 1/z
