"""Required friction along the load paths of the test rig, and when the clutch slips by Coulomb.

The paths are taken as a row of rests. What inertia adds is some (f/f_0)² of the loads: f_0 is the
frequency at which the ring by itself swings on the wedged rollers.
"""

import math
from functools import lru_cache
from typing import Any

import numpy as np

from analytic.freewheel import criterion
from analytic.freewheel.course import Course, follow
from analytic.freewheel.load_path import AlternatingAxial, AxialRamp, BothAlternating, LoadPath
from analytic.freewheel.state import loaded
from verify.cases.freewheel.bounds import Bounds, Interval
from verify.cases.freewheel.paths.inputs import PathInputs
from verify.core.case import Values

STEP = 1e-3  # of T, over which the stiffness is taken
SWAY = 0.01  # of the loads: inertia that may be neglected
SHARES = (1.0, 0.3)  # sines of load case 3 at which mu_req is compared
TIMES = 240  # of a cycle
LEAST = 2000  # of a path
ROUND_OFF = 1e-9  # of the cycles of a path: one time more would move all of them


def paths(q: PathInputs) -> dict[int, LoadPath]:
    """The three load cases by their numbers."""
    ramp = {"T": q.T, "F": q.F_ax, "rise": q.rise, "duration": q.duration}
    return {
        1: AxialRamp(**ramp), 2: AlternatingAxial(**ramp, frequency=q.f),
        3: BothAlternating(T=q.T, F=q.F_ax, frequency=q.f, duration=q.duration, T_m=q.T_m),
    }  # fmt: skip


@lru_cache(maxsize=8)
def courses(q: PathInputs) -> dict[int, Course]:
    return {case: course(q, case, q.mu) for case in (1, 2, 3)}


def course(q: PathInputs, case: int, mu: float) -> Course:
    """Load case `case` with this friction."""
    cycles = q.f * q.duration * (1 - ROUND_OFF)
    points = 1 + max(LEAST, math.ceil(TIMES * cycles))
    return follow(q.clutch, paths(q)[case], mu=mu, t=np.linspace(0, q.duration, points))


def axial_load(q: PathInputs, share: float) -> float:
    """F_ax [N] of load case 3 in its last cycle where its sine is `share`."""
    return q.F_ax * share


def required(q: PathInputs, share: float) -> float:
    """mu_req of load case 3 in its last cycle where its sine is `share`."""
    T = q.T_m + share * q.T
    alpha = loaded(q.clutch, T).alpha
    return float(criterion.required_friction(alpha=alpha, T=T, F_ax=axial_load(q, share), R=q.R))


def limit(q: PathInputs, T: float) -> float:
    """Axial load [N] at which the clutch slips under the torque; nan where it does without."""
    alpha = loaded(q.clutch, T).alpha
    return float(criterion.largest_axial_load(alpha=alpha, T=T, R=q.R, mu=q.mu))


def analytic(q: PathInputs) -> Values:
    top, state = q.under(q.T_peak), q.under(q.T)
    values: dict[str, Any] = {
        "alpha": state.alpha, "N": state.N, "mu_t": np.tan(state.alpha), "phi": top.phi,
        "coulomb": 1.0, **inertia(q),
    }  # fmt: skip
    for share in SHARES:
        values[f"mu_req at {share:g}"] = required(q, share)
    values |= {"F_lim": limit(q, q.T), "F_lim 3": limit(q, q.T_critical) if q.T_critical else 0.0}
    for case, along in courses(q).items():
        values |= {
            f"peak {case}": along.peak, f"when {case}": along.when,
            f"safety {case}": q.mu / along.peak, f"slip {case}": along.slips_at,
        }  # fmt: skip
    return {key: float(v) for key, v in values.items() if np.isfinite(v)}


def inertia(q: PathInputs) -> dict[str, float]:
    """Stiffness [N m/rad], f_0 [Hz], (f/f_0)² and the inertia [kg m²] at which this is 1 %."""
    phi = loaded(q.clutch, q.T * np.array([1 - STEP, 1 + STEP])).phi
    stiffness = 2 * STEP * q.T / (phi[1] - phi[0])
    J = q.rho * math.pi / 2 * (q.R_a**4 - q.R**4) * q.L
    f_0 = math.sqrt(stiffness / J) / (2 * math.pi)
    return {
        "stiffness": stiffness, "f_0": f_0, "sway": (q.f / f_0) ** 2,
        "J": SWAY * stiffness / (2 * math.pi * q.f) ** 2,
    }  # fmt: skip


def expected(q: PathInputs, T: float) -> Bounds:
    return Bounds(q, loaded(q.clutch, T))


def of_limit(q: PathInputs, T: float) -> Interval | None:
    """Of the axial load at slip, from what may be wrong with tan(alpha) of one contact."""
    if not T:
        return None
    own = math.tan(float(loaded(q.clutch, T).alpha))
    ends = [own / (1 + m) for m in expected(q, T).slope(tilted=True)]
    if max(*ends, own) >= q.mu:
        return None
    found = [_lever(q, own) / _lever(q, tan) - 1 for tan in ends]
    return min(found), max(found)


def _lever(q: PathInputs, tan: float) -> float:
    return math.sqrt((q.mu / tan) ** 2 - 1)
