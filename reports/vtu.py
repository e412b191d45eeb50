"""One VTU file per solved mesh, for ParaView."""

import re
import tempfile
from collections.abc import Iterator
from pathlib import Path

import meshio
import numpy as np

from verify.results import Field, Report

CELLS = {2: "line", 3: "triangle", 4: "quad"}


def vtu_files(report: Report) -> Iterator[tuple[str, bytes]]:
    """File name and content for every field of every case."""
    for case in report.cases:
        for field in case.fields:
            slug = re.sub(r"[^a-z0-9]+", "-", f"{case.id}-{field.name}".lower()).strip("-")
            yield f"{slug}.vtu", vtu(field)


def vtu(field: Field) -> bytes:
    """A field as VTU; plane points and vectors get a zero third component."""
    mesh = meshio.Mesh(
        _solid(field.points),
        [(CELLS[field.cells.shape[1]], field.cells)],
        point_data={k: _solid(v) for k, v in field.point_data.items()},
        cell_data={k: [v] for k, v in field.cell_data.items()},
    )
    with tempfile.TemporaryDirectory() as folder:  # meshio writes by file name alone
        path = Path(folder) / "field.vtu"
        mesh.write(path, file_format="vtu")
        return path.read_bytes()


def _solid(
    values: np.ndarray[tuple[int, ...], np.dtype[np.float64]],
) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    if values.ndim == 2 and values.shape[1] == 2:
        return np.column_stack([values, np.zeros(len(values))])
    return values
