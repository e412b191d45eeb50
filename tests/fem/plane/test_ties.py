"""Cyclic sectors and bonded bodies against the whole, meshed alike, to round-off."""

import re
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from fem.plane.ties import Tie
from tests.fem.cyclic_rings import KINDS, apart, arc, beside, ring, sector, turned

MATERIAL = Elastic(E=1000.0, nu=0.3)
START = 0.3
SAME = 1e-10  # of the largest displacement or force


def cyclic(z, *, swapped=False):
    sides = ("last cut", "first cut") if swapped else ("first cut", "last cut")
    return Tie(leader=sides[0], follower=sides[1], angle=(-1 if swapped else 1) * 2 * pi / z)


def patches(z):
    """A patch of pressure and shear on every sector, beside its middle: no mirror maps it."""

    def traction(x):
        within = np.mod(np.arctan2(x[1], x[0]) - START, 2 * pi / z) * z / (2 * pi)
        radial = x / np.hypot(*x)
        tangent = np.array([-radial[1], radial[0]])
        return np.exp(-60 * (within - 0.3) ** 2) * (0.7 * tangent - radial)

    return traction


def solved(mesh, **given):
    given = {"supports": {"bore": "xy"}, "assumption": "plane strain"} | given
    return solve_plane(mesh, materials=MATERIAL, **given)


@pytest.mark.parametrize(
    ("kind", "z", "swapped"),
    [("tri3", 1, False), ("tri6", 2, True), ("quad4", 5, True), ("quad9", 7, False)],
)
def test_a_tied_sector_moves_as_the_ring_at_every_node(kind, z, swapped):
    load = {"rim": patches(z)}
    # one sector of one is cut open and tied to itself, turned by nothing
    part = solved(sector(kind, z), tractions=load, ties=[cyclic(z, swapped=swapped)])
    whole = solved(ring(kind, z), tractions=load)
    assert apart(part, whole) < SAME
    assert z * part.strain_energy == pytest.approx(whole.strain_energy, rel=SAME)
    assert z * part.reaction("bore")[2] == pytest.approx(whole.reaction("bore")[2], rel=SAME)


@pytest.mark.parametrize(
    ("kind", "supports"),
    [("tri6", {"bore": "n", "rim": {"t": 1e-3}}), ("quad4", {"bore": {"t": 1e-3}})],
)
def test_round_guides_go_on_across_the_cut(kind, supports):
    # half-cell normals at the two ends of the bore would hold the tied corner altogether
    z = 5
    part = solved(sector(kind, z), supports=supports, pressures={"rim": 1.0}, ties=[cyclic(z)])
    whole = solved(ring(kind, z), supports=supports, pressures={"rim": 1.0})
    assert apart(part, whole) < SAME
    for wall in supports:
        moment = whole.reaction(wall)[2]
        assert z * part.reaction(wall)[2] == pytest.approx(moment, abs=SAME)


@pytest.mark.parametrize(("kind", "z"), [("tri3", 2), ("tri6", 7)])
def test_the_axis_of_a_solid_disc_stays_where_it_is(kind, z):
    mesh = disc_sector(kind, z)
    s = solved(mesh, supports={"rim": "t"}, tractions={"rim": patches(z)}, ties=[cyclic(z)])
    assert s.displacement_at((0.0, 0.0)) == (0.0, 0.0)
    # under pressure all round it shrinks evenly: u_r = -(1 + nu)(1 - 2 nu) p r / E, linear
    s = solved(mesh, supports={"rim": "t"}, pressures={"rim": 1.0}, ties=[cyclic(z)])
    if kind == "tri6":
        u = np.array([s.u[::2], s.u[1::2]])
        exact = -1.3 * 0.4 / MATERIAL.E * s.basis.doflocs[:, ::2]
        assert np.abs(u - exact).max() < 2e-3 * np.abs(exact).max()


def disc_sector(kind, z, cells=6):
    """A fan of triangles about the axis."""
    straight, shape = KINDS[kind]
    angle, radii = 2 * pi / z * np.linspace(0, 1, cells + 1) + START, np.linspace(0.25, 1, 4)
    points = [(0.0, 0.0), *((r * np.cos(a), r * np.sin(a)) for r in radii for a in angle)]
    n = cells + 1
    t = [(0, 1 + i, 2 + i) for i in range(cells)]
    for a in (1 + k * n + i for k in range(len(radii) - 1) for i in range(cells)):
        t += [(a, a + n, a + n + 1), (a, a + n + 1, a + 1)]
    grid = straight(np.array(points).T, np.array(t).T)
    ends = grid.p[:, grid.facets]
    found = {"rim": np.all(np.abs(np.hypot(*ends) - 1) < 1e-9, axis=0)}
    for name, a in (("first cut", START), ("last cut", START + 2 * pi / z)):
        x, y = turned(ends.reshape(2, -1), -a).reshape(ends.shape)
        found[name] = np.all((np.abs(y) < 1e-9) & (x > -1e-9), axis=0)
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    return mesh.with_boundaries({name: np.flatnonzero(on) for name, on in found.items()})


@pytest.mark.parametrize(
    ("tie", "words"),
    [
        ({"leader": "bore", "angle": 2 * pi / 5}, "7 nodes cannot follow 13"),
        ({"leader": "first cut", "angle": -2 * pi / 5}, "no node follows that at (0.92203, -1.3"),
        ({"leader": "cut"}, "no boundary 'cut'"),
        ({"leader": "first cut", "angle": np.nan}, "angle, about and shift must be finite"),
        ({"leader": "last cut"}, "a boundary cannot follow itself"),
    ],
)
def test_a_wrong_tie_is_named_in_a_line(tie, words):
    with pytest.raises(ValueError, match=f"^[^\\n]*{re.escape(words)}[^\\n]*$"):
        solved(sector("tri6", 5), ties=[Tie(follower="last cut", **tie)])


def test_what_a_cyclic_tie_leaves_free_and_cannot_be_around_a_turn_is_refused():
    mesh = sector("tri6", 5)
    rough = np.random.default_rng(1).uniform(-3e-8, 3e-8, mesh.doflocs.shape)
    with pytest.raises(ValueError, match=r"\+1 rotation\): support it against that"):
        solved(replace(mesh, doflocs=mesh.doflocs + rough), supports={}, ties=[cyclic(5)])
    mesh = sector("tri6", 12, start=0.1)
    with pytest.raises(ValueError, match="around a turn followers are only shifted along y"):
        solved(mesh, assumption="axisymmetric", ties=[cyclic(12)])


def test_bonded_bodies_are_one():
    size = {"start": START, "around": 8}
    inner = arc("tri6", 2.0, through=3, **size)
    outer = arc("tri6", 2.0, through=3, r_i=1.6, r_o=2.2, **size)
    two = solved(
        beside("tri6", inner, outer), supports={"bore 0": "xy"}, tractions={"rim 1": patches(4)},
        ties=[Tie(leader="rim 0", follower="bore 1")],
    )  # fmt: skip
    whole = arc("tri6", 2.0, through=6, r_o=2.2, **size)
    one = solved(whole, supports={"bore": "xy"}, tractions={"rim": patches(4)})
    assert apart(two, one) < SAME
