"""An error that is known beforehand up to a slack."""

from typing import NamedTuple


class Estimate(NamedTuple):
    """Signed error formula/true - 1 [1] that is expected, and how far from that it may be."""

    error: float
    slack: float
