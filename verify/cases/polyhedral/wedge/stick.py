"""Stick zones of a wedged roller that is pressed without friction and then released."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from verify.cases.polyhedral.wedge.inputs import WedgeInputs

Array = NDArray[np.float64]


class Share(float):
    """Ratio T/(mu N) whose text, such as "0_4", can be part of keys of results."""

    def __str__(self) -> str:
        return f"{self:g}".replace(".", "_")


SHARES = tuple(map(Share, (0.4, 0.6, 0.8)))  # shares of the rows
GROWTH = np.linspace(0.1, 0.8, 15)  # shares of the figure
TILT, FLATTEST = 0.04, 0.02  # a/(mu R) and a/R at most


def small(q: WedgeInputs) -> float:
    """Half-width [m] of a contact so small that Cattaneo's half-planes represent the roller.

    For larger widths, the common contact surface is inclined by up to a/(2R) at its ends, which
    reduces the available angle of friction.
    """
    return q.R * min(TILT * q.mu, FLATTEST)


class Stuck(NamedTuple):
    """Ratios of stick half-width to a, by key; their uncertainties; half-widths for the figure."""

    values: dict[str, float]
    u_it: dict[str, float]
    growth: Array


def fem_stuck(q: WedgeInputs, level: int) -> Stuck:
    """Stick zones of a roller released under a small force; half a contact has `level` cells."""
    from fem.contact.partial_slip import smoothed
    from fem.contact.wedged import Geometry, Wedge
    from fem.contact.wedged_states import let_go
    from verify.cases.polyhedral.wedge.mesh import fem_mesh

    geometry = Geometry(q.R, q.half, small(q))
    N = math.pi * q.E_star * geometry.a**2 / (4 * q.R)
    wedge = Wedge(geometry, fem_mesh(geometry, level), E=q.E, nu=q.nu, mu=q.mu, normal="between")
    k_found, c2 = let_go(wedge, N, mu=q.mu)
    values, u_it = {}, {}
    for k in SHARES:
        share, u, _ = smoothed(k_found, c2, k)
        values[f"stick_{k}"] = math.sqrt(share)
        u_it[f"stick_{k}"] = u / (2 * math.sqrt(share))
    return Stuck(values, u_it, np.sqrt([smoothed(k_found, c2, k)[0] for k in GROWTH]))
