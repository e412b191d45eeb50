r"""Point contact of two spheres, or of a sphere and a flat (Hertz).

.. math::
    a = \left(\frac{3PR}{4E^*}\right)^{1/3}, \qquad
    p_0 = \frac{3P}{2\pi a^2} = \left(\frac{6P{E^*}^2}{\pi^3R^2}\right)^{1/3}, \qquad
    \delta = \frac{a^2}{R}

P is the load (a force). `hertz_line` contains the functions for the relative radius R and for the
contact modulus E*, which is that of plane strain. Any consistent units. Range: frictionless, small
strain, a much smaller than the radii.

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, secs. 3.4 and 4.2,
   Eqs. 4.22 to 4.24.
"""

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import minimize_scalar

from analytic.contact.checks import Array, finite, not_negative, poisson, positive


def radius(*, P: ArrayLike, R: ArrayLike, E_star: ArrayLike) -> Array:
    """Radius a [length] of the contact under the load P (Eq. 4.22).

    >>> float(radius(P=4.0, R=2.0, E_star=6.0))
    1.0
    """
    P, R, E_star = _load(P, R, E_star)
    return np.asarray(np.cbrt(3 * P * R / (4 * E_star)))


def peak_pressure(*, P: ArrayLike, R: ArrayLike, E_star: ArrayLike) -> Array:
    """Pressure p_0 [stress] in the middle of the contact (Eq. 4.24)."""
    P, R, E_star = _load(P, R, E_star)
    return np.asarray(np.cbrt(6 * P * E_star**2 / (np.pi**3 * R**2)))


def approach(*, P: ArrayLike, R: ArrayLike, E_star: ArrayLike) -> Array:
    """Approach delta [length] of two points of the bodies far from the contact (Eq. 4.23).

    >>> float(approach(P=4.0, R=2.0, E_star=6.0))  # a²/R with a = 1
    0.5
    """
    a = radius(P=P, R=R, E_star=E_star)
    return np.asarray(a**2 / np.asarray(R))


def load(*, delta: ArrayLike, R: ArrayLike, E_star: ArrayLike) -> Array:
    r"""Load P [force] at the approach delta: :math:`\tfrac43 E^* \sqrt R\, \delta^{3/2}`.

    >>> round(float(load(delta=0.5, R=2.0, E_star=6.0)), 12)
    4.0
    """
    delta = not_negative(delta, "approach", "m")
    R, E_star = positive(R, "relative radius", "m"), positive(E_star, "contact modulus", "Pa")
    return np.asarray(4 / 3 * E_star * np.sqrt(R) * delta**1.5)


def pressure(r: ArrayLike, *, a: ArrayLike, p_0: ArrayLike) -> Array:
    """Contact pressure [stress] at the radius r; 0 outside the contact."""
    a, p_0 = _contact(a, p_0)
    s = finite(r, "radius", "m") / a
    return np.asarray(p_0 * np.sqrt(np.maximum(1 - s**2, 0.0)))


def surface_displacement(
    r: ArrayLike, *, a: ArrayLike, p_0: ArrayLike, E: ArrayLike, nu: ArrayLike
) -> Array:
    r"""Displacement [length] of one body's surface into that body, at the radius r.

    With s = r/a it is :math:`\frac{1-\nu^2}{E}\, p_0 a` times :math:`\frac{\pi}{4}(2 - s^2)`
    inside the contact and
    :math:`\frac12\left[(2 - s^2)\arcsin\frac1s + \sqrt{s^2 - 1}\right]` outside it.

    >>> body = {"E": 1.0, "nu": 0.0}
    >>> float(surface_displacement(0.0, a=2.0, p_0=1.0, **body) / np.pi)
    1.0
    """
    a, p_0 = _contact(a, p_0)
    scale = (1 - poisson(nu) ** 2) / positive(E, "Young's modulus", "Pa") * p_0 * a
    s = not_negative(r, "radius", "m") / a
    out = np.maximum(s, 1.0)
    beyond = ((2 - out**2) * np.arcsin(1 / out) + np.sqrt(out**2 - 1)) / 2
    return np.asarray(scale * np.where(s < 1, np.pi / 4 * (2 - s**2), beyond))


def axis_stresses(
    z: ArrayLike, *, a: ArrayLike, p_0: ArrayLike, nu: ArrayLike
) -> tuple[Array, Array]:
    """Stresses sigma_r = sigma_theta and sigma_z [stress] on the axis at the depth z (sec. 3.4).

    >>> sigma_r, sigma_z = axis_stresses(0.0, a=1.0, p_0=1.0, nu=0.25)  # -(1 + 2 nu)/2, -1
    >>> float(sigma_r), float(sigma_z)
    (-0.75, -1.0)
    """
    a, p_0 = _contact(a, p_0)
    t = not_negative(z, "depth", "m") / a
    sigma_z = -1 / (1 + t**2)
    sigma_r = -(1 + poisson(nu)) * (1 - t * np.arctan2(1, t)) - sigma_z / 2
    return np.asarray(p_0 * sigma_r), np.asarray(p_0 * sigma_z)


def largest_shear_stress(*, a: ArrayLike, p_0: ArrayLike, nu: float) -> tuple[Array, Array]:
    """Largest shear stress [stress] on the axis and its depth [length], by numerical maximisation.

    For nu = 0.3, the stress is 0.310 p_0 at the depth 0.481 a. The error of the depth is below
    1e-7 a.
    """
    a, p_0 = _contact(a, p_0)

    def shear(t: float) -> float:
        sigma_r, sigma_z = axis_stresses(t, a=1.0, p_0=1.0, nu=nu)
        return float(sigma_r - sigma_z) / 2

    best = minimize_scalar(
        lambda t: -shear(t), bounds=(0.0, 2.0), method="bounded", options={"xatol": 1e-10}
    )
    return p_0 * shear(best.x), a * best.x


def _contact(a: ArrayLike, p_0: ArrayLike) -> tuple[Array, Array]:
    return positive(a, "contact radius", "m"), positive(p_0, "peak pressure", "Pa")


def _load(P: ArrayLike, R: ArrayLike, E_star: ArrayLike) -> tuple[Array, Array, Array]:
    return (
        positive(P, "load", "N"),
        positive(R, "relative radius", "m"),
        positive(E_star, "contact modulus", "Pa"),
    )
