"""Forces along z balance, friction in the cone only takes energy; without them it is the plane."""

import numpy as np
import pytest

from fem.contact.along import Along
from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import block
from meshes.contact.disc import half_disc
from meshes.join import join

SOFT, HARD = Elastic(E=1.0, nu=0.3), Elastic(E=4.0, nu=0.2)
EXACT = 1e-9


def test_what_pulls_above_arrives_below():
    # two blocks on a floor, the lower one pulled as well, all of them held by friction alone
    mesh = join({"up": block(x=(0.2, 0.7), y=(0.5, 1.0), nx=6, ny=5),
                 "low": block(x=(0, 1), y=(0, 0.5), nx=11, ny=5)})  # fmt: skip
    problem = ContactProblem(
        mesh, materials={"up": SOFT, "low": HARD}, assumption="plane strain", thickness=0.3,
        obstacles={"floor": Obstacle(Flat())}, along=Along(),
        contacts=[Pair(slave="up.bottom", master="low.top", friction=0.5),
                  Pair(slave="low.bottom", master="floor", friction=0.5)],
    )  # fmt: skip
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
    R, a = 10e-3, 2e-4
    problem = ContactProblem(
        half_disc(R=R, zone=1.4 * a, refine=1), materials=Elastic(E=210e9, nu=0.3),
        assumption="plane strain", supports={"middle": "xy"}, obstacles={"flat": Obstacle(Flat())},
        along=Along(supports={"middle": 0.0}),
        contacts=[Pair(slave="surface", master="flat", friction=0.3,
                       slave_shape=Circle((0, R), R))],
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
    change = energy[-1] - energy[48]
    assert work - change == pytest.approx(sum(lost[49:]), rel=1e-6)


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
