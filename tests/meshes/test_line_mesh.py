"""Any line model of gmsh is read with its names, its numbering and its middle nodes."""

from math import pi

import gmsh
import numpy as np
import pytest

from meshes.line import line_mesh
from meshes.session import gmsh_session

SPACING = 1e-7  # gmsh integrates an arc's length to that when it spaces points evenly


def hook():
    """From (0, 0) up by 2, a half circle of radius 1 on to (2, 2), and a branch to (-1, 2)."""
    with gmsh_session():
        geo = gmsh.model.geo
        geo.addPoint(50, 50, 0, tag=900)  # belongs to nothing
        foot, knee, centre, crown, tip, branch = (
            geo.addPoint(*p, 0) for p in ((0, 0), (0, 2), (1, 2), (1, 3), (2, 2), (-1, 2))
        )
        stem = geo.addLine(foot, knee)
        bow = [geo.addCircleArc(knee, centre, crown), geo.addCircleArc(crown, centre, tip)]
        side = geo.addLine(branch, knee)  # against the others
        for curve, cells in ((stem, 3), (bow[0], 4), (bow[1], 4), (side, 2)):
            geo.mesh.setTransfiniteCurve(curve, cells + 1)
        geo.synchronize()
        gmsh.model.addPhysicalGroup(0, [foot], name="foot")
        gmsh.model.addPhysicalGroup(0, [tip], name="tip")
        gmsh.model.addPhysicalGroup(1, bow, name="bow")
        gmsh.model.addPhysicalGroup(1, [stem, side], name="straight")
        gmsh.model.mesh.generate(1)
        gmsh.model.mesh.setOrder(2)
        return line_mesh()


def test_bodies_share_out_the_elements_and_nodes_are_numbered_without_gaps():
    mesh = hook()
    assert {name: len(own) for name, own in mesh.bodies.items()} == {"bow": 8, "straight": 5}
    everything = np.sort(np.concatenate(list(mesh.bodies.values())))
    np.testing.assert_array_equal(everything, np.arange(len(mesh.elements)))
    a, b, middle = np.moveaxis(mesh.points[mesh.elements], 1, 0)
    np.testing.assert_allclose(np.hypot(*(middle - a).T), np.hypot(*(b - middle).T), rtol=SPACING)
    # an eighth of a half circle: the middle stands off its chord by 1 - cos(pi / 16)
    sagitta = np.hypot(*((a + b) / 2 - middle)[mesh.bodies["bow"]].T)
    np.testing.assert_allclose(sagitta, 1 - np.cos(pi / 16), rtol=SPACING)
    # 13 elements in a tree have 14 ends and 13 middles
    assert mesh.points.shape == (27, 2)
    np.testing.assert_array_equal(np.unique(mesh.elements[:, :2]), np.arange(14))
    np.testing.assert_array_equal(np.sort(mesh.elements[:, 2]), np.arange(14, 27))
    assert mesh.points.max() == 3.0  # the stray point stayed behind
    points, pairs = mesh.chords  # the straight elements between the ends
    assert points.shape == (14, 2)
    length = np.hypot(*(points[pairs[:, 1]] - points[pairs[:, 0]]).T)
    np.testing.assert_allclose(length[mesh.bodies["bow"]], 2 * np.sin(pi / 16), rtol=SPACING)
    assert length[mesh.bodies["straight"]].sum() == pytest.approx(3, rel=1e-12)


def bar(order, name):
    """A straight line of three elements; without a name if that is None."""
    with gmsh_session():
        geo = gmsh.model.geo
        line = geo.addLine(geo.addPoint(0, 0, 0), geo.addPoint(3, 0, 0))
        geo.mesh.setTransfiniteCurve(line, 4)
        geo.synchronize()
        if name is not None:
            gmsh.model.addPhysicalGroup(1, [line], name=name)
        gmsh.model.mesh.generate(1)
        gmsh.model.mesh.setOrder(order)
        return line_mesh()


@pytest.mark.parametrize(
    ("order", "name", "message"),
    [
        (1, "bar", "curve 1 must have quadratic elements: set"),
        (3, "bar", "curve 1 must have quadratic elements: set"),
        (2, None, "physical curves"),
    ],
)
def test_elements_without_one_middle_node_or_a_name_are_refused(order, name, message):
    with pytest.raises(ValueError, match=message):
        bar(order, name)
