r"""Polyhedral ring under z equal rollers that press on its rim above the middle of each flat.

Each roller presses radially with N per unit length, distributed as a semi-ellipse (Hertz) over the
arc -a <= r_e theta <= a. For the full disc under the same load with the Fourier coefficients c_m,

.. math:: \phi = -r_e\sum_{m \ge 0} \frac{c_m}{m + 1}\,\xi^{m+1}\;
          (\text{half of the term } m = 0), \qquad
          \psi = r_e\sum_{m > 0} \frac{m\,c_m}{m - 1}\,\xi^{m-1}, \qquad \xi = \zeta/r_e,

m = 0, z, 2z, ... The series converge geometrically on the bore. The potential of `free_rim` removes
the forces of the disc from the bore. The displacement of the rim of the disc, including its
indentation, is

.. math:: u_r = -r_e\left[\frac{4}{E'}\left(\frac{c_0}{2} + \sum\frac{c_m\cos m\theta}{m + 1}\right)
          - \frac{1 + \nu'}{E'}\left(c_0 - 2\sum\frac{c_m\cos m\theta}{m^2 - 1}\right)\right].

References
----------
.. [1] N. I. Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity,
   Noordhoff 1953: the disc under forces on its boundary.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, Assumption, finite, in_plane, positive
from analytic.polyhedral.bore_pressure import mean_rim_displacement
from analytic.polyhedral.free_rim import FreeRim, Values, free_rim
from analytic.polyhedral.patch_series import slow_sums, weights
from analytic.polyhedral.sector import Complex, Sector

DEEPEST = 0.999  # relative to the outside radius: nearer to the load the disc's series is too slow
DIGITS = 38.0  # the disc's series ends where its terms have fallen by exp(-38)


@dataclass(frozen=True)
class RollerLoad:
    """Ring under the force N = 1 per roller and unit length, on patches of half-width a."""

    sector: Sector
    a: float
    correction: FreeRim

    def __call__(self, zeta: Complex) -> Values:
        """Potentials at points of the ring up to 0.999 of the outside radius."""
        largest = float(np.abs(zeta).max())
        if largest > DEEPEST * self.sector.r_e:
            raise ValueError(
                f"points must have |zeta| <= {DEEPEST} d_e/2, got |zeta|={largest:g} m, "
                f"d_e={self.sector.d_e:g} m"
            )
        return _disc(self.sector, self.a, zeta).plus(self.correction(zeta))

    def rim_displacement(
        self, theta: ArrayLike, *, E: float, nu: float, assumption: Assumption
    ) -> Array:
        """Radial displacements u_r [length] of the rim for N = 1 at angles in [0, pi/z] [rad].

        Inward displacements are negative.
        """
        theta = np.atleast_1d(finite(theta, "angle", "rad"))
        E_plane, nu_plane = in_plane(positive(E, "Young's modulus", "Pa"), nu, assumption)
        z, half = self.sector.z, self.sector.half_angle
        if not np.all((theta >= 0) & (theta <= half * (1 + 1e-12))):
            raise ValueError(f"angles must lie between 0 and pi/z, got theta={theta} rad, z={z}")
        first, second = slow_sums(theta, z=z, alpha=self.a / self.sector.r_e)
        disc = -4 * (0.5 + first) + (1 + nu_plane) * (1 - 2 * second)
        own = z / (2 * np.pi) * disc
        return np.asarray((own + self.correction.rim_displacement(theta).real) / E_plane)

    def mean_rim_displacement(self, *, E: float, nu: float, assumption: Assumption) -> float:
        """Mean of u_r [length] over the rim for N = 1."""
        E_plane, nu_plane = in_plane(positive(E, "Young's modulus", "Pa"), nu, assumption)
        own = -self.sector.z / (2 * np.pi) * (1 - nu_plane)
        return float((own + mean_rim_displacement(self.correction)) / E_plane)


def roller_load(*, sector: Sector, a: float) -> RollerLoad:
    """Ring under unit roller forces on patches of half-width a [length], which must not overlap.

    >>> ring = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
    >>> load = roller_load(sector=ring, a=0.2)
    >>> steel = {"E": 210e3, "nu": 0.3, "assumption": "plane stress"}
    >>> (1e6 * load.rim_displacement([0, np.pi / 6], **steel)).round(2).tolist()
    [-74.41, -7.54]
    """
    a = float(positive(a, "the patch's half-width a", "m"))
    if a >= sector.half_angle * sector.r_e:
        raise ValueError(
            f"patches must not overlap: a must be less than pi d_e/(2 z), got a={a:g} m, "
            f"z={sector.z}"
        )
    correction = free_rim(sector, lambda zeta, _: -_disc(sector, a, zeta).force(zeta) / zeta)
    return RollerLoad(sector, a, correction)


def _disc(sector: Sector, a: float, zeta: Complex) -> Values:
    """Potentials of the full disc under unit forces."""
    z, r_e = sector.z, sector.r_e
    xi = np.asarray(zeta) / r_e
    count = int(DIGITS / (z * np.log(1 / np.abs(xi).max()))) + 1
    m = z * np.arange(1.0, count + 1)
    mean = z / (2 * np.pi * r_e)
    c = mean * weights(m, a / r_e)
    parts = np.stack([c / (m + 1), c, c * m / (m - 1)], axis=1)
    omega = xi**z
    phi, dphi, psi = omega * np.polynomial.polynomial.polyval(omega, parts)
    return Values(-r_e * xi * (mean / 2 + phi), -(mean / 2 + dphi), r_e * psi / xi)
