"""What Eqs. 9, 10 and 16 say as printed, and by how much it is off."""

import numpy as np
import pytest

from analytic.sprag import printed
from analytic.sprag.closure import wedged
from analytic.sprag.clutch import Clutch
from analytic.sprag.geometry import triangle
from analytic.sprag.parts import Parts


@pytest.fixture
def fast(sprag):
    """The clutch at 1000 rad/s."""
    parts = Parts(
        sprag=sprag, n_s=12, l=9e-3, b=4e-3, R_id=7.21e-3, R_ed=26.23e-3, E=206e9, nu=0.3,
        omega=1000.0,
    )  # fmt: skip
    return Clutch(sprag=sprag, n_s=12, compliance=parts.palmgren())


def test_the_printed_pole_lets_the_sprag_grow_with_the_outer_race(fast):
    """Erratum eq-9-centrifugal: C_eB is the sprag's own radius less its own flattening."""
    now = wedged(fast, 2000.0)
    y = now.yields
    own = fast.sprag.r_e - y.contact_e / 2 - y.sprag / 2
    assert float(now.OB - now.OC_e) == pytest.approx(float(own), rel=1e-12)
    grown = now.OB - printed.pole_distance(fast.sprag, y) - own
    assert float(grown) == pytest.approx(float(y.d_ce), rel=1e-9)
    assert float(y.d_ce) > 4e-7


def test_the_printed_theta_is_no_angle_of_the_spiral():
    """Erratum eq-10-theta: rho grows by m rho a radian; log((rho/a)/m) grows by rho'/rho = m."""
    a, m, theta = 3.5, 0.0892, np.array([0.5, 1.5])
    rho = a * np.exp(m * theta)
    assert np.log(rho / a) / m == pytest.approx(theta, rel=1e-12)
    told = printed.polar_angle(rho=rho, a=a, m=m)
    assert told[1] - told[0] == pytest.approx(m * (theta[1] - theta[0]), rel=1e-12)


def test_the_printed_lever_arms_are_halves(clutch):
    """Erratum eq-16-lever-arms: 5.6 for 11.1 mm and 9.7 for 19.4 mm double the contact force."""
    now = wedged(clutch, 3407.0)
    inner, outer = printed.lever_arms(clutch.sprag, now.yields)
    assert float(inner / now.OA) == pytest.approx(0.5, abs=1e-3)
    assert float(outer / now.OB) == pytest.approx(0.5, abs=1e-3)
    assert float(inner) == pytest.approx(5.55e-3, abs=5e-5)
    assert float(outer) == pytest.approx(9.73e-3, abs=5e-5)
    moment = now.OA * now.T_i - now.OB * now.T_e
    assert float(moment) == pytest.approx(0.0, abs=1e-12)


def test_the_printed_triangle_turns_the_sprag_less_under_the_same_force(clutch):
    """OA with delta_HI/2 alone: six sevenths of the rotation, a seventh more force at the same."""
    ours, theirs = wedged(clutch, 3407.0), printed.wedged(clutch, 3407.0)
    assert float(theirs.alpha_b / ours.alpha_b) == pytest.approx(0.85, abs=0.01)
    assert float(theirs.OA) == float(ours.OA)
    lost = theirs.OA_s - ours.OA_s
    assert float(lost) == pytest.approx(
        float(ours.yields.contact_i / 2 + ours.yields.sprag / 2), rel=1e-9
    )
    found = triangle(OA=theirs.OA, OC_e=theirs.OC_e, m=clutch.sprag.m)
    assert float(found.beta) == float(theirs.beta)
