"""Where nothing pulls along z, the cone is the plane's friction, and what is turned is turned."""

import numpy as np
import pytest

from fem.contact.along import Along
from fem.contact.cone import State
from fem.contact.cone_descent import Descent
from fem.contact.pairs import Pair
from fem.contact.problem import ContactProblem
from fem.plane.material import Elastic
from meshes.contact.block import block
from meshes.join import join

SOFT, HARD = Elastic(E=1.0, nu=0.3), Elastic(E=4.0, nu=0.2)


def tower(along, friction=0.25):
    mesh = join({"up": block(x=(0.2, 0.7), y=(0.5, 1.0), nx=6, ny=5),
                 "low": block(x=(0, 1), y=(0, 0.5), nx=11, ny=5)})  # fmt: skip
    return ContactProblem(
        mesh, materials={"up": SOFT, "low": HARD}, assumption="plane strain",
        supports={"low.bottom": "xy"}, along=along,
        contacts=[Pair(slave="up.bottom", master="low.top", friction=friction)],
    )  # fmt: skip


def test_without_loads_along_z_the_plane_is_what_it_was():
    plane, both = tower(None), tower(Along(supports={"low.bottom": 0.0}))
    a = b = None
    for x in (0.0, 6e-4, 1.2e-3, -5e-4):
        load = {"up.top": (x, -8e-3)}
        a, b = plane.solve(forces=load, after=a), both.solve(forces=load, after=b)
        np.testing.assert_array_equal(a.rest.multipliers, b.rest.multipliers)
        np.testing.assert_array_equal(a.displacements, b.displacements)
        assert not np.any(b.u_z)
        assert b.touches[0].force_z == 0.0
        assert a.u_z.size == b.u_z.size


def test_the_cones_own_equations_find_the_planes_friction():
    # the way over Newton's method, from elsewhere: all nodes pulled along z at the start
    problem = tower(Along(supports={"low.bottom": 0.0}))
    pressed = problem.solve(forces={"up.top": (0.0, -8e-3)})
    load = {"up.top": (0.75 * 0.25 * 8e-3, -8e-3)}
    s = problem.solve(forces=load, after=pressed)
    cone = s.along.interface.cone
    n, k = s.rest.multipliers.size, s.rest.motion.size
    w_0 = s.w - problem.interface.kernel.B @ s.rest.multipliers
    w_0 = w_0 - problem.interface.kernel.D @ s.rest.motion
    w = np.concatenate([w_0, np.zeros(len(cone.B) - n)])
    e = np.concatenate([s.e, np.zeros(cone.D.shape[1] - k)])
    rest = pressed.rest
    start = State(
        np.concatenate([rest.multipliers, 0.1 * rest.multipliers[cone.rough]]),
        np.concatenate([rest.motion, np.zeros(e.size - k)]),
    )
    found = Descent(cone, w, e).solve([start])
    peak = s.touches[0].peak
    np.testing.assert_allclose(found.multipliers[:n], s.rest.multipliers, atol=1e-9 * peak)
    np.testing.assert_allclose(found.multipliers[n:], 0.0, atol=1e-9 * peak)


def test_shares_of_a_step_are_steps_of_their_own():
    problem = tower(Along(supports={"low.bottom": 0.0}), friction=0.6)

    def at(share, after, steps=1):
        return problem.solve(
            forces={"up.top": (share * 1e-3, share * -8e-3)},
            axial_forces={"up.top": share * 2e-3},
            axial_displacements={"low.bottom": share * 0.1}, after=after, steps=steps,
        )  # fmt: skip

    one = at(1.0, at(0.5, None))
    there = at(1.0, None, 2)
    back = at(0.25, there, 3)
    same = at(0.25, at(0.5, at(0.75, one)))
    for found, expected in ((there, one), (back, same)):
        a, b = found.touches[0], expected.touches[0]
        np.testing.assert_allclose(a.traction_z, b.traction_z, atol=1e-9 * b.peak)
        np.testing.assert_allclose(found.u_z, expected.u_z, atol=1e-9 * np.abs(one.u_z).max())


def test_what_is_held_along_z_changes_in_proportion_to_the_thickness():
    mesh = join({"up": block(x=(0.2, 0.7), y=(0.5, 1.0), nx=6, ny=5),
                 "low": block(x=(0, 1), y=(0, 0.5), nx=11, ny=5)})  # fmt: skip
    thin, thick = (
        ContactProblem(
            mesh, materials={"up": SOFT, "low": HARD}, assumption="plane strain", thickness=t,
            supports={"low.bottom": "xy"}, along=Along(supports={"low.bottom": 0.0}),
            contacts=[Pair(slave="up.bottom", master="low.top", friction=0.25)],
        ).solve(forces={"up.top": (3e-4 * t, -8e-3 * t)}, axial_forces={"up.top": 1e-3 * t})
        for t in (1.0, 0.2)
    )  # fmt: skip
    np.testing.assert_allclose(thin.u_z, thick.u_z, atol=1e-9 * np.abs(thin.u_z).max())
    assert thick.touches[0].force_z == pytest.approx(0.2 * thin.touches[0].force_z, rel=1e-9)
