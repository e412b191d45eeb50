"""Blocking pressures and the growth of the outside, by statics and Lamé's ring."""

import math

import pytest

from analytic.bounds.polyhedral import thin_ring
from analytic.ring import lame
from verify.cases.polyhedral.clutch.case import PolyhedralClutch
from verify.cases.polyhedral.locking.case import LockedPolyhedralRing
from verify.cases.polyhedral.pressure.case import RingPressure


def test_the_blocking_pressure_of_eq_17_follows_from_the_balance_of_a_flat():
    q = PolyhedralClutch(e=7e-3)
    N = q.M_t / (q.z * q.mu * q.D_i / 2)  # of a roller
    turn = math.atan2(q.e, q.apothem) + q.phi_1
    hub = q.M_t / q.z / (math.hypot(q.e, q.apothem) * math.sin(turn))
    chord = q.d_i * math.sin(math.pi / q.z)
    assert q.p_17 == pytest.approx((N - hub * math.cos(q.phi_1)) / (q.b * chord), rel=1e-9)
    arc = math.pi * q.d_i / q.z
    assert q.p_17_arc == pytest.approx(q.p_17 * chord / arc, rel=1e-9)
    assert q.p_block > 2 * q.p_17  # the ring's hoop force carries the rest


def test_a_long_ring_needs_more_pressure_to_reach_its_rollers_by_poisson_s_ratio():
    q = LockedPolyhedralRing()
    assert q.touch_long == pytest.approx(q.p_1r / (1 - q.nu**2), rel=1e-9)


@pytest.mark.parametrize("wall", [1e-3, 4e-3, 12e-3])
def test_the_outside_grows_less_than_eq_8_by_the_mean_hoop_stress(wall):
    q = RingPressure(delta_1=wall)
    p = 2 * q.delta_1 * q.sigma_t / q.d_i  # hoop force of a wall over the bore
    outside = 2 * float(lame.radial_displacement(
        q.d_e / 2, r_i=q.d_i / 2, r_o=q.d_e / 2, p_i=p, E=q.E, nu=q.nu, ends="plane stress"
    ))  # fmt: skip
    low, high = thin_ring.outside_growth_error(d_e=q.d_e, wall=q.delta_1)
    assert low < q.growth / outside - 1 < high
    assert q.growth > outside
