"""Number of cells for a ratio of two lengths, independent of the last digits of the ratio.

Ratios of round lengths are often whole or half numbers, except for round-off. Without a tolerance,
the choice between two meshes would depend on the last bits of a logarithm or a sine, which differ
between processors.
"""

import math

ROUND_OFF = 1e-9  # over a ratio: far above round-off, far below the tolerance of a cell's length


def at_least(ratio: float) -> int:
    """Smallest whole number that is not below `ratio`, except for round-off.

    >>> at_least(12.000000000001), at_least(12.1)
    (12, 13)
    """
    return math.ceil(ratio * (1 - ROUND_OFF))


def nearest(ratio: float) -> int:
    """Whole number nearest to a positive `ratio`; half numbers are rounded up.

    >>> nearest(2.4999999999999), nearest(2.4)
    (3, 2)
    """
    return math.floor(ratio * (1 + ROUND_OFF) + 0.5)
