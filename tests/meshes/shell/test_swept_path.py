"""Strips and panels lie on their surfaces, with names, bodies and cells where they were asked."""

from math import pi, radians

import numpy as np
import pytest

from meshes.shell.panel import cylinder_panel, rectangle
from meshes.shell.strip import swept_path
from meshes.spring.path import Piece, accordion

WIDTH, RADIUS = 28.0, 0.5
SPRING = {"n": 4, "L1": 11.6, "radius": RADIUS, "alpha": radians(80), "tail": "arc"}
CELLS = {"width": WIDTH, "per_arc": 3, "per_leaf": 4, "across": 5}


def spring(**more):
    return swept_path(accordion(**SPRING), **CELLS | more)


def lengths(mesh, name):
    """Of the edges of a boundary, by their chords."""
    a, b = mesh.points[mesh.boundaries[name][:, :2]].swapaxes(0, 1)
    return np.linalg.norm(b - a, axis=1)


def area(mesh):
    """By the two diagonals of cells nearly parallelograms."""
    a, b, c, d = mesh.points[mesh.cells[:, :4]].swapaxes(0, 1)
    return np.linalg.norm(np.cross(c - a, d - b), axis=1).sum() / 2


@pytest.fixture(scope="module")
def mesh():
    return spring()


def test_every_piece_has_its_cells(mesh):
    pieces = list(accordion(**SPRING))
    arcs = sum(piece.kind == "arc" for piece in pieces)
    assert len(mesh.bodies["arcs"]) == arcs * 3 * 5
    assert len(mesh.bodies["leaves"]) == (len(pieces) - arcs) * 4 * 5
    everything = np.sort(np.concatenate(list(mesh.bodies.values())))
    np.testing.assert_array_equal(everything, np.arange(len(mesh.cells)))


