"""Cyclic sectors and bonded bodies against the whole; equal cells; mean motions of boundaries."""

from math import pi

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.means import Mean
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
    # two different normals at the ends of the bore would prevent all motion of the tied corner
    z = 5
    part = solved(sector(kind, z), supports=supports, pressures={"rim": 1.0}, ties=[cyclic(z)])
    whole = solved(ring(kind, z), supports=supports, pressures={"rim": 1.0})
    assert apart(part, whole) < SAME
    for wall in supports:
        moment = whole.reaction(wall)[2]
        assert z * part.reaction(wall)[2] == pytest.approx(moment, abs=SAME)


@pytest.mark.parametrize(
    ("kind", "z", "swapped"), [("tri3", 2, False), ("tri6", 7, False), ("tri6", 7, True)]
)
def test_the_axis_of_a_solid_disc_stays_where_it_is(kind, z, swapped):
    mesh, ties = disc_sector(kind, z), [cyclic(z, swapped=swapped)]
    s = solved(mesh, supports={"rim": "t"}, tractions={"rim": patches(z)}, ties=ties)
    assert s.displacement_at((0.0, 0.0)) == (0.0, 0.0)
    # under pressure all round it shrinks evenly: u_r = -(1 + nu)(1 - 2 nu) p r / E, linear
    s = solved(mesh, supports={"rim": "t"}, pressures={"rim": 1.0}, ties=ties)
    if kind == "tri6":
        u = np.array([s.u[::2], s.u[1::2]])
        exact = -1.3 * 0.4 / MATERIAL.E * s.basis.doflocs[:, ::2]
        assert np.abs(u - exact).max() < 2e-3 * np.abs(exact).max()


def disc_sector(kind, z):
    """A fan of triangles about the axis."""
    straight, shape = KINDS[kind]
    cells = 6
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


every_element = pytest.mark.parametrize("kind", KINDS)


def shear(x):
    """A traction on one side of the ring only."""
    return np.array([0.3 * x[1] ** 2 * (x[0] > 0), 0.1 + 0 * x[0]])


@every_element
def test_a_rim_turned_on_the_average_is_in_pure_torsion(kind):
    # tractions along the arm are even shear on a circle, so that the rim stays one: see
    # u_phi = a r + b/r in the bore 0 and at the rim v, couple 4 pi mu b
    v, mu = 1e-3, MATERIAL.E / 2.6
    couple = 4 * pi * mu * v / (1 - 1 / 1.6**2)
    errors = []
    for through in (3, 6):
        mesh = sector(kind, 5, around=2 * through, through=through)
        s = solved(mesh, ties=[cyclic(5)], means={"rim": Mean({"r": v})})
        moment = 5 * s.mean_reaction("rim")["r"]
        assert 5 * s.reaction("bore")[2] == pytest.approx(-moment, rel=SAME)
        errors.append(moment / couple - 1)
    order = 2 * (1 if kind in ("tri3", "quad4") else 2)
    assert np.log2(abs(errors[0] / errors[1])) == pytest.approx(order, abs=0.3), errors


@every_element
def test_means_are_what_they_are_prescribed_to_be_and_hold_with_forces_in_balance(kind):
    about = (0.4, -0.2)
    held = {"x": 2e-3, "y": -1e-3, "r": 5e-4}
    s = solved(
        ring(kind, 5), supports={}, tractions={"bore": shear}, thickness=0.7,
        means={"rim": Mean(held, about=about)},
    )  # fmt: skip
    rim = s.on_boundary("rim")
    arm = rim.x - np.reshape(about, (2, 1))
    turn = rim.mean(arm[0] * rim.u[1] - arm[1] * rim.u[0]) / rim.mean((arm**2).sum(axis=0))
    shift = [rim.mean(u) for u in rim.u]
    assert (*shift, turn) == pytest.approx(tuple(held.values()), rel=1e-8)
    # the mean's tractions have these resultants, x and y evenly, r growing with the arm
    f = s.internal - s.f
    x, y = s.basis.doflocs[:, ::2]
    force = s.mean_reaction("rim")
    size = rim.mean((arm**2).sum(axis=0))
    mean_arm = [rim.mean(a) for a in arm]
    assert f[::2].sum() == pytest.approx(force["x"] - force["r"] * mean_arm[1] / size, rel=1e-8)
    assert f[1::2].sum() == pytest.approx(force["y"] + force["r"] * mean_arm[0] / size, rel=1e-8)
    moment = ((x - about[0]) * f[1::2] - (y - about[1]) * f[::2]).sum()
    assert moment == pytest.approx(
        force["r"] + force["y"] * mean_arm[0] - force["x"] * mean_arm[1], rel=1e-8
    )
