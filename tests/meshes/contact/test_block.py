"""Rectangular blocks have the corners, names, areas and normals of rectangles."""

import numpy as np
import pytest
from skfem import (
    Basis,
    ElementQuad1,
    ElementTriP1,
    FacetBasis,
    Functional,
    MeshQuad1,
    MeshQuad2,
    MeshTri1,
    MeshTri2,
)

from meshes.contact.block import block, full_block, half_block

ROUND_OFF = 1e-12  # relative
SIZES = [(1.0, 1.0), (1.0, 1.4), (1.0, 5.0), (5.0, 1.0)]  # square, by one fan, and with a strip
every_size = pytest.mark.parametrize(("width", "depth"), SIZES)
sides = pytest.mark.parametrize("above", [False, True], ids=["below", "above"])


@Functional
def one(w):
    return 1.0 + 0 * w.x[0]


def element(mesh):
    return ElementTriP1() if isinstance(mesh, MeshTri1) else ElementQuad1()


def area(mesh):
    return one.assemble(Basis(mesh, element(mesh), intorder=4))


def side(mesh, name):
    return FacetBasis(mesh, element(mesh), intorder=4, facets=mesh.boundaries[name])


def check_rectangle(mesh, x, y, outline):
    """Each name of `outline` is a whole side of the rectangle, with its normal."""
    ends = {"x": x, "y": y}
    assert area(mesh) == pytest.approx((x[1] - x[0]) * (y[1] - y[0]), rel=ROUND_OFF)
    named = np.concatenate([mesh.boundaries[name] for name in outline])
    np.testing.assert_array_equal(np.sort(named), mesh.boundary_facets())
    for name, (axis, end) in outline.items():
        k, edge = "xy".index(axis), side(mesh, name)
        scale = max(map(abs, (*x, *y)))
        place = ends[axis][end]
        np.testing.assert_allclose(
            np.asarray(edge.global_coordinates())[k], place, atol=ROUND_OFF * scale
        )
        np.testing.assert_allclose(edge.normals[k], 2 * end - 1, atol=ROUND_OFF)
        across = ends["yx"[k]]
        assert one.assemble(edge) == pytest.approx(across[1] - across[0], rel=ROUND_OFF)


@every_size
@sides
def test_the_half_block_fills_its_rectangle_and_names_its_sides(width, depth, above):
    mesh = half_block(width=width, depth=depth, zone=0.1, refine=1, above=above)
    assert set(mesh.subdomains) == {"block"}
    outline = {"axis": ("x", 0), "side": ("x", 1), "surface": ("y", 1), "bottom": ("y", 0)}
    if above:
        outline |= {"surface": ("y", 0), "bottom": ("y", 1)}
    assert set(mesh.boundaries) == set(outline)
    check_rectangle(mesh, (0, width), (0, depth) if above else (-depth, 0), outline)


@every_size
@sides
def test_the_full_block_fills_its_rectangle_and_names_its_sides(width, depth, above):
    mesh = full_block(width=width, depth=depth, zone=0.1, refine=1, above=above)
    outline = {"left": ("x", 0), "right": ("x", 1), "surface": ("y", 1), "bottom": ("y", 0)}
    if above:
        outline |= {"surface": ("y", 0), "bottom": ("y", 1)}
    assert set(mesh.boundaries) == {*outline, "axis"}
    y = (0, depth) if above else (-depth, 0)
    check_rectangle(mesh, (-width, width), y, outline)
    axis = np.asarray(side(mesh, "axis").global_coordinates())
    np.testing.assert_allclose(axis[0], 0, atol=ROUND_OFF)
    assert one.assemble(side(mesh, "axis")) == pytest.approx(depth, rel=ROUND_OFF)


@every_size
def test_the_full_block_is_two_half_blocks_grown_together(width, depth):
    half, full = (
        shape(width=width, depth=depth, zone=0.1, refine=2) for shape in (half_block, full_block)
    )
    on_axis = np.unique(half.facets[:, half.boundaries["axis"]]).size
    assert full.nelements == 2 * half.nelements
    assert full.nvertices == 2 * half.nvertices - on_axis


@pytest.mark.parametrize(
    ("cells", "order", "shape"),
    [("quad", 1, MeshQuad1), ("quad", 2, MeshQuad2), ("tri", 1, MeshTri1), ("tri", 2, MeshTri2)],
)
def test_an_even_block_has_the_cells_asked_for_and_the_names_of_its_sides(cells, order, shape):
    mesh = block(x=(-1.0, 2.0), y=(0.5, 1.0), nx=3, ny=4, cells=cells, order=order)
    assert type(mesh) is shape
    assert mesh.nelements == (24 if cells == "tri" else 12)
    assert set(mesh.subdomains) == {"block"}
    outline = {"left": ("x", 0), "right": ("x", 1), "bottom": ("y", 0), "top": ("y", 1)}
    assert set(mesh.boundaries) == set(outline)
    check_rectangle(mesh, (-1.0, 2.0), (0.5, 1.0), outline)
    for name, count in {"left": 4, "right": 4, "bottom": 3, "top": 3}.items():
        assert mesh.boundaries[name].size == count
        a, b = mesh.p[:, mesh.facets[:, mesh.boundaries[name]]].swapaxes(0, 1)
        length = {4: 0.5 / 4, 3: 3.0 / 3}[count]
        np.testing.assert_allclose(np.hypot(*(b - a)), length, rtol=1e-9)


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"x": (1.0, 1.0)}, "growing x and y"),
        ({"y": (1.0, 0.0)}, "growing x and y"),
        ({"x": (0.0, float("nan"))}, "growing x and y"),
        ({"x": (0.0, float("inf"))}, "growing x and y"),
        ({"nx": 0}, "nx=0"),
        ({"ny": -1}, "ny=-1"),
        ({"cells": "hex"}, "'quad' or 'tri', got 'hex'"),
    ],
)
def test_a_block_that_is_none_is_refused(changed, message):
    with pytest.raises(ValueError, match=message):
        block(**{"x": (0.0, 1.0), "y": (0.0, 1.0), "nx": 1, "ny": 1} | changed)


@pytest.mark.parametrize("shape", [half_block, full_block])
@pytest.mark.parametrize(
    ("width", "depth"), [(0.19, 1.0), (1.0, 0.09), (float("nan"), 1.0), (1.0, float("inf"))]
)
def test_a_graded_block_without_room_for_its_zone_is_refused(shape, width, depth):
    with pytest.raises(ValueError, match=r"0 < zone <= width/2 and zone <= depth, got zone=0.1 m"):
        shape(width=width, depth=depth, zone=0.1, refine=1)
