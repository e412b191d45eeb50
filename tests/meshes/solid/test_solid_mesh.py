"""Hexahedra of strips and blocks against volumes, areas and positions calculated by hand."""

from math import pi, radians

import numpy as np
import pytest

from fem.solid.geometry import cube_rule, faces, jacobians
from fem.solid.places import nodes_at
from meshes.solid.block import solid_block
from meshes.solid.grading import levels
from meshes.solid.strip import solid_strip
from meshes.spring.path import Piece, accordion

B, WIDTH, R = 0.1, 3.0, 0.5  # any
QUARTER = Piece("arc", 0.0, 0.0, pi / 2, R * pi / 2, -pi / 2, 1)
CELLS = {"through": 2, "per_arc": 4, "per_leaf": 3, "across": 3}
SPRING = list(accordion(n=4, L1=11.6, radius=R, alpha=radians(80), tail="arc"))
ROUND_OFF = 1e-9  # gmsh puts points with errors up to 1e-8 of a cell


def sheet(pieces=(QUARTER,), **changed):
    return solid_strip(pieces, b=B, width=WIDTH, **CELLS | changed)


def volume(mesh, cells=slice(None)):
    X, weight = cube_rule((4, 4, 4))
    return float((abs(jacobians(mesh, X)[1]) @ weight)[cells].sum())


def area(mesh, name):
    parts = faces(mesh, mesh.boundaries[name])
    return sum(np.linalg.norm(part.area, axis=-1).sum() for part in parts)


@pytest.mark.parametrize("order", [1, 2])
def test_a_block_has_its_volume_its_sides_and_cells_that_follow_the_axes(order):
    mesh = solid_block(x=(1, 3), y=(0, 5), z=(-1, 2), cells=(2, 3, 4), order=order)
    assert mesh.nelements == 24
    assert volume(mesh) == pytest.approx(30, rel=1e-12)
    assert mesh.subdomains["block"].size == 24
    J = jacobians(mesh, np.full((3, 1), 0.5))[0][:, 0]
    size = np.diag([1, 5 / 3, 3 / 4])
    assert np.broadcast_to(size, J.shape) == pytest.approx(J, abs=ROUND_OFF)
    for axis, (low, high) in enumerate([(1, 3), (0, 5), (-1, 2)]):
        for end, place in enumerate((low, high)):
            name = f"{'xyz'[axis]}={end}"
            assert mesh.doflocs[axis, nodes_at(mesh, name)] == pytest.approx(place, abs=1e-12)
            assert area(mesh, name) == pytest.approx(30 / (2, 5, 3)[axis])


def test_the_volume_of_an_arc_converges_with_order_4_and_with_straight_edges_2():
    exact = R * pi / 2 * B * WIDTH
    for straight, order in ((False, 4), (True, 2)):
        error = [abs(volume(sheet(per_arc=n, straight=straight)) / exact - 1) for n in (4, 8)]
        assert np.log2(error[0] / error[1]) == pytest.approx(order, abs=0.05)


def test_a_spring_has_its_volume_its_walls_and_its_names():
    mesh = sheet(SPRING, per_arc=16)
    length = {kind: sum(p.length for p in SPRING if p.kind == kind) for kind in ("arc", "leaf")}
    for name, kind in (("arcs", "arc"), ("leaves", "leaf")):
        own = volume(mesh, mesh.subdomains[name])
        assert own == pytest.approx(length[kind] * B * WIDTH, rel=1e-6)
    total = sum(length.values())
    expected = {
        "head": B * WIDTH, "tail": B * WIDTH, "middle": total * B, "edge": total * B,
    }  # fmt: skip
    assert set(mesh.boundaries) == {*expected, "left", "right"}
    assert {name: area(mesh, name) for name in expected} == pytest.approx(expected, rel=1e-6)
    assert area(mesh, "left") + area(mesh, "right") == pytest.approx(2 * total * WIDTH, rel=1e-6)
    outer = sum(f.size for f in mesh.boundaries.values())
    assert outer == np.count_nonzero(mesh.f2t[1] < 0)


def test_cells_shrink_towards_the_edge_by_the_grading_and_halve_on_one_map():
    sizes = np.diff([0.0, *levels(8, 100.0)])
    assert sizes[0] / sizes[-1] == pytest.approx(100 ** (7 / 8))
    assert sizes[:-1] / sizes[1:] == pytest.approx(100 ** (1 / 8))
    assert levels(16, 100.0)[1::2] == pytest.approx(levels(8, 100.0))
    assert levels(4, 1.0) == pytest.approx([0.25, 0.5, 0.75, 1.0])
    mesh = sheet(across=4, grading=9.0)
    z = np.unique(np.round(mesh.doflocs[2], 6))[::2]
    assert z / WIDTH == pytest.approx([0.0, *levels(4, 9.0)], abs=1e-6)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: sheet(()), "at least one leaf or arc"),
        (lambda: sheet(across=0),
         "must be >= 1, got through, per_arc, per_leaf, across = 2, 4, 3, 0"),
        (lambda: sheet(grading=0.5), "got grading=0.5"),
        (lambda: sheet([Piece("arc", 0, 0, 0, 0.05, 1.2, 1)]),
         "the radius of an arc must be above b/2, got"),
        (lambda: solid_strip([QUARTER], b=0.0, width=1.0, **CELLS),
         "b > 0 and width > 0, got b=0 m, width=1 m"),
        (lambda: solid_block(x=(0, 1), y=(1, 1), z=(0, 1), cells=(1, 1, 1)),
         "a block requires rising x, y, z and at least one cell"),
    ],
)  # fmt: skip
def test_wrong_input_gets_one_clear_line(make, words):
    with pytest.raises(ValueError, match=words):
        make()
