"""Bodies that nothing but contact holds, bodies that start apart, and bodies that do not deform."""

from dataclasses import replace

import numpy as np
import pytest

from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import block
from meshes.contact.disc import half_disc
from meshes.contact.round import full_disc
from meshes.join import join

R, LOAD = 10e-3, 1e5
STEEL = Elastic(E=210e9, nu=0.3)
EXACT = 1e-8


def at(mesh, x, y):
    return replace(mesh, doflocs=mesh.doflocs + np.reshape((x, y), (2, 1)))


@pytest.mark.parametrize(("friction", "gap"), [(0.0, 1e-3), (0.4, 2e-6)])
def test_three_blocks_fall_on_each_other(friction, gap):
    mesh = join({
        name: block(x=(0.0, 1.0), y=(k * (0.5 + gap), k * (0.5 + gap) + 0.5), nx=5 + k, ny=3)
        for k, name in enumerate(("low", "middle", "top"))
    })  # fmt: skip
    sides = {} if friction else {"supports": {f"{b}.left": "x" for b in ("low", "middle", "top")}}
    s = ContactProblem(
        mesh, materials=Elastic(E=1e6, nu=0.3), assumption="plane stress",
        obstacles={"floor": Obstacle(Flat())}, **sides,
        contacts=[Pair(slave="low.bottom", master="floor", friction=friction),
                  Pair(slave="middle.bottom", master="low.top", friction=friction),
                  Pair(slave="top.bottom", master="middle.top", friction=friction)],
    ).solve(body_forces=(0.0, -10.0))  # fmt: skip
    for touch, share in zip(s.touches, (3, 2, 1), strict=True):
        np.testing.assert_allclose(touch.force, (0.0, -5.0 * share), atol=EXACT * 15)


def in_groove(friction):
    n = {"left": (1.0, 1.0), "right": (-1.0, 1.0)}
    foot = R / np.sqrt(2)
    return ContactProblem(
        full_disc(R=R, around=32), materials=STEEL, assumption="plane strain",
        anchors={} if friction else {(0.0, R): "x"},  # against turning
        obstacles={k: Obstacle(Flat((-foot * v[0], -foot), v)) for k, v in n.items()},
        contacts=[Pair(slave="rim", master=k, slave_shape=Circle((0, 0), R), friction=friction)
                  for k in n],
    ).solve(body_forces=(0.0, -LOAD / (np.pi * R**2)))  # fmt: skip


@pytest.mark.parametrize("friction", [0.0, 0.5])
def test_a_disc_slips_down_a_groove_as_far_as_friction_lets_it(friction):
    # weight = 2 (N cos 45 deg + mu N sin 45 deg); it is that of the disc made of parabolas
    for touch in in_groove(friction).touches:
        assert touch.normal_force == pytest.approx(LOAD / np.sqrt(2) / (1 + friction), rel=1e-5)
        assert abs(touch.friction_force) == pytest.approx(friction * touch.normal_force, rel=1e-6)


def upright(mesh, centres):
    """Anchors sideways at two nodes of each disc, inside it, where no two bodies meet."""
    x, y = mesh.doflocs
    nodes = [
        np.argmin(np.abs(y - c - up) + 10 * np.abs(x)) for _, c in centres for up in (0.0, R / 2)
    ]
    return {(float(x[k]), float(y[k])): "x" for k in nodes}


def test_discs_stacked_by_their_whole_rims_meet_where_they_face_each_other():
    centres = {f"disc {k}": (0.0, R + 2 * R * k) for k in range(3)}
    mesh = join({name: at(full_disc(R=R, around=32), *c) for name, c in centres.items()})
    rim = {name: Circle(c, R) for name, c in centres.items()}
    pairs = [("disc 0", "floor"), ("disc 2", "press"), ("disc 1", "disc 0"), ("disc 1", "disc 2")]
    s = ContactProblem(
        mesh, materials=STEEL, assumption="plane strain",
        anchors=upright(mesh, centres.values()),
        obstacles={"floor": Obstacle(Flat()),
                   "press": Obstacle(Flat((0.0, 6 * R), (0.0, -1.0)), free="y")},
        contacts=[Pair(slave=f"{a}.rim", slave_shape=rim[a],
                       master=f"{b}.rim" if b in rim else b, master_shape=rim.get(b))
                  for a, b in pairs],
    ).solve(forces={"press": (0.0, -LOAD)})  # fmt: skip
    for touch, down in zip(s.touches, (-1, 1, -1, 1), strict=True):
        np.testing.assert_allclose(touch.force, (0.0, down * LOAD), atol=1e-7 * LOAD)


@pytest.mark.parametrize("share", [0.3, 0.999])
def test_a_block_on_a_rough_floor_holds_below_its_friction(share):
    s = pushed(share)
    np.testing.assert_allclose(s.touches[0].force, (0.3 * share, -1.0), atol=EXACT)
    assert np.any(s.touches[0].sticks)


def test_a_block_pushed_beyond_its_friction_is_refused():
    with pytest.raises(ValueError, match="loads do move it"):
        pushed(1.001)


def pushed(share):
    problem = ContactProblem(
        block(x=(-1, 1), y=(0, 1), nx=8, ny=4), materials=Elastic(E=100.0, nu=0.3),
        assumption="plane strain", obstacles={"floor": Obstacle(Flat())},
        contacts=[Pair(slave="bottom", master="floor", friction=0.3)],
    )  # fmt: skip
    down = problem.solve(forces={"top": (0.0, -1.0)})
    return problem.solve(forces={"top": (0.0, -1.0), "right": (0.3 * share, 0.0)}, after=down)


def test_contact_opens_and_closes_again_as_often_as_it_is_driven():
    disc = half_disc(R=R, zone=0.3e-3, refine=1)
    problem = ContactProblem(
        disc, materials=STEEL, assumption="plane strain", supports={"middle": "xy"},
        obstacles={"anvil": Obstacle(Flat())},
        contacts=[Pair(slave="surface", master="anvil", slave_shape=Circle((0.0, R), R))],
    )  # fmt: skip
    s, pressed = None, {}
    for down in (1e-6, 2e-6, -1e-6, 2e-6, 0.0, -1e-3, 1e-6):
        s = problem.solve(displacements={"middle": {"x": 0.0, "y": -down}}, after=s)
        force = s.touches[0].normal_force
        assert force == pytest.approx(pressed.setdefault(down, force), rel=EXACT)
        assert (force > 0) == (down > 0)
