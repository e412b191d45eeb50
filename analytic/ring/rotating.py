r"""Ring that rotates about its axis (hollow disc): stresses, displacement and strain energy.

Both walls are free. With the constants E' and nu' (E and nu in plane stress, E/(1 - nu²) and
nu/(1 - nu) in plane strain), the stresses are

.. math::
    \sigma_r &= \frac{3+\nu'}{8}\rho\omega^2
        \left(r_i^2 + r_o^2 - \frac{r_i^2 r_o^2}{r^2} - r^2\right), \\
    \sigma_\theta &= \frac{3+\nu'}{8}\rho\omega^2
        \left(r_i^2 + r_o^2 + \frac{r_i^2 r_o^2}{r^2} - \frac{1+3\nu'}{3+\nu'} r^2\right).

Plane stress applies to a ring whose length is much less than its wall thickness, plane strain to a
ring between rigid end walls. Any consistent units. Range: linear elasticity, small strain, steady
rotation.

References
----------
.. [1] S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed., McGraw-Hill 1970, art. 32.
.. [2] Huang 2018, Eq. 8.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, Assumption, in_plane, positive


def stresses(
    r: ArrayLike,
    *,
    r_i: ArrayLike,
    r_o: ArrayLike,
    rho: ArrayLike,
    omega: ArrayLike,
    nu: float,
    assumption: Assumption,
) -> tuple[Array, Array]:
    """Radial and hoop stress [stress] at the radii `r`; `omega` is in radians per time.

    >>> ring = dict(r_i=1.0, r_o=2.0, rho=4.0, omega=1.0, nu=0.0, assumption="plane stress")
    >>> sigma_r, sigma_t = stresses([1.0, 2.0], **ring)
    >>> sigma_t.tolist()  # bore: rho omega² [(3 + nu) r_o² + (1 - nu) r_i²]/4
    [13.0, 7.0]
    """
    r, r_i, r_o = _radii(r, r_i, r_o)
    load = _load(rho, omega)
    _, nu_plane = in_plane(1.0, nu, assumption)
    scale = (3 + nu_plane) / 8 * load
    both, turned = r_i**2 + r_o**2, (r_i * r_o / r) ** 2
    radial = scale * (both - turned - r**2)
    return radial, scale * (both + turned) - (1 + 3 * nu_plane) / 8 * load * r**2


def radial_displacement(
    r: ArrayLike,
    *,
    r_i: ArrayLike,
    r_o: ArrayLike,
    rho: ArrayLike,
    omega: ArrayLike,
    E: ArrayLike,
    nu: float,
    assumption: Assumption,
) -> Array:
    r"""Outward displacement [length] at the radii `r`: r (sigma_theta - nu' sigma_r)/E'.

    At the bore in plane stress it is Eq. 8 of Huang 2018,

    .. math:: \delta_{ce} = \frac{R_e}{E}\frac{(3+\nu)\rho\omega^2}{4}
              \left[R_{ed}^2 + R_e^2\,\frac{1-\nu}{3+\nu}\right].

    >>> ring = dict(r_i=1.0, r_o=2.0, rho=4.0, omega=1.0, E=1.0, nu=0.0)
    >>> float(radial_displacement(1.0, **ring, assumption="plane stress"))
    13.0
    """
    E_plane, nu_plane = in_plane(positive(E, "Young's modulus", "Pa"), nu, assumption)
    radial, hoop = stresses(r, r_i=r_i, r_o=r_o, rho=rho, omega=omega, nu=nu, assumption=assumption)
    return np.asarray(np.asarray(r, dtype=np.float64) / E_plane * (hoop - nu_plane * radial))


def strain_energy(
    *,
    r_i: float,
    r_o: float,
    rho: float,
    omega: float,
    E: float,
    nu: float,
    assumption: Assumption,
) -> float:
    r"""Strain energy [force] of the whole ring per unit length: half the work of the body force.

    .. math:: U = \pi\rho\omega^2\int_{r_i}^{r_o} r^2 u_r\,dr
    """
    _radii(r_i, r_i, r_o)
    E_plane, nu_plane = in_plane(positive(E, "Young's modulus", "Pa"), nu, assumption)
    load = float(_load(rho, omega))
    k = float(nu_plane)

    def integral(r: float) -> float:
        """Integral of r² u_r from 0 to r, with u_r in units of rho omega²/(8 E')."""
        lame = (3 + k) * (
            (1 - k) * (r_i**2 + r_o**2) * r**4 / 4 + (1 + k) * (r_i * r_o * r) ** 2 / 2
        )
        return float(lame - (1 - k**2) * r**6 / 6)

    return float(np.pi * load**2 / (8 * E_plane) * (integral(r_o) - integral(r_i)))


def _load(rho: ArrayLike, omega: ArrayLike) -> Array:
    rho = positive(rho, "density", "kg/m³")
    return np.asarray(rho * positive(omega, "angular speed", "rad/s") ** 2)


def _radii(r: ArrayLike, r_i: ArrayLike, r_o: ArrayLike) -> tuple[Array, Array, Array]:
    r, low, high = (np.asarray(x, dtype=np.float64) for x in (r, r_i, r_o))
    if not np.all((low > 0) & (low < high) & np.isfinite(high)):
        raise ValueError(
            f"radii of a ring must satisfy 0 < r_i < r_o, got r_i={low} m, r_o={high} m"
        )
    slack = 1e-12 * high  # a radius computed by the caller may miss the wall by round-off
    if not np.all((r >= low - slack) & (r <= high + slack)):
        raise ValueError(f"r must lie in the wall [{low}, {high}] m, got {r} m")
    return r, low, high
