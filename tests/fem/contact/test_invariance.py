"""Changes without effect on a contact: position, units, and a sector instead of the whole."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from skfem import MeshTri1, MeshTri2

from fem.contact.pairs import Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from fem.plane.means import Mean
from fem.plane.ties import Tie
from meshes.contact.block import full_block
from meshes.contact.disc import half_disc
from meshes.join import join
from tests.fem.cyclic_rings import apart, beside, ring, sector, turned

R, E, NU = 10e-3, 210e9, 0.3  # m, Pa
A = 0.02 * R  # about the half-width of the contact
DOWN, ALONG = 2e-6, 0.3e-6  # m; presses the disc into the block, then pushes it along
SOLVED = 1e-8  # relative; the solver's part


def turn(angle, v):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s], [s, c]]) @ v


def rolling(angle=0.0, shift=(0.0, 0.0), scale=1.0, stress=1.0, thickness=1.0):
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
    problem = ContactProblem(
        mesh, assumption="plane strain", thickness=thickness,
        materials={"disc": Elastic(E=E * stress, nu=NU),
                   "block": Elastic(E=E * stress / 2, nu=0.2)},
        supports={"block.bottom": "xy", "disc.middle": "xy"},
        contacts=[Pair(slave="disc.surface", master="block.surface", friction=0.25,
                       slave_shape=disc, master_shape=flat)],
    )  # fmt: skip
    s = None
    for along in (0.0, ALONG):
        x, y = turn(angle, (along * scale, -DOWN * scale))
        s = problem.solve(displacements={"disc.middle": {"x": x, "y": y}}, after=s)
    return s


def test_place_units_and_thickness_change_nothing():
    # in millimetres and megapascals, turned and shifted, 0.04 of the thickness
    angle = 2.5
    upright = rolling()
    s = rolling(angle=angle, shift=(13.0, -20.0), scale=1e3, stress=1e-6, thickness=0.04)
    one, other = upright.touches[0], s.touches[0]
    assert 2 < np.count_nonzero(one.sticks) < np.count_nonzero(one.closed) - 2
    np.testing.assert_allclose(other.force, 0.04e-3 * turn(angle, one.force), rtol=SOLVED)
    np.testing.assert_allclose(other.pressure, 1e-6 * one.pressure, atol=SOLVED * 1e-6 * one.peak)
    np.testing.assert_allclose(other.traction, 1e-6 * one.traction, atol=SOLVED * 1e-6 * one.peak)
    np.testing.assert_allclose(other.gap, 1e3 * one.gap, atol=SOLVED * 1e3 * abs(one.gap).max())
    np.testing.assert_array_equal(other.sticks, one.sticks)
    assert other.half_width() == pytest.approx(1e3 * one.half_width(), rel=SOLVED)
    assert s.strain_energy == pytest.approx(0.04 * upright.strain_energy, rel=SOLVED)


MATERIAL = Elastic(E=1000.0, nu=0.3)
Z, START = 4, 0.2
HUB, DISC, REACH = 1.0, 0.2, 1.2  # radii of hub and disc, and of the disc's centre
PRESSURE = 20.0
HELD = {"rim 1": Mean({"r": 0.0})}
ANGLE = 1.2e-2  # [rad] of the rim


def disc(angle):
    """A disc of curved triangles between hub and ring at `angle` [rad]."""
    straight = MeshTri1.init_circle(4)
    mesh = MeshTri2.from_mesh(straight).with_boundaries({"rim": straight.boundary_facets()})
    x = mesh.doflocs.copy()
    edge = np.unique(mesh.dofs.get_facet_dofs(mesh.boundaries["rim"]).all())
    x[:, edge] /= np.hypot(*x[:, edge])
    return replace(mesh, doflocs=turned(DISC * x + [[REACH], [0.0]], angle))


def centre(angle):
    return REACH * float(np.cos(angle)), REACH * float(np.sin(angle))


def clutch(start, whole=False, friction=0.3, means=HELD):
    """Bodies 0, 1: hub and ring; then one disc, or all."""
    make = ring if whole else sector
    size = {"start": start, "around": 10, "through": 3}
    hub = make("tri6", Z, r_i=0.6, r_o=HUB, **size)
    race = make("tri6", Z, r_i=HUB + 2 * DISC, r_o=1.8, **size)
    # discs lie beside their sectors' middles
    middles = [start + (k + 0.37) * 2 * pi / Z for k in range(Z if whole else 1)]
    mesh = beside("tri6", hub, race, *map(disc, middles))
    contacts = []
    for k, a in enumerate(middles):
        own = Circle(centre(a), DISC)
        axis = (0.0, 0.0)
        contacts += [
            Pair(slave=f"rim {k + 2}", master="rim 0", slave_shape=own, friction=friction,
                 master_shape=Circle(axis, HUB)),
            Pair(slave=f"rim {k + 2}", master="bore 1", slave_shape=own, friction=friction,
                 master_shape=Circle(axis, HUB + 2 * DISC, hollow=True)),
        ]  # fmt: skip
    ties = () if whole else (
        *(Tie(leader=f"first cut {b}", follower=f"last cut {b}", angle=2 * pi / Z) for b in (0, 1)),
    )  # fmt: skip
    return ContactProblem(
        mesh, materials=MATERIAL, assumption="plane strain", supports={"bore 0": "xy"},
        # discs whose centres could move would roll, and resist by nothing
        anchors={centre(a): "xy" for a in middles}, contacts=contacts, ties=ties, means=means,
    )  # fmt: skip


def test_a_sector_in_contact_moves_as_the_whole():
    part, whole = (
        clutch(START, all_of_it).solve(
            pressures={"rim 1": PRESSURE}, displacements={"rim 1": {"r": ANGLE}}, steps=3
        )
        for all_of_it in (False, True)
    )
    assert apart(part.plane, whole.plane) < 1e-8
    for one, all_of_them in zip(part.touches, whole.touches[:2], strict=True):
        assert one.force == pytest.approx(all_of_them.force, rel=1e-8)
    assert Z * part.strain_energy == pytest.approx(whole.strain_energy, rel=1e-9)
    # the moment of the mean is the sector's share; contacts transmit it to the bore
    moment = part.plane.mean_reaction("rim 1")["r"]
    assert moment > 0
    assert Z * moment == pytest.approx(whole.plane.mean_reaction("rim 1")["r"], rel=1e-8)
    inner, outer = part.touches
    # the mesh's curved edges miss the exact circles, on which tractions count, by 1e-6
    assert part.plane.reaction("bore 0")[2] == pytest.approx(-inner.moment(), rel=1e-5)
    assert outer.moment() == pytest.approx(-moment, rel=1e-5)
    assert {s.tolist() for t in part.touches for s in t.sticks[t.closed]} == {True, False}


def test_a_ring_that_loads_turn_and_means_of_what_is_in_contact_are_refused():
    free = clutch(START, friction=0.0, means={})
    with pytest.raises(ValueError, match="rotation\\), and the loads cause this motion"):
        free.solve(
            pressures={"rim 1": 1.0},
            tractions={"rim 1": lambda x: np.array([-0.1 * x[1], 0.1 * x[0]])},
        )
    with pytest.raises(ValueError, match="prescribed mean motion must not be in contact"):
        clutch(START, means={"bore 1": Mean({"r": 0.0})})
