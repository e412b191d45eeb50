"""Search by the procedure of Fig. 12 for all candidates: limits, Pareto front, members."""

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
    """Results of a design task. Indices are positions of candidates in the arrays of `springs`."""

    task: Task
    springs: Springs
    formulas: Formulas
    judged: Judged
    front: Indices
    members: Indices

    @cached_property
    def objectives(self) -> Array:
        """Objectives to minimise, (N, 4), in the order of OBJECTIVES."""
        return objectives(self.formulas, self.task.demands.F_w)

    @cached_property
    def distance(self) -> Array:
        """Distance of each member from the ideal point of the front, in scaled objectives."""
        front = distance_to_ideal(self.objectives[self.front])
        return front[np.searchsorted(self.front, self.members)]

    @cached_property
    def relaxations(self) -> Sequence[Relaxation]:
        """Relaxations of single limits, each sufficient alone; empty if a candidate is feasible."""
        return () if self.front.size else alone(self.judged)

    @cached_property
    def nearest(self) -> Sequence[Relaxation]:
        """Relaxations for the candidate closest to feasible; empty if a candidate is feasible."""
        return () if self.front.size else nearest(self.judged)


def objectives(f: Formulas, F_w: float) -> Array:
    """Objectives (N, 4): stress, free length, -U_A/U_w and |k_1/k_w - 1| with k_w = F_w/U_w."""
    return np.stack([f.stress, f.L0, -f.U_A / f.U_w, np.abs(f.k1 * f.U_w / F_w - 1)], axis=1)


def search(task: Task) -> Search:
    """Evaluate the limits for every candidate and find the front of the feasible candidates."""
    springs = candidates(task.ranges)
    found = formulas(springs, task.demands)
    judged = limits(springs, found, task.demands)
    which = np.flatnonzero(judged.feasible)
    goals = objectives(found, task.demands.F_w)[which] if which.size else np.zeros((0, 4))
    best = pareto(goals)
    members = best[thinned(goals[best])] if best.size else best
    return Search(task, springs, found, judged, which[best], which[members])
