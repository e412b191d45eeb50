"""Fields of a solution and their pictures, each in one call."""

from collections.abc import Mapping
from typing import Protocol

import numpy as np

from verify.core import units
from verify.core.figures import Array, Field, Picture

# of a plane body's cells: what, symbol, unit of the solver, unit of the picture
CELL_DATA = {"von_mises": ("Von Mises stress", "σ_v", "Pa", "MPa")}


class HasCells(Protocol):
    """A solved plane body."""

    def cells(self) -> Mapping[str, Array]:
        """Points, cells, displacement and cell data."""
        ...


def plane_field(solution: HasCells, data: str, *, name: str = "body", scale: float = 1.0) -> Field:
    """Mesh, displacements and one cell quantity of a solution under `scale` times its loads."""
    cells, (_, _, unit, _) = solution.cells(), CELL_DATA[data]
    return Field(
        name=name, points=cells["points"], cells=cells["cells"].astype(np.int64),
        point_data={"displacement": cells["displacement"] * scale},
        cell_data={data: cells[data] * scale}, units={"displacement": "m", data: unit},
    )  # fmt: skip


def picture(field: str, data: str, caption: str = "", *, mirror: str = "") -> Picture:
    """A field in colours; `mirror` completes a symmetric body, "xy" from a quarter."""
    what, symbol, _, unit = CELL_DATA[data]
    return Picture(
        field=field, data=data, symbol=symbol, unit=unit, factor=units.factor(unit),
        caption=caption or what, mirror=tuple(mirror),
    )  # fmt: skip
