"""Partial slip and its cycle: balance, the half-plane's integral, the rule of friction, energy."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.contact import partial_slip, tangential_cycle

LOAD = {"Q": 0.3, "P": 2.0, "mu": 0.4, "a": 0.5}  # k = 0.375
E_STAR = 7.0


def q(x):
    return float(partial_slip.traction(x, **LOAD))


def c_of():
    return float(partial_slip.stick_half_width(**LOAD))


def test_the_traction_carries_the_force_and_uses_friction_up_where_it_slips_alone():
    carried, _ = quad(q, -0.5, 0.5, points=[-c_of(), c_of()], epsabs=1e-11, limit=200)
    assert carried == pytest.approx(LOAD["Q"], rel=1e-8)
    x = np.linspace(-0.5, 0.5, 201)
    limit = 0.4 * 2 * 2.0 / (np.pi * 0.5) * np.sqrt(1 - (x / 0.5) ** 2)
    traction, stuck = partial_slip.traction(x, **LOAD), np.abs(x) < c_of()
    np.testing.assert_allclose(traction[~stuck], limit[~stuck], atol=1e-14)
    assert np.all(traction[stuck] < limit[stuck])


def middle_displacement(x):
    """-2/(pi E*) times the integral of q ln|x - t|: the shift, up to a constant."""
    a, c = LOAD["a"], c_of()
    cuts = sorted({-a, -c, c, a, x})

    def part(t):
        return q(t) * np.log(abs(x - t))

    pieces = [quad(part, u, v, epsabs=1e-12, limit=200)[0] for u, v in pairwise(cuts)]
    return -2 / (np.pi * E_STAR) * sum(pieces)


@pytest.mark.parametrize("share", [0.5, 0.97])
def test_slip_is_what_the_traction_does_not_carry_along(share):
    """By the half plane's logarithm alone: zero if it sticks, the closed form where it slips."""
    x = share * LOAD["a"]
    lag = middle_displacement(0.0) - middle_displacement(x)
    slip = float(partial_slip.slip(x, **LOAD, E_star=E_STAR))
    assert slip == pytest.approx(lag, abs=1e-9)
    assert (slip > 0) == (x > c_of())


def test_displacement_beyond_stick_is_that_of_the_traction_less_that_of_a_bonded_contact():
    """The bonded traction Q/(pi sqrt(a² - x²)) shifts the middle by -2Q/(pi E*) ln(a/2)."""
    bonded = -2 * LOAD["Q"] / (np.pi * E_STAR) * np.log(LOAD["a"] / 2)
    load = {"Q": 0.3, "P": 2.0, "mu": 0.4, "E_star": E_STAR}
    beyond = float(partial_slip.rigid_displacement_beyond_stick(**load))
    assert beyond == pytest.approx(middle_displacement(0.0) - bonded, rel=1e-8)


def test_bodies_of_one_material_are_uncoupled_and_a_rigid_one_is_not():
    one = {"E_1": 2.0, "nu_1": 0.3}
    for assumption in ("plane stress", "plane strain"):
        same = partial_slip.dundurs_beta(**one, E_2=2.0, nu_2=0.3, assumption=assumption)
        assert float(same) == 0
    rigid = partial_slip.dundurs_beta(**one, E_2=np.inf, nu_2=0.0, assumption="plane strain")
    assert float(rigid) == pytest.approx(-0.4 / (2 * 0.7))  # -(1 - 2 nu)/(2 (1 - nu))
    swapped = partial_slip.dundurs_beta(
        E_1=np.inf, nu_1=0.0, E_2=2.0, nu_2=0.3, assumption="plane strain"
    )
    assert float(swapped) == -float(rigid)


CYCLE_LOAD = {"Q_max": 0.6, "P": 2.0, "mu": 0.4, "a": 0.5}  # k = 0.75
NO_WIDTH = {"Q_max": 0.6, "P": 2.0, "mu": 0.4, "E_star": E_STAR}


def test_the_cycle_closes_and_starts_where_the_first_loading_ends():
    x = np.linspace(-0.5, 0.5, 11)
    first = partial_slip.traction(x, Q=0.6, P=2.0, mu=0.4, a=0.5)
    end = partial_slip.slip(x, Q=0.6, P=2.0, mu=0.4, a=0.5, E_star=E_STAR)
    for branch in ("unloading", "reloading"):
        for sign in (1, -1):
            at = {"Q": sign * 0.6, **CYCLE_LOAD, "branch": branch}
            q = tangential_cycle.traction(x, **at)
            np.testing.assert_allclose(q, sign * first, atol=1e-14)
            slip = tangential_cycle.slip(x, **at, E_star=E_STAR)
            np.testing.assert_allclose(slip, sign * end, atol=1e-15)


def test_dissipation_is_the_area_of_the_loop():
    def width(Q):
        down, up = (
            float(tangential_cycle.rigid_displacement_beyond_stick(Q=Q, **NO_WIDTH, branch=b))
            for b in ("unloading", "reloading")
        )
        return down - up

    area, _ = quad(width, -0.6, 0.6, epsabs=1e-14)
    assert float(tangential_cycle.dissipation(**NO_WIDTH)) == pytest.approx(area, rel=1e-9)
