"""VTU files for ParaView, one for each solved mesh.

Names of arrays contain their unit, such as "von_mises [Pa]", because ParaView writes the name
beside the colour bar. Points are in m. Plane vectors have a third component of zero. Plane stresses
(xx, yy, xy, zz) become the six components of a symmetric tensor, which ParaView names XX to XZ.
"""

import re
import tempfile
from collections.abc import Iterator
from pathlib import Path

import meshio
import numpy as np

from verify.core.figures import Array, Field
from verify.core.results import CaseResult

CELLS = {2: "line", 3: "triangle", 4: "quad"}


def vtu_files(case: CaseResult) -> Iterator[tuple[str, bytes]]:
    """File name and content for every field of a case."""
    taken: set[str] = set()
    for field in case.fields:
        slug = re.sub(r"[^a-z0-9]+", "-", f"{case.id}-{field.name}".lower()).strip("-")
        name, count = f"{slug}.vtu", 1
        while name in taken:  # names that differ only in punctuation
            count += 1
            name = f"{slug}-{count}.vtu"
        taken.add(name)
        yield name, vtu(field)


def vtu(field: Field) -> bytes:
    """Content of the VTU file of a field, compressed by meshio."""
    mesh = meshio.Mesh(
        _solid(field.points),
        [(CELLS[field.cells.shape[1]], field.cells)],
        point_data={_named(field, k): _solid(v) for k, v in field.point_data.items()},
        cell_data={_named(field, k): [_solid(v)] for k, v in field.cell_data.items()},
    )
    with tempfile.TemporaryDirectory() as folder:  # meshio writes by file name alone
        path = Path(folder) / "field.vtu"
        mesh.write(path, file_format="vtu")
        return path.read_bytes()


def _named(field: Field, key: str) -> str:
    unit = field.units.get(key, "1")
    return key if unit == "1" else f"{key} [{unit}]"


def _solid(values: Array) -> Array:
    """Plane vectors and plane stresses with the components of space; other data unchanged."""
    if values.ndim == 2 and values.shape[1] == 2:
        return np.column_stack([values, np.zeros(len(values))])
    if values.ndim == 2 and values.shape[1] == 4:
        xx, yy, xy, zz = values.T
        nothing = np.zeros(len(values))
        return np.column_stack([xx, yy, zz, xy, nothing, nothing])
    return values
