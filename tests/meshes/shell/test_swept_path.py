"""Strips and panels lie on their surfaces, with names, bodies and cells as specified."""

from math import pi, radians

import numpy as np
import pytest

from meshes.shell.panel import cylinder_panel, rectangle
from meshes.shell.strip import swept_path
from meshes.spring.path import accordion

WIDTH, RADIUS = 28.0, 0.5
SPRING = {"n": 4, "L1": 11.6, "radius": RADIUS, "alpha": radians(80), "tail": "arc"}
CELLS = {"width": WIDTH, "per_arc": 3, "per_leaf": 4, "across": 5}


def spring(**more):
    return swept_path(accordion(**SPRING), **CELLS | more)


def area(mesh):
    """Areas from the two diagonals of cells, which are nearly parallelograms."""
    a, b, c, d = mesh.points[mesh.cells[:, :4]].swapaxes(0, 1)
    return np.linalg.norm(np.cross(c - a, d - b), axis=1).sum() / 2


def test_cells_area_and_boundaries_are_those_of_the_path():
    mesh, pieces = spring(per_arc=24), list(accordion(**SPRING))
    arcs = sum(piece.kind == "arc" for piece in pieces)
    assert len(mesh.bodies["arcs"]) == arcs * 24 * 5
    assert len(mesh.bodies["leaves"]) == (len(pieces) - arcs) * 4 * 5
    everything = np.sort(np.concatenate(list(mesh.bodies.values())))
    np.testing.assert_array_equal(everything, np.arange(len(mesh.cells)))
    length = sum(piece.length for piece in pieces)
    assert area(mesh) == pytest.approx(length * WIDTH, rel=1e-4)
    last = list(accordion(**SPRING))[-1]
    for name, x, y in (("head", 0, 0), ("tail", *last.end)):
        at = mesh.points[np.unique(mesh.boundaries[name])]
        np.testing.assert_allclose(at[:, :2], np.broadcast_to((x, y), (11, 2)), atol=1e-12)
        np.testing.assert_allclose(mesh.points[mesh.nodes[name]], (x, y, 0), atol=1e-12)
    for name, z in (("middle", 0), ("edge", WIDTH)):
        np.testing.assert_allclose(mesh.points[mesh.boundaries[name], 2], z, atol=1e-12)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: spring(width=0.0), "width must be positive, got 0"),
        (lambda: spring(across=0), "per_arc, per_leaf and across must be at least 1"),
        (lambda: spring(finest=-1.0), "the finest cell size must be positive, got finest=-1"),
        (lambda: spring(leaf_ends=2.0), r"leaf_ends must lie in \(0, 1\], got 2"),
        (lambda: swept_path([], **CELLS), "a path must have at least one leaf or arc"),
        (lambda: rectangle(length=0.0, width=1.0, along=1, across=1),
         "length must be positive, got 0"),
        (lambda: cylinder_panel(radius=-1.0, angle=pi / 2, width=1.0, around=1, across=1),
         "got radius=-1, angle=90 deg"),
    ],
)  # fmt: skip
def test_wrong_numbers_are_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def lengths(mesh, name):
    """Of the edges of a boundary, by their chords."""
    a, b = mesh.points[mesh.boundaries[name][:, :2]].swapaxes(0, 1)
    return np.linalg.norm(b - a, axis=1)


def test_cells_shrink_to_the_finest_at_the_edge_and_leaves_to_their_ends():
    graded = spring(across=12, finest=0.1, per_leaf=12, leaf_ends=0.1)
    over = lengths(graded, "head")[np.argsort(graded.points[graded.boundaries["head"][:, 2], 2])]
    assert (np.diff(over) < 0).all()
    assert over[-1] == pytest.approx(0.1, rel=0.5)
    assert over.sum() == pytest.approx(WIDTH, rel=1e-12)
    leaf = lengths(graded, "middle")[:12]  # the head's
    assert leaf[0] == pytest.approx(leaf[-1], rel=1e-6)
    assert leaf[0] < 0.2 * leaf.max()
