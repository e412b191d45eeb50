"""Where nothing is feasible: the candidate that comes nearest, and which limits to relax."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from verify.design.limits import Judged, Limit


@dataclass(frozen=True)
class Relaxation:
    """Candidate `i` needs `limit` at `needed` [SI of the input] in the place of `given`."""

    limit: Limit
    candidate: int
    given: float
    needed: float

    @property
    def excess(self) -> float:
        """Share of the bound by which the candidate is beyond."""
        return float(self.limit.excess[self.candidate])


def relaxation(limit: Limit, i: int) -> Relaxation:
    """What of a limit candidate `i` asks for."""
    given, needed = limit.bound - limit.offset, float(limit.value[i]) - limit.offset
    return Relaxation(limit, i, given, needed)


def nearest(judged: Judged) -> list[Relaxation]:
    """What the candidate with the smallest largest excess violates, the worst first.

    Empty where no candidate is a spring at all.
    """
    if not judged.possible.any():
        return []
    excess = np.array([limit.excess for limit in judged.limits])
    i = int(np.where(judged.possible, excess.max(axis=0), np.inf).argmin())
    found = [relaxation(limit, i) for limit in judged.limits if limit.violated[i]]
    return sorted(found, key=lambda r: -r.excess)


def alone(judged: Judged) -> Sequence[Relaxation]:
    """For every limit whose relaxing alone makes something feasible, the least that does so."""
    lonely = judged.possible & (judged.violations.sum(axis=0) == 1)
    found = []
    for limit, bad in zip(judged.limits, judged.violations, strict=True):
        which = np.flatnonzero(lonely & bad)
        if which.size:
            found.append(relaxation(limit, int(which[limit.excess[which].argmin()])))
    return sorted(found, key=lambda r: r.excess)
