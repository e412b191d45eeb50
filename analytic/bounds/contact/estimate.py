"""An expected error with its tolerance."""

from typing import NamedTuple


class Estimate(NamedTuple):
    """Signed error formula/true - 1 [1] that is expected, and its tolerance."""

    error: float
    slack: float
