"""One pitch of a freewheel by finite elements: at rest, under axial load, and released."""

import math

import numpy as np
import pytest

from fem.wedge import pulled as model
from fem.wedge.flat import Sector
from fem.wedge.held import Held
from fem.wedge.pulled import Borne
from fem.wedge.slip_limit import Limit
from verify.cases.freewheel.cup.case import FreewheelCup
from verify.cases.freewheel.fem import overlapping
from verify.cases.freewheel.friction.case import FRICTION, FreewheelFriction
from verify.cases.freewheel.paths import reference as paths
from verify.cases.freewheel.paths.case import LoadPaths
from verify.cases.freewheel.pulled_sector import one_pulled
from verify.cases.freewheel.torque.case import FreewheelTorque

STAR, CUP, PULLED = FreewheelTorque(), FreewheelCup(), FreewheelFriction()
ONE = one_pulled(PULLED)
GIVEN = {  # approaches, half-widths [m], and cells
    "star": (STAR, (8e-6, 17e-6), (95e-6, 103e-6), 3),
    "cup": (CUP, (10e-6, 17e-6), (83e-6, 91e-6), 4),
}


def sector(kind):
    q, approaches, widths, cells = GIVEN[kind]
    place = overlapping(q, *approaches)
    return Sector(place, widths, cells, mu=2 * math.tan(place.psi / 2))


@pytest.fixture(scope="module", params=GIVEN)
def at_rest(request):
    return GIVEN[request.param][0], sector(request.param).rest()


@pytest.fixture(scope="module")
def start():
    return model.at_torque(ONE, 4)


def test_roller_race_and_flat_are_in_balance_under_the_torque(at_rest):
    q, state = at_rest
    forces = np.array([touch.force for touch in state.solution.touches])
    assert np.abs(forces.sum(axis=0)).max() < 1e-9 * np.abs(forces).max()
    assert max(map(abs, state.motion)) < 1e-5 * (state.place.d_i + state.place.d_o)
    (N, F_t), (_, on_race) = state.on_flat, state.on_race
    assert min(N, F_t, on_race) > 0
    assert q.z * q.race * on_race == pytest.approx(state.torque, rel=1e-3)
    assert q.z * (N * state.place.x - F_t * q.flat) == pytest.approx(state.torque, rel=1e-3)
    assert F_t / N == pytest.approx(math.tan(state.place.psi / 2), rel=2e-3)


def test_star_and_ring_turned_together_turn_the_state_and_nothing_else():
    angle, star = 1e-4, sector("star").rest()
    turned = sector("star").at((star.drags[0] + angle * STAR.X, star.drags[1] + angle * STAR.R))
    assert turned.torque == pytest.approx(star.torque, rel=1e-4)
    assert turned.tilt == pytest.approx(star.tilt + angle, rel=1e-9)
    assert turned.place.psi == pytest.approx(star.place.psi, rel=1e-4)


def test_a_pull_within_the_cone_leaves_torque_and_normal_force_and_one_beyond_finds_no_rest(start):
    there = model.sector(ONE.q, start, 4, PULLED.mu, driven=False)
    rest = there.rest(start.drags)
    before, after = Borne.by(rest), Borne.by(model.pulled(ONE, there, rest))
    assert pytest.approx(before.N, rel=1e-4) == after.N
    assert after.F_t == pytest.approx(before.F_t, rel=1e-4)
    pull = PULLED.F_ax * rest.torque / (PULLED.z * PULLED.T)
    assert after.F_z == pytest.approx([pull, -pull], rel=1e-9)
    limit = FRICTION.analytic(PULLED)["F_lim"] / (PULLED.z * PULLED.L)
    with pytest.raises(ArithmeticError):
        there.at(rest.drags, after=rest.solution, axial_forces={"ring.rim": 1.05 * limit})


def test_a_ring_driven_on_keeps_its_torque_as_it_slips_and_a_held_one_loses_approach(start):
    """Slip of a held ring costs approach as Coulomb's law has it."""
    there = model.sector(ONE.q, start, 4, PULLED.mu, driven=True)
    rest = there.rest(start.drags)
    driven = model.creeping(there, rest, axial_displacements={"ring.rim": 2e-6})
    assert driven.torque == pytest.approx(rest.torque, rel=3e-3)
    held = rest
    places = []
    for slip in (5e-6, 8e-6):
        held = there.at(rest.drags, after=held.solution, axial_displacements={"ring.rim": slip})
        places.append(held.place)
    lost = sum(getattr(places[0], d) - getattr(places[1], d) for d in ("d_i", "d_o"))
    tan = math.tan(rest.start.psi / 2)
    assert lost / 3e-6 == pytest.approx(tan / math.sqrt((PULLED.mu / tan) ** 2 - 1), rel=0.02)
    assert held.torque < rest.torque


def test_where_friction_is_below_the_angle_s_tangent_every_node_slips(start):
    limit = Limit(ONE, start, start.drags)
    assert limit.slipping(0.9 * limit.tan).tolist() == [1.0, 1.0]
    assert limit.slipping(2.0 * limit.tan).max() < 0.5


def test_after_a_load_along_the_axis_has_come_and_gone_the_roller_is_still_in_balance():
    q = LoadPaths()
    one = one_pulled(q)
    held = Held.at(one, paths.at_torque(one, 3), 3, q.mu)
    there = held.to(-0.8, held.to(0.8, held.rest))
    b, on_mesh = Borne.by(there), Borne.on_mesh(there)
    assert b.F_z.sum() == pytest.approx(0.0, abs=1e-8 * b.N[0])
    assert np.hypot(on_mesh.F_t, on_mesh.F_z).max() < q.mu * on_mesh.N.min() * (1 + 1e-9)
    assert b.tangent == pytest.approx(math.tan(held.rest.place.psi / 2), rel=2e-5)
