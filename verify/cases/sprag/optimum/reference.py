"""Reference: strips for the given crown, the optimisation, and the end effects of its crowns."""

import numpy as np

from analytic.sprag.crown_surrogate import held
from verify.case import Level
from verify.cases.sprag.clutch.drawn_fem import crowned
from verify.cases.sprag.clutch.model import built, under
from verify.cases.sprag.clutch.paper_fem import fitted_angle_fem, peak_fem
from verify.cases.sprag.clutch.run_fem import run_fem
from verify.cases.sprag.engagement.model import crowned_for, in_strips
from verify.cases.sprag.optimum.ends_fem import STRIPPED, ends_fem
from verify.cases.sprag.optimum.inputs import OptimumInputs
from verify.cases.sprag.optimum.study_fem import study_fem
from verify.cases.sprag.peaks import peaks_fem, with_crown
from verify.core.figures import Array

STEPS = 241  # number of states of an engagement that are drawn
LEVELS = STRIPPED  # strips along a sprag


def solve(q: OptimumInputs, level: int) -> Level:
    """Results with `level` strips for the given crown; the finest level adds the optimisation."""
    now, one = under(q), built(q)
    assert now is not None  # a clutch without a peak was refused before
    found = in_strips(q, crowned(q, level), one.radii(now)[0], float(now.N))
    values = {"static_mid": float(found.mid), "static_peak": float(found.peak)}
    arrays: dict[str, Array] = {}
    if level == LEVELS[-1]:
        arrays = study_fem(q)
        arrays |= ends_fem(q, arrays)
        arrays |= maps_fem(q) | lundberg_fem(q, arrays) | courses_fem(q, arrays["best"])
        arrays |= calibrated_fem(q, arrays)
    return Level(h=1 / level, values=values, arrays=arrays)


def maps_fem(q: OptimumInputs) -> dict[str, Array]:
    """Pressures [Pa] (torques, K_1, z_m) of computed engagements, at the K_2 of Figs. 15, 17."""
    low, high = np.array(q.box.low), np.array(q.box.high)
    K_1, z_m = (np.linspace(low[k], high[k], q.levels) for k in (0, 2))
    grid = np.array([(a, held(q.box, 1), b) for a in K_1 for b in z_m])
    largest = peaks_fem(q, grid, q.torques).largest.T.reshape(-1, q.levels, q.levels)
    return {"true K_1, z_m": largest}


def lundberg_fem(q: OptimumInputs, found: dict[str, Array]) -> dict[str, Array]:
    """Lundberg's crown for N_max (K_1 = N_max/Q; optimal K_2 and z_m), and its pressure."""
    K_1 = float(np.clip(found["best true"][3] / crowned_for(q), q.K_1_low, q.K_1_high))
    row = int(np.argmin(np.abs(found["K_1"] - K_1)))
    K_2, z_m = np.unravel_index(np.argmin(found["whole"][row]), found["whole"][row].shape)
    crown = np.array([K_1, found["K_2"][K_2], found["z_m"][z_m]])
    true = peaks_fem(q, crown[None], [q.T]).largest[0]
    return {"Lundberg": np.array([*crown, *true])}


def courses_fem(q: OptimumInputs, best: Array) -> dict[str, Array]:
    """Normal force [N] over time [s], without and with the optimal crown (Figs. 16, 18)."""
    found: dict[str, Array] = {}
    for name, crown in (("before", None), ("after", best)):
        run = run_fem(with_crown(q, crown)).engagement
        every = max(len(run.t) // STEPS, 1)
        found |= {f"{name} t": run.t[::every], f"{name} N": run.N[::every]}
    return found


def calibrated_fem(q: OptimumInputs, found: dict[str, Array]) -> dict[str, Array]:
    """Fitted wedge angle [rad] and, with this angle, p_max [Pa] without and with optimal crown.

    The wedge angle is fitted to the pressure printed at 25 N m. The result is empty for inputs
    other than those of the paper.
    """
    if q != type(q)():
        return {}
    nu_0 = fitted_angle_fem()
    if nu_0 is None:
        return {"fitted": np.full(3, np.nan)}
    K_1, K_2, z_m = (float(x) for x in found["best"])
    peaks = [peak_fem(crown, q.T, nu_0=nu_0) for crown in (None, (K_1, K_2, z_m))]
    return {"fitted": np.array([nu_0, *peaks])}
