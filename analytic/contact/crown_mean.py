"""Mean of the logarithmic crown (Eq. 1) over the length, and its sensitivity to the end drop.

A is the depth 2 K_1 Q/(pi l E') [length], K_2 the crowned fraction of the length, z_m the drop at
the ends. All lengths have the same unit.
"""

import numpy as np


def mean_drop(A: float, K_2: float, z_m: float) -> float:
    r"""Mean drop [length] of the crown of Eq. 1 over the length of the roller.

    .. math:: \bar z = K_2\left[z_m + 2A - 2A\,\frac{\operatorname{artanh}\sqrt c}{\sqrt c}\right],
        \qquad c = 1 - e^{-z_m/A}

    >>> round(mean_drop(1.0, 1.0, 1e-3) / 1e-3, 3)  # a parabola: a third
    0.333
    """
    c = -np.expm1(-z_m / A)
    return float(K_2 * (z_m + 2 * A * (1 - _around(c, z_m / A))))


def z_m_share(A: float, z_m: float) -> float:
    r"""Relative increase of the mean drop per relative increase of z_m (no unit).

    .. math:: \frac{z_m}{\bar z}\frac{\partial\bar z}{\partial z_m}, \qquad
        \frac{\partial\bar z}{\partial z_m}
        = K_2\left[1 - \frac1c + \frac{e^{-z_m/A}\operatorname{artanh}\sqrt c}{c\sqrt c}\right]

    >>> round(z_m_share(1.0, 1e-3), 3), round(z_m_share(1.0, 40.0), 3)  # a parabola; Lundberg's
    (1.0, 0.0)
    """
    c, left = -np.expm1(-z_m / A), np.exp(-z_m / A)
    slope = 1 - (1 - left * _around(c, z_m / A)) / c
    return float(z_m * slope / mean_drop(A, 1.0, z_m))


def _around(c: float, m: float) -> float:
    """artanh(√c)/√c of c = 1 - exp(-m), accurate also where c rounds to 1."""
    root = np.sqrt(c)
    return float((np.log1p(root) + m / 2) / root)  # 1 - c = exp(-m)
