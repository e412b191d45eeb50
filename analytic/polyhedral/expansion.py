r"""Pressure that closes the clearance of the polyhedral ring (Belcin et al., Eqs. 6-12).

.. math::
    j_D = D_i - (d_e + 2d), \qquad \sigma_t = \frac{E j_D}{d_m}, \qquad
    p_1 = \frac{2 \delta_1 \sigma_t}{d_i}, \qquad p_{1r} = K p_1

for a round ring with the wall thickness delta_1 = (d_e - d_i)/2 under its mean hoop stress. K
corrects for the polygonal bore (d_i is the diameter through its corners); in the paper, K = 1. For
many corners, K is the ratio of Lamé's pressure to p_1,

.. math:: K \to \frac{d_m^2}{d_i d_e} \qquad (z \to \infty)

in plane stress, because in Eq. 8 the mean diameter increases by j_D, but the clearance is at the
outside. Any consistent units. Range: linear elasticity, small strain; the accuracy of K is that of
its source.

References
----------
.. [1] O. Belcin, I. Turcu, M. Pustan, Freewheeling Clutch and Polyhedral Ring, Eqs. 6-12.
.. [2] S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed.,
   McGraw-Hill 1970, art. 28.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite, positive
from analytic.ring import lame


def mean_diameter(*, d_i: ArrayLike, d_e: ArrayLike) -> Array:
    """Mean diameter [length] of a ring: d_m, or D_m of the outer race from D_i and D (Eq. 6)."""
    d_i, d_e = _wall(d_i, d_e)
    return np.asarray((d_i + d_e) / 2)


def clearance(*, D_i: ArrayLike, d_e: ArrayLike, d: ArrayLike) -> Array:
    """Diametral clearance j_D [length] (Eq. 7); negative if the rollers do not fit.

    >>> float(clearance(D_i=104.0, d_e=80.0, d=10.0))
    4.0
    """
    D_i, d_e = positive(D_i, "race's inner diameter D_i", "m"), positive(d_e, "diameter d_e", "m")
    return np.asarray(D_i - (d_e + 2 * positive(d, "roller's diameter d", "m")))


def growth(*, sigma_t: ArrayLike, d_m: ArrayLike, E: ArrayLike) -> Array:
    """Increase [length] of the mean diameter under the hoop stress sigma_t (Eq. 8)."""
    d_m, E = positive(d_m, "mean diameter d_m", "m"), positive(E, "Young's modulus", "Pa")
    return np.asarray(finite(sigma_t, "hoop stress", "Pa") * d_m / E)


def hoop_stress(*, j_D: ArrayLike, d_m: ArrayLike, E: ArrayLike) -> Array:
    """Hoop stress sigma_t [stress] of the round ring whose expansion closes j_D (Eq. 9)."""
    d_m, E = positive(d_m, "mean diameter d_m", "m"), positive(E, "Young's modulus", "Pa")
    return np.asarray(E * positive(j_D, "clearance j_D", "m") / d_m)


def pressure(*, sigma: ArrayLike, d_i: ArrayLike, d_e: ArrayLike) -> Array:
    """Pressure [stress] in equilibrium with a mean hoop stress in the wall delta_1.

    It gives p_1 from sigma_t (Eq. 10) and p_1r from sigma_tr (Eq. 12).

    >>> float(pressure(sigma=9.0, d_i=6.0, d_e=8.0))  # p d_i = 2 delta_1 sigma
    3.0
    """
    d_i, d_e = _wall(d_i, d_e)
    return np.asarray((d_e - d_i) * finite(sigma, "hoop stress", "Pa") / d_i)


def mean_hoop_stress(*, p: ArrayLike, d_i: ArrayLike, d_e: ArrayLike) -> Array:
    """Mean hoop stress [stress] in the corners under the pressure p; sigma_tr for p_1r (Eq. 12).

    It is exact before the ring touches the rollers: between neighbouring corners, p d_i sin(pi/z)
    is in equilibrium with the hoop forces, 2 sigma delta_1 sin(pi/z). sigma_tr/sigma_t is
    p_1r/p_1 = K; the printed K p_1r/p_1 is K².
    """
    d_i, d_e = _wall(d_i, d_e)
    return np.asarray(finite(p, "pressure", "Pa") * d_i / (d_e - d_i))


def touching_pressure(
    *, j_D: ArrayLike, d_i: ArrayLike, d_e: ArrayLike, E: ArrayLike, K: ArrayLike = 1.0
) -> Array:
    """Pressure p_1r [stress] at which the ring reaches the rollers (Eq. 11); p_1 with K = 1.

    >>> p = touching_pressure(j_D=0.06, d_i=72.0, d_e=80.0, E=210e3)
    >>> round(float(p), 3)  # MPa
    18.421
    """
    sigma_t = hoop_stress(j_D=j_D, d_m=mean_diameter(d_i=d_i, d_e=d_e), E=E)
    return positive(K, "correction K", "") * pressure(sigma=sigma_t, d_i=d_i, d_e=d_e)


def many_corners_factor(*, d_i: ArrayLike, d_e: ArrayLike) -> Array:
    """Factor K of a bore with very many corners, in plane stress: d_m²/(d_i d_e), above 1."""
    d_i, d_e = _wall(d_i, d_e)
    return np.asarray((d_i + d_e) ** 2 / (4 * d_i * d_e))


def round_ring_pressure(
    *, j_D: ArrayLike, d_i: float, d_e: float, E: ArrayLike, nu: float, ends: lame.Ends
) -> Array:
    """Pressure [stress] at which the outside diameter of a round ring grows by j_D (Lamé)."""
    wall = {"r_i": d_i / 2, "r_o": d_e / 2}
    u = lame.radial_displacement(d_e / 2, **wall, p_i=1.0, E=E, nu=nu, ends=ends)
    return np.asarray(positive(j_D, "clearance j_D", "m") / (2 * u))


def _wall(d_i: ArrayLike, d_e: ArrayLike) -> tuple[Array, Array]:
    d_i, d_e = np.asarray(d_i, dtype=np.float64), np.asarray(d_e, dtype=np.float64)
    if not np.all((d_i > 0) & (d_i < d_e) & np.isfinite(d_e)):
        raise ValueError(
            f"diameters of a ring must satisfy 0 < d_i < d_e, got d_i={d_i} m, d_e={d_e} m"
        )
    return d_i, d_e
