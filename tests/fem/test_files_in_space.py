"""Files of solids, shells, bodies of revolution and modes contain the components in their names.

All components of a state differ, so that no two of them can be exchanged unseen.
"""

from dataclasses import replace

import meshio
import numpy as np
import pytest
from skfem import MeshQuad

import fem
from fem.plane import Elastic, solve_plane
from fem.rotor import Disc, Element, Rotor, Shaft, Support, solve_modes
from fem.shell import solve_shell
from fem.solid import solve_solid
from meshes.solid import solid_block
from tests.fem.shell.grids import over

E, NU = 200.0, 0.3
LAM, MU = E * NU / ((1 + NU) * (1 - 2 * NU)), E / (2 * (1 + NU))
STEEL = Elastic(E=E, nu=NU)
GRAD = np.array([[1.0, 0.4, -0.2], [0.3, -2.0, 0.5], [0.1, 0.6, 0.7]])  # du_i/dx_j


def written(solution, tmp_path, **more):
    return meshio.read(fem.to_vtu(solution, tmp_path / "x.vtu", **more))


def von_mises(xx, yy, zz, xy, yz, xz):
    normal = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.sqrt(normal / 2 + 3 * (xy**2 + yz**2 + xz**2))


@pytest.mark.parametrize("order", [1, 2])
def test_a_solid_file_has_each_component_of_the_stress(order, tmp_path):
    mesh = solid_block(x=(0, 2), y=(0, 3), z=(0, 5), cells=(2, 1, 2), order=order)
    moved = {c: (lambda x, i=i: (GRAD @ x)[i]) for i, c in enumerate("xyz")}
    solved = solve_solid(mesh, materials=STEEL, supports=dict.fromkeys(mesh.boundaries, moved))
    read = written(solved, tmp_path)
    s = LAM * np.trace(GRAD) * np.eye(3) + MU * (GRAD + GRAD.T)
    six = s[0, 0], s[1, 1], s[2, 2], s[0, 1], s[1, 2], s[0, 2]
    assert len({round(value, 6) for value in six}) == 6
    assert read.cell_data["stress"][0] == pytest.approx(np.tile(six, (4, 1)), rel=1e-9)
    assert read.cell_data["von_mises"][0] == pytest.approx(von_mises(*six))
    assert read.point_data["displacement"] == pytest.approx(read.points @ GRAD.T, abs=1e-9)
    # VTK: the first four corners around one face, the others above them
    assert read.cells[0].type == "hexahedron"
    at = read.points[read.cells[0].data]
    sides = np.stack([at[:, k] - at[:, 0] for k in (1, 3, 4)], axis=1)
    assert np.linalg.det(sides) == pytest.approx(np.full(4, 30 / 4))
    for corner, sum_of in ((2, (1, 3)), (5, (1, 4)), (7, (3, 4)), (6, (2, 4))):
        opposite = at[:, sum_of[0]] + at[:, sum_of[1]] - at[:, 0]
        assert at[:, corner] == pytest.approx(opposite)


def test_the_mean_stress_of_a_solid_s_cell_counts_its_volume(tmp_path):
    """E = 1, u_x = x^2 in a cell that is 1 + x wide: 2 x is 10/9 in the mean over the volume."""
    mesh = solid_block(x=(0, 1), y=(0, 1), z=(0, 1), cells=(1, 1, 1))
    x, y, z = mesh.doflocs
    mesh = replace(mesh, doflocs=np.array([x, y * (1 + x), z]))
    moved = {"x": lambda p: p[0] ** 2, "y": 0.0, "z": 0.0}
    solved = solve_solid(
        mesh, materials=Elastic(E=1.0, nu=0.0), supports=dict.fromkeys(mesh.boundaries, moved),
        body_force=(-2.0, 0.0, 0.0),
    )  # fmt: skip
    assert written(solved, tmp_path).cell_data["stress"][0][0, 0] == pytest.approx(10 / 9)


def test_a_file_of_a_body_of_revolution_has_radius_axis_and_hoop(tmp_path):
    """u_r = a r + g/r, u_y = c y + d ln r, in balance without loads: all components differ."""
    a, g, c, d = 0.5, 0.9, -2.0, 3.0
    block = MeshQuad.init_tensor(np.linspace(2, 4, 17), np.linspace(1, 2, 3))
    block = block.with_boundaries({"all": lambda x: x[0] > 0})
    field = {"x": lambda x: a * x[0] + g / x[0], "y": lambda x: c * x[1] + d * np.log(x[0])}
    solved = solve_plane(block, materials=STEEL, assumption="axisymmetric", supports={"all": field})
    read = written(solved, tmp_path)
    r, y, _ = read.points.T
    move = np.column_stack([a * r + g / r, c * y + d * np.log(r), 0 * r])
    assert read.point_data["displacement"] == pytest.approx(move, abs=1e-4)
    r = read.points[read.cells[0].data][:, :, 0].mean(axis=1)
    trace = LAM * (2 * a + c)
    rr, yy, tt = (trace + 2 * MU * strain for strain in (a - g / r**2, c, a + g / r**2))
    expected = np.column_stack([rr, yy + 0 * r, tt, MU * d / r, 0 * r, 0 * r])
    found = read.cell_data["stress"][0]
    assert found == pytest.approx(expected, abs=0.2)  # the mean over a cell for its middle
    apart = expected[:, :4, None] - expected[:, None, :4] + 99 * np.eye(4)
    assert abs(apart).min() > 10


