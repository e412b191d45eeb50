r"""Hoop stress on bore and rim of the polyhedral ring.

The sum of both normal stresses on a wall is :math:`4\operatorname{Re}\phi'`; the stress normal to
the wall is known. The stresses of pressure, rollers and hub are superposed.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, Assumption, finite
from analytic.polyhedral.bore_pressure import pressed, stiffness_factors
from analytic.polyhedral.free_rim import FreeRim
from analytic.polyhedral.hub_force import HubForce
from analytic.polyhedral.roller_load import RollerLoad
from analytic.polyhedral.sector import Sector

ALONG = 400  # points of half the fillet among which the largest stress is sought

Field = FreeRim | RollerLoad | HubForce


def bore_stress(s: ArrayLike, *, sector: Sector, field: Field, p: float = 0.0) -> Array:
    """Hoop stress [stress] on the bore at the arc lengths s [length] from mid-flat.

    `p` is the pressure of this field on the bore at s; 0 if the bore is free there.

    >>> from analytic.polyhedral.bore_pressure import pressed
    >>> ring = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
    >>> ends = bore_stress([0.0, ring.half_bore], sector=ring, field=pressed(ring), p=1.0)
    >>> ends.round(2).tolist()  # mid-flat, corner
    [-1.22, 32.82]
    """
    s = np.atleast_1d(finite(s, "arc length", "m"))
    if not np.all((s >= 0) & (s <= sector.half_bore * (1 + 1e-12))):
        raise ValueError(f"arc lengths must lie between 0 and {sector.half_bore:g} m, got s={s} m")
    return np.asarray(4 * field(sector.bore(s)).dphi.real + finite(p, "the pressure p", "Pa"))


def rim_stress(theta: ArrayLike, *, sector: Sector, field: FreeRim | HubForce) -> Array:
    """Hoop stress [stress] on a free rim at the angles theta [rad] from mid-flat."""
    turn = np.exp(1j * np.atleast_1d(finite(theta, "angle", "rad")))
    return np.asarray(4 * field(sector.r_e * turn).dphi.real)


def largest_fillet_stress(*, sector: Sector) -> tuple[float, float]:
    """Ratio (no unit) of the largest fillet stress to the pressure; arc length [length] there.

    The arc length s is that of the point with the largest stress.

    >>> stress, s = largest_fillet_stress(sector=Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0))
    >>> round(stress, 3), round(s - 17.0, 3)  # in the corner: the fillet reaches from 0 to 1.047
    (32.816, 1.047)
    """
    arc = sector.rho * sector.half_angle
    at = np.linspace(0, arc, ALONG + 1) + sector.straight
    stress = bore_stress(at, sector=sector, field=pressed(sector), p=1.0)
    i = int(np.clip(stress.argmax(), 1, ALONG - 1))
    bend = np.polyfit([-1, 0, 1], stress[i - 1 : i + 2], 2)
    top = float(np.clip(-bend[1] / (2 * bend[0]), -1, 1))
    return float(np.polyval(bend, top)), float(at[i] + top * (at[1] - at[0]))


def corner_stress_factor(*, sector: Sector, nu: float, assumption: Assumption) -> float:
    r"""Ratio of the largest fillet stress to sigma_t = E j_D/d_m.

    The stress is that at the pressure at which the rim reaches the rollers.

    .. math:: \frac{\sigma_{max}}{\sigma_t} = \frac{\sigma_{max}}{p}\,K_{mid}\,
              \frac{2\,\delta_1}{d_i}

    >>> ring = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
    >>> round(corner_stress_factor(sector=ring, nu=0.3, assumption="plane stress"), 3)
    4.011
    """
    K = stiffness_factors(sector=sector, nu=nu, assumption=assumption)
    stress, _ = largest_fillet_stress(sector=sector)
    return stress * K.mid * (sector.d_e - sector.d_i) / sector.d_i
