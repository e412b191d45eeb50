r"""Torque and pressure of the polyhedral ring clutch (Belcin et al., Eqs. 17-21).

The normal forces N of Eq. 4 and Eq. 16 are equal. For each roller, the hub force contributes the
share s of N, and the pressure contributes the rest:

.. math::
    s = \frac{\mu D_i \cos(\gamma + \varphi_1)}{2 (r + r_1) \sin(\psi + \varphi_1)}, \qquad
    p_2 \ge \frac{2 M_t (1 - s)}{\mu D_i\, z d_i \sin(\pi/z)\, b}, \qquad p_t = p_{1r} + p_2

(Eqs. 17 to 20 with the perimeter of the polygon in place of the circumference). If s >= 1, the hub
force increases the roller forces as fast as friction requires: the pressure at which the ring
touches the rollers is sufficient, and the torque is infinite in this model. For free rollers,
tan(alpha/2) replaces mu (`wedging`).

Angles in rad, otherwise any consistent units. Range: see `wedging` and `forces`; z rollers
carry equal loads.

References
----------
.. [1] O. Belcin, I. Turcu, M. Pustan, Freewheeling Clutch and Polyhedral Ring, Eqs. 17-21.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.checks import Array, finite, not_negative, positive
from analytic.polyhedral import expansion, forces, wedging


def hub_share(
    *,
    mu: ArrayLike,
    D_i: ArrayLike,
    lever: ArrayLike,
    psi: ArrayLike,
    phi_1: ArrayLike,
    gamma: ArrayLike,
) -> Array:
    """Share s of the hub force in the normal force of the rollers (no unit); may exceed 1.

    >>> wide = {"mu": 0.1, "D_i": 10.0, "lever": 2.0, "phi_1": 0.0, "gamma": 0.0}
    >>> round(float(hub_share(psi=np.pi / 6, **wide)), 12)
    0.5
    """
    psi, phi_1 = forces.hub_angles(psi, phi_1)
    lever, D_i = positive(lever, "lever of the hub", "m"), positive(D_i, "race's D_i", "m")
    towards = np.cos(finite(gamma, "direction gamma", "rad") + phi_1)
    return np.asarray(wedging.friction(mu) * D_i * towards / (2 * lever * np.sin(psi + phi_1)))


def self_locking(share: ArrayLike) -> NDArray[np.bool_]:
    """True if the `share` of the hub is so large (>= 1) that pressure does not limit the torque."""
    return np.asarray(np.asarray(share) >= 1)


def hub_releases(*, psi: ArrayLike, phi_1: ArrayLike) -> NDArray[np.bool_]:
    """True if the hub, with reversed friction, releases the ring: psi > phi_1 (below Eq. 15)."""
    return np.asarray(np.asarray(psi) > np.asarray(phi_1))


def blocking_pressure(*, p_t: ArrayLike, p_1r: ArrayLike) -> Array:
    """Part p_2 [stress] of p_t that exceeds p_1r, the pressure at contact (Eq. 19); at least 0."""
    p_t, p_1r = not_negative(p_t, "pressure p_t", "Pa"), not_negative(p_1r, "pressure p_1r", "Pa")
    return np.maximum(p_t - p_1r, 0.0)


def torque(
    *,
    p_t: ArrayLike,
    p_1r: ArrayLike,
    share: ArrayLike,
    mu: ArrayLike,
    z: ArrayLike,
    D_i: ArrayLike,
    d_i: ArrayLike,
    b: ArrayLike,
) -> Array:
    """Largest torque M_t [force x length] under the total pressure p_t (Eqs. 17 and 20).

    It is 0 if the ring does not touch the rollers. Otherwise, it is infinite if `share` >= 1.
    """
    p_2 = blocking_pressure(p_t=p_t, p_1r=p_1r)
    F = forces.pressure_force(p_2=p_2, b=b, d_i=d_i, z=z)
    alone, share = wedging.largest_torque(N=F, mu=mu, z=z, D_i=D_i), np.asarray(share)
    rest = np.where(self_locking(share), 1.0, 1 - share)
    limited = np.where(self_locking(share) & (p_2 > 0), np.inf, alone / rest)
    return np.asarray(limited)


def required_pressure(
    *,
    M_t: ArrayLike,
    p_1r: ArrayLike,
    share: ArrayLike,
    mu: ArrayLike,
    z: ArrayLike,
    D_i: ArrayLike,
    d_i: ArrayLike,
    b: ArrayLike,
) -> Array:
    """Total pressure p_t [stress] required for the torque M_t (Eqs. 18 and 20); at least p_1r."""
    N = wedging.least_normal_force(M_t=M_t, mu=mu, z=z, D_i=D_i)
    F = N * np.maximum(1 - np.asarray(share), 0.0)
    unit = forces.pressure_force(p_2=1.0, b=b, d_i=d_i, z=z)
    return np.asarray(not_negative(p_1r, "pressure p_1r", "Pa") + F / unit)


def first_torque(
    *,
    p_t: ArrayLike,
    z: ArrayLike,
    d_i: ArrayLike,
    d_e: ArrayLike,
    D_i: ArrayLike,
    b: ArrayLike,
    E: ArrayLike,
    j_D: ArrayLike,
    mu: ArrayLike,
    psi: ArrayLike,
    phi_1: ArrayLike,
) -> Array:
    """Torque M_t [force x length] of a first design: gamma = psi, lever d_i/2, K = 1 (Eq. 21)."""
    lever = positive(d_i, "corner diameter d_i", "m") / 2
    share = hub_share(mu=mu, D_i=D_i, lever=lever, psi=psi, phi_1=phi_1, gamma=psi)
    p_1 = expansion.touching_pressure(j_D=j_D, d_i=d_i, d_e=d_e, E=E)
    return torque(p_t=p_t, p_1r=p_1, share=share, mu=mu, z=z, D_i=D_i, d_i=d_i, b=b)
