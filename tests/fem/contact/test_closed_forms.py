"""Contacts whose answers are closed formulas."""

import numpy as np
import pytest

from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.disc import quarter_disc
from meshes.contact.round import full_ring
from meshes.join import join

R, E, NU = 10e-3, 210e9, 0.3  # m, Pa


# on the third mesh the axis is prone to open
@pytest.mark.parametrize(("partner", "refine"), [("flat", 2), ("sphere", 3)])
def test_spheres_meet_hertz(partner, refine):
    a = 0.02 * R
    soft = (1 - NU**2) / E * (1 if partner == "flat" else 2)
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
        join(bodies), materials=Elastic(E=E, nu=NU), assumption="axisymmetric",
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
