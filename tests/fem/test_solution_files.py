"""Pictures and files of solutions contain the values of the solution."""

import sys

import matplotlib as mpl
import matplotlib.pyplot as plt
import meshio
import numpy as np
import pytest
from skfem import MeshQuad

import fem
from fem.beam import Section, solve_frame
from fem.contact import ContactProblem, Pair
from fem.plane import Elastic, solve_plane
from fem.rotor import (
    Disc,
    Element,
    Rotor,
    Shaft,
    Support,
    campbell_diagram,
    solve_modes,
    unbalance_response,
)  # fmt: skip
from meshes import join_meshes

SIDES = {
    "left": lambda x: x[0] == 0, "right": lambda x: x[0] == 2,
    "bottom": lambda x: x[1] == 0, "top": lambda x: x[1] == 1,
}  # fmt: skip


@pytest.fixture(autouse=True)
def _drawn_without_a_window():
    backend = mpl.get_backend()
    mpl.use("agg")
    yield
    plt.close("all")
    mpl.use(backend)


def block():
    mesh = MeshQuad.init_tensor(np.linspace(0, 2, 5), np.linspace(0, 1, 3))
    return mesh.with_boundaries(SIDES).with_subdomains({"block": lambda x: x[0] > -1})


@pytest.fixture(scope="module")
def bar():
    """Tension 3 along x in plane stress: u_x = 3 x/E, u_y = -nu 3 y/E."""
    return solve_plane(
        block(), materials=Elastic(E=200.0, nu=0.25), assumption="plane stress",
        supports={"left": "x", "bottom": "y"}, tractions={"right": (3.0, 0.0)},
    )  # fmt: skip


def test_a_plane_file_has_the_stress_and_the_displacement(bar, tmp_path):
    path = fem.to_vtu(bar, tmp_path / "bar.vtu")
    read = meshio.read(path)
    assert read.cells[0].type == "quad"
    assert read.cell_data["stress"][0] == pytest.approx(
        np.tile([3, 0, 0, 0, 0, 0], (8, 1)), abs=1e-9
    )
    assert read.cell_data["von_mises"][0] == pytest.approx(3.0)
    x, y, _ = read.points.T
    expected = np.column_stack([3 * x / 200, -0.25 * 3 * y / 200, 0 * x])
    assert read.point_data["displacement"] == pytest.approx(expected, abs=1e-12)


def test_a_plane_file_has_shear_and_the_stress_through_the_thickness(tmp_path):
    sheared = solve_plane(
        block(), materials=Elastic(E=200.0, nu=0.25), assumption="plane strain",
        supports={"bottom": "xy"}, tractions={"top": (1.0, 2.0)},
    )  # fmt: skip
    read = meshio.read(fem.to_vtu(sheared, tmp_path / "sheared.vtu"))
    xx, yy, zz, xy, yz, xz = read.cell_data["stress"][0].T
    assert zz == pytest.approx(0.25 * (xx + yy))
    assert xy.mean() == pytest.approx(1.0)
    assert yy.mean() == pytest.approx(2.0)
    assert not np.any([yz, xz])


def test_a_plane_picture_has_the_chosen_value_of_every_cell(bar):
    for value, expected in (("", 3.0), ("xx", 3.0), ("yy", 0.0)):
        (cells,) = fem.plot(bar, value).collections
        assert np.asarray(cells.get_array()) == pytest.approx(np.full(8, expected), abs=1e-9)
    axes = plt.subplots()[1]
    assert fem.plot(bar, "x", ax=axes) is axes
    middle = np.asarray(axes.collections[0].get_array())
    assert middle.max() == pytest.approx(3 * 1.75 / 200)  # of the last cells, from 1.5 to 2
    assert axes.get_xlabel() == "x [as given]"


def test_a_contact_is_drawn_by_its_field_and_by_its_pressure():
    mesh = join_meshes({"low": block(), "high": block().translated((0.0, 1.0))})
    pressed = ContactProblem(
        mesh,
        materials=Elastic(E=200.0, nu=0.0),
        assumption="plane stress",
        supports={"low.bottom": "y", "low.left": "x", "high.left": "x"},
        contacts=[Pair(slave="high.bottom", master="low.top")],
    ).solve(forces={"high.top": (0.0, -4.0)})  # on a length of 2: a pressure of 2
    (line,) = fem.plot(pressed, "pressure").lines
    assert line.get_ydata() == pytest.approx(np.full(5, 2.0))
    (cells,) = fem.plot(pressed, "yy").collections
    assert np.asarray(cells.get_array()) == pytest.approx(np.full(16, -2.0))


def test_a_frame_is_drawn_and_written_with_its_elements(tmp_path):
    points, elements = np.array([[0.0, 0.0], [3.0, 0.0]]), np.array([[0, 1]])
    bent = solve_frame(
        points, elements, sections=Section(EA=1e9, EI=9.0, GA=1e12),
        supports={0: "xyr"}, loads={1: (0.0, 2.0, 0.0)},
    )  # fmt: skip
    end = 2.0 * 3.0**3 / (3 * 9.0)  # F l^3/(3 E I)
    read = meshio.read(fem.to_vtu(bent, tmp_path / "bent.vtu", elements=elements))
    assert read.point_data["displacement"][1, 1] == pytest.approx(end)
    _, displaced = fem.plot(bent, scale=10, elements=elements).lines
    assert displaced.get_ydata()[1] == pytest.approx(10 * end)
    with pytest.raises(ValueError, match="the solution of a frame contains no"):
        fem.to_vtu(bent, tmp_path / "bent.vtu")


def test_results_of_rotors_are_drawn_over_the_speed():
    shaft = Shaft([Element(length=0.25, d_o=0.03)] * 4)
    bearings = [Support(0, kxx=1e8, cxx=10.0), Support(4, kxx=1e8, cxx=10.0)]
    rotor = Rotor([shaft], [Disc(2, mass=10.0)], bearings)
    speeds = np.linspace(10, 300, 20)
    diagram = campbell_diagram(rotor, speeds, count=2)
    lines = fem.plot(diagram).lines
    assert lines[0].get_ydata() == pytest.approx(diagram.frequencies[:, 0])
    assert lines[-1].get_ydata() == pytest.approx(speeds)
    free = solve_modes(rotor, count=2)
    assert np.abs(fem.plot(free).lines[0].get_ydata()).argmax() == 2  # the disc
    swing = unbalance_response(rotor, speeds, {2: 1e-4})
    (line,) = fem.plot(swing, node=2).lines
    assert line.get_ydata() == pytest.approx(swing.major(2))
    with pytest.raises(ValueError, match="the plot of a response requires a node: give"):
        fem.plot(swing)


def test_what_cannot_be_drawn_is_refused(bar, tmp_path, monkeypatch):
    with pytest.raises(ValueError, match="value must be one of von_mises, xx, yy, xy"):
        fem.plot(bar, "mises")
    for function in (fem.plot, lambda x: fem.to_vtu(x, tmp_path / "x.vtu")):
        with pytest.raises(TypeError, match=r"one of PlaneSolution, .*, got int"):
            function(3)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    monkeypatch.setitem(sys.modules, "meshio", None)
    with pytest.raises(ImportError, match=r"matplotlib: install freewheel-verification\[report\]"):
        fem.plot(bar)
    with pytest.raises(ImportError, match=r"meshio: install freewheel-verification\[fem\]"):
        fem.to_vtu(bar, tmp_path / "bar.vtu")
