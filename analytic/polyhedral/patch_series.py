r"""Fourier series for z equal patches of Hertz's pressure on a rim, summed in closed form.

The pressure q = q_0 (1 + 2 sum J_m cos m theta), m = z, 2z, ..., is a semi-ellipse of half-width
alpha (an angle) around each theta = 2 pi k/z, with :math:`J_m = 2 J_1(m\alpha)/(m\alpha)`. The
terms decrease slowly, and alpha may be small. Therefore, the slow parts are computed as means over
the semi-ellipse of

.. math:: \sum \frac{\cos m\theta}{m} = -\frac{1}{z}\ln\left|2\sin\frac{z\theta}{2}\right|, \qquad
          \sum \frac{\cos m\theta}{m^2} = \frac{1}{z^2}\left(\frac{\pi^2}{6} - \frac{\pi x}{2}
          + \frac{x^2}{4}\right), \quad x = z|\theta|,

and the remaining terms decrease as 1/m³ independently of J_m.
"""

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import j1

from analytic.contact.checks import Array

TERMS = 3000  # the rest left out is below 1/(2 TERMS² z³) of the first term's size
POINTS = 40


def weights(m: Array, alpha: float) -> Array:
    """Fourier coefficients J_m of a semi-elliptic pressure of mean 1; 1 for a zero width."""
    return np.asarray(2 * j1(m * alpha) / (m * alpha))


def slow_sums(theta: ArrayLike, *, z: int, alpha: float) -> tuple[Array, Array]:
    """Sums over m of J_m cos(m theta)/(m + 1) and of J_m cos(m theta)/(m² - 1).

    theta is in [0, pi/z] [rad]; the patches must not overlap, alpha < pi/z.
    """
    theta = np.atleast_1d(np.asarray(theta, dtype=np.float64))
    m = z * np.arange(1.0, TERMS + 1)
    waves = np.cos(np.outer(theta, m)) * weights(m, alpha)
    first = -_mean_log(theta, z, alpha) / z
    second = _mean_parabola(theta, z, alpha) / z**2
    return (
        first - second + waves @ (1 / (m**2 * (m + 1))),
        second + waves @ (1 / (m**2 * (m**2 - 1))),
    )


def _mean_log(theta: Array, z: int, alpha: float) -> Array:
    """Mean over the semi-ellipse of ln|2 sin(z(theta - t)/2)|, logarithmic part in closed form."""
    s = theta / alpha
    outside = np.maximum(s, 1.0)
    root = np.sqrt(outside**2 - 1)
    log = s**2 - outside * root + np.log(outside + root) - np.log(2) - 0.5
    turn = np.arange(1, POINTS + 1) * np.pi / (POINTS + 1)
    x = z * (theta[:, None] - alpha * np.cos(turn)) / 2
    smooth = np.log(np.sinc(x / np.pi)) @ np.sin(turn) ** 2 * 2 / (POINTS + 1)
    return np.asarray(np.log(z * alpha) + log + smooth)


def _mean_parabola(theta: Array, z: int, alpha: float) -> Array:
    """Mean over the semi-ellipse of pi²/6 - pi x/2 + x²/4 at x = z|theta - t|."""
    s = np.minimum(theta / alpha, 1.0)
    inside = 2 / np.pi * (s * np.arcsin(s) + np.sqrt(1 - s**2) * (2 + s**2) / 3)
    distance = np.where(theta < alpha, alpha * inside, theta)
    square = theta**2 + alpha**2 / 4
    return np.asarray(np.pi**2 / 6 - np.pi / 2 * z * distance + (z**2 * square) / 4)
