"""Any quadrilateral surface of gmsh is read from memory, with its names."""

import gmsh
import numpy as np
import pytest

from meshes.session import gmsh_session
from meshes.shell.surface import shell_mesh


def roof(order=2, named=True, recombine=True):
    """Two slopes that meet in a ridge at z = 1, over the unit square."""
    with gmsh_session():
        geo = gmsh.model.geo
        geo.addPoint(50, 50, 0, tag=900)  # belongs to nothing
        south = [geo.addPoint(x, 0, z) for x, z in ((0, 0), (0.5, 1), (1, 0))]
        north = [geo.addPoint(x, 2, z) for x, z in ((0, 0), (0.5, 1), (1, 0))]
        ribs = [geo.addLine(a, b) for a, b in zip(south, north, strict=True)]
        faces = []
        for k in (0, 1):
            low, high = geo.addLine(south[k], south[k + 1]), geo.addLine(north[k], north[k + 1])
            loop = geo.addCurveLoop([low, ribs[k + 1], -high, -ribs[k]])
            faces.append(geo.addPlaneSurface([loop]))
            geo.mesh.setTransfiniteSurface(faces[-1])
            if recombine:
                geo.mesh.setRecombine(2, faces[-1])
        for curve in (*ribs, *range(ribs[-1] + 1, ribs[-1] + 5)):
            geo.mesh.setTransfiniteCurve(curve, 4)
        geo.synchronize()
        if named:
            gmsh.model.addPhysicalGroup(2, faces[:1], name="west")
            gmsh.model.addPhysicalGroup(2, faces[1:], name="east")
        gmsh.model.addPhysicalGroup(1, [ribs[1]], name="ridge")
        gmsh.model.addPhysicalGroup(0, [south[1]], name="gable")
        gmsh.model.mesh.generate(2)
        gmsh.model.mesh.setOrder(order)
        return shell_mesh()


def test_names_points_and_cells_come_over():
    mesh = roof()
    assert mesh.points.shape == (13 * 7, 3)  # both slopes share the ridge, none has the idle point
    assert mesh.cells.shape == (18, 9)
    np.testing.assert_array_equal(np.unique(mesh.cells), np.arange(len(mesh.points)))
    np.testing.assert_allclose(mesh.points[mesh.boundaries["ridge"], 0], 0.5, atol=1e-14)
    np.testing.assert_allclose(mesh.points[mesh.nodes["gable"]], (0.5, 0, 1), atol=1e-14)
    for name, sign in (("west", -1), ("east", 1)):
        centre = mesh.points[mesh.cells[mesh.bodies[name], 8]]
        assert (sign * (centre[:, 0] - 0.5) > 0).all()
    corner = mesh.points[mesh.cells[:, :4]]  # corners and middles run round the cell
    between = (corner + np.roll(corner, -1, axis=1)) / 2
    np.testing.assert_allclose(mesh.points[mesh.cells[:, 4:8]], between, atol=1e-12)


def test_other_cells_are_refused():
    with pytest.raises(ValueError, match="a shell mesh requires physical surfaces"):
        roof(named=False)
    with pytest.raises(ValueError, match=r"surface 1 must have .* nine-node quadrilaterals"):
        roof(order=1)
    with pytest.raises(ValueError, match="surface 1 must have"):
        roof(recombine=False)
