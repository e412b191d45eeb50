r"""Frictionless normal contact of half-spaces with any gap between them, by boundary elements.

The pressure is uniform in each of nx by ny equal cells. The displacements of the cell centres
follow from Love's formula (`love`) and are summed by fast transforms (`half_space_convolution`).
The unilateral contact conditions are satisfied within a tolerance (`half_space_cg`). E* is the
contact modulus of both bodies. Any consistent units.

Range: small strain, contact area much smaller than the bodies, no free edge near the contact. Each
cell is either inside or outside of the contact, so that the boundary of the contact is stepped. The
mean-square error of the pressures is of the order of the relative cell size; the errors of the peak
pressure and the approach of a circular contact are of the order of its square. A singular pressure
(the rim of a punch, the end of a roller without crown) has no finite peak: the computed value
increases as 1/sqrt(cell).

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, sec. 5.9.
"""

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite, positive
from analytic.contact.half_space_cg import solve
from analytic.contact.half_space_contact import HalfSpaceContact
from analytic.contact.half_space_convolution import Convolution

TOLERANCE = 1e-10
LIMIT = 1000  # iterations; tens are usual
MIRROR = 1e-13  # share of the gap's range: allowed difference of its halves as mirror images


class HalfSpace:
    """Grid of `shape` = (nx, ny) cells, sides `cell` = (hx, hy), with influence coefficients."""

    def __init__(self, shape: tuple[int, int], *, cell: tuple[float, float], E_star: float) -> None:
        if np.shape(cell) != (2,):
            raise ValueError(f"a cell must have two sides hx, hy, got {cell} m")
        sides = positive(cell, "sides of a cell", "m")
        self.shape = whole_counts(shape)
        self.cell = float(sides[0]), float(sides[1])
        self.E_star = float(positive(E_star, "contact modulus", "Pa"))
        self._influence: dict[tuple[bool, bool], Convolution] = {}

    def press(
        self,
        gap: ArrayLike,
        *,
        load: float | None = None,
        approach: float | None = None,
        start: ArrayLike | None = None,
        tolerance: float = TOLERANCE,
        limit: int = LIMIT,
    ) -> HalfSpaceContact:
        """Contact of half-spaces with the initial `gap` (nx, ny) under either `load` or `approach`.

        `start` is an estimate of the pressures. If the gap is symmetric about the middle of an even
        number of cells, the pressure is symmetric, too, and only half of the grid is solved. If the
        bodies do not touch at the given approach, the load is zero. Raises ArithmeticError if the
        residual exceeds `tolerance` after `limit` iterations.
        """
        gap = _field(gap, self.shape, "gap", "m")
        load, approach = _one_of(load, approach)
        tolerance = float(positive(tolerance, "tolerance", ""))
        K = self.influence(gap)
        part = K.half(gap)
        total = None
        if load is not None:
            total = load / (self.cell[0] * self.cell[1]) * part.size / gap.size
        guess = _first(K, part, approach)
        if start is not None:
            started = K.half(np.maximum(_field(start, self.shape, "starting pressure", "Pa"), 0.0))
            guess = started if np.any(started > 0) else guess
        found = solve(
            K, part, total=total, approach=approach or 0.0, start=guess,
            tolerance=tolerance, limit=limit,
        )  # fmt: skip
        displacement = K.whole(found.displacement)
        return HalfSpaceContact(
            pressure=K.whole(found.pressure), displacement=displacement,
            gap=displacement + gap - found.approach, approach=found.approach, cell=self.cell,
            iterations=found.iterations, residual=found.residual,
        )  # fmt: skip

    def press_each(
        self, gap: ArrayLike, loads: Iterable[float], **how: Any
    ) -> list[HalfSpaceContact]:
        """Contacts for all `loads`; each solution starts from the pressures of the previous one."""
        found: list[HalfSpaceContact] = []
        for load in loads:
            start = found[-1].pressure if found else None
            found.append(self.press(gap, load=load, start=start, **how))
        return found

    def influence(self, gap: Array) -> Convolution:
        """Influence coefficients, for half of the grid if `gap` is symmetric; computed once."""
        near = MIRROR * np.ptp(gap)
        mirrored = tuple(
            n % 2 == 0 and bool(np.abs(gap - np.flip(gap, axis)).max() <= near)
            for axis, n in enumerate(self.shape)
        )
        assert len(mirrored) == 2
        if mirrored not in self._influence:
            self._influence[mirrored] = Convolution(
                self.shape, cell=self.cell, E_star=self.E_star, mirrored=mirrored
            )
        return self._influence[mirrored]


def press_half_space(
    gap: ArrayLike,
    *,
    cell: tuple[float, float],
    E_star: float,
    load: float | None = None,
    approach: float | None = None,
    **how: Any,
) -> HalfSpaceContact:
    """Contact of half-spaces with the initial `gap` (nx, ny); see `HalfSpace.press`.

    >>> one = press_half_space([[0.0]], cell=(1.0, 1.0), E_star=4 / np.pi, load=1.0)
    >>> bool(np.isclose(one.approach, np.log(1 + np.sqrt(2))))  # Love's 4 h asinh(1) / (pi E*)
    True
    """
    shape = np.shape(gap)
    if len(shape) != 2:
        raise ValueError(f"the gap must have nx by ny values, got shape {shape}")
    return HalfSpace(shape, cell=cell, E_star=E_star).press(
        gap, load=load, approach=approach, **how
    )


press = press_half_space  # its name in version 0.1


def whole_counts(shape: tuple[int, int]) -> tuple[int, int]:
    """`shape` of a grid as two integers; raises ValueError unless both are integers >= 1."""
    if len(shape) != 2 or not all(isinstance(n, int | np.integer) and n > 0 for n in shape):
        raise ValueError(
            f"a grid must have nx by ny cells, two integers of at least 1, got {shape}"
        )
    return int(shape[0]), int(shape[1])


def _field(values: ArrayLike, shape: tuple[int, int], what: str, unit: str) -> Array:
    if np.shape(values) != shape:
        raise ValueError(
            f"{what} must have one value per cell, {shape}, got shape {np.shape(values)}"
        )
    return finite(values, what, unit)


def _one_of(load: float | None, approach: float | None) -> tuple[float | None, float | None]:
    if (load is None) == (approach is None):
        raise ValueError(
            f"exactly one of load and approach must be given, got load={load} N, "
            f"approach={approach} m"
        )
    if load is not None:
        return float(positive(load, "load", "N")), None
    return None, float(finite(approach if approach is not None else 0.0, "approach", "m"))


def _first(K: Convolution, gap: Array, approach: float | None) -> Array:
    """Initial pressures: uniform for a given load; from the overlaps for a given `approach`."""
    if approach is None:
        return np.ones_like(gap)
    return np.asarray(np.maximum(K.precondition(np.maximum(approach - gap, 0.0)), 0.0))
