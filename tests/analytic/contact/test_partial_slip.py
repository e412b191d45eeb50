"""Partial slip against its balance, the half plane's integral and the rule of friction."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.contact import partial_slip

LOAD = {"Q": 0.3, "P": 2.0, "mu": 0.4, "a": 0.5}  # k = 0.375
E_STAR = 7.0


def q(x, **change):
    return float(partial_slip.traction(x, **LOAD | change))


def c_of(**change):
    return float(partial_slip.stick_half_width(**LOAD | change))


def total(function):
    """Integral over the contact, by arcs x = w sin(t) that take the roots at c and a out."""
    c, a = c_of(), LOAD["a"]

    def arc(t, low, high):
        x = (low + high) / 2 + (high - low) / 2 * np.sin(t)
        return function(x) * (high - low) / 2 * np.cos(t)

    pieces = [(-a, -c), (-c, c), (c, a)]
    return sum(quad(arc, -np.pi / 2, np.pi / 2, args=p, epsabs=1e-13)[0] for p in pieces)


def test_the_traction_carries_the_tangential_force():
    assert total(q) == pytest.approx(LOAD["Q"], rel=1e-10)


def test_friction_is_used_up_where_it_slips_and_nowhere_else():
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


@pytest.mark.parametrize("share", [0.0, 0.5, 0.9, 0.97])
def test_slip_is_what_the_traction_does_not_carry_along(share):
    """By the half plane's logarithm alone: zero where it sticks, the closed form where it slips."""
    x = share * LOAD["a"]
    lag = middle_displacement(0.0) - middle_displacement(x)
    slip = float(partial_slip.slip(x, **LOAD, E_star=E_STAR))
    assert slip == pytest.approx(lag, abs=1e-9)
    assert (slip > 0) == (x > c_of())


def test_slip_is_even():
    left, right = partial_slip.slip([-0.48, 0.48], **LOAD, E_star=E_STAR)
    assert left == right > 0


def test_displacement_beyond_stick_is_that_of_the_traction_less_that_of_a_bonded_contact():
    """The bonded traction Q/(pi sqrt(a² - x²)) shifts the middle by -2Q/(pi E*) ln(a/2)."""
    bonded = -2 * LOAD["Q"] / (np.pi * E_STAR) * np.log(LOAD["a"] / 2)
    load = {"Q": 0.3, "P": 2.0, "mu": 0.4, "E_star": E_STAR}
    beyond = float(partial_slip.rigid_displacement_beyond_stick(**load))
    assert beyond == pytest.approx(middle_displacement(0.0) - bonded, rel=1e-8)


@pytest.mark.parametrize("k", [0.05, 0.5, 0.999])
def test_displacement_beyond_stick_has_the_closed_form_of_its_docstring(k):
    beyond = partial_slip.rigid_displacement_beyond_stick(Q=k, P=1.0, mu=1.0, E_star=1 / np.pi)
    assert float(beyond) == pytest.approx(k + (1 - k) * np.log1p(-k), rel=1e-11)


def test_with_little_force_hardly_anything_slips():
    """Beyond stick k²/2 + k³/6, an edge strip of a k/2."""
    load = {"P": 1.0, "mu": 1.0}
    beyond = partial_slip.rigid_displacement_beyond_stick(Q=1e-9, **load, E_star=1 / np.pi)
    assert float(beyond) == pytest.approx(5e-19, rel=1e-8)
    assert 1 - float(partial_slip.stick_half_width(Q=1e-6, **load, a=1.0)) == pytest.approx(
        5e-7, rel=1e-5
    )


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


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"Q": 0.8}, "the contact slides: Q must be below mu P = 0.8 N/m, got 0.8 N/m"),
        ({"Q": -0.1}, "tangential force"),
        ({"Q": np.nan}, "tangential force"),
        ({"P": 0.0}, "load per length"),
        ({"mu": 0.0}, "coefficient of friction must be positive and finite, got 0.0$"),
        ({"a": np.inf}, "half-width"),
    ],
)
def test_input_that_makes_no_sense_is_refused(change, message):
    with pytest.raises(ValueError, match=message):
        partial_slip.traction(0.0, **LOAD | change)


def test_slip_beyond_the_contact_has_no_answer():
    with pytest.raises(ValueError, match=r"slip is known in the contact, \|x\| <= 0.5 m"):
        partial_slip.slip(0.6, **LOAD, E_star=E_STAR)
