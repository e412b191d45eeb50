r"""First-order error of Hertz's largest shear stress below a line contact.

The stresses of Hertz's half plane differ from those of a disc between flats already in the first
order of a/R; the pressures differ only in the second order. There are two first-order effects. The
opposite contact adds sigma_y = -P/(pi R), hence the shear stress P/(2 pi R) = p_0 a/(4R). By the
curvature of the circle, forces at x' are nearer to the depth z by x'²/(2R). With the kernel of the
half plane, the largest shear stress, at the depth h = g^(-1/2) a (g is the golden ratio), is

.. math:: \frac{\tau}{p_0} = g^{-5/2} + \frac{a}{R}\left[\frac{1}{4} - \frac{1}{\pi}
    \int_{-1}^{1} \frac{s^2}{2}\,\frac{6 s^2 h^2 - h^4 - s^4}{(s^2 + h^2)^3}
    \sqrt{1 - s^2}\,ds\right] = 0.3003 + 0.2082\,\frac{a}{R}, \qquad h = g^{-1/2}.

If the deformed contact line is curved, the pressure is inclined: see `tilted_shear_excess`. The
golden ratio is defined again here, independent of the formula that these terms correct.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, positive

GOLDEN = (1 + np.sqrt(5)) / 2
POINTS = 600


def shear_excess(*, a: ArrayLike, R: ArrayLike) -> Array:
    """Relative excess of the largest shear stress over Hertz's 0.300 p_0: 0.693 a/R.

    >>> round(float(shear_excess(a=0.01, R=1.0)), 5)
    0.00693
    """
    turn = np.arange(1, POINTS + 1) * np.pi / (POINTS + 1)
    s, h = np.cos(turn), GOLDEN**-0.5
    bend = s**2 / 2 * (6 * s**2 * h**2 - h**4 - s**4) / (s**2 + h**2) ** 3
    nearer = float(bend @ np.sin(turn) ** 2 / (POINTS + 1))
    ratio = positive(a, "half-width", "m") / positive(R, "radius", "m")
    return np.asarray(GOLDEN**2.5 * (1 / 4 - nearer) * ratio)


def tilted_shear_excess(kappa_a: float) -> float:
    r"""Relative excess (no unit) of the largest shear stress if the deformed line is curved.

    On a contact line with the curvature kappa, the pressure p at x' has the tangential component
    kappa x' p towards the axis. By Flamant's solution for a tangential force, this component adds
    at the depth h = g^(-1/2) a

    .. math:: \frac{\Delta\tau}{p_0} = \frac{\kappa a}{\pi}\int_{-1}^{1}
        \frac{s^2 (h^2 - s^2)}{(s^2 + h^2)^2}\sqrt{1 - s^2}\,ds = 0.02786\,\kappa a.

    >>> round(tilted_shear_excess(1.0), 4)
    0.0928
    """
    turn = np.arange(1, POINTS + 1) * np.pi / (POINTS + 1)
    s2, h2 = np.cos(turn) ** 2, 1 / GOLDEN
    mean = s2 * (h2 - s2) / (s2 + h2) ** 2 @ np.sin(turn) ** 2 / (POINTS + 1)
    return float(GOLDEN**2.5 * mean * kappa_a)
