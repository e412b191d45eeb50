r"""Friction between sprag and race that decreases with the sliding speed (Huang 2018, Eqs. 12, 13).

.. math:: \mu_d(v) = \mu_c + (\mu_s - \mu_c)\,e^{-\gamma_b |v|}, \qquad T_{bis} = \mu_s N

As mu_d(0) = mu_s, slip begins at the largest static force T_bis. The paper gives no formula for
T_bis; only with this one are the branches of Eq. 12 continuous.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite, not_negative
from analytic.freewheel.rules import require


def coefficient(v: ArrayLike, *, mu_c: ArrayLike, mu_s: ArrayLike, gamma_b: ArrayLike) -> Array:
    """Coefficient of sliding friction at the speed `v` [m/s] of any sign; gamma_b in s/m (Eq. 13).

    Raises ValueError unless 0 < mu_c <= mu_s < 1.

    >>> coefficient([0.0, -np.log(4)], mu_c=0.25, mu_s=0.5, gamma_b=0.5).tolist()
    [0.5, 0.375]
    """
    v, gamma_b = finite(v, "sliding speed", "m/s"), not_negative(gamma_b, "gamma_b", "s/m")
    mu_c, mu_s = np.asarray(mu_c, dtype=np.float64), np.asarray(mu_s, dtype=np.float64)
    require(
        (mu_c > 0) & (mu_c <= mu_s) & (mu_s < 1), "friction needs 0 < mu_c <= mu_s < 1", "",
        mu_c=mu_c, mu_s=mu_s,
    )  # fmt: skip
    return np.asarray(mu_c + (mu_s - mu_c) * np.exp(-gamma_b * np.abs(v)))


def static_limit(*, N: ArrayLike, mu_s: ArrayLike) -> Array:
    """Largest static friction T_bis [N] under the normal force N [N] (Eq. 12).

    >>> float(static_limit(N=8.0, mu_s=0.25))
    2.0
    """
    mu_s = np.asarray(mu_s, dtype=np.float64)
    require((mu_s > 0) & (mu_s < 1), "friction needs 0 < mu_s < 1", "", mu_s=mu_s)
    return np.asarray(mu_s * not_negative(N, "normal force", "N"))
