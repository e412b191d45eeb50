r"""Expected interval of a clamped star's approach, from three bodies that can be solved.

A layer of the height h = X - r_b, bonded to a rigid base, under loads a flat's length apart, holds
the star's material inside, and its clamp falls away from the base: for stars of thin wall it is too
stiff. Its surface gives way to a wave of the number q by 2 K(q h)/(E' q) times its pressure,

.. math:: K(t) = \frac{2\kappa\sinh 2t - 4t}{2\kappa\cosh 2t + 4t^2 + 1 + \kappa^2},
          \qquad \kappa = 3 - 4\nu .

The disc through the corners, of the radius X/cos(pi/z) or R where the ring is nearer, clamped on
the same bore, is deeper than the star under any contact: for stars of thin wall it is too soft.
The disc of radius X lies inside the star. Few corners or thick walls put the three in another
order; the star is expected between the least and the largest.

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, sec. 5.8 (layers).
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, positive
from analytic.freewheel import series
from analytic.freewheel.clutch import Clutch
from analytic.freewheel.compliance import Body, compliance
from analytic.freewheel.geometry import InnerCam

DEEP = 20.0  # q h beyond which K is 1 to round-off


def expected_approach(clutch: Clutch, P: ArrayLike) -> tuple[Array, Array]:
    """Least and largest d_i [length] of an inner cam under P = N/L, of one clutch."""
    if not isinstance(clutch.cam, InnerCam):
        raise ValueError("the interval is that of a star: the clutch needs an inner cam")
    P = positive(P, "load per length", "N/m")
    flat, corner = _rims(clutch)
    found = np.array([
        _approach(clutch, body, P)
        for body in (_layer(clutch), _disc(clutch, flat), _disc(clutch, corner))
    ])  # fmt: skip
    return found.min(axis=0), found.max(axis=0)


def between_discs(clutch: Clutch, P: ArrayLike) -> Array:
    """Approach d_i [length] of a disc through the contact, drawn between those of the two discs.

    What `compliance` should say of a star, to second order in the corners' height: for judging it.
    """
    P = positive(P, "load per length", "N/m")
    flat, corner = _rims(clutch)
    x, _ = clutch.cam.centre(d_i=0.0, d_o=0.0)
    low, high = (_approach(clutch, _disc(clutch, rim), P) for rim in (flat, corner))
    share = (np.hypot(flat, x) - flat) / (corner - flat)
    return np.asarray(low + share * (high - low))


def _rims(clutch: Clutch) -> tuple[Array, Array]:
    """Radii [length] of the discs through the flats and through the corners."""
    flat = clutch.cam.flat
    return flat, np.minimum(flat / np.cos(np.pi / clutch.cam.count), clutch.cam.race)


def _approach(clutch: Clutch, body: Body, P: Array) -> Array:
    """Of half a roller and a star [length]."""
    a, _ = clutch.half_widths(P)
    half, _ = compliance(clutch).half_roller.approach(P, a)
    return np.asarray(half + body.approach(P, a)[0])


def layer_constant(*, pitch: float, kappa: float) -> float:
    """K of a bonded layer of height 1 under loads at the distance `pitch`, for l = 1.

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


def _layer(clutch: Clutch) -> Body:
    cam, (E, _) = clutch.cam, clutch.inner.plane
    height = cam.flat - np.asarray(clutch.r_b)
    kappa = 3 - 4 * float(np.asarray(clutch.inner.nu))
    k = layer_constant(pitch=float(2 * cam.corner / height), kappa=kappa)
    return Body(E=E, l=height, k=np.asarray(k))


def _disc(clutch: Clutch, rim: Array) -> Body:
    E, nu = clutch.inner.plane
    k = series.star_constant(ratio=rim / np.asarray(clutch.r_b), n=clutch.cam.count, nu=nu)
    return Body(E=E, l=rim, k=k)
