"""Inputs of case spring-map, and the springs of its maps."""

import math
from dataclasses import dataclass
from typing import Any

from pydantic import model_validator

from verify.cases.spring.inputs import SpringInputs, length_of
from verify.core.inputs import quantity

SHARES = (0.3, 0.6)  # over the free length: the limits of Eq. 12
SLENDER = (60.0, 120.0, 240.0, 480.0)  # L_0/b
SEGMENTS = (4, 6, 10, 16, 24)
LEAVES = (8.0, 16.0, 26.0, 40.0)  # L_1/r
ANGLES = (60.0, 70.0, 80.0, 90.0)  # deg
DEEP_SLENDER = (50.0, 75.0, 100.0, 150.0, 200.0, 240.0, 300.0, 400.0, 600.0)
DEEP_SEGMENTS = (4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 16, 20, 24, 30)
DEEP_LEAVES = (6.0, 8.0, 12.0, 16.0, 20.0, 26.0, 32.0, 40.0, 60.0)
DEEP_ANGLES = (50.0, 55.0, 60.0, 65.0, 70.0, 75.0, 80.0, 85.0, 90.0)


class MapInputs(SpringInputs):
    """Inputs of the spring whose dimensions are varied in the maps, and of its roller's path."""

    x_r: float = quantity(
        "8.3 mm", "mm", "x_r", "travel of the roller along the spring", gt=0, le=1e3,
        claims="wang2023:roller-travel-x",
    )  # fmt: skip
    y_r: float = quantity(
        "0.56 mm", "mm", "y_r", "travel of the roller across the spring", ge=0, le=1e3,
        claims="wang2023:roller-travel-y",
    )  # fmt: skip
    kappa: float = quantity(
        "0.012 1/mm", "1/mm", "κ", "curvature of the chamber", ge=0, le=10,
        claims="wang2023:chamber-curvature",
    )  # fmt: skip

    @model_validator(mode="after")
    def _straight(self) -> "MapInputs":
        if self.x_r > 0.7 * self.length:
            raise ValueError(
                f"the roller's travel must be at most {0.7 * self.length * 1e3:.4g} mm (0.7 times "
                f"the spring's length), got x_r = {self.x_r * 1e3:g} mm"
            )
        if self.y_r > 0.2 * self.x_r:
            raise ValueError(
                f"the path must be nearly straight: y_r <= 0.2 x_r, got x_r = "
                f"{self.x_r * 1e3:g} mm, y_r = {self.y_r * 1e3:g} mm"
            )
        return self

    @property
    def length(self) -> float:
        """Free length [m] between the centre lines of the leaves of head and tail."""
        return Cell(self.n, self.b, self.r, self.L1, self.alpha).length


@dataclass(frozen=True)
class Cell:
    """Spring of a map: number of segments, thickness, inner radius, leaf [m] and angle [rad]."""

    n: int
    b: float
    r: float
    L1: float
    alpha: float

    @property
    def R(self) -> float:
        """Radius [m] of the centre line of the arcs."""
        return self.r + self.b / 2

    @property
    def length(self) -> float:
        """Free length [m] between the centre lines of the leaves of head and tail."""
        return length_of(self.n, self.L1, self.R, self.alpha)

    @property
    def path(self) -> dict[str, Any]:
        """Arguments that define the centre line."""
        return {"n": self.n, "L1": self.L1, "radius": self.R, "alpha": self.alpha, "tail": "arc"}

    @property
    def eqs(self) -> dict[str, Any]:
        """Geometry as arguments of the functions for Eqs. 1-9."""
        return {"n": self.n, "b": self.b, "r": self.r, "L1": self.L1, "alpha": self.alpha}


def slender(q: MapInputs, n: int, ratio: float) -> Cell:
    """Spring with the inner radius r, n segments and L_0/b = `ratio`; b is found by iteration."""
    b = Cell(n, q.b, q.r, q.L1, q.alpha).length / ratio
    for _ in range(60):
        b = Cell(n, b, q.r, q.L1, q.alpha).length / ratio
    return Cell(n, b, q.r, q.L1, q.alpha)


def points(q: MapInputs, deep: bool) -> dict[str, list[list[Cell]]]:
    """Rows of cells of both maps: n over L_0/b ("slender"), and alpha over L_1/r ("shape")."""
    columns, rows = (DEEP_SLENDER, DEEP_SEGMENTS) if deep else (SLENDER, SEGMENTS)
    leaves, angles = (DEEP_LEAVES, DEEP_ANGLES) if deep else (LEAVES, ANGLES)
    return {
        "slender": [[slender(q, n, ratio) for ratio in columns] for n in rows],
        "shape": [
            [Cell(q.n, q.b, q.r, ratio * q.r, math.radians(angle)) for ratio in leaves]
            for angle in angles
        ],
    }
