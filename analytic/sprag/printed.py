r"""Eqs. 9, 10 and 16 as printed in the paper, for comparison with the corrected equations.

- `wedged`: the triangle contains the lever arm OA in place of OA_s of the unstrained spiral. Thus,
  delta_HI/2 + delta_g/2 are omitted on the inner side, and the work on the rotation of the races is
  less than the work on the deflections.
- `pole_distance`: OC_e without the growth delta_ce of the outer race (Eq. 9).
- `polar_angle`: log((rho/a)/m) for ln(rho/a)/m (Eq. 10).
- `lever_arms`: lever arms that are halved by misplaced brackets (Eq. 16).
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
    """State under the normal force N [N], by Eqs. 9 and 10 as printed.

    OA of Eq. 9 is a side of the triangle of Eq. 10; OC_e includes delta_ce.
    """
    N = np.asarray(N, dtype=np.float64)
    yields = clutch.compliance.yields(N)
    OA = np.asarray(np.asarray(clutch.sprag.R_i) - yields.race_i - yields.contact_i / 2)
    return closure.closed(clutch, N, yields, OA_s=OA, OA=OA)


def at_torque(clutch: SpragClutch, T: float) -> Wedged:
    """State with the smallest normal force under the torque T [N m] of the clutch."""
    sprag = clutch.sprag
    start = np.asarray(T / (clutch.n_s * np.asarray(sprag.R_i) * np.tan(sprag.nu_0)))
    N = first_reach(lambda N: wedged(clutch, N).T, np.asarray(T), start=start)
    return wedged(clutch, N)


def pole_distance(sprag: LogSprag, yields: Yields) -> Array:
    """Distance OC_e [m] of the pole without delta_ce (Eq. 9, third line)."""
    return np.asarray(sprag.OC_e + yields.outer)


def polar_angle(*, rho: ArrayLike, a: ArrayLike, m: ArrayLike) -> Array:
    """Polar angle log((rho/a)/m) [rad] (Eq. 10, last line)."""
    return np.asarray(np.log(np.asarray(rho) / np.asarray(a) / np.asarray(m)))


def lever_arms(sprag: LogSprag, yields: Yields) -> tuple[Array, Array]:
    """Lever arms [m] of the friction forces about O (Eq. 16)."""
    inner = (np.asarray(sprag.R_i) - yields.race_i - yields.contact_i) / 2
    outer = (np.asarray(sprag.R_e) + yields.race_e + yields.contact_e) / 2 + yields.d_ce
    return np.asarray(inner), np.asarray(outer)
