"""Fields of a solution, and pictures of them."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple, Protocol

import numpy as np

from verify.core import units
from verify.core.figures import Array, Field, Picture


class HasCells(Protocol):
    """Solution of a plane body that returns its cells with data."""

    def cells(self) -> Mapping[str, Array]:
        """Arrays (name: array): points, cells, displacements and cell data."""
        ...


def _hoop(cells: Mapping[str, Array]) -> Array:
    """Hoop stress (m,) about the origin, from the mean stresses of the cells."""
    x, y = cells["points"][cells["cells"].astype(int)].mean(axis=1).T
    xx, yy, xy, _ = cells["stress"].T
    return np.asarray((xx * y**2 + yy * x**2 - 2 * xy * x * y) / (x**2 + y**2))


class CellData(NamedTuple):
    """A cell quantity of a plane body: name, symbol, and units of the solver and of the picture."""

    what: str
    symbol: str
    unit: str
    drawn: str
    of: Callable[[Mapping[str, Array]], Array]


CELL_DATA = {
    "stress": CellData("Stresses", "σ", "Pa", "MPa", lambda cells: cells["stress"]),
    "von_mises": CellData("Von Mises stress", "σ_v", "Pa", "MPa", lambda cells: cells["von_mises"]),
    "hoop_stress": CellData("Hoop stress", "σ_θ", "Pa", "MPa", _hoop),
    "log_mises": CellData(  # lowest decade 10 MPa
        "Von Mises stress", "σ_v", "1", "MPa",
        lambda cells: np.log10(np.maximum(cells["von_mises"] / 1e6, 10.0)),
    ),
}  # fmt: skip


def plane_field(solution: HasCells, *data: str, name: str = "body", scale: float = 1.0) -> Field:
    """Field with mesh, displacements and cell data of a solution, for loads times `scale`.

    >>> sorted(CELL_DATA)
    ['hoop_stress', 'log_mises', 'stress', 'von_mises']
    """
    cells = solution.cells()
    if "log_mises" in data and scale != 1.0:
        raise ValueError("scale must be 1 for log_mises, which is not proportional to the loads")
    return Field(
        name=name, points=cells["points"], cells=cells["cells"].astype(np.int64),
        point_data={"displacement": cells["displacement"] * scale},
        cell_data={one: CELL_DATA[one].of(cells) * scale for one in data},
        units={"displacement": "m", **{one: CELL_DATA[one].unit for one in data}},
    )  # fmt: skip


def picture(field: str, data: str, caption: str = "", *, mirror: str = "", **more: Any) -> Picture:
    """Picture of a field in colours.

    `mirror` completes a symmetric body: "xy" for a quarter. `more` are `window`, `share` and other
    fields of `verify.core.figures.Picture`.
    """
    about = CELL_DATA[data]
    decades = data == "log_mises"
    return Picture(
        field=field, data=data, symbol=about.symbol, unit=about.drawn,
        factor=1.0 if decades else units.factor(about.drawn), decades=decades,
        caption=caption or about.what, mirror=tuple(mirror), **more,
    )  # fmt: skip
