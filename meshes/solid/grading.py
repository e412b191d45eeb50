"""Positions of the ends of cells whose sizes decrease towards one end of a line."""

import math


def levels(cells: int, grading: float) -> list[float]:
    """Ends, between 0 and 1, of `cells` cells with sizes that decrease as a geometric series.

    The end 0 is omitted. `grading` is the total ratio of first to last size. All meshes use the
    same map: twice the number of cells halves the cells. Raises ValueError unless grading >= 1.
    """
    if not 1 <= grading < math.inf:
        raise ValueError(f"grading must be finite and at least 1, got grading={grading:g}")
    rest = [1 - k / cells for k in range(1, cells)]
    if grading > 1:
        rest = [(grading**s - 1) / (grading - 1) for s in rest]
    return [1 - s for s in rest] + [1.0]
