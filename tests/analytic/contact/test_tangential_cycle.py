"""The swinging tangential force against balance, friction's limit and the energy of the strips."""

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.contact import partial_slip, tangential_cycle

LOAD = {"Q_max": 0.6, "P": 2.0, "mu": 0.4, "a": 0.5}  # k = 0.75
E_STAR = 7.0
NO_WIDTH = {"Q_max": 0.6, "P": 2.0, "mu": 0.4, "E_star": E_STAR}


@pytest.mark.parametrize("branch", ["unloading", "reloading"])
@pytest.mark.parametrize("Q", [-0.6, -0.2, 0.0, 0.45, 0.6])
def test_the_traction_carries_the_force_and_stays_within_friction(Q, branch):
    t = (np.arange(20000) + 0.5) * np.pi / 20000  # midpoints in the angle: x = -a cos(t)
    x = -0.5 * np.cos(t)
    q = tangential_cycle.traction(x, Q=Q, **LOAD, branch=branch)
    assert np.sum(q * 0.5 * np.sin(t)) * np.pi / 20000 == pytest.approx(Q, abs=1e-6)
    limit = 0.4 * 2 * 2.0 / (np.pi * 0.5) * np.sqrt(1 - (x / 0.5) ** 2)
    assert np.all(np.abs(q) <= limit + 1e-14)


def test_the_cycle_closes_and_starts_where_the_first_loading_ends():
    x = np.linspace(-0.5, 0.5, 11)
    first = partial_slip.traction(x, Q=0.6, P=2.0, mu=0.4, a=0.5)
    end = partial_slip.slip(x, Q=0.6, P=2.0, mu=0.4, a=0.5, E_star=E_STAR)
    for branch in ("unloading", "reloading"):
        for sign in (1, -1):
            at = {"Q": sign * 0.6, **LOAD, "branch": branch}
            q = tangential_cycle.traction(x, **at)
            np.testing.assert_allclose(q, sign * first, atol=1e-14)
            slip = tangential_cycle.slip(x, **at, E_star=E_STAR)
            np.testing.assert_allclose(slip, sign * end, atol=1e-15)


def test_without_force_tractions_stay_locked_in():
    """At Q = 0 on the way down the strip slid back carries -mu p, the middle its opposite."""
    q = tangential_cycle.traction([0.0, 0.499], Q=0.0, **LOAD, branch="unloading")
    assert q[0] > 0 > q[1]
    up = tangential_cycle.traction([0.0, 0.499], Q=0.0, **LOAD, branch="reloading")
    np.testing.assert_allclose(up, -q, rtol=1e-14)


def test_a_strip_slides_back_only_against_friction():
    """Where slip changes on the way down, the traction is -mu p."""
    x = np.linspace(-0.499, 0.499, 101)
    before, after = (
        tangential_cycle.slip(x, Q=Q, **LOAD, E_star=E_STAR, branch="unloading")
        for Q in (0.2, 0.199)
    )
    limit = 0.4 * 2 * 2.0 / (np.pi * 0.5) * np.sqrt(1 - (x / 0.5) ** 2)
    q = tangential_cycle.traction(x, Q=0.199, **LOAD, branch="unloading")
    moving = np.abs(after - before) > 1e-12
    assert moving.any()
    assert np.all(after[moving] < before[moving])
    np.testing.assert_allclose(q[moving], -limit[moving], rtol=1e-12)


def test_dissipation_is_friction_times_slip_over_the_strips():
    """Every point of a strip slides by twice its slip under mu p, there and back."""
    c = float(partial_slip.stick_half_width(Q=0.6, P=2.0, mu=0.4, a=0.5))

    def work(x):
        slip = partial_slip.slip(x, Q=0.6, P=2.0, mu=0.4, a=0.5, E_star=E_STAR)
        limit = partial_slip.traction(x, Q=0.6, P=2.0, mu=0.4, a=0.5)
        return 4 * float(limit * slip)

    lost, _ = quad(work, c, 0.5, epsabs=1e-14)
    assert float(tangential_cycle.dissipation(**NO_WIDTH)) == pytest.approx(2 * lost, rel=1e-8)


def test_dissipation_is_the_area_of_the_loop():
    def width(Q):
        down, up = (
            float(tangential_cycle.rigid_displacement_beyond_stick(Q=Q, **NO_WIDTH, branch=b))
            for b in ("unloading", "reloading")
        )
        return down - up

    area, _ = quad(width, -0.6, 0.6, epsabs=1e-14)
    assert float(tangential_cycle.dissipation(**NO_WIDTH)) == pytest.approx(area, rel=1e-9)


@pytest.mark.parametrize("k", [0.1, 0.9, 0.999])
def test_dissipation_has_the_closed_form_of_its_docstring(k):
    W = tangential_cycle.dissipation(Q_max=k, P=1.0, mu=1.0, E_star=2 / np.pi)
    assert float(W) == pytest.approx(k * (2 - k) + 2 * (1 - k) * np.log1p(-k), rel=1e-11)


def test_dissipation_starts_with_the_cube_of_the_force():
    W = tangential_cycle.dissipation(Q_max=[1e-6, 2e-6], P=1.0, mu=1.0, E_star=2 / np.pi)
    np.testing.assert_allclose(W, [1e-18 / 3, 8e-18 / 3], rtol=2e-6)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"Q": 0.7}, "between -Q_max and Q_max = 0.6 N/m, got 0.7 N/m"),
        ({"Q": np.nan}, "between -Q_max and Q_max"),
        ({"Q_max": 0.8}, "the contact slides"),
        ({"Q_max": 0.0}, "amplitude of the force"),
        ({"branch": "down"}, "branch is one of unloading, reloading"),
    ],
)
def test_input_that_makes_no_sense_is_refused(change, message):
    sound = {"Q": 0.0, **LOAD, "branch": "unloading"} | change
    with pytest.raises(ValueError, match=message):
        tangential_cycle.traction(0.0, **sound)
