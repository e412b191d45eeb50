"""Contacts against closed-form solutions, their balance, and the energy dissipated by friction."""

import numpy as np
import pytest

from fem.contact.along import Along
from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.disc import half_disc, quarter_disc
from meshes.contact.round import full_ring
from meshes.join import join
from tests.fem.contact.models import on_flat, tower

R, YOUNG, NU = 10e-3, 210e9, 0.3  # m, Pa


# on the third mesh the axis is prone to open
@pytest.mark.parametrize(("partner", "refine"), [("flat", 2), ("sphere", 3)])
def test_spheres_meet_hertz(partner, refine):
    a = 0.02 * R
    soft = (1 - NU**2) / YOUNG * (1 if partner == "flat" else 2)
    bend = 1 / R * (1 if partner == "flat" else 2)
    load = 4 / 3 * a**3 * bend / soft
    ball = {"slave": "up.surface", "slave_shape": Circle((0, R), R)}
    bodies = {"up": quarter_disc(R=R, zone=1.4 * a, refine=refine)}
    held = {"supports": {}, "obstacles": {"flat": Obstacle(Flat())}}
    contact = Pair(**ball, master="flat")
    if partner == "sphere":
        bodies["low"] = quarter_disc(R=R, zone=1.5 * a, refine=refine, below=True)
        held = {"supports": {"low.middle": "y"}}
        contact = Pair(**ball, master="low.surface", master_shape=Circle((0, -R), R))
    s = ContactProblem(
        join(bodies), materials=Elastic(E=YOUNG, nu=NU), assumption="axisymmetric",
        contacts=[contact], **held,
    ).solve(forces={"up.middle": (0, -load)})  # fmt: skip
    touch = s.touches[0]
    r, p = touch.x[0] / a, touch.pressure / (1.5 * load / (np.pi * a**2))
    inner = r < 0.5  # nearer to the edge a mesh that does not end there shows
    np.testing.assert_allclose(p[inner], np.sqrt(1 - r[inner] ** 2), rtol=2e-3)
    assert touch.normal_force == pytest.approx(load, rel=1e-6)
    assert touch.half_width((0, 0)) == pytest.approx(a, rel=5e-3)
    # the centre comes nearer by less than delta = a^2 bend: what lies beyond it does not count,
    # and of a half-space's approach the part beyond the depth R is 0.4 a/R to 0.6 a/R
    delta = -s.plane.displacement_at((0, R))[1] / (a**2 * bend)
    assert -0.65 * a / R < delta - 1 < 0


def test_a_press_fit_meets_lame():
    i, r_i, r, r_o = 1e-5, 20e-3, 40e-3, 70e-3
    E_1, nu_1, E_2, nu_2 = 210e9, 0.3, 70e9, 0.33
    mesh = join({"in": full_ring(r_i=r_i, r_o=r, around=40, across=4),
                 "out": full_ring(r_i=r, r_o=r_o, around=32, across=5)})  # fmt: skip
    anchors = {(a, 0): "y" for a in (r_i, -r_i, r_o, -r_o)} | {(0, a): "x" for a in (r_i, r_o)}
    s = ContactProblem(
        mesh, materials={"in": Elastic(E=E_1, nu=nu_1), "out": Elastic(E=E_2, nu=nu_2)},
        assumption="plane stress", anchors=anchors,
        contacts=[Pair(slave="in.rim", master="out.bore", friction=0.2, interference=i,
                       slave_shape=Circle((0, 0), r),
                       master_shape=Circle((0, 0), r, hollow=True))],
    ).solve()  # fmt: skip
    inner = ((r**2 + r_i**2) / (r**2 - r_i**2) - nu_1) / E_1
    outer = ((r_o**2 + r**2) / (r_o**2 - r**2) + nu_2) / E_2
    p = i / (r * (inner + outer))
    touch = s.touches[0]
    assert touch.normal_force / (2 * np.pi * r) == pytest.approx(p, rel=3e-4)
    np.testing.assert_allclose(touch.pressure, p, rtol=2e-2)


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
