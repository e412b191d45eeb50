"""Crowns of rollers in a second implementation, for references that are independent.

Same as in `crown`, with other symbols: E' for 2 E*, the half-length as a
unit, and logarithms of products. Any consistent units.
"""

from collections.abc import Callable

import numpy as np

from analytic.contact.checks import Array

Gap = Callable[[Array], Array]  # height over the race at places y from mid-length


def logarithmic(
    *, K_1: float, K_2: float, z_m: float, load: float, length: float, E_star: float
) -> Gap:
    """Fujiwara's crown with its bracket cut off at zero, for both ends: A = 2 K_1 Q/(pi l E')."""
    A = 2 * K_1 * load / (np.pi * length * 2 * E_star)

    def drop(y: Array) -> Array:
        end = np.maximum(np.abs(y) / (length / 2) - 1, -1.0)  # from -1 at mid-length to 0
        bracket = np.clip(end / K_2 + 1, 0.0, 1.0)
        return np.asarray(-A * np.log(1 - bracket**2 + np.exp(-z_m / A) * bracket**2))

    return drop


def lundberg(*, load: float, length: float, E_star: float) -> Gap:
    """Lundberg's crown, for a uniform load: (F/(pi l E*)) ln 1/((1 - s)(1 + s))."""

    def drop(y: Array) -> Array:
        s = y / (length / 2)
        return np.asarray(-load / (np.pi * length * E_star) * (np.log(1 - s) + np.log(1 + s)))

    return drop


def johns_gohar(*, load: float, length: float, half_width: float, E_star: float) -> Gap:
    """Johns and Gohar's crown with the constant that they print, 0.3033 of 2b/l."""
    left = 1 - 0.3033 * 2 * half_width / length

    def drop(y: Array) -> Array:
        s = y / (length / 2)
        return np.asarray(load / (np.pi * length * E_star) * np.log(1 / (1 - left * s**2)))

    return drop
