"""Ends of cells along a line whose sizes decrease towards one end."""

import math


def levels(cells: int, grading: float) -> list[float]:
    """Ends (0..1] of `cells` with sizes that decrease as a geometric series, by `grading` in total.

    They are on one map: twice the number halves the cells. ValueError unless 1 <= grading.
    """
    if not 1 <= grading < math.inf:
        raise ValueError(f"cells shrink by a factor of at least 1, got grading={grading:g}")
    rest = [1 - k / cells for k in range(1, cells)]
    if grading > 1:
        rest = [(grading**s - 1) / (grading - 1) for s in rest]
    return [1 - s for s in rest] + [1.0]
