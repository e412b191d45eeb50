"""Any plane gmsh model is read with its names, areas, outlines and normals."""

from math import pi

import gmsh
import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from meshes.plane import plane_mesh
from meshes.session import gmsh_session
from tests.meshes.measures import measure, side

KINDS = {"tri3": MeshTri1, "tri6": MeshTri2, "quad4": MeshQuad1, "quad9": MeshQuad2}
ROUND_OFF = 1e-12  # relative
curved_kinds = pytest.mark.parametrize("kind", ["tri6", "quad9"])


def generate(kind, straight=False):
    if "quad" in kind:
        for _, surface in gmsh.model.getEntities(2):
            gmsh.model.mesh.setRecombine(2, surface)
        gmsh.option.setNumber("Mesh.RecombinationAlgorithm", 2)  # leaves no triangle
    gmsh.model.mesh.generate(2)
    gmsh.model.mesh.setOrder(2 if kind in ("tri6", "quad9") else 1)
    return plane_mesh(straight=straight)


def two_rooms(kind, reverse=False):
    """A house of corners (0, 0), (3, 0), (3, 1), (1, 2), (0, 1), split along x = 1 up to (1, 2).

    Its surfaces and curves carry high and scattered tags; a stray point belongs to neither.
    """
    with gmsh_session():
        geo = gmsh.model.geo
        geo.addPoint(9, 9, 0, tag=500)
        spots = [(0, 0), (1, 0), (3, 0), (3, 1), (1, 2), (0, 1)]
        corner = [geo.addPoint(*p, 0, 0.4, tag=7 * k + 3) for k, p in enumerate(spots)]
        side = [geo.addLine(corner[k], corner[(k + 1) % 6], tag=100 - 9 * k) for k in range(6)]
        wall = geo.addLine(corner[1], corner[4], tag=1)
        west, east = [side[0], wall, side[4], side[5]], [side[1], side[2], side[3], -wall]
        if reverse:
            west, east = ([-c for c in loop[::-1]] for loop in (west, east))
        geo.addPlaneSurface([geo.addCurveLoop(west)], tag=70)
        geo.addPlaneSurface([geo.addCurveLoop(east)], tag=31)
        geo.synchronize()
        gmsh.model.addPhysicalGroup(2, [70], tag=8, name="west room")
        gmsh.model.addPhysicalGroup(2, [31], tag=2, name="east room")
        gmsh.model.addPhysicalGroup(2, [31, 70], tag=40, name="house")
        named = {"floor": side[:2], "east": side[2:3], "roof": side[3:5], "west": side[5:]}
        for name, curves in (named | {"wall": [wall]}).items():
            gmsh.model.addPhysicalGroup(1, curves, name=name)
        return generate(kind)


def plate_with_hole(kind, size, straight=False):
    """The unit square about a round hole of radius 0.3."""
    with gmsh_session():
        occ = gmsh.model.occ
        square = occ.addRectangle(-0.5, -0.5, 0, 1, 1)
        hole = occ.addDisk(0, 0, 0, 0.3, 0.3)
        occ.cut([(2, square)], [(2, hole)])
        occ.synchronize()
        gmsh.option.setNumber("Mesh.MeshSizeMax", size)
        rim = [
            tag for _, tag in gmsh.model.getEntities(1)
            if np.ptp(np.reshape(gmsh.model.getBoundingBox(1, tag), (2, 3))[:, :2]) < 0.7
        ]  # fmt: skip
        gmsh.model.addPhysicalGroup(1, rim, name="hole")
        return generate(kind, straight)


@pytest.mark.parametrize("kind", KINDS)
def test_names_areas_lengths_and_nodes_come_over(kind):
    mesh = two_rooms(kind)
    assert type(mesh) is KINDS[kind]
    assert set(mesh.subdomains) == {"west room", "east room", "house"}
    # trapezoids: (1 + 2) / 2 * 1 and (2 + 1) / 2 * 2
    for body, exact in (("west room", 1.5), ("east room", 3.0), ("house", 4.5), ("", 4.5)):
        assert measure(mesh, body) == pytest.approx(exact, rel=ROUND_OFF)
    centres = mesh.doflocs[0, mesh.t].mean(axis=0)
    assert (centres[mesh.subdomains["west room"]] < 1).all()
    assert (centres[mesh.subdomains["east room"]] > 1).all()
    on = {
        "floor": (3, lambda x, y: y),
        "east": (1, lambda x, y: x - 3),
        "roof": (np.sqrt(2) + np.sqrt(5), lambda x, y: y - np.minimum(1 + x, 2.5 - x / 2)),
        "west": (1, lambda x, y: x),
        "wall": (2, lambda x, y: x - 1),
    }
    assert set(mesh.boundaries) == set(on)
    for name, (exact, distance) in on.items():
        assert measure(mesh, name) == pytest.approx(exact, rel=ROUND_OFF)
        points = np.asarray(side(mesh, name).global_coordinates())
        np.testing.assert_allclose(distance(*points), 0, atol=ROUND_OFF)
    np.testing.assert_array_equal(np.unique(mesh.t), np.arange(mesh.nvertices))
    # Euler: corners - edges + cells = 1 in one piece without holes
    assert mesh.nvertices - mesh.nfacets + mesh.nelements == 1
    nodes = mesh.nvertices
    nodes += {"tri6": mesh.nfacets, "quad9": mesh.nfacets + mesh.nelements}.get(kind, 0)
    assert mesh.doflocs.shape == (2, nodes)
    assert mesh.doflocs.max() == 3.0  # the stray point at (9, 9) stayed behind


@curved_kinds
def test_curved_cells_follow_the_circle_at_order_four_and_chords_at_order_two(kind):
    exact = {"area": 1 - pi * 0.3**2, "length": 2 * pi * 0.3}

    def errors(size, straight):
        mesh = plate_with_hole(kind, size, straight)
        found = {"area": measure(mesh), "length": measure(mesh, "hole")}
        edges = len(mesh.boundaries["hole"])
        return edges, {name: found[name] - exact[name] for name in exact}

    for straight, order in ((False, 4), (True, 2)):
        (few, coarse), (many, fine) = (errors(size, straight) for size in (0.1, 0.05))
        for name in exact:
            observed = np.log(abs(coarse[name] / fine[name])) / np.log(many / few)
            assert observed == pytest.approx(order, abs=0.1), (name, coarse, fine)


def test_mixed_cells_and_curves_beside_the_cells_are_refused_by_name():
    with gmsh_session():
        occ = gmsh.model.occ
        occ.addRectangle(0, 0, 0, 1, 1)
        occ.addRectangle(2, 0, 0, 1, 1)
        occ.synchronize()
        gmsh.model.mesh.setTransfiniteSurface(1)
        gmsh.model.mesh.setRecombine(2, 1)
        gmsh.model.mesh.generate(2)
        with pytest.raises(ValueError, match=r"one kind, got \['Triangle 3', 'Quadrilateral 4'\]"):
            plane_mesh()
    # a line that bounds no surface has no facets, and no other boundary must stand in for it
    with gmsh_session():
        occ = gmsh.model.occ
        occ.addRectangle(0, 0, 0, 1, 1)
        beside = occ.addLine(occ.addPoint(2, 0, 0), occ.addPoint(2, 1, 0))
        occ.synchronize()
        gmsh.model.addPhysicalGroup(1, [beside], name="ghost")
        gmsh.model.mesh.generate(2)
        with pytest.raises(ValueError, match="ghost"):
            plane_mesh()
