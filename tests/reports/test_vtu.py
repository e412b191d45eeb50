"""Every VTU file of a run is read back by meshio and by VTK, the reader of ParaView."""

import meshio
import numpy as np
import pyvista

from reports.vtu import vtu, vtu_files
from verify.core.figures import Field

VTK = {2: pyvista.CellType.LINE, 3: pyvista.CellType.TRIANGLE, 4: pyvista.CellType.QUAD}
TRIANGLE = Field(
    name="one triangle", points=np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]),
    cells=np.array([[0, 1, 2]]), point_data={"displacement": np.ones((3, 2))},
    cell_data={"stress": np.array([[1.0, 2.0, 3.0, 4.0]]), "share": np.array([0.5])},
    units={"displacement": "m", "stress": "Pa", "share": "1"},
)  # fmt: skip


def named(field, key):
    unit = field.units.get(key, "1")
    return key if unit == "1" else f"{key} [{unit}]"


def test_every_field_opens_in_two_readers(report, tmp_path):
    files = dict(file for case in report.cases for file in vtu_files(case))
    fields = [field for case in report.cases for field in case.fields]
    assert len(files) == len(fields) > 3
    path, grids = tmp_path / "field.vtu", []
    for content, field in zip([*files.values(), vtu(TRIANGLE)], [*fields, TRIANGLE], strict=True):
        path.write_bytes(content)
        mesh, grid = meshio.read(path), pyvista.read(path)
        grids.append(grid)
        corners = field.cells.shape[1]
        assert len(mesh.points) == grid.n_points == len(field.points)
        np.testing.assert_array_equal(mesh.cells[0].data, field.cells)
        np.testing.assert_array_equal(grid.cells.reshape(-1, corners + 1)[:, 1:], field.cells)
        assert set(grid.celltypes) == {VTK[corners]}
        np.testing.assert_array_equal(grid.points[:, : field.points.shape[1]], field.points)
        for key, values in field.point_data.items():
            flat = values.ndim == 2 and values.shape[1] == 2
            shown = np.pad(values, ((0, 0), (0, 1))) if flat else values
            for reader in (mesh, grid):
                np.testing.assert_array_equal(reader.point_data[named(field, key)], shown)
        for key, values in field.cell_data.items():
            name = named(field, key)
            assert len(mesh.cell_data[name][0]) == len(grid.cell_data[name]) == len(values)
            if values.ndim == 1:
                np.testing.assert_array_equal(grid.cell_data[name], values)
    # the stress is a symmetric tensor whose invariant is the von Mises stress
    assert grids[-1].cell_data["stress [Pa]"].tolist() == [[1, 2, 4, 3, 0, 0]]
    grid = grids[list(files).index("ring-lame-plane-strain.vtu")]
    xx, yy, zz, xy, yz, xz = grid.cell_data["stress [Pa]"].T
    mises = np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * xy**2)
    np.testing.assert_allclose(mises, grid.cell_data["von_mises [Pa]"], rtol=1e-12)
    assert not yz.any()
    assert not xz.any()
