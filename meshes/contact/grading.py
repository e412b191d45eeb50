"""Grading: cell sizes that increase with the distance from a fine zone up to a constant size.

Roberts' stretching: with u from 1 at the fine end to 0 at the other end, the length of cells is
proportional to beta^2 - u^2. Near the fine end, each cell is longer than the previous cell by a
constant factor; at the other end, all cells have the same size. Refined meshes use the same map;
refinement therefore halves the coarse cells.
"""

import math

from scipy.optimize import brentq

from meshes.counts import at_least

FINEST, EVEN = 1e-9, 1e3  # bounds of beta - 1; at the upper one cells differ by 1e-6


def cells_along(*, length: float, first: float, growth: float) -> int:
    """Number of cells over `length` from size `first`, each at most `growth` times the previous.

    `length` and `first` have the same unit; `growth` is above 1.
    """
    rate = math.log(growth)
    beta = math.sqrt(1 + 2 * first / (rate * length))
    return at_least(math.log((beta + 1) / (beta - 1)) / (beta * rate))


def beta(*, length: float, first: float, cells: int) -> float:
    """Grading parameter beta for `cells` cells over `length`, the first of size `first`.

    If equal cells are smaller than `first`, beta gives equal cells.

    `first` is the cell size of the map at its fine end, without the growth within the first cell.
    The cell size therefore has no jump at the border of the fine zone.
    """

    def excess(log: float) -> float:
        beta = 1 + math.exp(log)
        start = (beta**2 - 1) / (2 * beta) * math.log((beta + 1) / (beta - 1))
        return start - first * cells / length

    low, high = math.log(FINEST), math.log(EVEN)
    return 1 + math.exp(high if excess(high) < 0 else brentq(excess, low, high, xtol=1e-12))


def last_cell(*, length: float, cells: int, beta: float) -> float:
    """Size of the last of `cells` cells graded by `beta`, in the unit of `length`."""
    ratio = (beta + 1) / (beta - 1)
    # distance of the last node from the far end, with u = beta (e - 1) / (e + 1)
    e = ratio ** (1 / cells)
    return length * beta * (e - 1) / (e + 1)
