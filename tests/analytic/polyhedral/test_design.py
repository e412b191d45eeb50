"""Design values of the clutch: balance, remarks, torque and pressure as inverse functions."""

from dataclasses import replace
from math import atan, radians, tan

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from analytic.contact import hertz_line
from analytic.polyhedral import forces, torque
from analytic.polyhedral.design import PolyhedralClutch
from analytic.polyhedral.parts import PolyhedralParts

PARTS = PolyhedralParts(z=6, d_i=0.072, d_e=0.08, D_i=0.10006, d=0.01, b=0.03, e=0.009)
LOADS = {"p_t": 30e6, "E": 210e9, "nu": 0.3, "mu": 0.08, "phi_1": atan(0.05)}


@pytest.mark.parametrize("lever", ["exact", "d_i/2"])
@pytest.mark.parametrize("gamma", ["normal", "radius"])
@pytest.mark.parametrize("alpha", [None, radians(6.0)])
def test_the_normal_force_carries_the_torque_that_it_came_from(lever, gamma, alpha):
    clutch = PolyhedralClutch(
        PARTS, **LOADS, K=1.3, alpha=alpha, lever=lever, gamma=gamma, M_wanted=150.0
    )
    grip = 0.08 if alpha is None else tan(radians(3.0))
    assert clutch.grip * clutch.N * 6 * PARTS.D_i / 2 == pytest.approx(clutch.M_t, rel=1e-12)
    assert clutch.grip == grip
    assert 6 * clutch.T * clutch.arm == pytest.approx(clutch.M_t, rel=1e-12)  # on the hub's lever
    by_pressure = (1 - clutch.hub_share) * clutch.N
    assert by_pressure == pytest.approx(clutch.F, rel=1e-12)
    assert clutch.sigma_tr == pytest.approx(1.3 * clutch.sigma_t, rel=1e-12)
    assert clutch.p_1r + clutch.p_2 == pytest.approx(30e6, rel=1e-15)
    assert clutch.remarks == ()
    reached = replace(clutch, p_t=clutch.p_required)
    assert (reached.M_t, reached.margin) == pytest.approx((150.0, 1.0))


def test_rollers_without_contact_carry_nothing_and_the_clutch_reports_it():
    clutch = PolyhedralClutch(PARTS, **LOADS | {"p_t": 18e6}, M_wanted=100.0)
    assert (clutch.p_2, clutch.M_t, clutch.N, clutch.p_0_ring, clutch.margin) == (0, 0, 0, 0, 0)
    assert "p_t=1.8e+07 Pa is not above p_1r=1.84211e+07 Pa, no torque" in clutch.remarks[0]
    assert replace(clutch, p_t=clutch.p_required).M_t == pytest.approx(100.0)


CHAIN = {"p_1r": 18e6, "mu": 0.08, "z": 6, "D_i": 0.10006, "d_i": 0.072, "b": 0.03}


@settings(deadline=None)
@given(
    share=st.floats(-1, 0.99), over=st.floats(1e-3, 1e3), mu=st.floats(0.01, 0.9),
    z=st.integers(3, 48), p_1r=st.floats(0, 1e9),
)  # fmt: skip
def test_the_pressure_for_the_torque_of_a_pressure_is_that_pressure(share, over, mu, z, p_1r):
    chain = CHAIN | {"mu": mu, "z": z, "p_1r": p_1r, "share": share}
    p_t = p_1r + over * 1e6
    M_t = torque.torque(p_t=p_t, **chain)
    assert float(torque.required_pressure(M_t=M_t, **chain)) == pytest.approx(p_t, rel=1e-9)


ALL = np.arange(3, 49)


def test_a_fillet_moves_the_flats_out_while_its_corners_stay():
    """By the unfilleted corner and the fillet's centre, as the bore is drawn."""
    half, rho, d_i = np.pi / ALL, 5e-3, 0.072
    R_u = d_i / 2 + rho * (1 / np.cos(half) - 1)
    centre = R_u - rho / np.cos(half)
    np.testing.assert_allclose(centre + rho, d_i / 2)  # the real corner
    a = forces.apothem(d_i=d_i, z=ALL, rho=rho)
    np.testing.assert_allclose(a, R_u * np.cos(half), rtol=1e-14)
    np.testing.assert_allclose(centre * np.cos(half) + rho, a, rtol=1e-14)  # the arc meets the flat
    flat = forces.half_flat(d_i=d_i, z=ALL, rho=rho)
    np.testing.assert_allclose(flat, R_u * np.sin(half) - rho * np.tan(half), rtol=1e-12)
    np.testing.assert_allclose(centre * np.sin(half), flat, rtol=1e-12)


def test_rollers_press_the_ring_harder_than_the_race():
    """Hertz on two steel cylinders of lengths b; the race is hollow."""
    clutch = PolyhedralClutch(PARTS, **LOADS)
    for R, p_0 in ((1 / (2 / 0.01 + 2 / 0.08), clutch.p_0_ring),
                   (1 / (2 / 0.01 - 2 / 0.10006), clutch.p_0_race)):  # fmt: skip
        a = hertz_line.half_width(P=clutch.N / 0.03, R=R, E_star=210e9 / (2 * 0.91))
        assert p_0 == pytest.approx(2 * clutch.N / 0.03 / (np.pi * float(a)), rel=1e-12)
    assert clutch.p_0_ring > clutch.p_0_race
