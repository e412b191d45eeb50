r"""Stresses on the line of the load through a disc pressed between two rigid flats.

Two opposite forces at the ends of a chord of half-length y' cause two radial (Flamant) stress
fields and a uniform tension, so that the rim is free of stress. These stresses are integrated over
the pressure of `disc`. With the heights h below the upper and above the lower contact, the stresses
on the axis x = 0 are

.. math::
    \sigma_x = \int\left[\frac{y'}{\pi R^2} - \frac{2}{\pi}\sum_h
        \frac{x'^2 h}{(x'^2 + h^2)^2}\right] q\,dx', \qquad
    \sigma_y = \int\left[\frac{y'}{\pi R^2} - \frac{2}{\pi}\sum_h
        \frac{h^3}{(x'^2 + h^2)^2}\right] q\,dx'.

References
----------
.. [1] S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed.,
   McGraw-Hill 1970, art. 41: the disc under forces at the ends of a chord.
"""

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import minimize_scalar

from analytic.contact.checks import Array, positive
from analytic.contact.disc import PressedDisc

POINTS = 600


def axis_stresses(z: ArrayLike, *, disc: PressedDisc) -> tuple[Array, Array]:
    """Stresses [stress] sigma_x across and sigma_y along the load at depths z on the axis.

    z is measured from the middle of the contact and must lie between 0.1 a and R (the centre).
    Tension is positive. Depths below 0.1 a raise ValueError, because the fixed number of points is
    not sufficient there.

    >>> from analytic.contact.disc import disc_in_contact
    >>> disc = disc_in_contact(a=1e-3, R=1.0, E_plane=1.0)
    >>> sx, sy = axis_stresses(1.0, disc=disc)  # at the centre, in P/(pi R)
    >>> round(float(sx / disc.P * np.pi), 5), round(float(sy / disc.P * np.pi), 5)
    (1.0, -3.0)
    """
    z = positive(z, "depth", "m")
    if not np.all((z >= 0.1 * disc.a) & (z <= disc.R)):
        raise ValueError(
            f"depth z must lie between 0.1 a and R, got z={z} m with a={disc.a:g} m, R={disc.R:g} m"
        )
    turn = np.arange(1, POINTS + 1) * np.pi / (POINTS + 1)
    x = disc.a * np.cos(turn)
    q = disc.pressure(x) * disc.a * np.sin(turn) * np.pi / (POINTS + 1)
    y = np.sqrt(disc.R**2 - x**2)
    height = disc.R - z[..., None]
    tension = q @ y / (np.pi * disc.R**2)
    across, along = tension, tension
    for h in (y - height, y + height):
        radial = -2 / np.pi * h / (x**2 + h**2) ** 2
        across = across + (radial * x**2) @ q
        along = along + (radial * h**2) @ q
    return np.asarray(across), np.asarray(along)


def largest_shear_stress(*, disc: PressedDisc) -> tuple[float, float]:
    """Largest in-plane shear stress [stress] on the axis and its depth [length].

    >>> from analytic.contact.disc import disc_in_contact
    >>> disc = disc_in_contact(a=1e-2, R=1.0, E_plane=1.0)
    >>> tau, z = largest_shear_stress(disc=disc)  # 0.3003 + 0.2082 a/R + ...
    >>> round(tau / disc.p_0, 4)
    0.3024
    """

    def shear(t: float) -> float:
        across, along = axis_stresses(t * disc.a, disc=disc)
        return float(across - along) / 2

    top = min(1.6, disc.R / disc.a)
    found = minimize_scalar(
        lambda t: -shear(t) / disc.p_0, bounds=(0.4, top), method="bounded", options={"xatol": 1e-9}
    )
    return shear(float(found.x)), float(found.x) * disc.a
