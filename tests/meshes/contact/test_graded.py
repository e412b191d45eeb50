"""Discs, blocks and races: fine contact zones, no folded cells, growth of cells as specified."""

from math import asin

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2

from meshes.contact.block import full_block, half_block
from meshes.contact.disc import half_disc, quarter_disc
from meshes.contact.grading import beta, cells_along, last_cell
from meshes.contact.race import half_race
from meshes.counts import at_least, nearest
from tests.meshes.measures import assert_unfolded, lengths

ZONE = 0.03
BODIES = {  # with their sizes and the radius of the touched surface
    "disc": (quarter_disc, {"R": 1.0}, 1.0),
    "halved disc": (half_disc, {"R": 1.0}, 1.0),
    "square": (half_block, {"width": 1.0, "depth": 1.2}, None),
    "slab": (half_block, {"width": 1.0, "depth": 0.2}, None),
    "column": (full_block, {"width": 0.2, "depth": 1.0}, None),
    "race": (half_race, {"r_i": 1.0, "r_o": 1.3}, 1.0),
}
EXTREMES = [
    *[("disc", {"zone": zone}) for zone in (1e-3, 0.5)],
    *[("disc", {"zone": 0.1, "cells": cells}) for cells in (1, 12)],
    *[("square", {"depth": d, "zone": 1e-3}) for d in (0.6, 1.5)],
    *[("slab", {"depth": d, "zone": 0.1}) for d in (0.1, 0.6)],
    *[("column", {"width": w, "zone": 1e-3}) for w in (0.05, 0.6)],
    *[("race", {"r_o": r_o, "zone": 1e-3}) for r_o in (1.1, 4.0)],
]


def body(name, **changed):
    make, sizes, _ = BODIES[name]
    return make(**{"zone": ZONE, "refine": 1} | sizes | changed)


def touched(mesh):
    """Name of the boundary that contains the origin and is no axis."""
    return "bore" if "bore" in mesh.boundaries else "surface"


def growth(mesh):
    """How much longer the longer of two neighbouring facets is, along the touched surface."""
    facets = np.asarray(mesh.boundaries[touched(mesh)])
    size, ends = np.tile(lengths(mesh, facets), 2), mesh.facets[:, facets].ravel()
    order = np.lexsort((size, ends))
    at, sizes = ends[order], size[order]
    twice = np.flatnonzero(at[1:] == at[:-1])
    return (sizes[twice + 1] / sizes[twice]).max()


def sides_and_angles(mesh):
    """Lengths of the four sides of every cell and its angles [deg], between its corners."""
    corners = mesh.p[:, mesh.t]
    ahead, back = (np.roll(corners, k, axis=1) - corners for k in (-1, 1))
    cosine = (ahead * back).sum(axis=0) / np.hypot(*ahead) / np.hypot(*back)
    return np.hypot(*ahead), np.degrees(np.arccos(cosine))


def slenderness(mesh):
    a, b, c, d = sides_and_angles(mesh)[0]
    ratio = (a + c) / (b + d)
    return np.maximum(ratio, 1 / ratio)


@pytest.mark.parametrize("name", BODIES)
def test_the_zone_has_even_cells_of_the_specified_number(name):
    refine, radius = 3, BODIES[name][2]
    mesh = body(name, refine=refine, cells=5)
    facets = np.asarray(mesh.boundaries[touched(mesh)])
    middles = mesh.p[:, mesh.facets[:, facets]].mean(axis=1)
    inside = facets[(middles[0] > 0) & (middles[0] < ZONE) & (abs(middles[1]) < ZONE)]
    assert inside.size == 5 * refine
    kinds = [type(body(name, **c)) for c in ({"order": 1}, {"order": 2}, {"straight": True})]
    assert kinds == [MeshQuad1, MeshQuad2, MeshQuad1]
    # chords of even arcs, or even lines
    angle = None if radius is None else asin(ZONE / radius) / (5 * refine)
    size = ZONE / (5 * refine) if angle is None else 2 * radius * np.sin(angle / 2)
    # gmsh finds even places on an arc by a numerical integral too
    np.testing.assert_allclose(lengths(mesh, inside), size, rtol=1e-8)


@pytest.mark.parametrize(("name", "changed"), EXTREMES, ids=str)
def test_no_cell_is_folded_slender_or_skewed_and_neighbours_grow_by_less_than_six_tenths(
    name, changed
):
    mesh = body(name, **changed)
    assert growth(mesh) < 1.6 + 1e-3  # chords of long arcs are not their lengths
    assert_unfolded(mesh)
    # n cells share half a right angle, pi/4 r / n wide and up to ln(1.6) r long: 3.6 for n = 6, and
    # more by the sides of a rectangle where it is no square
    n = changed.get("cells", 6)
    assert slenderness(mesh).max() < 3.6 * 1.5 * max(1, n / 6)
    angles = sides_and_angles(mesh)[1]
    # the blocks meet at half a right angle; a rectangle longer than wide, or a ring four times as
    # wide as its bore, bends that
    least, most = (45, 140) if name == "disc" else (20, 160)
    assert least < angles.min()
    assert angles.max() < most


def places(length, n, b):
    """Roberts' stretching in closed form, at n + 1 even parameters."""
    ratio = ((b + 1) / (b - 1)) ** (1 - np.arange(n + 1) / n)
    return length * ((b + 1) - (b - 1) * ratio) / (ratio + 1)


@pytest.mark.parametrize(
    ("length", "first", "growth"),
    [(1.0, 0.1, 1.6), (1.0, 1e-4, 1.6), (500.0, 1.0, 1.2), (3.0, 2.5, 2.0)],
)
def test_cells_grow_by_no_more_than_specified_and_start_with_their_size(length, first, growth):
    n = cells_along(length=length, first=first, growth=growth)
    b = beta(length=length, first=first, cells=n)
    sizes = np.diff(places(length, n, b))
    assert (sizes[1:] / sizes[:-1]).max(initial=1) < growth * (1 + 1e-9)
    # the size at the very start, where a map of many more cells has it
    many = np.diff(places(length, 10_000 * n, b))
    assert many[0] * 10_000 == pytest.approx(first, rel=1e-3)
    assert last_cell(length=length, cells=n, beta=b) == pytest.approx(sizes[-1], rel=1e-9)


@pytest.mark.parametrize("off", [-1e-13, 0.0, 1e-13])
def test_round_off_of_a_ratio_does_not_change_the_number_of_cells(off):
    assert at_least(4000 * (1 + off)) == nearest(4000 * (1 + off)) == 4000
    assert nearest(12.5 * (1 + off)) == 13
    assert (at_least(0.3 + off), at_least(11.001 + off)) == (1, 12)
    assert (nearest(0.3 + off), nearest(11.001 + off)) == (0, 11)
