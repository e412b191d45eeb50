"""Errata of the printed Eqs. 2 to 11, with numbers for 24 sprags."""

import math

import numpy as np
import pytest

from analytic.rotor import clutch_printed as printed
from analytic.rotor import clutch_uniform as uniform
from analytic.rotor.clutch import SpragCoupling, even_angles
from analytic.rotor.clutch_state import under_torque

T, Z = 15.0, 24
ONE = SpragCoupling(psi=even_angles(Z=Z), R_i=40e-3, nu=math.radians(4), L=10e-3, k_n=6e8, n_s=9)
AT = under_torque(ONE, T=T)
N = float(uniform.normal_force(T=T, Z=Z, d_t=ONE.d_t))
DELTA = float(uniform.approach(N=N, k_n=ONE.k_n))
K_T = float(uniform.contact_stiffness(N=N, k_n=ONE.k_n))


def printed_deformation(q):
    """Eq. 8 as printed: one angle for displacement and tilt, no preload, no cut."""
    dx, dy, gx, gy, gz = q
    delta_r, theta = math.hypot(dx, dy), math.hypot(gx, gy)
    c = np.cos(ONE.psi)[:, None]
    return delta_r * c + ONE.d_t * gz - theta * np.outer(np.cos(ONE.psi), ONE.x)


def test_eq_9_with_one_angle_gives_no_stiffness_and_a_force_at_rest():
    right = ONE.stiffness(AT)[0, 0]
    assert right == pytest.approx(Z / 2 * K_T, rel=1e-12)
    assert abs(printed.radial_stiffness(ONE, AT)) < 1e-12 * right
    assert printed.radial_force(ONE, AT) == pytest.approx(Z * N, rel=1e-12)
    assert abs(ONE.loads(AT)[0]) < 1e-12 * Z * N
    # the same by differences of the printed force
    h = np.array([1e-3 * DELTA, 0, 0, 0, 0])
    change = printed.radial_force(ONE, AT + h) - printed.radial_force(ONE, AT - h)
    assert abs(change / (2 * h[0])) < 1e-9 * right


def test_eq_8_without_the_preload_is_negative_for_half_the_sprags_and_leaves_no_stiffness():
    delta = printed_deformation([1e-6, 0, 0, 0, 0])
    assert (delta < -1e-12).any(axis=1).sum() == 11  # two of 24 stand across, at zero
    assert not ONE.stiffness(np.zeros(5)).any()
    assert ONE.stiffness(AT)[0, 0] > 0


def test_eq_2_with_the_tangent_for_the_constant_counts_the_nonlinearity_twice():
    # k_t delta^n over k_n delta^n is n delta^(n-1): no number, it changes with the unit of length
    twice = K_T * DELTA ** (10 / 9)
    assert twice / N == pytest.approx(10 / 9 * DELTA ** (1 / 9), rel=1e-12)
    in_mm = K_T / 1e3 * (DELTA * 1e3) ** (10 / 9)
    assert in_mm / twice == pytest.approx(1000 ** (1 / 9), rel=1e-12)


def test_eq_8_with_one_angle_cannot_tell_the_plane_of_a_tilt():
    # a displacement along x and a rotation about x: cosine for one, sine for the other
    q = np.array([1e-6, 0, 1e-4, 0, 0.02])
    right = (
        ONE.d_t * 0.02 + 1e-6 * np.cos(ONE.psi)[:, None] - 1e-4 * np.outer(np.sin(ONE.psi), ONE.x)
    )
    assert ONE.deformation(q) == pytest.approx(right, rel=1e-13)
    assert np.abs(printed_deformation(q) - right).max() > 0.5e-6
    # with both in one plane, the printed form serves, its theta counted against Eq. 1's gy
    together = np.array([1e-6, 0, 0, 1e-4, 0.02])
    assert printed_deformation(together)[:, ::-1] == pytest.approx(ONE.deformation(together))


def test_a_torque_with_twice_the_lever_makes_k_asymmetric():
    gap = SpragCoupling(psi=even_angles(Z=Z, missing=(0,)), R_i=40e-3, nu=math.radians(4), L=10e-3,
                 k_n=6e8)  # fmt: skip
    at = under_torque(gap, T=T)
    K = printed.stiffness_with_lever(gap, at, lever=2 * gap.d_t)
    assert K[4, 0] / K[0, 4] == pytest.approx(2, rel=1e-12)
    right = gap.stiffness(at)
    assert right[4, 0] == pytest.approx(right[0, 4], rel=1e-13)


def test_eq_10_with_whole_displacements_overstates_the_load_by_n():
    assert (ONE.stiffness(AT) @ AT)[4] / T == pytest.approx(10 / 9, rel=1e-12)
    assert uniform.secant_over_tangent() == pytest.approx(0.9, rel=1e-15)
    # increments obey it
    step = 1e-6 * AT
    grown = ONE.loads(AT + step)[4] - T
    assert (ONE.stiffness(AT) @ step)[4] == pytest.approx(grown, rel=1e-6)


def test_a_uniform_preload_couples_nothing_with_or_without_a_crown():
    crowned = SpragCoupling(psi=ONE.psi, R_i=ONE.R_i, nu=ONE.nu, L=ONE.L, k_n=ONE.k_n, n_s=9,
                     crown=lambda x: 1e-6 * (x / 5e-3) ** 2)  # fmt: skip
    size = np.array([1, 1, ONE.L, ONE.L, ONE.R_i])
    for one in (ONE, crowned):
        K = one.stiffness(under_torque(one, T=T)) / np.outer(size, size)
        assert np.abs(K - np.diag(K.diagonal())).max() < 1e-12 * K[0, 0]
