r"""Expected interval of the approach of a clamped star, from three bodies with known solutions.

First body: a layer of the height h = X - r_b on a rigid base, under loads whose spacing is the
length of a flat. It contains the star, but the clamped bore of the star curves away from the base;
the layer is too stiff for stars with a thin wall. Under a pressure wave with the wave number q, the
deflection of its surface is 2 K(q h)/(E' q) times the pressure,

.. math:: K(t) = \frac{2\kappa\sinh 2t - 4t}{2\kappa\cosh 2t + 4t^2 + 1 + \kappa^2},
          \qquad \kappa = 3 - 4\nu .

Second body: the disc through the corners, clamped on the same bore. Its radius is X/cos(pi/z), but
at most the radius R of the ring. The disc is thicker than the star below each contact and too
compliant for stars with thin walls. Third body: the disc of radius X, which is inside the star.
With few corners or thick walls, the order of the three approaches is different. The approach of the
star is expected between the smallest and the largest of the three.

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, sec. 5.8 (layers).
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.bounds.freewheel.parts import FreewheelParts, approach, half_roller
from analytic.bounds.freewheel.ring_constants import clamped_disc
from analytic.contact.checks import Array, positive

DEEP = 20.0  # q h beyond which K is 1 to round-off


def expected_approach(star: FreewheelParts, P: ArrayLike) -> tuple[Array, Array]:
    """Smallest and largest expected d_i [length] of a star under P = N/L [force/length]."""
    P = positive(P, "load per length", "N/m")
    flat, corner = _rims(star)
    found = np.array([_on_layer(star, P), _on_disc(star, flat, P), _on_disc(star, corner, P)])
    return found.min(axis=0), found.max(axis=0)


def between_discs(star: FreewheelParts, P: ArrayLike) -> Array:
    """Approach d_i [length] of a disc whose rim contains the contact point on the flat.

    The approach is interpolated between discs whose radii are those of the flats and of the
    corners. It is the expected approach of a star, to second order in the height of the corners.
    """
    P = positive(P, "load per length", "N/m")
    flat, corner = _rims(star)
    x, _ = star.centre(d_i=0.0, d_o=0.0)
    low, high = (_on_disc(star, rim, P) for rim in (flat, corner))
    share = (np.hypot(flat, x) - flat) / (corner - flat)
    return np.asarray(low + share * (high - low))


def layer_constant(*, pitch: float, kappa: float) -> float:
    """Constant k (for l = 1) of a bonded layer of height 1 under loads spaced by `pitch`.

    >>> [round(layer_constant(pitch=p, kappa=1.8), 2) for p in (500.0, 5.0)]  # others hardly matter
    [1.33, 1.33]
    """
    step = 2 * np.pi / pitch
    t = step * np.arange(1, np.ceil(DEEP / step) + 1)
    K = (2 * kappa * np.sinh(2 * t) - 4 * t) / (
        2 * kappa * np.cosh(2 * t) + 4 * t**2 + 1 + kappa**2
    )
    uniform = 4 * (kappa - 1) / (1 + kappa) ** 2  # K/t at 0: the layer pressed everywhere
    return float(2 * np.log(2 / step) + 1 + uniform * step + 2 * ((K - 1) / t * step).sum())


def _rims(star: FreewheelParts) -> tuple[float, float]:
    """Radii [length] of the discs through the flats and through the corners."""
    return star.flat, min(star.flat / np.cos(np.pi / star.z), star.race)


def _on_layer(star: FreewheelParts, P: Array) -> Array:
    height, kappa = star.flat - star.r_b, 3 - 4 * star.nu
    k = layer_constant(pitch=float(2 * star.corner / height), kappa=kappa)
    return _with_roller(star, P, height, k)


def _on_disc(star: FreewheelParts, rim: float, P: Array) -> Array:
    k = clamped_disc(ratio=rim / star.r_b, n=star.z, nu=float(star.plane[1]))
    return _with_roller(star, P, rim, k)


def _with_roller(star: FreewheelParts, P: Array, l: float, k: Array | float) -> Array:  # noqa: E741
    """Approach [length] of half a roller and a body with the constants l and k."""
    a = star.width_on_flat(P)
    return half_roller(star, P, a) + approach(P, a, E=star.plane[0], l=l, k=k)
