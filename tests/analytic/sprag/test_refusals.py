"""Invalid sprags, motions and loads are refused in one line."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.sprag import friction, limits, pressure
from analytic.sprag.closure import at_rotation, wedged
from analytic.sprag.column import Column, approach
from analytic.sprag.geometry import LogSprag
from analytic.sprag.motion import Speeds, Torque
from analytic.sprag.rest import at_rest
from analytic.sprag.start import spring_equilibrium
from analytic.sprag.table import table as tabled
from analytic.sprag.table import tabulated
from tests.analytic.sprag.models import PARTS

nan = np.nan
TABLE = {"R_i": 11.11, "R_e": 19.44, "r_i": 4.02}
RISING = np.linspace(0, 1, 50)
COLUMNS = dict.fromkeys(("OA", "OB", "OC_g", "beta", "gamma"), RISING + 1)


def sprag(**change):
    return LogSprag(**{"m": 0.09} | TABLE | change)


def torque(times, values):
    return Torque(times=np.array(times), values=np.array(values))


def dented(a):
    column = Column(sprag=LogSprag.from_wedge_angle(nu_0=0.055, **TABLE), b=4.0)
    return approach(column.outline(turned=0.0, alpha_b=0.0), a=a, nu=0.3)


WITHOUT_CLUTCH = [
    (lambda: sprag(m=0.0), "m must be positive"),
    (lambda: sprag(R_i=20.0), "R_i must be below R_e"),
    (lambda: sprag(r_i=9.0), "pole C_e must lie inside the bore"),
    (lambda: LogSprag.from_wedge_angle(nu_0=2.0, **TABLE), "below pi/2"),
    (lambda: LogSprag.from_wedge_angle(nu_0=0.8, **TABLE), "no spiral has this wedge angle"),
    (lambda: Column(sprag=sprag(), b=9.0), "must not exceed the width of spiral and arc"),
    (lambda: dented((0.0, 0.1)), "half-width"),
    (lambda: friction.coefficient(0.0, mu_c=0.2, mu_s=0.1, gamma_b=1.0), "0 < mu_c <= mu_s < 1"),
    (lambda: pressure.along([-1.0], np.zeros(5), length=9e-3, R=2.95e-3, E_star=113.2e9),
     "normal force must be finite and not negative"),
    (lambda: torque([0.0, 0.0], [1.0, 2.0]), "times of a torque must increase"),
    (lambda: torque([0.0, 1.0], [1.0]), "one value per time"),
    (lambda: tabled(n_s=3, alpha=RISING * (1 - RISING), N=RISING, **COLUMNS), "must increase"),
    (lambda: tabled(n_s=3, alpha=RISING, N=RISING + 1, **COLUMNS), "begin at N = 0"),
    (lambda: replace(PARTS, b=6e-3), "sprags touch each other"),
    (lambda: replace(PARTS, R_id=12e-3), "R_id below R_i"),
    (lambda: replace(PARTS, R_ed=19e-3), "R_ed above R_e"),
    (lambda: replace(PARTS, n_s=2.5), "must be whole"),
    (lambda: replace(PARTS, omega=-1.0), "speed omega"),
]  # fmt: skip


@pytest.mark.parametrize(("call", "message"), WITHOUT_CLUTCH, ids=[m for _, m in WITHOUT_CLUTCH])
def test_what_makes_no_sense_is_refused_in_one_line(call, message):
    with pytest.raises(ValueError, match=message) as refused:
        call()
    assert "\n" not in str(refused.value)


OF_CLUTCH = [
    (lambda c: wedged(c, -1.0), "normal force"),
    (lambda c: at_rotation(c, nan), "rotation alpha"),
    (lambda c: limits.sprag_torque_limits(c, mu=0.0, theta_max=0.3), "friction"),
    (lambda c: limits.sprag_torque_limits(c, mu=0.1, theta_max=-1.0), "theta_max"),
    (lambda c: spring_equilibrium(c, K_r=0.01, alpha_max=-0.1), "alpha_max above alpha"),
    (lambda c: spring_equilibrium(c, K_r=1e9, alpha_max=3.0), "balances energizing springs of K_r"),
    (lambda c: tabulated(c, N_end=20e3, theta_max=1e-9), "no equilibrium under normal forces"),
]


@pytest.mark.parametrize(("call", "message"), OF_CLUTCH, ids=[m for _, m in OF_CLUTCH])
def test_loads_without_equilibrium_are_refused(clutch, call, message):
    with pytest.raises((ValueError, ArithmeticError), match=message):
        call(clutch)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"m_g": 0.0}, "m_g must be positive and finite, got 0.0 kg"),
        ({"C_rl": -0.1}, "C_rl must be finite and not negative, got -0.1 N m s/rad"),
        ({"mu_c": 0.2}, "mu_c <= mu_s\\), got mu_c=0.2, mu_s=0.12"),
        ({"K_r": 1e5, "alpha_max": 3.0}, "must not rotate the sprag to the end of its profile"),
    ],
)
def test_a_motion_that_makes_no_sense_is_refused(table, motion, change, message):
    with pytest.raises(ValueError, match=message):
        at_rest(table, replace(motion, **change), Speeds())


@pytest.mark.parametrize("wrong", [{"duration": 0.0}, {"dt": -1e-5}, {"D_V": nan}])
def test_times_and_bands_that_make_no_sense_are_refused(engaged, wrong):
    with pytest.raises(ValueError, match="must be positive and finite"):
        engaged(25.0, **wrong)
