"""Stress in the fillets of the driven ring, by the series."""

import numpy as np

from analytic.polyhedral.bore_pressure import pressed
from analytic.polyhedral.capacity import Driven
from analytic.polyhedral.hub_force import hub_force
from analytic.polyhedral.roller_load import roller_load
from analytic.polyhedral.wall_stress import bore_stress

ALONG = 200  # points of the fillet


def in_fillet(hub: Driven, N: float, p: float) -> float:
    """Largest hoop stress [Pa] in the fillets under p [Pa], rollers with N [N/m] and the hub."""
    ring = hub.contact.sector
    at = ring.straight + np.linspace(0, 1, ALONG + 1) * ring.rho * ring.half_angle
    stress = p * bore_stress(at, sector=ring, field=pressed(ring), p=1.0)
    if 0 < N < np.inf:
        normal = N * hub.kappa / np.hypot(1, hub.tan_phi)
        push = hub_force(sector=ring, e=hub.e, normal=normal, along=-normal * hub.tan_phi)
        load = roller_load(sector=ring, a=hub.contact.half_width(N))
        stress = stress + bore_stress(at, sector=ring, field=push)
        stress = stress + N * bore_stress(at, sector=ring, field=load)
    return float(stress.max())
