r"""Slope of the deformed rim, which is the wedge angle of a roller that is not at mid-flat.

The deformed rim has the shape :math:`r_e + u_r(\theta)`. The angle between its tangent and that of
the circle is

.. math:: \frac{1}{r_e}\frac{du_r}{d\theta} = \frac{4}{E' r_e}
          \operatorname{Re}\left[i\,(\zeta\phi' - \phi)\,e^{-i\theta}\right]

on a free rim. It differs from the rotation of the material, :math:`(du_r/d\theta - u_\theta)/r_e`,
whose part u_theta/r_e only moves points along the circle.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite
from analytic.polyhedral.free_rim import FreeRim
from analytic.polyhedral.hub_force import HubForce
from analytic.polyhedral.sector import Sector

ALONG = 400  # angles among which the steepest is sought


def rim_slope(theta: ArrayLike, *, sector: Sector, field: FreeRim | HubForce) -> Array:
    """Slope times E' [stress] of the free rim, from the potentials `field`, at theta [rad].

    >>> from analytic.polyhedral.bore_pressure import pressed
    >>> ring = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
    >>> slope = rim_slope([0.0, 0.25, np.pi / 6], sector=ring, field=pressed(ring))
    >>> bool(np.allclose(slope[[0, 2]], 0, atol=1e-9)), round(float(slope[1]), 3)
    (True, -10.461)
    """
    turn = np.exp(1j * np.atleast_1d(finite(theta, "angle", "rad")))
    zeta = sector.r_e * turn
    values = field(zeta)
    return np.asarray(-4 / sector.r_e * ((zeta * values.dphi - values.phi) / turn).imag)


def steepest(*, sector: Sector, field: FreeRim | HubForce) -> tuple[float, float]:
    """Largest |slope| times E' [stress] between flat and corner, and its position theta [rad]."""
    theta = np.linspace(0, sector.half_angle, ALONG + 1)
    slope = np.abs(rim_slope(theta, sector=sector, field=field))
    i = int(np.clip(slope.argmax(), 1, ALONG - 1))
    bend = np.polyfit([-1, 0, 1], slope[i - 1 : i + 2], 2)
    top = float(-bend[1] / (2 * bend[0]))
    return float(np.polyval(bend, top)), float(theta[i] + top * (theta[1] - theta[0]))
