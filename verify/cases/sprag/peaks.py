"""Largest pressures of the engagements of a sprag clutch with different crowns.

A crown mainly changes the laws of the contacts. These laws are solved once for all torques.
`analytic.sprag.peaks` compares slices and strips at the ends: for the optimal crown of Eq. 19 at
25 N m, 41 slices give 2946 MPa, 81 strips give 3255 MPa and 161 strips give 3766 MPa.
"""

import math
from collections.abc import Callable, Iterable
from functools import lru_cache

import numpy as np

from analytic.sprag.closure import wedged
from analytic.sprag.peaks import By, Peaks
from verify.cases.sprag.clutch.model import built
from verify.cases.sprag.clutch.run_fem import AHEAD, engaged_fem
from verify.cases.sprag.engagement.model import crowned_for, gap, in_slices, in_strips
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.figures import Array
from verify.jobs.executor import Drive, Lost, local

ENGAGED = 1024  # engagements stored: two optimisations with common designs
CHUNK = 5  # crowns per task of a process
STRIPS = 81  # along a sprag; with unloaded ends, 161 strips change the peak by 0.1 %
HOW = {
    "slips": "a contact continues to slide",
    "over the end": "the sprags roll beyond their profile or beyond the range of the formulas",
    "disengages": "the contacts are separated at the end of the engagement",
    "not followed": "the force still rises at the end of the integration (increase t_end)",
}

Crown = tuple[float, float, float]  # K_1, K_2, z_m [m]


class NoLockError(ArithmeticError):
    """Error for an engagement that does not lock and thus has no largest pressure."""


def with_crown(q: EngagementInputs, crown: Crown | Array | None) -> EngagementInputs:
    """Inputs of the clutch with `crown` for the same design load; without crown if None."""
    own = {name: getattr(q, name) for name in EngagementInputs.model_fields}
    own["Q"] = crowned_for(q)
    if crown is None:
        return EngagementInputs.model_construct(**own | {"z_m": 0.0})
    K_1, K_2, z_m = (float(x) for x in crown)
    return EngagementInputs.model_construct(**own | {"K_1": K_1, "K_2": K_2, "z_m": z_m})


def one_fem(
    q: EngagementInputs, torques: Iterable[float], by: By = "slices"
) -> tuple[Array, Array]:
    """N_max [N], (m,), and pressures [Pa], (m, slices), with the crown of `q`.

    Raises NoLockError if an engagement does not lock, another error if it has no solution.
    """
    one = built(q)
    N, R = np.array([_peak_fem(q.model_copy(update={"T": float(T)})) for T in torques]).T
    if by == "slices":
        return N, in_slices(q, one.gap, R, N).peak_pressure
    fine = gap(q.model_copy(update={"slices": STRIPS}))
    return N, in_strips(q, fine, R, N).pressure


@lru_cache(maxsize=ENGAGED)
def _peak_fem(q: EngagementInputs) -> tuple[float, float]:
    """N_max [N], and the relative radius [m] of the inner contact under this force."""
    one = built(q)
    run = engaged_fem(one, q, AHEAD * q.T / (q.z * q.R_i * math.tan(q.nu_0)))
    verdict = run.engagement.verdict
    if verdict != "locks":
        raise NoLockError(f"under T = {q.T:g} N m {HOW[verdict]}; no crown prevents this")
    N = run.engagement.N_max
    return N, one.radii(wedged(one.clutch, N))[0]


Task = tuple[EngagementInputs, tuple[float, ...], tuple[Crown, ...], By]


def some_fem(task: Task) -> list[tuple[Array, Array]] | str:
    """Pairs (N_max [N], pressures [Pa]) of a task's crowns, or a text why the clutch does not lock.

    Raises another error if an engagement cannot be solved, which does not mean that it slips.
    """
    q, torques, crowns, by = task
    try:
        return [one_fem(with_crown(q, crown), torques, by) for crown in crowns]
    except NoLockError as error:
        return str(error)


def peaks_fem(
    q: EngagementInputs,
    crowns: Array,
    torques: Iterable[float],
    *,
    by: By = "slices",
    jobs: int = 1,
    progress: Callable[[int], None] = lambda _done: None,
) -> Peaks:
    """Largest forces and pressures of engagements with the crowns (n, 3), under each torque [N m].

    All crowns have the same design load. Pressures are computed by the slices of the clutch, or by
    STRIPS strips on a half-space. `progress` is called with the number of crowns done.
    Raises NoLockError if an engagement does not lock, another ArithmeticError if it is not solved.
    """
    torques, n = tuple(float(T) for T in torques), len(crowns)
    tasks = [
        tuple((float(a), float(b), float(c)) for a, b, c in crowns[k : k + CHUNK])
        for k in range(0, n, CHUNK)
    ]
    found: dict[tuple[Crown, ...], list[tuple[Array, Array]]] = {}
    done = 0
    with local(0 if jobs == 1 or len(tasks) == 1 else min(jobs, len(tasks))) as engine:
        for result in Drive(engine, some_fem).answers((q, torques, task, by) for task in tasks):
            if result is None:
                continue
            (_, _, task, _), answer = result
            if isinstance(answer, Lost):
                raise ArithmeticError(f"an engagement could not be computed: {answer.reason}")
            if isinstance(answer, str):
                raise NoLockError(answer)
            found[task] = answer  # also for repeated crowns
            done += len(task)
            progress(done)
    whole = [one for task in tasks for one in found[task]]
    return Peaks(
        np.asarray(crowns, dtype=np.float64), np.array(torques),
        np.array([N for N, _ in whole]), np.array([p for _, p in whole]), by,
    )  # fmt: skip
