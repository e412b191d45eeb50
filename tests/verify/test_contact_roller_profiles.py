"""Crowns and tilts are written twice: the reference takes the gap that the inputs say."""

import numpy as np
import pytest

from verify.cases.contact.roller import profiles
from verify.cases.contact.roller.inputs import Crown, Design, Roller, Tilt

SAME = 1e-12  # of the drop, and as much of A, in which logarithms near 1 are rounded


def along(q, count=4001):
    return np.linspace(-q.L / 2, q.L / 2, count)


def test_the_reference_s_crown_is_that_of_the_inputs():
    q = Crown()
    A = q.K_1 * q.Q / (np.pi * q.L * q.E_star)
    y = along(q)
    assert np.abs(profiles.gap(q)(y) - q.gap(y)).max() <= 1e-9 * A
    again = profiles.gap(Roller(F=q.Q), Design(q.K_1, q.K_2, q.z_m))(y)
    assert np.abs(again - q.gap(y)).max() <= 1e-9 * A


def test_crowns_of_an_even_pressure_are_made_for_the_load():
    q, more = Roller(), Roller(F=2 * 3407.0)
    y = along(q)[1:-1]
    one, other = profiles.even_crowns(q), profiles.even_crowns(more)
    assert other["Lundberg"](y) == pytest.approx(2 * one["Lundberg"](y), rel=1e-12)
    low, high = (crowns["Johns"](np.array([q.L / 2]))[0] for crowns in (one, other))
    assert 1.5 < high / low < 2  # the wider contact needs less of a drop at its end


@pytest.mark.parametrize("theta", [0.0, 5e-4, np.pi / 180])
def test_both_writings_of_the_tilt_agree_as_small_angles_do(theta):
    q = Tilt(theta=theta)
    y = along(q)
    lean = Crown.gap(q, y) - q.gap(y)
    design = Design(q.K_1, q.K_2, q.z_m)
    other = profiles.gap(Roller(F=q.Q), design)(y) - profiles.gap(q)(y)
    assert np.abs(other - lean).max() <= theta**3 / 2 * q.L / 2 + SAME * 1e-3
    assert np.all(np.diff(lean) >= 0)
    assert lean[0] == -lean[-1] == pytest.approx(-theta * q.L / 2, abs=1e-15)


def test_a_roller_without_crown_has_no_gap():
    q = Roller()
    assert not profiles.gap(q)(along(q)).any()
    assert not q.gap(along(q)).any()
