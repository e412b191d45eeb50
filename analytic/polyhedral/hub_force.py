r"""Polyhedral ring under point forces of the hub on its bore, mirrored in every flat and sector.

A force F = F_x + i F_y on the boundary of a half plane at s has the potentials (Flamant)

.. math:: \phi = -\frac{F}{2\pi}\ln(\zeta - s), \qquad
          \psi = \frac{\overline F}{2\pi}\ln(\zeta - s) + \frac{F}{2\pi}\frac{\bar s}{\zeta - s},

whatever the boundary's direction. All forces together are in balance, so that each logarithm may be
that of 1 - s/zeta, with its cut in the hole. To leave the rim free, too, phi is complemented by

.. math:: \phi_2(\zeta) = -\overline{\psi}\!\left(\frac{r_e^2}{\zeta}\right)
          - \zeta\,\overline{\phi'}\!\left(\frac{r_e^2}{\zeta}\right),

which is regular in the ring. On the bore f is constant between the forces: real, C, on the stretch
around the flat's middle and :math:`r e^{i\pi/z}` around the corner, and it falls by iF, hence
:math:`r = -F_x/\sin(\pi/z)`, :math:`C = r\cos(\pi/z) - F_y`. What the point forces lack of this is
bounded, and `free_rim` supplies it.

Range: points of the bore further than some widths of the hub's contact from the force.

References
----------
.. [1] S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed.,
   McGraw-Hill 1970, art. 36.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite, not_negative
from analytic.polyhedral.free_rim import FreeRim, Values, free_rim
from analytic.polyhedral.sector import Complex, Sector


@dataclass(frozen=True)
class HubForce:
    """Ring under forces per unit length at +e and -e on each flat, `normal` and `along` in all."""

    sector: Sector
    points: Complex  # of all forces
    forces: Complex
    correction: FreeRim

    @property
    def resultant(self) -> float:
        """Force on one flat per unit length, both halves."""
        return float(2 * np.abs(self.forces[0]))

    def __call__(self, zeta: Complex) -> Values:
        """Potentials at points of the ring; ValueError at the point of a force (infinite)."""
        if np.any(np.abs(np.asarray(zeta)[..., None] - self.points) < 1e-12 * self.sector.r_e):
            raise ValueError("stress and displacement are infinite at the hub's point force itself")
        return _flamant(self.sector, self.points, self.forces, zeta).plus(self.correction(zeta))

    def rim_displacement(self, theta: ArrayLike) -> Complex:
        """u_r + i u_theta on the rim, times E' [load times length], at the angles theta [rad]."""
        turn = np.exp(1j * np.atleast_1d(finite(theta, "angle", "rad")))
        return np.asarray(4 * self(self.sector.r_e * turn).phi / turn)


def hub_force(*, sector: Sector, e: float, normal: float, along: float = 0.0) -> HubForce:
    """Solution for a hub that pushes on each flat with `normal` outwards and `along` to the corner.

    Forces [force per length] act on one flat; one half acts at the distance e [length] from
    its middle, the other, mirrored, at -e: the part of a hub's push that is equal for all rollers
    at mid-flat. e counts along the bore, `Sector.half_bore` is the corner itself.

    >>> ring = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
    >>> hub = hub_force(sector=ring, e=9.0, normal=1000.0)
    >>> (1e3 * hub.rim_displacement([0, np.pi / 6]).real / 210e3).round(3).tolist()
    [44.009, 14.987]
    """
    e = float(not_negative(e, "the lever e", "m"))
    if not 0 < e <= sector.half_bore * (1 + 1e-12):
        raise ValueError(
            f"the hub pushes between mid-flat and corner: 0 < e <= {sector.half_bore:g} m, "
            f"got e={e:g} m"
        )
    normal, along = float(finite(normal, "force", "N/m")), float(finite(along, "force", "N/m"))
    s = np.array([e])
    push = complex((sector.normal(s) * (normal + 1j * along) / 2)[0])
    turns = np.exp(2j * np.pi * np.arange(sector.z) / sector.z)
    at = complex(sector.bore(s)[0])
    points = np.concatenate([turns * at, turns * at.conjugate()])
    forces = np.concatenate([turns * push, turns * push.conjugate()])
    r = -push.real / np.sin(sector.half_angle)
    middle = r * np.cos(sector.half_angle) - push.imag
    corner = r * np.exp(1j * sector.half_angle)

    def lacking(zeta: Complex, along_bore: Array) -> Complex:
        asked = np.where(along_bore < e, middle, corner)
        return np.asarray((asked - _flamant(sector, points, forces, zeta).force(zeta)) / zeta)

    return HubForce(sector, points, forces, free_rim(sector, lacking))


def _flamant(sector: Sector, points: Complex, forces: Complex, zeta: Complex) -> Values:
    """Potentials of the point forces with a free rim."""
    zeta = np.asarray(zeta)
    at = zeta[..., None]
    F, F_bar, s, s_bar = forces, forces.conj(), points, points.conj()
    beyond = sector.r_e**2 - s_bar * at
    log: Complex = np.log(1 - s / at)
    log_image: Complex = np.log(beyond / sector.r_e**2)
    phi = -log @ F - log_image @ F + (at * (at - s) / beyond) @ F_bar
    d_image = (s_bar / beyond) @ F
    d_image = d_image + ((2 * at - s) / beyond + at * (at - s) * s_bar / beyond**2) @ F_bar
    psi = log @ F_bar + (s_bar / (at - s)) @ F + log_image @ F_bar
    psi = psi - sector.r_e**2 / zeta * d_image
    parts = (phi, d_image - (1 / (at - s)) @ F, psi)
    return Values(*(part / (2 * np.pi) for part in parts))
