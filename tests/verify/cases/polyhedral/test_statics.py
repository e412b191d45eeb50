"""Finite elements of locked rings and wedged rollers are in balance, on coarse meshes."""

import math

import numpy as np
import pytest

from fem.contact.wedged import Geometry, Wedge
from verify.cases.polyhedral.locking.case import LockedPolyhedralRing
from verify.cases.polyhedral.locking.fem import locked_fem
from verify.cases.polyhedral.wedge.case import WedgedRoller
from verify.cases.polyhedral.wedge.mesh import fem_mesh


def wedge(q, *, mu=None, caged=False):
    geometry = Geometry(q.R, q.half, q.a)
    return Wedge(geometry, fem_mesh(geometry, 6), E=q.E, nu=q.nu, mu=mu or q.mu, caged=caged)


def test_forces_on_half_a_sector_are_in_balance_with_the_ring_s_hoop_force_alone():
    q = LockedPolyhedralRing()
    hub = (2e5, 1e4)
    ring = locked_fem(q, 1, d=q.d, e=q.e, p=q.p_t, hub=hub)
    rest_x, rest_y, hoop = ring.balance(q.p_t, hub)
    side = q.p_t * q.d_i * np.sin(q.half_angle)
    assert max(abs(rest_x), abs(rest_y)) < 1e-8 * side
    assert abs(hoop) > 0.1 * side  # what Eq. 16 leaves out


@pytest.mark.parametrize(("alpha", "mu"), [(6, 0.5), (25, 0.3)])
def test_friction_on_a_free_roller_is_that_of_two_forces_in_balance(alpha, mu):
    q = WedgedRoller(alpha=math.radians(alpha), mu=mu)
    free = wedge(q)
    state, _ = free.pressed(q.line_load)
    N, T = free.forces(state)
    assert q.line_load == pytest.approx(N, rel=1e-11)
    assert math.tan(q.half) == pytest.approx(T / N, rel=1e-8)


def test_the_roller_leaves_to_the_wide_end_where_friction_is_too_low():
    q = WedgedRoller()
    _, down = wedge(q).pressed(q.line_load)
    slippery = wedge(q, mu=0.5 * math.tan(q.half))
    gone = slippery.at(down)
    assert slippery.forces(gone)[0] < 1e-6 * q.line_load
    x, _ = gone.plane.displacement_at((0.0, 0.0))
    assert x < -0.5 * down / math.tan(q.half)
