"""The search of Fig. 12 over all candidates at once: judged, and the best of them."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from verify.studies.design.front import Indices, distance_to_ideal, pareto, thinned
from verify.studies.design.inputs import Task
from verify.studies.design.limits import Judged, limits
from verify.studies.design.nearest import Relaxation, alone, nearest
from verify.studies.design.springs import Formulas, Springs, candidates, formulas

Array = NDArray[np.float64]
OBJECTIVES = ("stress", "L_0", "room to A", "error of the stiffness")


@dataclass(frozen=True)
class Search:
    """All results of a design task; indices are numbers of candidates."""

    task: Task
    springs: Springs
    formulas: Formulas
    judged: Judged
    front: Indices
    members: Indices

    @cached_property
    def objectives(self) -> Array:
        """Objectives to minimise (N, 4), see OBJECTIVES."""
        return objectives(self.formulas, self.task.demands.F_w)

    @cached_property
    def distance(self) -> Array:
        """Distance of each member to the ideal point of the front, in scaled objectives."""
        front = distance_to_ideal(self.objectives[self.front])
        return front[np.searchsorted(self.front, self.members)]

    @cached_property
    def relaxations(self) -> Sequence[Relaxation]:
        """Limits whose relaxation alone is sufficient if no candidate is feasible."""
        return () if self.front.size else alone(self.judged)

    @cached_property
    def nearest(self) -> Sequence[Relaxation]:
        """Violations of the nearest candidate, if no candidate is feasible."""
        return () if self.front.size else nearest(self.judged)


def objectives(f: Formulas, F_w: float) -> Array:
    """Stress, free length, minus U_A/U_w, and |k_1/k_w - 1| with k_w = F_w/U_w (N, 4)."""
    return np.stack([f.stress, f.L0, -f.U_A / f.U_w, np.abs(f.k1 * f.U_w / F_w - 1)], axis=1)


def search(task: Task) -> Search:
    """Judge every candidate and find the front of the feasible ones."""
    springs = candidates(task.ranges)
    found = formulas(springs, task.demands)
    judged = limits(springs, found, task.demands)
    which = np.flatnonzero(judged.feasible)
    goals = objectives(found, task.demands.F_w)[which] if which.size else np.zeros((0, 4))
    best = pareto(goals)
    members = best[thinned(goals[best])] if best.size else best
    return Search(task, springs, found, judged, which[best], which[members])
