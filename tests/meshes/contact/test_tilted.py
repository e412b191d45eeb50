"""A half disc that touches beside its crown has its fine cells there, and its cut on y = 0."""

from math import cos, pi, radians, sin

import numpy as np
import pytest

from meshes.contact.block import full_block
from meshes.contact.tilted import placed, tilted_half_disc

R, ZONE = 0.01, 2e-4  # [m]
TILTS = [0.0, radians(0.3), radians(45), radians(-7)]


def place(tilt):
    return R * np.array([[sin(tilt)], [cos(tilt)]])


@pytest.mark.parametrize("tilt", TILTS)
def test_its_fine_cells_lie_about_the_tilted_point(tilt):
    mesh = tilted_half_disc(R=R, tilt=tilt, zone=ZONE, refine=1, cells=8)
    rim = mesh.p[:, np.unique(mesh.facets[:, mesh.boundaries["surface"]])]
    near = np.sort(np.hypot(*(rim - place(tilt))))
    assert near[0] < 1e-12 * R
    # eight cells on each side, as long as the zone
    np.testing.assert_allclose(near[1:17:2], ZONE * np.arange(1, 9) / 8, rtol=1e-3)


def test_a_body_is_turned_anticlockwise_and_then_shifted():
    block = full_block(width=1.0, depth=1.0, zone=0.1, refine=1, above=True)
    moved = placed(block, turn=pi / 2, shift=(2.0, 3.0))
    np.testing.assert_allclose(moved.doflocs[0], 2 - block.doflocs[1], atol=1e-14)
    np.testing.assert_allclose(moved.doflocs[1], 3 + block.doflocs[0], atol=1e-14)
    assert set(moved.boundaries) == set(block.boundaries)
    assert set(moved.subdomains) == set(block.subdomains)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"zone": 0.0}, "0 < zone <= R/2"),
        ({"zone": 0.6 * R}, "0 < zone <= R/2"),
        ({"tilt": 0.9}, "tilted by 45 degrees at most, got 51.5"),
        ({"tilt": float("nan")}, "tilted by 45 degrees"),
    ],
)
def test_what_makes_no_half_disc_is_refused(change, words):
    with pytest.raises(ValueError, match=words):
        tilted_half_disc(**{"R": R, "tilt": 0.1, "zone": ZONE, "refine": 1} | change)
