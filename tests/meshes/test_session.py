"""gmsh starts, gives equal meshes and ends, also after errors."""

import gmsh
import numpy as np
import pytest

from meshes.plane import plane_mesh
from meshes.ring.quarter import quarter_ring
from meshes.session import gmsh_session
from meshes.spring.centre_line import centre_line
from meshes.spring.strip import strip

SPRING = {"n": 4, "L1": 10.0, "radius": 0.5, "alpha": 1.4, "per_arc": 4, "per_leaf": 3}


def disc():
    """An unstructured mesh, where a thread or a seed would show."""
    with gmsh_session():
        gmsh.model.occ.addDisk(0, 0, 0, 1, 1)
        gmsh.model.occ.synchronize()
        gmsh.option.setNumber("Mesh.MeshSizeMax", 0.1)
        gmsh.model.mesh.generate(2)
        return plane_mesh()


@pytest.mark.parametrize("fault", [ValueError, KeyboardInterrupt])
def test_gmsh_ends_when_something_goes_wrong_and_the_fault_comes_out(fault):
    with pytest.raises(fault, match="mine"), gmsh_session():
        raise fault("mine")
    assert not gmsh.isInitialized()


def test_options_of_one_session_do_not_reach_the_next():
    with gmsh_session():
        before = gmsh.option.getNumber("Mesh.MeshSizeMax")
        gmsh.option.setNumber("Mesh.MeshSizeMax", 0.01)
        gmsh.option.setNumber("Mesh.SecondOrderIncomplete", 1)
    with gmsh_session():
        assert gmsh.option.getNumber("Mesh.MeshSizeMax") == before
        assert gmsh.option.getNumber("Mesh.SecondOrderIncomplete") == 0
        assert gmsh.option.getNumber("General.NumThreads") == 1


@pytest.mark.parametrize(
    "make",
    [
        pytest.param(disc, id="unstructured disc"),
        pytest.param(lambda: quarter_ring(r_i=1.0, r_o=2.0, refine=1), id="quarter ring"),
        pytest.param(lambda: strip(b=0.1, through=2, **SPRING), id="strip"),
    ],
)
def test_a_mesh_repeats_to_the_last_digit_and_gmsh_prints_nothing(make, capfd):
    first, second = make(), make()
    captured = capfd.readouterr()
    assert captured.out == captured.err == ""
    np.testing.assert_array_equal(first.doflocs, second.doflocs)
    np.testing.assert_array_equal(first.t, second.t)
    for name, facets in (first.boundaries or {}).items():
        np.testing.assert_array_equal(facets, second.boundaries[name])
    for name, cells in (first.subdomains or {}).items():
        np.testing.assert_array_equal(cells, second.subdomains[name])
    line, again = centre_line(**SPRING), centre_line(**SPRING)
    np.testing.assert_array_equal(line.points, again.points)
    np.testing.assert_array_equal(line.elements, again.elements)
    assert line.nodes == again.nodes
