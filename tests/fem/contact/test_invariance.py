"""What must not change a contact's answer: its place, its units, the names of its sides, copies."""

from dataclasses import replace

import numpy as np
import pytest

from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import full_block
from meshes.contact.disc import half_disc, quarter_disc
from meshes.join import join

R, E, NU = 10e-3, 210e9, 0.3  # m, Pa
A = 0.02 * R  # about the half-width of the contact
DOWN, ALONG = 2e-6, 0.3e-6  # m; presses the disc into the block, then pushes it along
SOLVED = 1e-8  # relative; the solver's part


def turn(angle, v):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s], [s, c]]) @ v


def rolling(
    angle=0.0, shift=(0.0, 0.0), scale=1.0, stress=1.0, swap=False, thickness=1.0, refine=1
):
    """A disc pressed and pushed along a block, with `scale` units a metre, `stress` a pascal."""
    mesh = join({
        "disc": half_disc(R=R * scale, zone=1.4 * A * scale, refine=1),
        "block": full_block(
            width=R * scale, depth=R * scale, zone=1.5 * A * scale, refine=1, cells=7
        ),
    })  # fmt: skip
    mesh = replace(mesh, doflocs=turn(angle, mesh.doflocs) + np.reshape(shift, (2, 1)))
    disc = Circle(tuple(turn(angle, (0.0, R * scale)) + shift), R * scale)
    flat = Flat(tuple(shift), tuple(turn(angle, (0.0, 1.0))))
    sides = [("disc.surface", disc), ("block.surface", flat)]
    (slave, one), (master, other) = sides[::-1] if swap else sides
    problem = ContactProblem(
        mesh, assumption="plane strain", thickness=thickness,
        materials={"disc": Elastic(E=E * stress, nu=NU),
                   "block": Elastic(E=E * stress / 2, nu=0.2)},
        supports={"block.bottom": "xy", "disc.middle": "xy"},
        contacts=[Pair(slave=slave, master=master, friction=0.25, slave_shape=one,
                       master_shape=other)],
    )  # fmt: skip
    s = None
    for along in (0.0, ALONG):
        x, y = turn(angle, (along * scale, -DOWN * scale))
        s = problem.solve(displacements={"disc.middle": {"x": x, "y": y}}, after=s)
    return s


@pytest.fixture(scope="module")
def upright():
    return rolling()


@pytest.mark.parametrize("angle", [0.1, np.pi / 2, 2.5, -np.pi / 4])
def test_a_turned_problem_has_turned_forces_and_the_same_pressures(upright, angle):
    s = rolling(angle=angle, shift=(0.013, -0.02))
    one, other = upright.touches[0], s.touches[0]
    np.testing.assert_allclose(other.force, turn(angle, one.force), rtol=SOLVED)
    np.testing.assert_allclose(other.pressure, one.pressure, atol=SOLVED * one.peak)
    np.testing.assert_allclose(other.traction, one.traction, atol=SOLVED * one.peak)
    np.testing.assert_array_equal(other.sticks, one.sticks)
    assert s.strain_energy == pytest.approx(upright.strain_energy, rel=SOLVED)


def test_the_push_lets_the_edges_slip_and_the_middle_stick(upright):
    touch = upright.touches[0]  # else the tests here would miss half of the code
    assert 2 < np.count_nonzero(touch.sticks) < np.count_nonzero(touch.closed) - 2


def test_millimetres_and_megapascals_give_the_same_numbers(upright):
    # per metre of thickness in one, per millimetre in the other
    one, other = upright.touches[0], rolling(scale=1e3, stress=1e-6).touches[0]
    np.testing.assert_allclose(other.pressure, 1e-6 * one.pressure, atol=SOLVED * 1e-6 * one.peak)
    np.testing.assert_allclose(other.gap, 1e3 * one.gap, atol=SOLVED * 1e3 * abs(one.gap).max())
    np.testing.assert_allclose(np.multiply(other.force, 1e3), one.force, rtol=SOLVED)
    assert other.half_width() == pytest.approx(1e3 * one.half_width(), rel=SOLVED)


