"""A crowned clutch under force: contacts by slices, torque of a pressure, races as rings."""

import numpy as np
import pytest

from analytic.sprag.closure import wedged
from analytic.sprag.clutch import Clutch
from analytic.sprag.crowned import Crowned, mid, stiffness
from analytic.sprag.geometry import LogSprag
from analytic.sprag.parts import Parts
from analytic.sprag.race_stress import hoop, over_smeared
from analytic.sprag.tolerance import sensitivities, slope

SPRAG = LogSprag.from_wedge_angle(nu_0=0.055, R_i=11.11e-3, R_e=19.44e-3, r_i=4.02e-3)
PARTS = Parts(
    sprag=SPRAG, n_s=12, l=9e-3, b=4e-3, R_id=7.21e-3, R_ed=26.23e-3, E=206e9, nu=0.3
)  # fmt: skip
ONE = Crowned(
    PARTS, Clutch(sprag=SPRAG, n_s=12, compliance=PARTS.plane()), np.zeros(21), N_top=2e4
)  # fmt: skip


def test_without_a_crown_the_middle_has_little_less_than_hertz_s_pressure():
    inner, outer = ONE.pressed(3000.0)
    R, _ = ONE.radii(wedged(ONE.clutch, 3000.0))
    hertz = np.sqrt(3000.0 / 9e-3 * float(PARTS.E_star) / (np.pi * R))
    assert 0.95 * hertz < mid(inner) < hertz < inner.peak_pressure.max()  # ends carry
    assert mid(outer) < mid(inner)


def test_the_outer_flank_lies_in_its_bore():
    """A circle in a larger one: their curvatures' difference, and Hertz's pressure of it."""
    now = wedged(ONE.clutch, 3000.0)
    R = ONE.radii(now)[1]
    curvature = 1 / float(SPRAG.r_e) - 1 / 19.44e-3
    assert R * curvature == pytest.approx(1.0, rel=1e-12)
    hertz = np.sqrt(float(now.N_e) / 9e-3 * float(PARTS.E_star) / (np.pi * R))
    outer = ONE.pressed(3000.0)[1]
    assert 0.95 * hertz < mid(outer) < hertz < outer.peak_pressure.max()


def test_a_torque_of_a_pressure_has_that_pressure():
    T = ONE.torque_at(2.5e9, 0)
    N = 2e4 * np.linspace(0.01, 1, 400)
    force = float(np.interp(T, wedged(ONE.clutch, N).T, N))
    assert ONE.peaks(force)[0] == pytest.approx(2.5e9, rel=1e-4)
    assert ONE.torque_at(1e12, 0) == np.inf


def test_stiffness_grows_as_contacts_grow():
    assert stiffness(ONE.clutch, 6000.0) > stiffness(ONE.clutch, 1000.0) > 0


def test_slopes_of_the_wedge_angle_are_its_derivatives():
    exact = sensitivities(SPRAG)
    assert slope(SPRAG, "dR_i")[0] == pytest.approx(float(exact.R_i), rel=1e-5)


def test_hoop_stresses_balance_the_pressure_on_a_race():
    """Their mean over the wall is pressure times radius over thickness; the largest is more."""
    found = hoop(PARTS, 3000.0, 3000.0)
    mean = 12 * 3000.0 / (2 * np.pi * 9e-3) / (26.23e-3 - 19.44e-3)
    assert found["s_e"] > mean > 0 > found["s_i"] > found["s_id"]
    assert found["Tresca_i"] == -found["s_id"]


def test_a_race_of_many_sprags_deflects_as_a_smeared_one():
    many = Parts(
        sprag=SPRAG, n_s=60, l=9e-3, b=0.5e-3, R_id=7.21e-3, R_ed=26.23e-3, E=206e9, nu=0.3
    )  # fmt: skip
    for loaded in ("rim", "bore"):
        few, more = (abs(over_smeared(p, 1e-4, loaded) - 1) for p in (PARTS, many))
        assert more < few
