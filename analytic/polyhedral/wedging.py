r"""Roller wedged between the polyhedral ring and the outer race (Belcin et al., Eqs. 1-5).

The tangents at the two contacts make the full wedge angle alpha. Along the bisector friction pulls
into the wedge, the normal forces push out:

.. math:: C = 2 N \left(\mu \cos\frac{\alpha}{2} - \sin\frac{\alpha}{2}\right)

C > 0 is Eq. 1, tan(alpha/2) < mu is Eq. 2. A roller that nothing but its contacts holds does not
use all of its friction: two forces are in balance when both lie on the line through both contacts,
which makes alpha/2 with each normal, so

.. math:: M_t = N \tan\frac{\alpha}{2}\, z \frac{D_i}{2}

for any mu. The printed mu N z D_i/2 (Eq. 3) holds when a cage holds the roller back
with C until it slips: an upper bound of the race's torque, as Eq. 4 is a lower bound of N. The
cage's part, z C times its lever, does not pass through the ring; all of the race's torque does
so for free rollers alone, mu N at their largest angle, alpha = 2 arctan mu. Beyond Eq. 2 a
free roller is expelled and carries nothing: check `holds`, as no formula here does so.

Angles in rad, otherwise any consistent units. Range: rigid roller without weight, friction the same
at both contacts; the paper has no equation for alpha.

References
----------
.. [1] O. Belcin, I. Turcu, M. Pustan, Freewheeling Clutch and Polyhedral Ring, Eqs. 1-5.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.checks import Array, not_negative, positive


def holds(*, alpha: ArrayLike, mu: ArrayLike) -> NDArray[np.bool_]:
    """Whether a free roller stays wedged (Eqs. 1 and 2); False if it slips and is expelled.

    >>> holds(alpha=[0.1, 0.2], mu=0.08).tolist()  # tan(alpha/2) = 0.05 and 0.10
    [True, False]
    """
    return np.asarray(np.tan(_wedge(alpha) / 2) < friction(mu))


def largest_angle(*, mu: ArrayLike) -> Array:
    """Wedge angle alpha [rad] below which a free roller stays wedged, 2 arctan(mu) (Eq. 2)."""
    return np.asarray(2 * np.arctan(friction(mu)))


def cage_force(*, N: ArrayLike, alpha: ArrayLike, mu: ArrayLike) -> Array:
    """Force [force] along the bisector that pulls the roller out when both contacts slip (Eq. 1).

    Negative if a force into the wedge is needed to hold the roller.
    """
    half, N = _wedge(alpha) / 2, not_negative(N, "normal force", "N")
    return np.asarray(2 * N * (friction(mu) * np.cos(half) - np.sin(half)))


def least_friction(*, N: float, alpha: float) -> float:
    """Coefficient of friction at which the force of Eq. 1 is zero, tan(alpha/2) (Eq. 2).

    From the force at two coefficients, in which Eq. 1 is linear.

    >>> bool(abs(least_friction(N=1.0, alpha=0.1) - np.tan(0.05)) < 1e-15)
    True
    """
    low, high = 0.25, 0.75
    at = [float(cage_force(N=N, alpha=alpha, mu=mu)) for mu in (low, high)]
    return low - at[0] * (high - low) / (at[1] - at[0])


def tangential_force(*, N: ArrayLike, alpha: ArrayLike) -> Array:
    """Tangential force [force] at either contact of a free roller, N tan(alpha/2)."""
    return np.asarray(not_negative(N, "normal force", "N") * np.tan(_wedge(alpha) / 2))


def torque(*, N: ArrayLike, alpha: ArrayLike, z: ArrayLike, D_i: ArrayLike) -> Array:
    """Torque [force x length] of z free rollers that hold (Eq. 3, corrected).

    >>> round(float(torque(N=10.0, alpha=np.pi / 2, z=6, D_i=2.0)), 12)  # tan 45° = 1
    60.0
    """
    return tangential_force(N=N, alpha=alpha) * _lever(z, D_i)


def largest_torque(*, N: ArrayLike, mu: ArrayLike, z: ArrayLike, D_i: ArrayLike) -> Array:
    """Torque [force x length] at which z caged rollers slip (Eq. 3): mu N z D_i/2."""
    return np.asarray(friction(mu) * not_negative(N, "normal force", "N") * _lever(z, D_i))


def normal_force(*, M_t: ArrayLike, alpha: ArrayLike, z: ArrayLike, D_i: ArrayLike) -> Array:
    """Normal force N [force] on each free roller that carries M_t (Eq. 5, corrected)."""
    M_t = not_negative(M_t, "torque", "N m")
    return np.asarray(M_t / (_lever(z, D_i) * np.tan(_wedge(alpha) / 2)))


def least_normal_force(*, M_t: ArrayLike, mu: ArrayLike, z: ArrayLike, D_i: ArrayLike) -> Array:
    """Normal force [force] below which even a caged roller slips under M_t (Eq. 4)."""
    return np.asarray(not_negative(M_t, "torque", "N m") / (_lever(z, D_i) * friction(mu)))


def friction(mu: ArrayLike) -> Array:
    """Coefficient of friction as an array; ValueError outside (0, 1)."""
    mu = np.asarray(mu, dtype=np.float64)
    if not np.all((mu > 0) & (mu < 1)):
        raise ValueError(f"coefficient of friction must lie in (0, 1), got mu={mu}")
    return mu


def _wedge(alpha: ArrayLike) -> Array:
    alpha = np.asarray(alpha, dtype=np.float64)
    if not np.all((alpha > 0) & (alpha < np.pi)):
        raise ValueError(f"wedge angle must lie in (0, 180) deg, got {np.degrees(alpha)} deg")
    return alpha


def _lever(z: ArrayLike, D_i: ArrayLike) -> Array:
    z = positive(z, "number of rollers", "")
    return np.asarray(z * positive(D_i, "race's inner diameter D_i", "m") / 2)
