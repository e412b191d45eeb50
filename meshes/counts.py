"""Number of cells for a ratio of two lengths, independent of its last digits.

Ratios of round lengths are often whole, or halfway, but for round-off. Without a tolerance the last
bits of a logarithm or a sine, which differ between processors, would choose between two meshes.
"""

import math

ROUND_OFF = 1e-9  # over a ratio: far above round-off, far below the tolerance of a cell's length


def at_least(ratio: float) -> int:
    """The least whole number that is not below `ratio`, but for round-off.

    >>> at_least(12.000000000001), at_least(12.1)
    (12, 13)
    """
    return math.ceil(ratio * (1 - ROUND_OFF))


def nearest(ratio: float) -> int:
    """The whole number nearest to a positive `ratio`, the upper one halfway but for round-off.

    >>> nearest(2.4999999999999), nearest(2.4)
    (3, 2)
    """
    return math.floor(ratio * (1 + ROUND_OFF) + 0.5)
