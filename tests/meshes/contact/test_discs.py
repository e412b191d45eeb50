"""Discs and rings: equal cells on whole circles, fine zones at the ends and crown of a roller."""

from math import cos, pi, radians, sin

import numpy as np
import pytest

from meshes.contact.block import block, full_block, half_block
from meshes.contact.disc import quarter_disc
from meshes.contact.race import half_race
from meshes.contact.roller import half_roller
from meshes.contact.round import full_disc, full_ring
from meshes.contact.tilted import placed, tilted_half_disc
from tests.meshes.measures import assert_unfolded, lengths, vertices

R_I, R_O, R = 0.02, 0.03, 0.005  # [m]


@pytest.mark.parametrize("around", [8, 80])
@pytest.mark.parametrize("make", [full_ring, full_disc])
def test_whole_circles_have_even_cells_with_corners_on_both_axes(make, around):
    size = {"r_i": R_I, "r_o": R_O, "across": 3} if make is full_ring else {"R": R_O}
    mesh = make(**size, around=around)
    assert_unfolded(mesh)
    for name in mesh.boundaries:
        radius = {"bore": R_I, "rim": R_O}[name]
        ends = mesh.p[:, mesh.facets[:, mesh.boundaries[name]]]
        assert ends.shape[2] == around
        np.testing.assert_allclose(lengths(mesh, name), 2 * radius * sin(pi / around), rtol=1e-7)
        found = {tuple(p) for p in (ends / radius).reshape(2, -1).T}
        assert {(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)} <= found


@pytest.mark.parametrize("tilt", [0.0, radians(0.3), radians(45), radians(-7)])
def test_a_tilted_half_disc_has_its_fine_cells_about_the_tilted_point(tilt):
    mesh = tilted_half_disc(R=R, tilt=tilt, zone=1e-4, refine=1, cells=8)
    near = np.sort(
        np.hypot(*(vertices(mesh, "surface") - R * np.array([[sin(tilt)], [cos(tilt)]])))
    )
    assert near[0] < 1e-12 * R
    # eight cells on each side, as long as the zone
    np.testing.assert_allclose(near[1:17:2], 1e-4 * np.arange(1, 9) / 8, rtol=1e-3)


def test_a_body_is_turned_anticlockwise_and_then_shifted():
    block = full_block(width=1.0, depth=1.0, zone=0.1, refine=1, above=True)
    moved = placed(block, turn=pi / 2, shift=(2.0, 3.0))
    np.testing.assert_allclose(moved.doflocs[0], 2 - block.doflocs[1], atol=1e-14)
    np.testing.assert_allclose(moved.doflocs[1], 3 + block.doflocs[0], atol=1e-14)
    assert set(moved.boundaries) == set(block.boundaries)
    assert set(moved.subdomains) == set(block.subdomains)


GOOD = {
    full_ring: {"r_i": R_I, "r_o": R_O, "around": 8, "across": 1},
    full_disc: {"R": R_O, "around": 8},
    half_roller: {"R": R, "zones": (1e-4, 1e-4), "refine": 1},
    tilted_half_disc: {"R": R, "tilt": 0.1, "zone": 1e-4, "refine": 1},
    block: {"x": (0.0, 1.0), "y": (0.0, 1.0), "nx": 1, "ny": 1},
    half_block: {"width": 1.0, "depth": 1.0, "zone": 0.1, "refine": 1},
    full_block: {"width": 1.0, "depth": 1.0, "zone": 0.1, "refine": 1},
    quarter_disc: {"R": 1.0, "zone": 0.03, "refine": 1},
    half_race: {"r_i": 1.0, "r_o": 1.3, "zone": 0.03, "refine": 1},
}


@pytest.mark.parametrize(
    ("make", "changed", "message"),
    [
        (full_ring, {"r_i": 0.0}, "0 < r_i < r_o"),
        (full_ring, {"around": 10}, "multiple of 4 .* around=10"),
        (full_ring, {"across": 0}, "one across.* across=0"),
        (full_disc, {"R": 0.0}, "R > 0"),
        (full_disc, {"around": 12}, "multiple of 8 .* around=12"),
        (half_roller, {"zones": (1e-4, 0.51 * R)}, r"the fine zones of a roller must have 0 <"),
        (tilted_half_disc, {"zone": 0.6 * R}, "0 < zone <= R/2"),
        (tilted_half_disc, {"tilt": 0.9}, "the tilt of a half disc must be at most 45"),
        (block, {"x": (1.0, 1.0)}, "a block requires rising x and y and nx, ny"),
        (block, {"nx": 0}, "nx=0"),
        (block, {"cells": "hex"}, "'quad' or 'tri', got 'hex'"),
        (half_block, {"width": 0.19}, "0 < zone <= width/2 and zone <= depth, got zone=0.1 m"),
        (half_block, {"refine": 0}, "a fine zone requires refine >= 1, got 0"),
        (quarter_disc, {"cells": 0}, "cells >= 1, got 0"),
        (half_race, {"r_o": 1.02}, "zone <= r_i/2 and zone < r_o - r_i"),
    ],
)
def test_sizes_that_do_not_fit_are_refused(make, changed, message):
    with pytest.raises(ValueError, match=message):
        make(**GOOD[make] | changed)


def test_both_ends_of_a_roller_have_even_cells_on_their_zones():
    cells, refine, zones = 4, 3, {"near": 1e-4, "far": 3e-4}
    mesh = half_roller(R=R, zones=tuple(zones.values()), refine=refine, cells=cells)
    for name, zone in zones.items():
        y = np.unique(vertices(mesh, name)[1])
        fine = y[y < zone * (1 + 1e-9)]
        assert fine.size == cells * refine + 1
        size = np.arcsin(zone / R) / (cells * refine)
        np.testing.assert_allclose(np.diff(np.arcsin(fine / R)), size, rtol=1e-6)
    for zones in ((R / 2, 1e-5), (1e-5, R / 2)):
        assert_unfolded(half_roller(R=R, zones=zones, refine=2))
