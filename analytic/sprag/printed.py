r"""Eqs. 9, 10 and 16 as printed in the paper, to compare with the corrected ones.

- `wedged`: the triangle takes the lever arm OA, on which half of delta_HI and no half of delta_g
  count, for the unstrained spiral's OA_s; what is lost is delta_HI/2 + delta_g/2 on the inner side,
  and the work on the races' rotation is less than that on the deflections.
- `pole_distance`: OC_e without the growth delta_ce (Eq. 9), as if the sprag grew with the race.
- `polar_angle`: log((rho/a)/m) for ln(rho/a)/m (Eq. 10).
- `lever_arms`: brackets that halve the lever arms (Eq. 16).
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array
from analytic.sprag import closure
from analytic.sprag.closure import Wedged
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.compliance import Yields
from analytic.sprag.geometry import LogSprag
from analytic.sprag.search import first_reach


def wedged(clutch: SpragClutch, N: ArrayLike) -> Wedged:
    """State under N [N] with Eq. 9's OA in the triangle of Eq. 10; OC_e includes its delta_ce."""
    N = np.asarray(N, dtype=np.float64)
    yields = clutch.compliance.yields(N)
    OA = np.asarray(np.asarray(clutch.sprag.R_i) - yields.race_i - yields.contact_i / 2)
    return closure.closed(clutch, N, yields, OA_s=OA, OA=OA)


def at_torque(clutch: SpragClutch, T: float) -> Wedged:
    """State at the torque T [N m] of the clutch: the first state from no load upwards."""
    sprag = clutch.sprag
    start = np.asarray(T / (clutch.n_s * np.asarray(sprag.R_i) * np.tan(sprag.nu_0)))
    N = first_reach(lambda N: wedged(clutch, N).T, np.asarray(T), start=start)
    return wedged(clutch, N)


def pole_distance(sprag: LogSprag, yields: Yields) -> Array:
    """OC_e [m] without delta_ce (Eq. 9, third line)."""
    return np.asarray(sprag.OC_e + yields.outer)


def polar_angle(*, rho: ArrayLike, a: ArrayLike, m: ArrayLike) -> Array:
    """Polar angle [rad], log((rho/a)/m) (Eq. 10, last line)."""
    return np.asarray(np.log(np.asarray(rho) / np.asarray(a) / np.asarray(m)))


def lever_arms(sprag: LogSprag, yields: Yields) -> tuple[Array, Array]:
    """Lever arms [m] of the friction forces about O (Eq. 16)."""
    inner = (np.asarray(sprag.R_i) - yields.race_i - yields.contact_i) / 2
    outer = (np.asarray(sprag.R_e) + yields.race_e + yields.contact_e) / 2 + yields.d_ce
    return np.asarray(inner), np.asarray(outer)
