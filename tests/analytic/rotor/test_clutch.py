"""The clutch as a spring in five directions: Eqs. 2 to 11, closed forms, range of validity."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from analytic.contact import crown as profiles
from analytic.rotor import clutch_uniform as uniform
from analytic.rotor.clutch import SpragCoupling, even_angles, slice_middles, with_axial
from analytic.rotor.clutch_inclined import coupling_across, inclined_stiffness
from analytic.rotor.clutch_state import preload_twist, under_loads, under_torque
from analytic.rotor.inertia import cylinder_inertia, tubes_inertia

fixed = settings(deadline=None, derandomize=True, max_examples=25)

# about those of Huang 2018 with Palmgren's yield of both contacts
SPRAG = {"R_i": 11.11e-3, "nu": math.radians(3.15), "L": 9e-3, "k_n": 5.7e8}
T = 15.0


def clutch(Z=12, *, missing=(), psi_0=0.0, **more):
    return SpragCoupling(
        psi=even_angles(Z=Z, psi_0=psi_0, missing=missing), **SPRAG | {"n_s": 11} | more
    )


def uneven(**more):
    """Crowned, one sprag missing, one pressed more: nothing about it is symmetric."""
    tight = np.zeros(11)
    tight[4] = 1e-6
    return clutch(missing=(0,), psi_0=0.2, crown=lambda x: 2e-6 * (2 * x / 9e-3) ** 2,
                  interference=tight, **more)  # fmt: skip


def size_of(one):
    return np.array([1.0, 1.0, one.L, one.L, one.d_t])


def test_eq_3_a_radial_displacement_counts_with_the_cosine_of_its_angle_to_the_sprag():
    delta_r, direction = 2e-6, 0.7
    q = np.array([delta_r * math.cos(direction), delta_r * math.sin(direction), 0, 0, 0])
    one = clutch(n_s=1)
    expected = delta_r * np.cos(one.psi - direction)
    assert one.deformation(q)[:, 0] == pytest.approx(expected, abs=1e-20)


def test_eq_4_a_twist_presses_all_sprags_by_d_t_of_it():
    one = clutch()
    # 11.11 mm tan 3.15 deg = 11.11 * 0.0550333 by a pocket calculator
    assert one.d_t == pytest.approx(0.61142e-3, rel=1e-5)
    assert one.deformation([0, 0, 0, 0, 0.01]) == pytest.approx(0.01 * one.d_t, rel=1e-14)


def test_eq_5_slices_have_their_middles_a_slice_apart_from_one_end_to_the_other():
    x = slice_middles(L=9.0, n_s=6)
    assert x.tolist() == pytest.approx([3.75, 2.25, 0.75, -0.75, -2.25, -3.75], rel=1e-15)


def test_eq_6_a_crown_takes_twice_its_drop():
    one = clutch(crown=lambda x: 1e-6 * np.abs(x) / 4.5e-3)
    lost = one.deformation(np.zeros(5))[3]
    assert lost == pytest.approx(-2e-6 * np.abs(one.x) / 4.5e-3, rel=1e-14)


def test_eq_6_takes_the_logarithmic_crown_of_the_paper_s_ref_9():
    def crown(x):
        return profiles.lundberg(x, load=2000.0, length=9.2e-3, E_star=113e9)

    one = clutch(crown=crown)
    assert one.deformation(np.zeros(5))[0] == pytest.approx(-2 * crown(one.x), rel=1e-14)
    K, plain = (c.stiffness(under_torque(c, T=T)) for c in (one, clutch()))
    assert K[2, 2] < plain[2, 2]  # a crown takes load from the ends


def test_eq_7_a_tilt_presses_slices_by_their_height_and_the_cosine_from_its_plane():
    theta, direction = 1e-4, 0.4  # the plane that holds the axis and the tilt
    q = np.array([0, 0, -theta * math.sin(direction), theta * math.cos(direction), 0])
    one = clutch()
    expected = np.outer(np.cos(one.psi - direction), theta * one.x)
    assert one.deformation(q) == pytest.approx(expected, abs=1e-20)


def test_eq_8_sums_the_parts():
    one = uneven()
    parts = [np.array(q) for q in np.diag([1e-6, 2e-6, 1e-4, -2e-4, 0.02])]
    at_rest = one.deformation(np.zeros(5))
    total = at_rest + sum(one.deformation(q) - at_rest for q in parts)
    assert one.deformation(sum(parts)) == pytest.approx(total, abs=1e-18)


def test_eq_2_a_slice_bears_its_share_of_the_power_of_its_deformation_and_nothing_in_a_gap():
    one = clutch(n_s=4)
    q = [0.0, 0.0, 0.0, 0.0, 10e-6 / one.d_t]
    # (1e-5 m)^(10/9) = 10^(-50/9)
    assert one.forces(q).sum(-1) == pytest.approx(5.7e8 * 10 ** (-50 / 9), rel=1e-12)
    assert not one.forces([0, 0, 0, 0, -0.01]).any()
    assert not one.slopes([0, 0, 0, 0, -0.01]).any()


displaced = st.tuples(
    st.floats(-8e-6, 8e-6), st.floats(-8e-6, 8e-6), st.floats(-1e-3, 1e-3), st.floats(-1e-3, 1e-3)
)


@fixed
@given(displaced)
def test_eq_9_loads_are_the_slopes_of_the_potential(offset):
    one = uneven()
    q = under_torque(one, T=T, offset=offset)
    size = size_of(one)
    h = np.diag(3e-9 / size)
    found = (one.energy(q + h) - one.energy(q - h)) / (2 * h.diagonal())
    assert found / size == pytest.approx(one.loads(q) / size, abs=2e-6 * T / one.d_t)


@fixed
@given(displaced)
def test_eq_11_the_tangent_is_that_of_the_loads_and_symmetric(offset):
    one = uneven(n=2.0, k_n=1e13)  # smooth where slices open, so that differences say 1e-8
    q, size = under_torque(one, T=T, offset=offset), size_of(one)
    h = np.diag(1e-9 / size)
    found = (one.loads(q + h) - one.loads(q - h)) / (2 * h.diagonal()[:, None])
    K = one.stiffness(q)
    scaled = np.abs(found - K) / np.outer(size, size)
    assert scaled.max() < 2e-8 * K[0, 0]
    assert np.abs((K - K.T) / np.outer(size, size)).max() < 1e-14 * K[0, 0]
    assert (np.linalg.eigvalsh(K / np.outer(size, size)) > 0).all()


def test_eq_11_the_axial_row_and_column_are_zero():
    K = uneven().stiffness(under_torque(uneven(), T=T))
    six = with_axial(K)
    assert not six[2].any()
    assert not six[:, 2].any()
    assert six[np.ix_([0, 1, 3, 4, 5], [0, 1, 3, 4, 5])] == pytest.approx(K)


@pytest.mark.parametrize("Z", [3, 5, 12, 24])
def test_a_uniform_clutch_is_isotropic_and_that_of_the_closed_forms(Z):
    one = clutch(Z, psi_0=0.3)
    q = under_torque(one, T=T)
    N = uniform.normal_force(T=T, Z=Z, d_t=one.d_t)
    delta_0 = uniform.approach(N=N, k_n=one.k_n)
    k = uniform.contact_stiffness(N=N, k_n=one.k_n)
    assert q[4] == pytest.approx(float(delta_0) / one.d_t, rel=1e-12)
    radial = uniform.radial_stiffness(Z=Z, k=k)
    tilting = uniform.tilting_stiffness(Z=Z, k=k, L=one.L, n_s=11)
    torsional = uniform.torsional_stiffness(Z=Z, k=k, d_t=one.d_t)
    K, size = one.stiffness(q), size_of(one)
    expected = np.diag([radial, radial, tilting, tilting, torsional])
    assert np.abs((K - expected) / np.outer(size, size)).max() < 1e-12 * radial


@fixed
@given(
    st.floats(-2, 3).map(lambda p: 10.0**p),
    st.tuples(*[st.floats(-100e-6, 100e-6)] * 2, *[st.floats(-5e-3, 5e-3)] * 2),
    st.floats(0, 20e-6),
)
def test_the_torque_is_met_at_any_offset_with_any_crown(T, offset, drop):
    one = clutch(n_s=7, missing=(2, 3), crown=lambda x: drop * (x / 4.5e-3) ** 2)
    q = under_torque(one, T=T, offset=offset)
    assert one.loads(q)[4] == pytest.approx(T, rel=1e-9)
    assert tuple(q[:4]) == offset


def test_loads_of_a_known_place_lead_back_to_it():
    one = clutch(n_s=7, missing=(1,), crown=lambda x: 1e-6 * (x / 4.5e-3) ** 2)
    q = np.array([3e-6, -2e-6, 2e-4, 3e-4, 0.021])
    found = under_loads(one, one.loads(q))
    assert found == pytest.approx(q, rel=1e-8)


def test_no_equilibrium_is_refused_not_returned():
    # sprags push outwards with N in all, T = Z N d_t: no radial load can be larger than all of N
    most = 15.0 / clutch(n_s=7).d_t
    with pytest.raises(ArithmeticError, match="no equilibrium under F"):
        under_loads(clutch(n_s=7), np.array([1.1 * most, 0, 0, 0, 15.0]))


def test_a_gap_all_around_is_twisted_away_first():
    one = clutch(n_s=7, interference=-50e-6)
    g = preload_twist(one, T=15.0)
    assert g == pytest.approx(preload_twist(clutch(n_s=7), T=15.0) + 50e-6 / one.d_t, rel=1e-12)


def test_the_twists_of_several_torques_are_those_of_each_alone():
    one, torques = clutch(n_s=7), np.array([5.0, 15.0, 40.0])
    alone = [float(preload_twist(one, T=T)) for T in torques]
    assert preload_twist(one, T=torques) == pytest.approx(alone, rel=1e-12)


def test_two_missing_sprags_couple_x_and_y_as_the_sum_over_the_others():
    """Sum of k e e^T with the directions e = (cos - tan nu sin, sin + tan nu cos) of the struts."""
    left = clutch(missing=(1, 11))
    q = under_torque(left, T=T)
    k, tan = float(left.slopes(q).sum(-1)[0]), math.tan(left.nu)
    x, y = (np.cos(left.psi - s * math.pi / 2) for s in (0, 1))
    summed = k * ((x - tan * y) * (y + tan * x)).sum()
    gone = np.array([-1, 1]) * 2 * math.pi / 12
    assert coupling_across(gone, k=k, nu=left.nu) == pytest.approx(summed, rel=1e-10)
    assert inclined_stiffness(left, T=T)[0, 1] == pytest.approx(summed, rel=1e-9)


def test_the_inertia_of_a_tube_is_that_of_the_textbook():
    shape = {"d_o": 0.06, "d_i": 0.02, "rho": 7850.0}
    found = cylinder_inertia(**shape, width=0.05)
    ends = tubes_inertia(end=np.array([0.025]), length=np.array([0.05]),
                         d_o=np.array([0.06]), d_i=np.array([0.02]), rho=7850.0)  # fmt: skip
    assert found == pytest.approx(tuple(ends), rel=1e-12)
    m, _, across = found  # m (3 (r_o^2 + r_i^2) + w^2)/12
    assert across == pytest.approx(m * (3 * (0.03**2 + 0.01**2) + 0.05**2) / 12, rel=1e-12)