def test_forces_and_energy_go_with_the_thickness_and_pressures_do_not(upright):
    s = rolling(thickness=0.04)
    one, other = upright.touches[0], s.touches[0]
    np.testing.assert_allclose(other.force, np.multiply(one.force, 0.04), rtol=SOLVED)
    np.testing.assert_allclose(other.pressure, one.pressure, atol=SOLVED * one.peak)
    assert s.strain_energy == pytest.approx(0.04 * upright.strain_energy, rel=SOLVED)


def test_slave_and_master_change_places_within_the_mesh_error(upright):
    one, other = upright.touches[0], rolling(swap=True).touches[0]
    # four cells on the half-width here; the second mesh halves these differences
    assert other.normal_force == pytest.approx(one.normal_force, rel=2e-3)
    assert other.friction_force == pytest.approx(one.friction_force, rel=1e-2)
    assert other.half_width() == pytest.approx(one.half_width(), rel=2e-2)


def on_flat(aR, *, make=quarter_disc, refine=1):
    """A disc pressed on a rigid flat by Hertz's load for a/R = `aR`."""
    a = aR * R
    load = np.pi * E / (1 - NU**2) * a**2 / (4 * R)
    half = make is quarter_disc
    return ContactProblem(
        make(R=R, zone=1.4 * a, refine=refine), materials=Elastic(E=E, nu=NU),
        assumption="plane strain", supports={"axis": "x"}, obstacles={"flat": Obstacle(Flat())},
        contacts=[Pair(slave="surface", master="flat", slave_shape=Circle((0, R), R))],
    ).solve(forces={"middle": (0, -load / 2 if half else -load)})  # fmt: skip


@pytest.mark.parametrize("refine", [1, 2])
def test_a_symmetric_half_is_half_of_the_whole(refine):
    half, whole = on_flat(0.02, refine=refine), on_flat(0.02, make=half_disc, refine=refine)
    one, two = half.touches[0], whole.touches[0]
    assert two.normal_force == pytest.approx(2 * one.normal_force, rel=SOLVED)
    assert two.peak == pytest.approx(one.peak, rel=1e-6)
    assert two.half_width((0, 0)) == pytest.approx(one.half_width((0, 0)), rel=1e-6)
    assert whole.strain_energy == pytest.approx(2 * half.strain_energy, rel=1e-7)


def test_contacts_grow_with_the_root_of_the_load():
    # meshes alike in a, so that only a/R, squared and times 3/16, is left between them
    small, large = (on_flat(a).touches[0] for a in (0.005, 0.02))
    assert large.half_width((0, 0)) / small.half_width((0, 0)) == pytest.approx(4, rel=1e-3)
    assert large.peak / small.peak == pytest.approx(4, rel=1e-3)


def test_discs_far_apart_on_one_flat_do_not_know_of_each_other():
    discs = {"left": -0.1, "right": 0.07}
    one = half_disc(R=R, zone=1.4 * A, refine=1)
    mesh = join({
        name: replace(one, doflocs=one.doflocs + np.reshape((x, 0.0), (2, 1)))
        for name, x in discs.items()
    })  # fmt: skip
    problem = ContactProblem(
        mesh, materials=Elastic(E=E, nu=NU), assumption="plane strain",
        supports={f"{name}.axis": "x" for name in discs}, obstacles={"flat": Obstacle(Flat())},
        contacts=[Pair(slave=f"{name}.surface", master="flat", slave_shape=Circle((x, R), R))
                  for name, x in discs.items()],
    )  # fmt: skip
    load = np.pi * E / (1 - NU**2) * A**2 / (4 * R)
    both = problem.solve(forces={f"{name}.middle": (0, -load) for name in discs})
    alone = on_flat(0.02, make=half_disc)
    for touch in both.touches:
        np.testing.assert_allclose(
            touch.pressure, alone.touches[0].pressure, atol=1e-7 * alone.touches[0].peak
        )
    assert both.strain_energy == pytest.approx(2 * alone.strain_energy, rel=1e-7)
