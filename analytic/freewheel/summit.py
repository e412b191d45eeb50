"""State at the largest torque of an outer cam, beyond which the rollers pop through."""

import numpy as np
from scipy.optimize import minimize_scalar

from analytic.freewheel.clutch import RollerClutch
from analytic.freewheel.limits import pop_through
from analytic.freewheel.state import RollerClutchState, at_normal_force, loaded

NEAR, BEYOND = 0.99, 1.4  # limits of the search, relative to N at the largest torque
FOUND = 1e-9  # relative to N


def summit(clutch: RollerClutch) -> RollerClutchState | None:
    """State of one clutch at its largest torque.

    None for an inner cam, and if the half-width of a contact reaches half the radius of the rollers
    before the largest torque.
    """
    T = float(pop_through(clutch))
    if not np.isfinite(T):
        return None
    N = float(loaded(clutch, NEAR * T).N)
    found = minimize_scalar(
        lambda N: -float(np.nan_to_num(at_normal_force(clutch, N).T)), bounds=(N, BEYOND * N),
        method="bounded", options={"xatol": FOUND * N},
    )  # fmt: skip
    return at_normal_force(clutch, found.x)
