"""Result of a crown design: the optimal crown, compared crowns, and half-space checks."""

import os
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from analytic.surrogate.designs import random_designs
from verify.cases.sprag.peaks import NoLockError
from verify.core import progress
from verify.core.figures import Array
from verify.core.inputs import InputError
from verify.studies.design_sprag.corners import corners, reach
from verify.studies.design_sprag.inputs import Task, unable
from verify.studies.design_sprag.known import Known
from verify.studies.design_sprag.model import Model
from verify.studies.design_sprag.search import LEVELS, Search, Worth, rounded
from verify.studies.design_sprag.surrogates import crowns_of, logs
from verify.studies.design_sprag.verified import Check, checks, ends_carry, unloading

FLAT = 0.005  # of the objective: crowns within this range are equivalent
SCATTERED, LINE = 3000, 201
EDGE, BEYOND = 0.01, 0.10  # of a range: distance of an active bound; extension of the search
GAIN = 0.001  # relative gain above which a bound is reported to raise the objective
SHALLOWER = 0.95  # factor on z_m; if the ends are then loaded, the crown is close to edge loading
MOST_JOBS = 2


@dataclass(frozen=True)
class Bound:
    """A bound that the optimal crown reaches.

    `parameter` is the number of the bounded parameter. `gain` is the relative reduction of the
    objective if the parameter has the value `beyond`, outside the range.
    """

    parameter: int
    beyond: float
    gain: float

    @property
    def costs(self) -> bool:
        return self.gain > GAIN


@dataclass(frozen=True, eq=False)
class Outcome:
    """Result of a crown design for m torques.

    `crown` (3,) is the chosen crown. `best_crowns` (m, 3) are the optimal crowns for each single
    torque, and `best` (m,) [Pa] the lowest pressures that the search found. `worst` (m,) [Pa] are
    the largest pressures of the chosen crown within its tolerance, scaled as in the search.
    `chosen`, `now` and `without` are results of the true model for the chosen crown, the present
    crown and no crown. `predicted` and `true` are the objective of the chosen crown by kriging and
    by the true model.
    """

    task: Task
    search: Search
    crown: Array
    chosen: Known
    worst: Array
    best_crowns: Array
    best: Array
    now: Known
    now_carries: Sequence[bool]  # whether its ends do, by torque
    without: Known
    predicted: float
    true: float
    rounds: int
    alone: Array  # (3, 2) ranges of each parameter within FLAT, the others constant
    together: Array  # (3, 2) of crowns within FLAT
    bounds: Sequence[Bound]
    checks: Sequence[Check]
    free_from: float | None  # smallest z_m [m] that unloads loaded ends
    on_edge: bool  # whether unloaded ends would be loaded at SHALLOWER z_m

    @property
    def relative(self) -> bool:
        """Whether the aim is the smallest excess of pressure over the optima of single torques."""
        return self.task.wishes.aim == "excess" and len(self.task.torques) > 1

    @property
    def excess(self) -> Array:
        """Relative excess (m,) of the chosen crown's pressure over the optimum of each torque."""
        return np.asarray(self.worst / self.best - 1)

    @property
    def pressures(self) -> Array:
        """Largest pressures [Pa] of the chosen crown with nominal dimensions, (m,)."""
        return np.asarray(self.largest(self.chosen)[0])

    def largest(self, known: Known) -> Array:
        """Largest pressures (n, m) [Pa] of the crowns in `known`, not scaled for the search."""
        contacts, m = self.task.wishes.contacts, len(self.task.torques)
        return np.column_stack([known.along(contacts, k).max(axis=1) for k in range(m)])

    @property
    def exceeded(self) -> Sequence[float]:
        """Torques [N m] at which the chosen crown has pressures over p_lim within its tolerance."""
        limit = self.task.wishes.p_lim
        p = np.maximum(self.pressures, self.largest(self.chosen).max(axis=0))
        return [T for T, x in zip(self.task.torques, p, strict=True) if limit and x > limit]

    @property
    def verified(self) -> bool:
        """Whether all half-space checks agree; True if there are no checks."""
        return all(check.agrees for check in self.checks)

    @property
    def passed(self) -> bool:
        return self.verified and not self.exceeded


def carry_out(task: Task, where: str, *, use_half_space: bool, quiet: bool) -> Outcome:
    """Optimal crown of a task, with all comparisons.

    Raises InputError if engagements do not lock or could not be solved; the message states which.
    If they could not be solved, it is not known whether the clutch locks.
    """
    try:
        with progress.shown(quiet=quiet) as show:
            return _carried_out(task, show, use_half_space)
    except NoLockError as error:
        raise InputError(f"{where}: inputs: {unable(task) or error}") from error
    except ArithmeticError as error:
        raise InputError(
            f"{where}: no crown can be chosen because engagements were not solved: {error}"
        ) from error


