r"""Polyhedral ring under a uniform pressure p on its bore.

The boundary function on the bore is :math:`f = -p\,\zeta`; `free_rim` computes the solution.

Range: linear elasticity, small strain. For z from 3 to 48, walls (d_e - d_i)/2 from 0.01 to 0.25
d_e and fillets from d_e/320, the relative error is 1e-7 for displacements and 1e-5 for the stress
in the fillet.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Assumption, finite, in_plane, positive
from analytic.polyhedral.free_rim import FreeRim, free_rim
from analytic.polyhedral.sector import Complex, Sector


@dataclass(frozen=True, kw_only=True)
class StiffnessFactors:
    """Stiffness factors K if the expansion j_D/2 is that at mid-flat, the mean, or at a corner.

    A factor is negative if the rim contracts.
    """

    mid: float  # above the flat, where the roller sits
    mean: float  # on average over the outside
    corner: float  # above the corner
    residual: float  # of the series, see `free_rim`


@lru_cache(maxsize=64)
def pressed(sector: Sector) -> FreeRim:
    """Potential of the ring under unit pressure on its bore."""
    return free_rim(sector, lambda zeta, _: np.full(zeta.shape, -1.0 + 0j))


def rim_displacement(
    theta: ArrayLike, *, sector: Sector, p: float, E: float, nu: float, assumption: Assumption
) -> Complex:
    """Displacements u_r + i u_theta [length] of the rim at the angles theta [rad] from mid-flat.

    >>> ring = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
    >>> u = rim_displacement([0, np.pi / 6], sector=ring, p=10.0, E=210e3, nu=0.3,
    ...                      assumption="plane stress")
    >>> u.real.round(5).tolist()  # the flat's middle bulges
    [0.01481, 0.00618]
    """
    E_plane, _ = in_plane(positive(E, "Young's modulus", "Pa"), nu, assumption)
    p = float(finite(p, "the pressure p", "Pa"))
    return np.asarray(p / E_plane * pressed(sector).rim_displacement(finite(theta, "angle", "rad")))


def mean_rim_displacement(ring: FreeRim) -> float:
    """Mean radial displacement u_r of the rim, times E' [load times length]."""
    wall = ring.sector.z * np.log(2 * ring.sector.r_e / ring.sector.d_i)
    count = int(20 / wall) + 8  # the midpoint rule's error falls as the wall's ratio to the 2 count
    theta = (np.arange(count) + 0.5) / count * ring.sector.half_angle
    return float(ring.rim_displacement(theta).real.mean())


def stiffness_factors(*, sector: Sector, nu: float, assumption: Assumption) -> StiffnessFactors:
    r"""Stiffness factors K = p/p_1 of a polygonal ring relative to a thin round ring.

    p is the pressure at which the rim expands by j_D/2, and p_1 that of the thin round ring.

    .. math:: p_1 = \frac{2\,\delta_1 E\, j_D}{d_i d_m}, \qquad d_m = \frac{d_e + d_i}{2},
              \qquad \delta_1 = \frac{d_e - d_i}{2}

    E and j_D cancel; nu has an effect only in plane strain.

    >>> ring = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
    >>> K = stiffness_factors(sector=ring, nu=0.3, assumption="plane stress")
    >>> round(K.mid, 4), round(K.mean, 4), round(K.corner, 4)
    (1.0999, 1.433, 2.6366)
    """
    E_plane, _ = in_plane(1.0, nu, assumption)
    ring = pressed(sector)
    mid, corner = ring.rim_displacement([0.0, sector.half_angle]).real
    thin = sector.d_i * (sector.d_e + sector.d_i) / (4 * (sector.d_e - sector.d_i))
    return StiffnessFactors(
        mid=float(thin * E_plane / mid),
        mean=float(thin * E_plane / mean_rim_displacement(ring)),
        corner=float(thin * E_plane / corner),
        residual=ring.residual,
    )
