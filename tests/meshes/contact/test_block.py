"""Rectangular blocks have the corners, names, areas and normals of rectangles."""

import numpy as np
import pytest
from skfem import (
    MeshQuad2,
    MeshTri1,
)

from meshes.contact.block import block, full_block, half_block
from tests.meshes.measures import measure, nodes


@pytest.mark.parametrize(
    ("cells", "order", "shape"),
    [("quad", 2, MeshQuad2), ("tri", 1, MeshTri1)],
)
def test_an_even_block_has_the_cells_asked_for_and_the_names_of_its_sides(cells, order, shape):
    mesh = block(x=(-1.0, 2.0), y=(0.5, 1.0), nx=3, ny=4, cells=cells, order=order)
    assert type(mesh) is shape
    assert mesh.nelements == (24 if cells == "tri" else 12)
    assert set(mesh.subdomains) == {"block"}
    outline = {"left": ("x", 0), "right": ("x", 1), "bottom": ("y", 0), "top": ("y", 1)}
    assert set(mesh.boundaries) == set(outline)
    assert measure(mesh) == pytest.approx(1.5, rel=1e-12)
    for name, (axis, end) in outline.items():
        place = {"x": (-1.0, 2.0), "y": (0.5, 1.0)}[axis][end]
        np.testing.assert_allclose(nodes(mesh, name)["xy".index(axis)], place, atol=1e-12)
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
        ({"nx": 0}, "nx=0"),
        ({"cells": "hex"}, "'quad' or 'tri', got 'hex'"),
    ],
)
def test_a_block_that_is_none_is_refused(changed, message):
    with pytest.raises(ValueError, match=message):
        block(**{"x": (0.0, 1.0), "y": (0.0, 1.0), "nx": 1, "ny": 1} | changed)


@pytest.mark.parametrize(
    ("shape", "width", "depth"), [(half_block, 0.19, 1.0), (full_block, 1.0, float("inf"))]
)
def test_a_graded_block_without_room_for_its_zone_is_refused(shape, width, depth):
    with pytest.raises(ValueError, match=r"0 < zone <= width/2 and zone <= depth, got zone=0.1 m"):
        shape(width=width, depth=depth, zone=0.1, refine=1)
