"""Contacts whose answers are closed formulas."""

import numpy as np
import pytest

from fem.contact.pairs import Obstacle, Pair, Rigid
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import block, full_block
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


def test_a_punch_off_its_middle_tilts_as_the_half_plane_has_it():
    load, off = 0.01, 0.25  # of the half-width; beyond a half it would lift
    punch = block(x=(-1, 1), y=(0, 1), nx=32, ny=1)
    low = full_block(width=60, depth=60, zone=1, refine=2, cells=8)
    s = ContactProblem(
        join({"punch": punch, "low": low}), assumption="plane strain",
        materials={"punch": Rigid(), "low": Elastic(E=1, nu=NU)},
        supports={"low.bottom": "xy"}, anchors={(0, 1): "x"},
        contacts=[Pair(slave="low.surface", master="punch.bottom")],
    ).solve(forces={"punch.top": (0, -load)}, point_forces={(1, 1): (0, -load * off / 2),
                    (-1, 1): (0, load * off / 2)})  # fmt: skip
    touch = s.touches[0]
    x = touch.x[0]
    inner = np.abs(x) < 0.8
    exact = load / np.pi / np.sqrt(1 - x**2, where=inner, out=np.ones(x.size)) * (1 + 2 * off * x)
    np.testing.assert_allclose(touch.pressure[inner], exact[inner], rtol=0.03)
    assert touch.moment(on="slave") == pytest.approx(-off * load, rel=1e-6)


@pytest.mark.parametrize(
    ("assumption", "overlap", "swap", "friction"),
    [
        ("plane strain", False, False, 0.2),
        ("plane stress", True, True, 0.0),
    ],
)
def test_a_press_fit_meets_lame(assumption, swap, overlap, friction):
    i, r_i, r, r_o = 1e-5, 20e-3, 40e-3, 70e-3
    E_1, nu_1, E_2, nu_2 = 210e9, 0.3, 70e9, 0.33
    r_1 = r + i if overlap else r
    mesh = join({"in": full_ring(r_i=r_i, r_o=r_1, around=40, across=4),
                 "out": full_ring(r_i=r, r_o=r_o, around=32, across=5)})  # fmt: skip
    sides = [("in.rim", Circle((0, 0), r_1)), ("out.bore", Circle((0, 0), r, hollow=True))]
    (slave, one), (master, other) = sides[::-1] if swap else sides
    anchors = {(r_i, 0): "y", (-r_i, 0): "y", (0, r_i): "x"}
    anchors |= {(r_o, 0): "y", (-r_o, 0): "y", (0, r_o): "x"}
    s = ContactProblem(
        mesh, materials={"in": Elastic(E=E_1, nu=nu_1), "out": Elastic(E=E_2, nu=nu_2)},
        assumption=assumption, anchors=anchors,
        contacts=[Pair(slave=slave, master=master, slave_shape=one, master_shape=other,
                       friction=friction, press_fit=overlap,
                       interference=0.0 if overlap else i)],
    ).solve()  # fmt: skip
    if assumption == "plane strain":
        E_1, nu_1 = E_1 / (1 - nu_1**2), nu_1 / (1 - nu_1)
        E_2, nu_2 = E_2 / (1 - nu_2**2), nu_2 / (1 - nu_2)
    inner = ((r**2 + r_i**2) / (r**2 - r_i**2) - nu_1) / E_1
    outer = ((r_o**2 + r**2) / (r_o**2 - r**2) + nu_2) / E_2
    p = i / (r * (inner + outer))
    touch = s.touches[0]
    # i/r = 2.5e-4 of the radius when bodies overlap, which are of one size here
    assert touch.normal_force / (2 * np.pi * r) == pytest.approx(p, rel=3e-4)
    np.testing.assert_allclose(touch.pressure, p, rtol=2e-2)
