"""A sector of discs between a hub and a ring, with friction and torque, against the whole."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from skfem import MeshTri1, MeshTri2

from fem.contact.pairs import Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle
from fem.plane.material import Elastic
from fem.plane.means import Mean
from fem.plane.ties import Tie
from tests.fem.cyclic_rings import apart, beside, ring, sector, turned

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
    # the mean's moment is the whole's share, and goes through the contacts to the bore
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
    with pytest.raises(ValueError, match="rotation\\), and the loads do move it"):
        free.solve(
            pressures={"rim 1": 1.0},
            tractions={"rim 1": lambda x: np.array([-0.1 * x[1], 0.1 * x[0]])},
        )
    with pytest.raises(ValueError, match="whose mean motion is held cannot be in contact as well"):
        clutch(START, means={"bore 1": Mean({"r": 0.0})})