def test_nodes_are_shared_between_pieces(mesh):
    along, over = 2 * (len(mesh.cells) // 5) + 1, 2 * 5 + 1
    assert len(mesh.points) == along * over


def test_the_area_is_the_path_s_length_times_the_width():
    fine = spring(per_arc=24)
    length = sum(piece.length for piece in accordion(**SPRING))
    assert area(fine) == pytest.approx(length * WIDTH, rel=1e-4)


def test_boundaries_are_where_their_names_say(mesh):
    last = list(accordion(**SPRING))[-1]
    for name, x, y in (("head", 0, 0), ("tail", *last.end)):
        at = mesh.points[np.unique(mesh.boundaries[name])]
        np.testing.assert_allclose(at[:, :2], np.broadcast_to((x, y), (11, 2)), atol=1e-12)
        np.testing.assert_allclose(mesh.points[mesh.nodes[name]], (x, y, 0), atol=1e-12)
    for name, z in (("middle", 0), ("edge", WIDTH)):
        np.testing.assert_allclose(mesh.points[mesh.boundaries[name], 2], z, atol=1e-12)


def test_every_node_of_an_arc_lies_on_it():
    panel = cylinder_panel(radius=25.0, angle=0.7, width=10.0, around=4, across=3)
    np.testing.assert_allclose(np.hypot(*panel.points[:, :2].T), 25, rtol=1e-14)
    head = panel.points[np.unique(panel.boundaries["head"])]
    np.testing.assert_allclose(head[:, :2], np.broadcast_to((0, 25), (7, 2)), atol=1e-13)
    tail = panel.points[np.unique(panel.boundaries["tail"])]
    np.testing.assert_allclose(
        tail[:, :2], np.broadcast_to((25 * np.sin(0.7), 25 * np.cos(0.7)), (7, 2)), atol=1e-12
    )


def test_middle_nodes_lie_between_their_ends_and_the_centre_between_them():
    flat = rectangle(length=3.0, width=2.0, along=3, across=2)
    corner = flat.points[flat.cells[:, :4]]
    np.testing.assert_allclose(
        flat.points[flat.cells[:, 4:8]], (corner + np.roll(corner, -1, axis=1)) / 2, atol=1e-14
    )
    np.testing.assert_allclose(flat.points[flat.cells[:, 8]], corner.mean(axis=1), atol=1e-14)
    ends, middle = flat.boundaries["head"][:, :2], flat.boundaries["head"][:, 2]
    np.testing.assert_allclose(flat.points[middle], flat.points[ends].mean(axis=1), atol=1e-14)


def test_normals_keep_to_the_right_of_the_path(mesh):
    a, b, c, d = mesh.points[mesh.cells[:, :4]].swapaxes(0, 1)
    normal = np.cross(c - a, d - b)
    first = mesh.bodies["leaves"][:20]  # the head's leaf, heading along y
    assert (normal[first, 0] > 0).all()
    tangent = np.cross(normal, (0, 0, 1))[:, :2]
    heading = ((b + c) / 2 - (a + d) / 2)[:, :2], ((c + d) / 2 - (a + b) / 2)[:, :2]
    along = np.where(np.linalg.norm(heading[0], axis=1)[:, None] > 1e-9, *heading)
    assert len(np.unique(np.sign(np.einsum("mc,mc->m", tangent, along)))) == 1


def test_cells_shrink_to_the_finest_at_the_edge_and_leaves_to_their_ends():
    graded = spring(across=12, finest=0.1, per_leaf=12, leaf_ends=0.1)
    over = lengths(graded, "head")[np.argsort(graded.points[graded.boundaries["head"][:, 2], 2])]
    assert (np.diff(over) < 0).all()
    assert over[-1] == pytest.approx(0.1, rel=0.5)
    assert over.sum() == pytest.approx(WIDTH, rel=1e-12)
    leaf = lengths(graded, "middle")[:12]  # the head's
    assert leaf[0] == pytest.approx(leaf[-1], rel=1e-6)
    assert leaf[0] < 0.2 * leaf.max()


def test_the_edge_is_never_finer_than_even_cells_would_be():
    np.testing.assert_allclose(lengths(spring(finest=9.0), "head"), WIDTH / 5, rtol=1e-12)


def test_refined_cells_halve_the_coarse_ones():
    coarse = spring(finest=0.4, leaf_ends=0.2)
    fine = spring(per_arc=6, per_leaf=8, across=10, finest=0.2, leaf_ends=0.2)
    corners = {tuple(p) for p in fine.points[np.unique(fine.cells[:, :4])].round(5)}
    assert all(tuple(p) in corners for p in coarse.points[np.unique(coarse.cells[:, :4])].round(5))


def test_a_path_may_lead_anywhere():
    hook = [
        Piece("leaf", 1.0, 2.0, 0.0, 3.0, 0.0, 1),
        Piece("arc", 4.0, 2.0, 0.0, pi / 2, pi / 2, 1),
        Piece("arc", 5.0, 3.0, pi / 2, pi / 2, -pi / 2, 1),
    ]
    mesh = swept_path(hook, width=2.0, per_arc=4, per_leaf=2, across=1)
    tail = mesh.points[np.unique(mesh.boundaries["tail"])]
    np.testing.assert_allclose(tail[:, :2], np.broadcast_to((6, 4), (3, 2)), atol=1e-12)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"width": 0.0}, "width must be positive, got 0"),
        ({"across": 0}, "needs one cell or more along each piece and across, got 0"),
        ({"finest": -1.0}, "finest must be positive, got -1"),
        ({"leaf_ends": 2.0}, r"leaf_ends must lie in \(0, 1\], got 2"),
    ],
)
def test_wrong_numbers_are_refused(change, message):
    with pytest.raises(ValueError, match=message):
        spring(**change)


def test_panels_without_extent_are_refused():
    with pytest.raises(ValueError, match="a path needs a leaf or an arc"):
        swept_path([], **CELLS)
    with pytest.raises(ValueError, match="length must be positive, got 0"):
        rectangle(length=0.0, width=1.0, along=1, across=1)
    with pytest.raises(ValueError, match="got radius=-1, angle=90 deg"):
        cylinder_panel(radius=-1.0, angle=pi / 2, width=1.0, around=1, across=1)
