"""Largest hoop stress in the fillets of a ring under pressure, hub force and roller forces."""

import numpy as np

from analytic.polyhedral.bore_pressure import pressed
from analytic.polyhedral.capacity import Driven
from analytic.polyhedral.hub_force import HubForce, hub_force
from analytic.polyhedral.roller_load import roller_load
from analytic.polyhedral.sector import Sector
from analytic.polyhedral.wall_stress import bore_stress

ALONG = 200  # points of the fillet


def loaded_fillet_stress(
    sector: Sector, *, p: float, hub: HubForce | None = None, N: float = 0.0, a: float = 0.0
) -> float:
    """Largest fillet stress [stress] under p, the hub force, and N on patches of width 2 a.

    The patches are on the rim above the flats. N is per unit length and 0 if the rollers do not
    touch. The stress is the largest at equally spaced points of the fillet.

    >>> ring = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
    >>> alone, pressed_back = (loaded_fillet_stress(ring, p=30.0, N=N, a=0.1) for N in (0.0, 180.0))
    >>> round(alone, 1), pressed_back < alone
    (984.5, True)
    """
    at = sector.straight + np.linspace(0, 1, ALONG + 1) * sector.rho * sector.half_angle
    stress = p * bore_stress(at, sector=sector, field=pressed(sector), p=1.0)
    if hub is not None:
        stress = stress + bore_stress(at, sector=sector, field=hub)
    if N:
        load = roller_load(sector=sector, a=a)
        stress = stress + N * bore_stress(at, sector=sector, field=load)
    return float(stress.max())


def driven_fillet_stress(hub: Driven, N: float, p: float) -> float:
    """Largest fillet stress of a ring driven by its hub; each roller carries N per unit length.

    If N is 0 or infinite, rollers and hub are omitted.
    """
    if not 0 < N < np.inf:
        return loaded_fillet_stress(hub.contact.sector, p=p)
    normal = N * hub.kappa / np.hypot(1, hub.tan_phi)
    push = hub_force(sector=hub.contact.sector, e=hub.e, normal=normal, along=-normal * hub.tan_phi)
    a = hub.contact.half_width(N)
    return loaded_fillet_stress(hub.contact.sector, p=p, hub=push, N=N, a=a)
