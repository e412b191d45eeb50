"""Data type of a measured error of a formula over one or two inputs, for a figure."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from verify.core.figures import Array

LIMITS = (0.02, 0.05, 0.10)
TINY = 5e-4  # smaller errors cannot be distinguished in a figure


@dataclass(frozen=True, kw_only=True)
class Measured:
    """Error (formula - FE)/scale of a formula with its expanded uncertainty `U`, on a grid.

    `x` (n,) and `y` (m,) are in the units of their labels. `error` and `U` are (n, m), or (n,)
    without `y`; they are NaN where nothing was solved. `nominal` is the position of the inputs of
    the file; it is None if inputs that are not drawn differ from the file. `box` contains the first
    and last x and y of the region with the name `box_name`. `log` states for x and y whether their
    values have equal ratios. `unsafe_sign` is the sign of errors on the unsafe side, 0 for both
    signs.
    """

    title: str
    x: Array
    x_label: str
    error: Array
    U: Array
    y: Array | None = None
    y_label: str = ""
    limits: tuple[float, ...] = LIMITS
    nominal: tuple[float, ...] | None = None
    box: tuple[tuple[float, float], tuple[float, float]] | None = None
    box_name: str = ""
    log: tuple[bool, ...] = (False, False)
    note: str = ""
    unsafe_sign: int | None = None

    @property
    def unsafe(self) -> NDArray[np.bool_]:
        """Whether an error is beyond the last limit on the unsafe side."""
        if self.unsafe_sign is None:
            return np.zeros(self.error.shape, dtype=bool)
        size = self.unsafe_sign * self.error if self.unsafe_sign else np.abs(self.error)
        return np.asarray(size > self.limits[-1])


def all_within(error: Array, U: Array) -> str:
    """Text with a limit of all errors and their bars, if they are too small for a figure.

    The text is empty if an error with its bar is large enough for a figure.
    """
    reach = (np.abs(error) + U)[np.isfinite(error)]
    if not reach.size or not (largest := float(reach.max())) < TINY:
        return ""
    if largest == 0:
        return "no difference"
    exponent = math.floor(math.log10(largest))
    bound = math.ceil(largest / 10.0**exponent - 1e-9) * 10.0**exponent
    words = np.format_float_positional(100 * bound, precision=1, fractional=False, trim="-")
    return f"all errors within {words} %"


def inside(error: Array, U: Array, limit: float) -> NDArray[np.bool_]:
    """Whether the whole error bar is within a limit."""
    return np.asarray(np.abs(error) + U <= limit)


def undecided(error: Array, U: Array, limits: Sequence[float]) -> NDArray[np.bool_]:
    """Whether an error bar extends across a limit, so that the result is undecided."""
    size = np.abs(error)
    across = [(size - U <= limit) & (size + U > limit) for limit in limits]
    return np.asarray(np.any(across, axis=0))
