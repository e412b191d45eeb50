"""Computed values of the paper's engagements, with calibrated wedge angle and number of slices.

At 25 N m, the wedge angle is fitted to the pressure printed for the optimised crown, which hardly
depends on the number of slices. The number of slices is fitted to the pressure printed without a
crown. Both values are then used to predict the pressures at 40 N m.
"""

import numpy as np
from scipy.optimize import brentq

from analytic.sprag.crowned import mid
from analytic.sprag.readings import second_peak
from verify.cases.sprag.clutch.run_fem import Run, run_fem
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.figures import Array

TORQUES = (25.0, 40.0)
BEST = {25.0: (2.1507, 0.6763, 0.0121e-3), 40.0: (2.80, 0.7, 0.0118e-3)}  # Eqs. 21, 22
PRINTED = {25.0: (3500e6, 2980e6), 40.0: (4700e6, 3400e6)}  # without and with the optimal crown
FIG_13 = ((1.0, 0.4, 0.01e-3), (3.0, 0.4, 0.01e-3))
COUNTS = (11, 15, 19, 21, 23, 25, 27, 31, 41, 81, 161)  # slices
ANGLES = np.radians([2.9, 3.3])
CALMED = {"C_rl": 3.0, "t_end": 0.15}  # N m s/rad and s for an engagement that comes to rest
SHORT = 0.03  # s, past the first peaks

Crown = tuple[float, float, float]


def designed(crown: Crown | None, T: float, **more: float) -> EngagementInputs:
    """Inputs of the paper's clutch with the crown `crown`; None stands for no crown.

    The design load is the static load at 25 N m.
    """
    q = EngagementInputs()
    nu_0 = more.get("nu_0", q.nu_0)
    K_1, K_2, z_m = crown or (q.K_1, q.K_2, 0.0)
    Q = TORQUES[0] / (q.z * q.R_i * np.tan(nu_0))
    changed = {"T": T, "K_1": K_1, "K_2": K_2, "z_m": z_m, "Q": float(Q), "t_end": SHORT, **more}
    return q.model_copy(update=changed)


def peak_fem(crown: Crown | None, T: float, **more: float) -> float:
    """Largest pressure [Pa] of the inner contact in the engagement with `crown` under T."""
    return run_fem(designed(crown, T, **more)).peaks[0]


def ends(run: Run) -> Array:
    """Pressures [Pa] of the inner contact under the largest force: end slice and mid-length."""
    inner, _ = run.one.pressed(run.engagement.N_max)
    return np.array([inner.peak_pressure[0], mid(inner)])


def paper_fem() -> dict[str, Array]:
    """Computed values of the paper's clutch, by name."""
    q = EngagementInputs()
    runs = [run_fem(designed(BEST[T], T)).engagement for T in TORQUES]
    return {
        "as given": np.array([[peak_fem(c, T) for c in (None, BEST[T])] for T in TORQUES]),
        "N_max": np.array([run.N_max for run in runs]),
        "N_static": np.array([run.N_static for run in runs]),
        "first peak": np.array([run.first_peak[1] for run in runs]),
        "second peak": np.array([second_peak(run) for run in runs]),
        "flat, ends": ends(run_fem(designed(None, 25.0))),
        "Fig. 13": np.array([peak_fem(c, 25.0) for c in FIG_13]),
        "damped": np.array([run_fem(q.model_copy(update=CALMED)).engagement.N[-1]]),
        "narrow": np.array([run_fem(designed(BEST[25.0], 25.0, b=3.05e-3)).engagement.N_max]),
    } | calibrated_fem()  # fmt: skip


def fitted_angle_fem() -> float | None:
    """Wedge angle [rad] that gives the pressure printed at 25 N m with the optimal crown.

    The result is None if no angle within ANGLES gives this pressure. Raises an error if an
    engagement has no solution.
    """
    T = TORQUES[0]

    def excess(nu_0: float) -> float:
        return peak_fem(BEST[T], T, nu_0=nu_0) - PRINTED[T][1]

    low, high = (float(nu_0) for nu_0 in ANGLES)
    if excess(low) * excess(high) > 0:
        return None
    return float(brentq(excess, low, high, xtol=1e-5))


def calibrated_fem() -> dict[str, Array]:
    """Wedge angle and number of slices fitted at 25 N m, and predicted pressures.

    Fitted values and pressures are nan if no angle gives the printed pressure.
    """
    counts = np.array(COUNTS, dtype=np.float64)
    nu_0 = fitted_angle_fem()
    if nu_0 is None:
        nothing = np.full(2, np.nan)
        return {"fitted": nothing, "flat, counts": counts, "flat, peaks": np.nan * counts,
                "pair 25": nothing, "pair 40": nothing}  # fmt: skip
    flat = np.array([peak_fem(None, 25.0, nu_0=nu_0, slices=n) for n in COUNTS])
    n = COUNTS[int(np.argmin(np.abs(flat - PRINTED[25.0][0])))]
    own = {"nu_0": nu_0, "slices": n}
    pairs = {T: [peak_fem(None, T, **own), peak_fem(BEST[T], T, **own)] for T in TORQUES}
    return {
        "fitted": np.array([nu_0, n]), "flat, counts": counts, "flat, peaks": flat,
        "pair 25": np.array(pairs[25.0]), "pair 40": np.array(pairs[40.0]),
    }  # fmt: skip
