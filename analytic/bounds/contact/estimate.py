"""Expected error of a formula, with its tolerance."""

from typing import NamedTuple


class Estimate(NamedTuple):
    """Expected signed error (formula/true value - 1) [1], and its tolerance."""

    error: float
    slack: float
