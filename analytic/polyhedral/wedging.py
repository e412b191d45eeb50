r"""Roller wedged between the polyhedral ring and the outer race (Belcin et al., Eqs. 1-5).

The angle between the tangents at the two contacts is the full wedge angle alpha. Along the
bisector, friction acts into the wedge, and the normal forces act out of it:

.. math:: C = 2 N \left(\mu \cos\frac{\alpha}{2} - \sin\frac{\alpha}{2}\right)

C > 0 is Eq. 1, tan(alpha/2) < mu is Eq. 2. If only the two contacts act on a roller, friction is
not fully used: the two forces are in equilibrium if both act along the line through both contacts,
at the angle alpha/2 with each normal. Hence

.. math:: M_t = N \tan\frac{\alpha}{2}\, z \frac{D_i}{2}

for every mu. The printed mu N z D_i/2 (Eq. 3) is valid if a cage retains the roller with the force
C until it slips. It is an upper bound of the torque on the race, as Eq. 4 is a lower bound of N.
The contribution of the cage, z C times its lever arm, does not act on the ring. Only with free
rollers does the whole torque of the race act on the ring. The tangential force of a free roller is
at most mu N, at the largest angle, alpha = 2 arctan mu. If Eq. 2 is violated, a free roller is
expelled and carries no load. The formulas below do not check this: use `holds`.

Angles in rad, otherwise any consistent units. Range: rigid roller without weight, equal friction at
both contacts. The paper has no equation for alpha.

References
----------
.. [1] O. Belcin, I. Turcu, M. Pustan, Freewheeling Clutch and Polyhedral Ring, Eqs. 1-5.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.checks import Array, not_negative, positive


def holds(*, alpha: ArrayLike, mu: ArrayLike) -> NDArray[np.bool_]:
    """True if a free roller remains wedged (Eqs. 1 and 2); False if it slips and is expelled.

    >>> holds(alpha=[0.1, 0.2], mu=0.08).tolist()  # tan(alpha/2) = 0.05 and 0.10
    [True, False]
    """
    return np.asarray(np.tan(_wedge(alpha) / 2) < friction(mu))


def largest_angle(*, mu: ArrayLike) -> Array:
    """Wedge angle alpha [rad] below which a free roller stays wedged, 2 arctan(mu) (Eq. 2)."""
    return np.asarray(2 * np.arctan(friction(mu)))


def cage_force(*, N: ArrayLike, alpha: ArrayLike, mu: ArrayLike) -> Array:
    """Force [force] on the roller along the bisector that is needed to pull it out (Eq. 1).

    Both contacts slip. The force is negative if a force into the wedge is needed to retain the
    roller.
    """
    half, N = _wedge(alpha) / 2, not_negative(N, "normal force", "N")
    return np.asarray(2 * N * (friction(mu) * np.cos(half) - np.sin(half)))


def least_friction(*, N: float, alpha: float) -> float:
    """Coefficient of friction at which the force of Eq. 1 is zero, tan(alpha/2) (Eq. 2).

    It is computed from the forces at two friction coefficients, because Eq. 1 is linear in mu.

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
    """Normal force N [force] on each free roller under the torque M_t (Eq. 5, corrected)."""
    M_t = not_negative(M_t, "torque", "N m")
    return np.asarray(M_t / (_lever(z, D_i) * np.tan(_wedge(alpha) / 2)))


def least_normal_force(*, M_t: ArrayLike, mu: ArrayLike, z: ArrayLike, D_i: ArrayLike) -> Array:
    """Normal force [force] below which even a roller in a cage slips under M_t (Eq. 4)."""
    return np.asarray(not_negative(M_t, "torque", "N m") / (_lever(z, D_i) * friction(mu)))


def friction(mu: ArrayLike) -> Array:
    """Coefficient of friction as an array; raises ValueError outside (0, 1)."""
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
