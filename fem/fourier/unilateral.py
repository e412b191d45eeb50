"""Non-negative contact pressures: p >= 0, gap >= 0, p . gap = 0, under a given total load."""

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cho_factor, cho_solve

from fem.plane.discretisation import Array

MAX_CHANGES = 60
ROUND_OFF = 1e-11  # relative to the largest pressure, and to the largest gap


def push_together(A: Array, gap: Array, area: Array, load: float) -> tuple[Array, float]:
    """Contact pressures (n,) of n cells, and the approach of the bodies, under the total `load`.

    `gap` (n,) and `area` (n,) are the initial gaps and the areas of the cells. A p + area (gap -
    approach) is 0 if p > 0, otherwise not negative; area . p = load. The compliance matrix `A` (n,
    n) is symmetric and positive definite. Initially all cells are in contact. Cells in tension are
    removed and overlapping cells are added until there are no such cells. Raises ArithmeticError if
    this iteration does not converge.
    """
    touching: NDArray[np.bool_] = np.ones(gap.size, bool)
    for _ in range(MAX_CHANGES):
        own = np.ix_(touching, touching)
        unit, shut = cho_solve(cho_factor(A[own]), np.array([area, area * gap]).T[touching]).T
        approach = (load + area[touching] @ shut) / (area[touching] @ unit)
        p = np.zeros(gap.size)
        p[touching] = approach * unit - shut
        opening = A @ p / area + gap - approach
        pulls = p < -ROUND_OFF * abs(p).max()
        overlaps = ~touching & (opening < -ROUND_OFF * abs(gap).max())
        if not np.any(pulls | overlaps):
            return np.maximum(p, 0.0), float(approach)
        touching = (touching & ~pulls) | overlaps
    raise ArithmeticError(
        f"the contact did not converge: after {MAX_CHANGES} changes of the set of cells in "
        f"contact, {pulls.sum()} cells are in tension, {overlaps.sum()} cells overlap"
    )
