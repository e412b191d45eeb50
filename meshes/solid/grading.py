"""Positions of the ends of cells whose sizes decrease towards one end of a line."""

import math


def levels(cells: int, grading: float) -> list[float]:
    """Return the ends of `cells` cells from 0 to 1, with sizes in a decreasing geometric series.

    The end 0 is omitted. `grading` is about the ratio of the first to the last size. With twice the
    number of cells, each cell is split into two. Raises ValueError unless grading >= 1.
    """
    if not 1 <= grading < math.inf:
        raise ValueError(f"grading must be finite and at least 1, got grading={grading:g}")
    rest = [1 - k / cells for k in range(1, cells)]
    if grading > 1:
        rest = [(grading**s - 1) / (grading - 1) for s in rest]
    return [1 - s for s in rest] + [1.0]
