"""Meshes of mapped blocks have constant topology while nodes move, and equal new meshes."""

import numpy as np
import pytest

from meshes.contact import blocks
from meshes.contact.block import block, half_block
from meshes.polyhedral.half_sector import half_sector
from meshes.topology import Topologies, Topology

KEPT = blocks.TOPOLOGIES
RING = {"z": 6, "d_e": 80.0, "d_i": 72.0, "fillet": 2.0, "refine": 1}
POINTS = {
    "ring": lambda: half_sector(**RING),
    "moved": lambda: half_sector(**RING | {"d_i": 72.01, "fillet": 1.999}),
    "zone": lambda: half_sector(**RING, zone=1.0),
    "hub": lambda: half_sector(**RING, hub=(9.0, 10.0)),
    "linear": lambda: half_sector(**RING, order=1),
    "straight": lambda: half_sector(**RING, straight=True),
    "block": lambda: half_block(width=3.0, depth=2.0, zone=0.1, refine=1),
    "above": lambda: half_block(width=3.0, depth=2.0, zone=0.1, refine=1, above=True),
    "tri": lambda: block(x=(0.0, 2.0), y=(0.0, 1.0), nx=3, ny=2, cells="tri"),
    "quad": lambda: block(x=(0.0, 2.0), y=(0.0, 1.0), nx=3, ny=2),
    "transposed": lambda: block(x=(0.0, 2.0), y=(0.0, 1.0), nx=2, ny=3),
}


@pytest.fixture(autouse=True)
def forgotten():
    """Nothing stored by other tests."""
    KEPT.kept.clear()


def alone(name):
    KEPT.kept.clear()
    return POINTS[name]()


def same(one, other):
    """Whether two meshes are one to the last bit, with all names."""
    return (
        type(one) is type(other)
        and all(
            np.array_equal(getattr(one, part), getattr(other, part))
            for part in ("doflocs", "t", "facets", "t2f", "f2t")
        )
        and np.array_equal(one.dofs.element_dofs, other.dofs.element_dofs)
        and all(
            list(a) == list(b) and all(np.array_equal(a[name], b[name]) for name in a)
            for a, b in ((one.boundaries, other.boundaries), (one.subdomains, other.subdomains))
        )
    )


def test_a_mesh_does_not_depend_on_those_made_before():
    expected = {name: alone(name) for name in POINTS}
    for order in (list(POINTS), list(POINTS)[::-1], sorted(POINTS) * 2):
        KEPT.kept.clear()
        for name in order:
            assert same(POINTS[name](), expected[name]), name


def test_a_moved_mesh_shares_what_does_not_move():
    ring, moved = POINTS["ring"](), POINTS["moved"]()
    assert len(KEPT.kept) == 1
    assert moved.t is ring.t
    assert moved.facets is ring.facets
    assert np.abs(moved.p - ring.p).max() > 0.002
    # maps of cells belong to the nodes
    assert moved.mapping() is not ring.mapping()
    assert ring.mapping().mesh is ring


def test_no_more_than_the_last_few_are_stored():
    few, made = Topologies(most=2, nodes=100), []

    def get(key, nodes=1):
        def make():
            made.append(key)
            return Topology(None, np.zeros(nodes, int))

        return few.get(key, make)

    for key in "abacab":
        get(key)
    assert made == ["a", "b", "c", "b"]
    assert list(few.kept) == ["a", "b"]
    get("large", 101)  # is not stored, and removes nothing
    assert list(few.kept) == ["a", "b"]
    get("wide", 100)
    assert list(few.kept) == ["wide"]
