"""Crowns of rollers: second implementation, for references that are independent of `crown`.

The formulas are those of `crown` with other symbols: E' = 2 E*, the half-length as the unit of
length, and logarithms of products. Any consistent units.
"""

from collections.abc import Callable

import numpy as np

from analytic.contact.checks import Array

Gap = Callable[[Array], Array]  # height over the race at places y from mid-length


def logarithmic(
    *, K_1: float, K_2: float, z_m: float, load: float, length: float, E_star: float
) -> Gap:
    """Fujiwara's crown with A = 2 K_1 Q/(pi l E'); the formula's bracket is limited to [0, 1]."""
    A = 2 * K_1 * load / (np.pi * length * 2 * E_star)

    def drop(y: Array) -> Array:
        end = np.maximum(np.abs(y) / (length / 2) - 1, -1.0)  # from -1 at mid-length to 0
        bracket = np.clip(end / K_2 + 1, 0.0, 1.0)
        return np.asarray(-A * np.log(1 - bracket**2 + np.exp(-z_m / A) * bracket**2))

    return drop


def lundberg(*, load: float, length: float, E_star: float) -> Gap:
    """Lundberg's crown (F/(pi l E*)) ln 1/((1 - s)(1 + s)), for a uniform line load."""

    def drop(y: Array) -> Array:
        s = y / (length / 2)
        return np.asarray(-load / (np.pi * length * E_star) * (np.log(1 - s) + np.log(1 + s)))

    return drop


def johns_gohar(*, load: float, length: float, half_width: float, E_star: float) -> Gap:
    """Johns and Gohar's crown, in which 2b/l has the factor 0.3033 as printed."""
    left = 1 - 0.3033 * 2 * half_width / length

    def drop(y: Array) -> Array:
        s = y / (length / 2)
        return np.asarray(load / (np.pi * length * E_star) * np.log(1 / (1 - left * s**2)))

    return drop
