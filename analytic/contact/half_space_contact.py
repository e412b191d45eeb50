"""Results of half-spaces in contact: fields over the cells and their integrals."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.contact.checks import Array


@dataclass(frozen=True, kw_only=True)
class HalfSpaceContact:
    """Fields (nx, ny) over the cells of a solved contact; x, y from the middle of the grid.

    `displacement` is the sum of the displacements of both bodies, `gap` the remaining distance.
    `residual` is the largest violation of the contact conditions, relative to the largest
    displacement: a gap in a loaded cell or an overlap in an unloaded cell.
    """

    pressure: Array
    displacement: Array
    gap: Array
    approach: float
    cell: tuple[float, float]
    iterations: int
    residual: float

    @property
    def x(self) -> Array:
        """Positions x [length] of the cell centres, shape (nx,)."""
        return centres(self.pressure.shape[0], self.cell[0])

    @property
    def y(self) -> Array:
        """Positions y [length] of the cell centres, shape (ny,)."""
        return centres(self.pressure.shape[1], self.cell[1])

    @property
    def carries(self) -> NDArray[np.bool_]:
        """True for cells in contact, shape (nx, ny)."""
        return self.pressure > 0

    @property
    def area(self) -> float:
        """Area of one cell."""
        return self.cell[0] * self.cell[1]

    @property
    def load(self) -> float:
        """Force that presses the bodies together."""
        return float(self.pressure.sum() * self.area)

    @property
    def moments(self) -> tuple[float, float]:
        """Tilting moments about x and y: integrals of y p and of x p."""
        along, across = self.pressure.sum(axis=0), self.pressure.sum(axis=1)
        return float(along @ self.y * self.area), float(across @ self.x * self.area)

    @property
    def energy(self) -> float:
        """Strain energy of both bodies."""
        return float(np.vdot(self.pressure, self.displacement) * self.area / 2)

    @property
    def complementarity(self) -> float:
        """Integral of pressure times remaining gap, divided by load times largest displacement."""
        scale = self.load * float(self.displacement.max())
        work = float(np.vdot(self.pressure, np.abs(self.gap)) * self.area)
        return work / scale if scale > 0 else 0.0


def centres(n: int, side: float) -> Array:
    """Positions of the centres of n equal cells in a row, from the middle of the row."""
    return np.asarray((np.arange(n) - (n - 1) / 2) * side, dtype=np.float64)
