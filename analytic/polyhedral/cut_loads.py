r"""Hoop force and bending moment in the cuts of the polyhedral ring.

The rim must be free of loads. Then, the force function f of `free_rim` is zero on the rim, and the
tension in the part of a cut at theta outside the radius r is
:math:`-\operatorname{Re} f e^{-i\theta}`. Integration by parts from the bore radius r_1 gives

.. math:: N = -\operatorname{Re} f(r_1)\,e^{-i\theta}, \qquad
          \int\sigma_\theta\,r\,dr = r_1 N - \int_{r_1}^{r_e}\operatorname{Re} f\,e^{-i\theta}\,dr.
"""

from typing import NamedTuple

import numpy as np

from analytic.polyhedral.free_rim import FreeRim
from analytic.polyhedral.hub_force import HubForce
from analytic.polyhedral.sector import Sector

POINTS = 60


class CutLoads(NamedTuple):
    """Hoop force and bending moment in a cut, per unit length of the ring."""

    force: float  # tension [force per length]
    moment: float  # of the tension about the ring's centre [force]

    def bending(self, radius: float) -> float:
        """Bending moment [force] about the point at `radius`; positive if it opens the bore."""
        return radius * self.force - self.moment


def cut_loads(*, sector: Sector, field: FreeRim | HubForce) -> tuple[CutLoads, CutLoads]:
    """Hoop forces and moments of the cuts through mid-flat and through the corner.

    >>> from analytic.polyhedral.bore_pressure import pressed
    >>> ring = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
    >>> mid, corner = cut_loads(sector=ring, field=pressed(ring))
    >>> round(mid.force, 4), round(corner.force, 4)  # p times the apothem, p d_i/2
    (31.4449, 36.0)
    """
    flat = _cut(sector, field, 0.0, sector.apothem)
    return flat, _cut(sector, field, sector.half_angle, sector.d_i / 2)


def _cut(sector: Sector, field: FreeRim | HubForce, theta: float, r_1: float) -> CutLoads:
    nodes, weights = np.polynomial.legendre.leggauss(POINTS)
    half = (sector.r_e - r_1) / 2
    r = np.append(sector.r_e - half * (1 - nodes), r_1)
    zeta = r * np.exp(1j * theta)
    beyond = -(field(zeta).force(zeta) * np.exp(-1j * theta)).real
    return CutLoads(float(beyond[-1]), float(r_1 * beyond[-1] + half * weights @ beyond[:-1]))