def _carried_out(task: Task, show: progress.Show, use_half_space: bool) -> Outcome:
    low, high = (logs(end[None]) for end in reach(task))
    middle = crowns_of((low + high) / 2)[0]
    model = Model(
        task.clutch, task.torques, (float(middle[0]), float(middle[1]), float(middle[2])),
        jobs=min(MOST_JOBS, os.cpu_count() or 1), show=show,
    )  # fmt: skip
    search = Search(task, model, LEVELS)
    search.prepare()
    singles = [search.least(_of_torque(k)) for k in range(len(task.torques))]
    best_crowns = crowns_of(np.array([one.x for one in singles]))
    worth = _worth(task, np.array([one.true for one in singles]))
    joint = search.least(worth) if len(singles) > 1 else singles[0]
    crown = rounded(task, crowns_of(joint.x[None])[0])
    worst = search.true(crown)
    inside = [p for x, p in search.complete if np.all((x >= task.low) & (x <= task.high))]
    best = np.min(inside, axis=0)
    q = task.clutch
    now = model.answers(np.array([[q.K_1, q.K_2, q.z_m]]))
    now_carries = [
        bool(ends_carry(model, now.crowns, now.N_max[:, k], k)[0]) for k in range(len(singles))
    ]
    found = checks(task, model, crown) if use_half_space else ()
    loaded = [c for c in found if c.end > 0 and c.which == "nominal"]
    alone, together = flatness(search, worth, crown, worst)
    return Outcome(
        task=task, search=search, crown=crown, worst=worst, best_crowns=best_crowns, best=best,
        chosen=model.answers(corners(task, crown[None])[0]), now=now,
        now_carries=now_carries,
        without=model.answers(np.array([[q.K_1, q.K_2, 0.0]])),
        predicted=float(worth(search.worst(crown[None]))[0]), true=float(worth(worst[None])[0]),
        rounds=len(joint.history), alone=alone, together=together,
        bounds=bound(search, worth, crown, worst), checks=found,
        free_from=unloading(model, loaded[-1]) if loaded else None,
        on_edge=_on_edge(model, crown),
    )  # fmt: skip


def _on_edge(model: Model, crown: Array) -> bool:
    """Whether the ends of a crown (3,) are unloaded, but loaded at a slightly smaller drop."""
    pair = np.array([crown, crown * [1, 1, SHALLOWER]])
    loads = model.answers(crown[None]).N_max[0]
    carry = np.array([ends_carry(model, pair, np.full(2, N), k) for k, N in enumerate(loads)])
    return bool(not carry[:, 0].any() and carry[:, 1].any())


def _of_torque(k: int) -> Worth:
    return lambda p: np.asarray(p[:, k])


def _worth(task: Task, best: Array) -> Worth:
    """Objective to minimise, as a function of pressures (n, m)."""
    if task.wishes.aim == "pressure" or len(best) == 1:
        return lambda p: np.asarray(p.max(axis=1))
    return lambda p: np.asarray((p / best).max(axis=1))


def flatness(search: Search, worth: Worth, crown: Array, worst: Array) -> tuple[Array, Array]:
    """Two sets of parameter ranges (3, 2) of crowns whose objective is almost the minimum.

    For the first set, only one parameter is varied; for the second, all three are varied together.
    """
    most = (1 + FLAT) * max(worth(worst[None])[0], worth(search.worst(crown[None]))[0])
    scattered = crowns_of(random_designs(search.box, SCATTERED, search.task.wishes.seed))
    good = scattered[worth(search.worst(scattered)) <= most]
    alone = np.empty((3, 2))
    for j in range(3):
        line = np.repeat(crown[None], LINE, axis=0)
        line[:, j] = np.linspace(search.task.low[j], search.task.high[j], LINE)
        kept = worth(search.worst(line)) <= most
        alone[j] = _around(line[:, j], kept, crown[j])
    good = np.vstack([good, alone.T])  # a crown with one changed parameter is a candidate, too
    return alone, np.column_stack([good.min(axis=0), good.max(axis=0)])


def _around(values: Array, mask: Array, at: float) -> Array:
    """Ends of the interval of ascending `values` around `at` in which `mask` is true."""
    outside = values[~mask.astype(bool)]
    below, above = outside[outside < at], outside[outside > at]
    inside = values[mask.astype(bool)]
    low = below.max() if below.size else -np.inf
    high = above.min() if above.size else np.inf
    stretch = np.append(inside[(inside > low) & (inside < high)], at)
    return np.array([stretch.min(), stretch.max()])


def bound(search: Search, worth: Worth, crown: Array, worst: Array) -> Sequence[Bound]:
    """Bounds that the crown reaches, with the gain from a value beyond each bound (true model)."""
    task, found = search.task, []
    for j in range(3):
        low, high = task.low[j], task.high[j]
        near = EDGE * (high - low)
        if crown[j] <= low + near:
            beyond = max(low - BEYOND * (high - low), low / 2)
        elif crown[j] >= high - near and not (j == 1 and high >= 1):
            beyond = high + BEYOND * (high - low)
            beyond = min(beyond, 1.0) if j == 1 else beyond
        else:
            continue
        other = crown.copy()
        other[j] = beyond
        if task.wishes.t_z >= other[2] or task.t_K2 >= other[1]:
            continue
        known = search.model.answers(corners(task, other[None])[0])
        there = known.largest(task.wishes.contacts).max(axis=0)
        gain = 1 - worth(there[None])[0] / worth(worst[None])[0]
        found.append(Bound(j, float(beyond), float(gain)))
    return found
