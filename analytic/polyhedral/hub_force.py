r"""Polyhedral ring under point forces of the hub on its bore, symmetric in every flat and sector.

A force F = F_x + i F_y on the boundary of a half plane at s has the potentials (Flamant)

.. math:: \phi = -\frac{F}{2\pi}\ln(\zeta - s), \qquad
          \psi = \frac{\overline F}{2\pi}\ln(\zeta - s) + \frac{F}{2\pi}\frac{\bar s}{\zeta - s},

for every direction of the boundary. All forces together are in equilibrium, so that each logarithm
can be replaced by that of 1 - s/zeta, whose branch cut is in the hole. So that the rim is also free
of forces, phi is complemented by

.. math:: \phi_2(\zeta) = -\overline{\psi}\!\left(\frac{r_e^2}{\zeta}\right)
          - \zeta\,\overline{\phi'}\!\left(\frac{r_e^2}{\zeta}\right),

which is regular in the ring. On the bore, f is constant between the forces: the real value C around
mid-flat and :math:`r e^{i\pi/z}` around the corner. At a force, f decreases by iF, hence
:math:`r = -F_x/\sin(\pi/z)`, :math:`C = r\cos(\pi/z) - F_y`. The difference between this f and the
f of the point forces is bounded; `free_rim` gives the potential that corrects it.

Range: points of the bore at a distance of at least a few widths of the hub contact from the force.

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
    """Ring under normal and tangential forces per unit length at +e and -e on each flat."""

    sector: Sector
    points: Complex  # of all forces
    forces: Complex
    correction: FreeRim

    @property
    def resultant(self) -> float:
        """Resultant force per unit length on one flat: sum of both halves."""
        return float(2 * np.abs(self.forces[0]))

    def __call__(self, zeta: Complex) -> Values:
        """Potentials at the points zeta of the ring; raises ValueError at the point of a force."""
        if np.any(np.abs(np.asarray(zeta)[..., None] - self.points) < 1e-12 * self.sector.r_e):
            raise ValueError(
                "stress and displacement are infinite at the point force of the hub: evaluate "
                "other points"
            )
        return _flamant(self.sector, self.points, self.forces, zeta).plus(self.correction(zeta))

    def rim_displacement(self, theta: ArrayLike) -> Complex:
        """Displacements u_r + i u_theta of the rim times E' [load times length] at theta [rad]."""
        turn = np.exp(1j * np.atleast_1d(finite(theta, "angle", "rad")))
        return np.asarray(4 * self(self.sector.r_e * turn).phi / turn)


def hub_force(*, sector: Sector, e: float, normal: float, along: float = 0.0) -> HubForce:
    """Ring under hub forces on each flat: `normal` acts outwards, `along` towards the corner.

    The forces [force per length] act on one flat. One half acts at the distance e [length] from
    mid-flat, the other half, mirrored, at -e. This is the symmetric part of the hub force; the
    antisymmetric part causes no radial displacement at mid-flat, where the rollers are. e is
    measured along the bore; the corner is at `Sector.half_bore`.

    >>> ring = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
    >>> hub = hub_force(sector=ring, e=9.0, normal=1000.0)
    >>> (1e3 * hub.rim_displacement([0, np.pi / 6]).real / 210e3).round(3).tolist()
    [44.009, 14.987]
    """
    e = float(not_negative(e, "the lever e", "m"))
    if not 0 < e <= sector.half_bore * (1 + 1e-12):
        raise ValueError(
            f"the hub force must act between mid-flat and corner: 0 < e <= {sector.half_bore:g} m, "
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
