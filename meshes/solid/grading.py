"""Ends of cells along a line on which they shrink towards one end."""

import math


def levels(cells: int, grading: float) -> list[float]:
    """Ends (0..1] of `cells` whose sizes fall towards 1 in a geometric row, by `grading` in all.

    They lie on one map, so that twice as many halve them. ValueError unless 1 <= grading.
    """
    if not 1 <= grading < math.inf:
        raise ValueError(f"cells shrink by a factor of at least 1, got grading={grading:g}")
    rest = [1 - k / cells for k in range(1, cells)]
    if grading > 1:
        rest = [(grading**s - 1) / (grading - 1) for s in rest]
    return [1 - s for s in rest] + [1.0]
