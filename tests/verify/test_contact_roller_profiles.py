"""Crowns and tilts are written twice: for the formulas and for the reference. They agree."""

import numpy as np
import pytest

from analytic.contact import crown
from verify.cases.contact.roller import profiles
from verify.cases.contact.roller.inputs import DESIGNS, Crown, Roller, Tilt

SAME = 1e-12  # of the drop, and as much of A, in which logarithms near 1 are rounded
RNG = np.random.default_rng(11)
DRAWN = tuple(zip(RNG.uniform(0.1, 10, 20), RNG.uniform(0.05, 1, 20), RNG.uniform(1e-7, 5e-5, 20),
                  strict=True))  # fmt: skip


def along(q, count=4001):
    return np.linspace(-q.L / 2, q.L / 2, count)


def scale(q, load):
    return load / (np.pi * q.L * q.E_star)


def same(one, other, A):
    return np.all(np.abs(one - other) <= SAME * (np.abs(one) + A))


@pytest.mark.parametrize("load", [1.0, 3407.0])
@pytest.mark.parametrize("design", [*DESIGNS, *DRAWN, (1, 1, 1e-3)], ids=str)
def test_both_writings_of_eq_1_agree(design, load):
    K_1, K_2, z_m = design
    q = Crown(K_1=K_1, K_2=K_2, z_m=min(z_m, 500 * K_1 * scale(Crown(), load)),
                      Q=load)  # fmt: skip
    y = along(q)
    A = K_1 * scale(q, load)
    # at the very end z_m alone is left of the reference's argument of the logarithm
    inner = np.abs(y) < 0.999 * q.L / 2 if q.z_m > 15 * A else np.full(y.shape, True)
    assert same(profiles.gap(q)(y)[inner], q.gap(y)[inner], A)
    assert same(profiles.logarithmic(q, (K_1, K_2, q.z_m), load)(y)[inner], q.gap(y)[inner], A)


def test_both_writings_of_lundberg_s_crown_agree():
    q = Roller()
    y = along(q)[1:-1]
    written = crown.lundberg(y, load=q.F, length=q.L, E_star=q.E_star)
    assert same(profiles.lundberg(q)(y), written, scale(q, q.F))


@pytest.mark.parametrize("load", [1.0, 3407.0, 30e3])
def test_johns_and_gohar_s_constant_is_the_one_that_they_print(load):
    q = Roller(F=load)
    y, A = along(q), scale(q, load)
    written = crown.johns_gohar(y, load=load, length=q.L, half_width=q.b, E_star=q.E_star)
    apart = np.abs(profiles.johns_gohar(q)(y) - written)
    assert abs(crown.END - 0.3033) <= 5e-5
    assert apart.max() <= 5e-5 / 0.3033 * A  # at the end the logarithm of the constant is left
    assert same(profiles.johns_gohar(q)(y)[y == 0], written[y == 0], A)


@pytest.mark.parametrize("theta", [0.0, 5e-4, np.pi / 180])
def test_both_writings_of_the_tilt_agree_as_small_angles_do(theta):
    q = Tilt(theta=theta)
    y = along(q)
    lean = Crown.gap(q, y) - q.gap(y)
    other = profiles.logarithmic(q, (q.K_1, q.K_2, q.z_m), q.Q)(y) - profiles.gap(q)(y)
    assert np.abs(other - lean).max() <= theta**3 / 2 * q.L / 2 + SAME * 1e-3
    assert np.all(np.diff(lean) >= 0)
    assert lean[0] == -lean[-1] == pytest.approx(-theta * q.L / 2, abs=1e-15)


def test_a_roller_without_crown_has_no_gap():
    q = Roller()
    assert not profiles.gap(q)(along(q)).any()
    assert not q.gap(along(q)).any()
