"""Loads, supports and contact forces balance; friction stays within its bound and takes energy."""

import numpy as np
import pytest

from fem.contact.along import Along
from fem.contact.errors import NotFoundError
from fem.contact.pairs import Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle
from meshes.contact.disc import half_disc
from meshes.contact.round import full_ring
from meshes.join import join
from tests.fem.contact.models import STEEL, on_flat, tower

EXACT = 1e-8  # of the load


def test_what_is_loaded_above_arrives_below():
    load = np.array([1e-3, -8e-3])
    s = tower(0.5, on_floor=True, assumption="plane stress", thickness=0.3).solve(
        forces={"up.top": tuple(load)}, body_forces={"low": (0.0, -0.02)}
    )
    upper, lower = s.touches
    weight = np.array([0.0, -0.02 * 0.5 * 0.3])
    np.testing.assert_allclose(upper.force, load, atol=EXACT * 8e-3)
    np.testing.assert_allclose(lower.force, load + weight, atol=EXACT * 8e-3)
    # moments about the origin: of the load at (0.45, 1), and the weight at (0.5, 0.25)
    moment = 0.45 * load[1] - 1.0 * load[0]
    assert upper.moment() == pytest.approx(moment, abs=EXACT * 8e-3)
    assert upper.moment(on="slave") == pytest.approx(-moment, abs=EXACT * 8e-3)
    assert lower.moment() == pytest.approx(moment + 0.5 * weight[1], abs=EXACT * 8e-3)
    assert s.plane.residual < 1e-10


def test_friction_stays_within_its_bound_and_sticking_points_do_not_slip():
    problem = tower(0.2, on_floor=True)
    s = problem.solve(forces={"up.top": (0.0, -8e-3)})
    s = problem.solve(forces={"up.top": (1.4e-3, -8e-3)}, after=s)
    for touch in s.touches:
        assert np.all(touch.pressure >= 0)
        assert np.all(np.abs(touch.traction) <= 0.2 * touch.pressure * (1 + 1e-9))
        assert np.abs(touch.slip[touch.sticks]).max(initial=0) < 1e-10 * np.abs(touch.slip).max()
        assert np.abs(touch.gap[touch.closed]).max() < 1e-10
        slides = touch.closed & ~touch.sticks & (np.abs(touch.slip) > 1e-12)
        assert np.any(slides)
        assert np.all(touch.traction[slides] * touch.slip[slides] < 0)  # drag, never drive


def rings(share):
    """A ring turned on another that holds it by a press fit, by `share` of what makes it slide."""
    r, mu = 0.04, 0.2
    mesh = join({"in": full_ring(r_i=0.02, r_o=r, around=32, across=4),
                 "out": full_ring(r_i=r, r_o=0.07, around=24, across=5)})  # fmt: skip
    problem = ContactProblem(
        mesh, materials=STEEL, assumption="plane strain", supports={"in.bore": "xy"},
        contacts=[Pair(slave="out.bore", master="in.rim", friction=mu, interference=1e-5,
                       slave_shape=Circle((0, 0), r, hollow=True), master_shape=Circle((0, 0), r))],
    )  # fmt: skip
    pressed = problem.solve()
    moment = share * mu * r * pressed.touches[0].normal_force

    def around(x):
        return moment / (2 * np.pi * 0.07**2) * np.array([-x[1], x[0]]) / np.hypot(*x)

    return problem.solve(tractions={"out.rim": around}, after=pressed), moment


def test_a_press_fit_hands_on_its_torque_and_turns_at_its_friction():
    # the load itself acts on parabolas, 1e-5 of the moment off the circle
    s, moment = rings(0.999)
    touch = s.touches[0]
    assert s.plane.reaction("in.bore")[2] == pytest.approx(-moment, rel=2e-5)
    assert touch.moment() == pytest.approx(moment, rel=2e-5)
    assert touch.moment(on="slave") == pytest.approx(-moment, rel=2e-5)
    np.testing.assert_allclose(touch.force, 0.0, atol=EXACT * touch.normal_force)
    with pytest.raises(NotFoundError, match="no state of rest was found"):
        rings(1.001)


def test_what_pulls_above_along_z_arrives_below():
    problem = tower(0.5, on_floor=True, thickness=0.3, along=Along())
    s = problem.solve(
        forces={"up.top": (1e-3, -8e-3)}, axial_forces={"up.top": 1.5e-3, "low.left": -4e-4}
    )
    upper, lower = s.touches
    assert upper.force_z == pytest.approx(1.5e-3, rel=EXACT)
    assert lower.force_z == pytest.approx(1.1e-3, rel=EXACT)
    assert s.along.reaction("floor") == pytest.approx(-1.1e-3, rel=EXACT)
    np.testing.assert_allclose(lower.force, (1e-3, -8e-3), atol=EXACT * 8e-3)
    internal = s.along.interface.bodies.internal_forces(s.u_z)
    rest = internal - s.along.pull.f - s.along.interface.rows.T @ s.along.traction
    assert np.abs(rest[:-1]).max() < EXACT * 1.5e-3  # every node but the floor, which is held


def test_friction_only_takes_energy_and_all_that_is_missing():
    # a roller on a flat swings in x and z out of phase; the trapezoidal rule loses nothing, for
    # each step is linear but for nodes that open or close in it, and here none does
    problem = on_flat(
        half_disc(R=10e-3, zone=0.28e-3, refine=1), friction=0.3, supports={"middle": "xy"},
        along=Along(supports={"middle": 0.0}),
    )  # fmt: skip
    s, before, lost, path = None, np.zeros((2, 1)), [], []
    for t in np.linspace(0, 4 * np.pi, 97):
        x, z = 6e-7 * np.sin(t), 6e-7 * np.sin(t - np.pi / 3)
        s = problem.solve(
            displacements={"middle": {"x": x, "y": -2e-6}}, axial_displacements={"middle": z},
            after=s,
        )  # fmt: skip
        touch = s.touches[0]
        forces = np.array([touch.traction, touch.traction_z]) * touch.mortar.size
        slips = np.array([touch.slip, touch.slip_z])
        lost.append(-float(((forces + before) * slips).sum()) / 2)
        before = forces
        path.append((x, z, touch.force[0], touch.force_z, s.strain_energy))
    x, z, F_x, F_z, energy = np.array(path).T
    assert min(lost) > -1e-12 * max(lost)
    second = slice(48, None)
    work = float(np.trapezoid(F_x[second], x[second]) + np.trapezoid(F_z[second], z[second]))
    assert work > 0.005 * np.ptp(x) * np.ptp(F_x)
    assert work - (energy[-1] - energy[48]) == pytest.approx(sum(lost[49:]), rel=1e-6)


HELD = {"supports": {"low.bottom": "xy"}}


def test_without_loads_along_z_the_plane_is_what_it_was():
    plane = tower(0.25, **HELD)
    both = tower(0.25, **HELD, along=Along(supports={"low.bottom": 0.0}))
    a = b = None
    for x in (0.0, 6e-4, 1.2e-3, -5e-4):
        load = {"up.top": (x, -8e-3)}
        a, b = plane.solve(forces=load, after=a), both.solve(forces=load, after=b)
        np.testing.assert_array_equal(a.rest.multipliers, b.rest.multipliers)
        np.testing.assert_array_equal(a.displacements, b.displacements)
        assert not np.any(b.u_z)
        assert b.touches[0].force_z == 0.0
        assert a.u_z.size == b.u_z.size
