"""Colour scales of fields, legible on white and on near-black."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from verify.core.figures import Array

# no end is nearly white or nearly black, and lightness grows along the unsigned ramp
UNSIGNED = ("#5f55b8", "#3f79bd", "#2b97a6", "#45b082", "#93c552", "#e0c93a")
SIGNED = ("#2a6bc8", "#7b9dcb", "#b3b3ad", "#d38a7d", "#cb3a3a")
PLAIN = "#6f8296"
UNSEEN = 1 / 256  # a share of the range below the steps of any display
ROUND_OFF = 1e-9


@dataclass(frozen=True, kw_only=True)
class Scale:
    """Scale of values from `low` to `high` over evenly spaced colour `stops`.

    Colours are linear in sRGB between the stops, as in an SVG gradient; therefore, the colour bar
    beside a picture has the same colours. Equal values have `low == high` and the middle colour.
    Without stops, the body has one colour.
    """

    low: float
    high: float
    stops: tuple[str, ...]

    def shares(self, values: Array) -> Array:
        """Positions of values along the colours, from 0 to 1."""
        span = self.high - self.low
        shares = (values - self.low) / span if span > 0 else np.full(len(values), 0.5)
        return np.asarray(np.clip(shares, 0, 1))

    def colours(self, values: Array) -> NDArray[np.uint8]:
        """RGBA colours (m, 4) of values (m,)."""
        rgb = np.array([_channels(stop) for stop in self.stops or (PLAIN,)], dtype=float)
        at = self.shares(values) * (len(rgb) - 1)
        mixed = np.column_stack([np.interp(at, np.arange(len(rgb)), c) for c in rgb.T])
        return np.column_stack([np.rint(mixed), np.full(len(values), 255)]).astype(np.uint8)


def scale(values: Array) -> Scale:
    """Scale for `values`: blue over grey to red, symmetric about zero, if both signs occur.

    Otherwise, a single colour ramp is used.
    """
    low, high = float(values.min()), float(values.max())
    reach = max(-low, high, 0.0)
    if high - low <= ROUND_OFF * max(abs(low), abs(high)):
        low = high = (low + high) / 2
    if min(-low, high) > UNSEEN * reach:
        return Scale(low=-reach, high=reach, stops=SIGNED)
    return Scale(low=low, high=high, stops=UNSIGNED)


def plain() -> Scale:
    """Scale with one colour for all values."""
    return Scale(low=0.0, high=0.0, stops=())


def _channels(colour: str) -> tuple[int, ...]:
    return tuple(bytes.fromhex(colour.removeprefix("#")))
