"""Damping ratios as inputs of a response, and peaks of the computed amplitudes over the speed."""

import numpy as np

from fem.rotor.elements import Array

EVEN = 1 / 1.32471795724474602596 ** np.array([1, 2])  # powers of the plastic number
LESS = 1 - 1e-9  # than the bound of Rayleigh damping


def spread_ratios(low: float, high: float, apart: float, count: int) -> Array:
    """Damping ratios (count, 2) at two frequencies; the logarithms of the ratios are spread evenly.

    The ratios are between `low` and `high` and follow the R2 sequence. `apart` is the quotient of
    the frequencies. With Rayleigh damping, the quotient of the two damping ratios is at most the
    quotient of the frequencies; the second ratio is limited accordingly.

    >>> ratios = spread_ratios(0.005, 0.03, 3.5, 64)
    >>> bool((ratios[:, 0] >= 0.005).all() and (ratios[:, 0] <= 0.03).all())
    True
    """
    share = (0.5 + np.arange(count)[:, None] * EVEN) % 1
    zeta = low * (high / low) ** share
    apart = apart * LESS
    zeta[:, 1] = np.clip(zeta[:, 1], zeta[:, 0] / apart, zeta[:, 0] * apart)
    return np.asarray(zeta)


def peaks(near: Array) -> Array:
    """Highest local maximum (...,) of the amplitudes `near` (..., speeds) over the speed.

    The result is NaN if there is no local maximum. The amplitude at an end of the range of
    speeds is never counted as a local maximum.

    >>> peaks(np.array([[1.0, 3.0, 2.0], [1.0, 2.0, 3.0]])).tolist()
    [3.0, nan]
    """
    inside = near[..., 1:-1]
    is_peak = (inside > near[..., :-2]) & (inside > near[..., 2:])
    highest = np.where(is_peak, inside, -np.inf).max(axis=-1)
    return np.asarray(np.where(np.isfinite(highest), highest, np.nan))


def above_chord(f: Array, u: Array) -> Array:
    """Largest relative excess [1] of f[1] at u[1] over the straight line through f[0] and f[2].

    >>> round(float(above_chord(np.array([[1.0], [3.3], [5.0]]), np.array([1.0, 2.0, 3.0]))), 12)
    0.1
    """
    share = (u[1] - u[0]) / (u[2] - u[0])
    chord = (1 - share) * f[0] + share * f[2]
    return np.asarray(((f[1] - chord) / chord).max())
