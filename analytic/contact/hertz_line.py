r"""Line contact of cylinders with parallel axes (Hertz).

.. math::
    a = \sqrt{\frac{4PR}{\pi E^*}}, \qquad p_0 = \frac{2P}{\pi a} = \sqrt{\frac{P E^*}{\pi R}},
    \qquad p(x) = p_0\sqrt{1 - x^2/a^2}

P is the load per unit length, R the relative radius, E* the contact modulus, which alone knows
whether the bodies are in plane strain (long) or plane stress (thin sheets). Any consistent units.

Range: frictionless, small strain, a much smaller than every radius and than the bodies: each body
is replaced by a half plane, each circle by a parabola. For a disc between flats `disc_series` says
what that costs: 3/16 (a/R)² of p_0.

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, sec. 4.2,
   Eqs. 4.43 to 4.45.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, Assumption, finite, pair_in_plane, positive


def contact_modulus(
    *, E_1: ArrayLike, nu_1: ArrayLike, E_2: ArrayLike, nu_2: ArrayLike, assumption: Assumption
) -> Array:
    r"""Contact modulus E* [stress], :math:`1/E^* = 1/E_1' + 1/E_2'`.

    E' is :math:`E/(1-\nu^2)` in plane strain (and in point contact), E in plane stress. One body
    may be rigid, `E` infinite; its `nu` then has no effect.

    >>> flat = {"E_2": np.inf, "nu_2": 0.0, "assumption": "plane strain"}
    >>> float(contact_modulus(E_1=3.0, nu_1=-0.5, **flat))  # E / (1 - 1/4)
    4.0
    """
    soft_1, _, soft_2, _ = pair_in_plane(E_1, nu_1, E_2, nu_2, assumption)
    return np.asarray(1 / (soft_1 + soft_2))


def relative_radius(*, R_1: ArrayLike, R_2: ArrayLike) -> Array:
    """Relative radius R [length], 1/R = 1/R_1 + 1/R_2.

    R_2 is infinite for a flat and negative for the bore of a ring, which must be larger than R_1.

    >>> relative_radius(R_1=2.0, R_2=[-4.0, np.inf, 2.0]).tolist()  # in a bore, on a flat, a pair
    [4.0, 2.0, 1.0]
    """
    R_1 = positive(R_1, "the roller's radius", "m")
    R_2 = np.asarray(R_2, dtype=np.float64)
    if not np.all((R_2 > 0) | (-R_2 > R_1)):
        raise ValueError(
            f"R_2 must be positive or, for a bore, beyond -R_1: got R_1={R_1} m, R_2={R_2} m"
        )
    return np.asarray(1 / (1 / R_1 + 1 / R_2))


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
    """Contact pressure [stress] at the distance x from the middle; 0 beyond the contact."""
    a, p_0 = positive(a, "half-width", "m"), positive(p_0, "peak pressure", "Pa")
    s = finite(x, "position", "m") / a
    return np.asarray(p_0 * np.sqrt(np.maximum(1 - s**2, 0.0)))


def _load(P: ArrayLike, R: ArrayLike, E_star: ArrayLike) -> tuple[Array, Array, Array]:
    return (
        positive(P, "load per length", "N/m"),
        positive(R, "relative radius", "m"),
        positive(E_star, "contact modulus", "Pa"),
    )
