"""Strips of thickness b along leaves and arcs, as cells for calculix and as beams."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from fem.beam.section import Section
from meshes.spring.path import Piece
from verify.studies.crosscheck.calculix.large import STEEL, Held

Array = NDArray[np.float64]
Indices = NDArray[np.int64]


def plane_strain_section(b: float, radius: float | None = None) -> Section:
    """Section of a strip in plane strain per unit of width.

    A curved bar bends as if EI were reduced by (b/R)^2/30 (exact solution of Golovin).
    """
    E = STEEL.E / (1 - STEEL.nu**2)
    curved = 1 - (b / radius) ** 2 / 30 if radius else 1.0
    return Section(
        EA=E * b, EI=curved * E * b**3 / 12, GA=5 / 6 * STEEL.E / (2 * (1 + STEEL.nu)) * b
    )


@dataclass(frozen=True)
class Strip:
    """A strip: nodes (n, 2) and cells (m, 8), in order along the line of the strip.

    `across` contains the nodes of each section between cells. `pieces[k]` is the range of the cells
    of piece k.
    """

    points: Array
    cells: Indices
    across: tuple[Indices, ...]
    pieces: tuple[range, ...]

    def middle(self, station: int) -> int:
        own = self.across[station]
        return int(own[len(own) // 2])


def strip(pieces: Sequence[Piece], counts: Sequence[int], b: float) -> Strip:
    """Strip with one cell through the thickness `b` and counts[k] cells along piece k."""
    x, y, heading = _places(pieces, counts).T
    n = np.column_stack([-np.sin(heading), np.cos(heading)])
    offsets = np.array([-b / 2, 0, b / 2])
    grid = np.column_stack([x, y])[:, None] + offsets[:, None] * n[:, None]
    k = np.arange(grid.shape[0] * 3).reshape(-1, 3)
    first, mid, last = k[0:-1:2], k[1::2], k[2::2]
    cells = np.column_stack([
        first[:, 0], last[:, 0], last[:, 2], first[:, 2],
        mid[:, 0], last[:, 1], mid[:, 2], first[:, 1],
    ])  # fmt: skip
    used, cells = np.unique(cells, return_inverse=True)
    new = np.zeros(k.size, int)
    new[used] = np.arange(used.size)
    ends = np.cumsum([0, *counts])
    return Strip(
        grid.reshape(-1, 2)[used], cells.reshape(-1, 8), tuple(new[k[::2]]),
        tuple(range(*pair) for pair in pairwise(ends)),
    )  # fmt: skip


def beams(pieces: Sequence[Piece], counts: Sequence[int]) -> tuple[Array, Indices]:
    """Points and three-node elements of the centre line, with counts[k] elements on piece k."""
    rows = _places(pieces, counts)
    first = np.arange(0, len(rows) - 1, 2)
    return rows[:, :2], np.column_stack([first, first + 2, first + 1])


def _places(pieces: Sequence[Piece], counts: Sequence[int]) -> Array:
    """Positions x, y and heading (k, 3) at the ends and middles of all cells."""
    rows = [
        _place(piece, j / (2 * count))
        for piece, count in zip(pieces, counts, strict=True)
        for j in range(2 * count)
    ]
    return np.array([*rows, _place(pieces[-1], 1.0)])


def _place(piece: Piece, share: float) -> tuple[float, float, float]:
    part = Piece(piece.kind, piece.x, piece.y, piece.heading, piece.length * share,
                 piece.turn * share, piece.unit)  # fmt: skip
    return *part.end, piece.heading + part.turn


def section_held(part: Strip, station: int, along: int) -> list[Held]:
    """Supports of a clamp.

    All nodes of the section are fixed in the direction `along`. In the other direction, only the
    middle node is fixed.
    """
    return [Held(part.across[station], along), Held([part.middle(station)], 1 - along)]
