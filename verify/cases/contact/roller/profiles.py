"""Gaps of rollers as the reference takes them: written a second time, so that none judges itself.

What `analytic.contact.crown` has for the formulas stands here in the paper's own letters: E' for
2 E*, the half-length as a unit, and logarithms of products.
"""

from collections.abc import Callable

import numpy as np

from verify.cases.contact.roller.inputs import Crown, Roller, Tilt
from verify.core.figures import Array

Gap = Callable[[Array], Array]


def gap(q: Roller) -> Gap:
    """Height over the race at y: of the crown where there is one, and of the tilt."""
    crown = logarithmic(q, (q.K_1, q.K_2, q.z_m), q.Q) if isinstance(q, Crown) else np.zeros_like
    slope = np.tan(q.theta) if isinstance(q, Tilt) else 0.0
    return lambda y: crown(y) - slope * y


def logarithmic(q: Roller, design: tuple[float, float, float], Q: float) -> Gap:
    """Eq. 1 with its bracket cut off at zero, for both ends: A = 2 K_1 Q/(pi l E')."""
    K_1, K_2, z_m = design
    A = 2 * K_1 * Q / (np.pi * q.L * 2 * q.E_star)

    def drop(y: Array) -> Array:
        end = np.maximum(np.abs(y) / (q.L / 2) - 1, -1.0)  # from -1 at mid-length to 0
        bracket = np.clip(end / K_2 + 1, 0.0, 1.0)
        return np.asarray(-A * np.log(1 - bracket**2 + np.exp(-z_m / A) * bracket**2))

    return drop


def lundberg(q: Roller) -> Gap:
    """What a uniform load sinks less by towards the ends: (F/(pi l E*)) ln 1/((1 - s)(1 + s))."""

    def drop(y: Array) -> Array:
        s = y / (q.L / 2)
        return np.asarray(-q.F / (np.pi * q.L * q.E_star) * (np.log(1 - s) + np.log(1 + s)))

    return drop


def johns_gohar(q: Roller) -> Gap:
    """The same with the constant that Johns and Gohar print, 0.3033 of 2b/l."""
    left = 1 - 0.3033 * 2 * q.b / q.L

    def drop(y: Array) -> Array:
        s = y / (q.L / 2)
        return np.asarray(q.F / (np.pi * q.L * q.E_star) * np.log(1 / (1 - left * s**2)))

    return drop