def test_a_shell_file_has_each_component_of_its_stresses(tmp_path):
    """A square whose sides are turned into x, y, z: membrane, bending and shear stresses differ."""
    e1, e2 = np.array([2.0, 1.0, 2.0]) / 3, np.array([-2.0, 2.0, 1.0]) / 3
    grid = over(2, 2, lambda u, v: tuple(u * p + 3 * v * q for p, q in zip(e1, e2, strict=True)))
    strain = np.array([[1.0, 0.25], [0.25, -0.4]]) * 1e-3
    lower = np.column_stack([e1, e2])
    u = (grid.points @ lower) @ strain @ lower.T
    edge = {
        int(n): dict(zip("xyz", u[n], strict=True)) | dict.fromkeys("abc", 0.0)
        for n in np.unique(np.concatenate([*grid.boundaries.values()]))
    }
    solved = solve_shell(grid.points, grid.cells, thickness=0.1, materials=STEEL, supports=edge)
    read = written(solved, tmp_path)
    plane = E / (1 - NU**2) * ((1 - NU) * strain + NU * np.trace(strain) * np.eye(2))
    s = lower @ plane @ lower.T
    six = s[0, 0], s[1, 1], s[2, 2], s[0, 1], s[1, 2], s[0, 2]
    assert read.cells[0].type == "quad9"
    assert read.cell_data["membrane_stress"][0] == pytest.approx(np.tile(six, (4, 1)), rel=1e-8)
    assert read.cell_data["bending_stress"][0] == pytest.approx(0, abs=1e-9)
    assert read.point_data["displacement"] == pytest.approx(u, abs=1e-12)
    assert read.cells[0].data == pytest.approx(grid.cells)


def test_bending_and_shear_of_a_shell_are_in_the_file(tmp_path):
    """A strip along x under the end load 2 per width: m_xx = 2 (4 - x), q_x = 2."""
    grid = over(4, 1, lambda u, v: (4 * u, v, 0 * u))
    solved = solve_shell(
        grid.points, grid.cells, thickness=0.5, materials=Elastic(E=E, nu=0.0),
        boundaries=grid.boundaries, supports={"u=0": "xyzabc"}, edge_loads={"u=1": (0.0, 0.0, 2.0)},
    )  # fmt: skip
    read = written(solved, tmp_path)
    x = read.points[read.cells[0].data][:, 8, 0]
    bending = np.zeros((4, 6))
    bending[:, 0] = -6 * 2 * (4 - x) / 0.5**2  # upwards: the upper face is compressed
    assert read.cell_data["bending_stress"][0] == pytest.approx(bending, abs=1e-6)
    assert read.cell_data["shear_stress"][0] == pytest.approx(np.tile([4, 0, 0], (4, 1)), abs=1e-6)
    end = read.point_data["displacement"][grid.number[-1]]
    turned = read.point_data["rotation"][grid.number[-1]]
    assert end[:, 2].mean() == pytest.approx(2 * 4**3 / (3 * E * 0.5**3 / 12), rel=0.02)
    assert turned[:, 1] == pytest.approx(-2 * 4**2 / (2 * E * 0.5**3 / 12), rel=1e-3)


def test_a_file_of_modes_has_their_shapes_along_the_shaft(tmp_path):
    shaft = Shaft([Element(length=0.25, d_o=0.03)] * 4, z=0.1)
    bearings = [Support(0, kxx=1e8, kyy=2e8, cxx=1e5), Support(4, kxx=1e8)]
    rotor = Rotor([shaft], [Disc(2, mass=10.0)], bearings, refine=2)
    modes = solve_modes(rotor, 100.0, count=3)
    read = written(modes, tmp_path, rotor=rotor)
    assert read.points == pytest.approx(np.column_stack([np.zeros((5, 2)), rotor.z]))
    assert read.cells[0].data.tolist() == [[0, 1], [1, 2], [2, 3], [3, 4]]
    for k in range(3):
        real, imaginary = (read.point_data[f"mode_{k + 1}_{p}"] for p in ("real", "imaginary"))
        assert real + 1j * imaginary == pytest.approx(modes.shapes[k, :5, :3])
    assert abs(modes.shapes[:, :5, :2].imag).max() > 1e-6
    with pytest.raises(ValueError, match="modes contain no positions of nodes: give the rotor"):
        fem.to_vtu(modes, tmp_path / "x.vtu")
    with pytest.raises(ValueError, match="but have 9 nodes; the rotor has 5"):
        fem.to_vtu(modes, tmp_path / "x.vtu", rotor=Rotor([shaft], rotor.discs, bearings))
