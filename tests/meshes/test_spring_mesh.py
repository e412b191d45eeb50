"""Line and strip of the accordion spring against lengths, areas, positions found by hand.

From the head's middle a half leaf a = L1/2 and a quarter arc lead to the level a + R; each of the
n - 2 units then crosses to the level -(a + R) or back by an arc, a leaf and an arc.
"""

from math import cos, pi, sin

import numpy as np
import pytest

from meshes.spring.centre_line import centre_line
from meshes.spring.strip import strip
from tests.meshes.measures import measure

L1, R, ALPHA, B = 11.6, 0.5, 80 * pi / 180, 0.1  # the paper's spring [mm], R the centre line's
LEAF = (L1 + 2 * R * cos(ALPHA)) / sin(ALPHA)  # from level a + R cos(alpha) to minus that
every = pytest.mark.parametrize(("n", "tail"), [(3, "arc"), (4, "mid-leaf"), (10, "arc")])


def arcs(n):
    return pi * R + (n - 2) * 2 * R * ALPHA


def leaves(n, tail):
    return L1 / 2 * (2 if tail == "mid-leaf" else 1) + (n - 2) * LEAF


def tail_place(n, tail):
    """On the head's side of the axis for even n; at mid-leaf on the axis itself."""
    x = 2 * R + (n - 2) * (2 * R * sin(ALPHA) + LEAF * cos(ALPHA))
    return x, 0.0 if tail == "mid-leaf" else (L1 / 2 if n % 2 == 0 else -L1 / 2)


def line(n, tail="arc", per_arc=4, **changed):
    problem = {"n": n, "L1": L1, "radius": R, "alpha": ALPHA, "tail": tail} | changed
    return centre_line(**problem, per_arc=per_arc, per_leaf=3)


def sheet(n, tail="arc", per_arc=4, **changed):
    problem = {"n": n, "L1": L1, "radius": R, "alpha": ALPHA, "tail": tail, "b": B} | changed
    return strip(**problem, through=2, per_arc=per_arc, per_leaf=3)


def polyline_length(mesh, body):
    a, b, middle = np.moveaxis(mesh.points[mesh.elements[mesh.bodies[body]]], 1, 0)
    return np.hypot(*(middle - a).T).sum() + np.hypot(*(b - middle).T).sum()


@every
def test_the_line_is_one_chain_of_arcs_and_leaves_from_head_to_tail(n, tail):
    mesh = line(n, tail)
    assert set(mesh.nodes) == {"head", "tail"}
    np.testing.assert_allclose(mesh.points[mesh.nodes["head"]], (0, 0), atol=1e-12)
    np.testing.assert_allclose(mesh.points[mesh.nodes["tail"]], tail_place(n, tail), atol=1e-12)
    uses = np.bincount(mesh.elements[:, :2].ravel())
    assert sorted(np.flatnonzero(uses == 1)) == sorted(mesh.nodes.values())
    assert np.all(uses <= 2)
    assert len(mesh.points) == 2 * len(mesh.elements) + 1
    count = {"arcs": 2 + 2 * (n - 2), "leaves": n - 1 + (tail == "mid-leaf")}
    assert len(mesh.bodies["arcs"]) == 4 * count["arcs"]
    assert len(mesh.bodies["leaves"]) == 3 * count["leaves"]
    assert polyline_length(mesh, "leaves") == pytest.approx(leaves(n, tail), rel=1e-12)
    # eight chords an arc: each of the angle t is short by t^2 / 24, pi/16 at the quarters
    assert polyline_length(mesh, "arcs") == pytest.approx(arcs(n), rel=(pi / 16) ** 2 / 24)
    a, b, middle = np.moveaxis(mesh.points[mesh.elements[mesh.bodies["arcs"]]], 1, 0)
    chord, sagitta = np.hypot(*(b - a).T), np.hypot(*((a + b) / 2 - middle).T)
    np.testing.assert_allclose(sagitta / 2 + chord**2 / (8 * sagitta), R, rtol=1e-9)


@every
def test_the_strip_covers_its_line_and_its_faces_are_as_long_as_their_turns_make_them(n, tail):
    # Pappus: the area of a bent strip is the length of its middle times b
    mesh = sheet(n, tail)
    assert measure(mesh, "leaves") == pytest.approx(B * leaves(n, tail), rel=1e-12)
    coarse, fine = (
        measure(sheet(n, tail, per_arc=cells), "arcs") / (B * arcs(n)) - 1 for cells in (4, 8)
    )
    assert np.log2(coarse / fine) == pytest.approx(4, abs=0.05), (coarse, fine)
    assert set(mesh.boundaries) == {"head", "tail", "left", "right"}
    assert set(mesh.subdomains) == {"arcs", "leaves"}
    outline = np.concatenate(list(mesh.boundaries.values()))
    np.testing.assert_array_equal(np.sort(outline), np.flatnonzero(mesh.f2t[1] < 0))
    # an arc of angle t to the right is longer by t b/2 on the left; the effects of the quarters at
    # both ends add up for even n and cancel for odd n, those of other arcs cancel within each unit
    mesh, total = sheet(n, tail, per_arc=16), arcs(n) + leaves(n, tail)
    extra = pi * B / 2 if n % 2 == 0 else 0
    # quadratic edges of pi/32 are off by h^4 / 120
    rel = (pi / 32) ** 4 / 120
    assert measure(mesh, "left") == pytest.approx(total + extra, rel=rel)
    assert measure(mesh, "right") == pytest.approx(total - extra, rel=rel)
    for end in ("head", "tail"):
        assert measure(mesh, end) == pytest.approx(B, rel=1e-12)
