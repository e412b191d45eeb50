r"""Line contact of cylinders with parallel axes (Hertz).

.. math::
    a = \sqrt{\frac{4PR}{\pi E^*}}, \qquad p_0 = \frac{2P}{\pi a} = \sqrt{\frac{P E^*}{\pi R}},
    \qquad p(x) = p_0\sqrt{1 - x^2/a^2}

P is the load per unit length, R the relative radius, E* the contact modulus. Only E* depends on
whether the bodies are in plane strain (long) or plane stress (thin sheets). Any consistent units.

Range: frictionless, small strain, a much smaller than every radius and than the bodies. Each body
is replaced by a half plane, each circle by a parabola. For a disc between flats, the resulting
error of p_0 is 3/16 (a/R)² (`disc_series`).

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, sec. 4.2,
   Eqs. 4.43 to 4.45.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite, positive
from analytic.contact.two_bodies import contact_modulus, relative_radius

__all__ = ["contact_modulus", "half_width", "peak_pressure", "pressure", "relative_radius"]


def half_width(*, P: ArrayLike, R: ArrayLike, E_star: ArrayLike) -> Array:
    """Half-width a [length] of the contact under the load P per unit length (Eq. 4.43).

    >>> float(half_width(P=np.pi, R=1.0, E_star=4.0))
    1.0
    """
    P, R, E_star = _load(P, R, E_star)
    return np.asarray(np.sqrt(4 * P * R / (np.pi * E_star)))


def peak_pressure(*, P: ArrayLike, R: ArrayLike, E_star: ArrayLike) -> Array:
    """Pressure p_0 [stress] in the middle of the contact (Eq. 4.45).

    >>> float(peak_pressure(P=np.pi, R=1.0, E_star=4.0))  # and P = pi a p_0 / 2 with a = 1
    2.0
    """
    P, R, E_star = _load(P, R, E_star)
    return np.asarray(np.sqrt(P * E_star / (np.pi * R)))


def pressure(x: ArrayLike, *, a: ArrayLike, p_0: ArrayLike) -> Array:
    """Contact pressure [stress] at the distance x from the middle; 0 outside the contact."""
    a, p_0 = positive(a, "half-width", "m"), positive(p_0, "peak pressure", "Pa")
    s = finite(x, "position", "m") / a
    return np.asarray(p_0 * np.sqrt(np.maximum(1 - s**2, 0.0)))


def _load(P: ArrayLike, R: ArrayLike, E_star: ArrayLike) -> tuple[Array, Array, Array]:
    return (
        positive(P, "load per length", "N/m"),
        positive(R, "relative radius", "m"),
        positive(E_star, "contact modulus", "Pa"),
    )
