"""If no candidate is feasible: the candidate closest to feasible, and the limits to relax."""

import operator
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from verify.core.inputs import BOUNDS, bounds_of
from verify.studies.design.inputs import Demands
from verify.studies.design.limits import ROUND_OFF, Judged, Limit

KEPT = {word: getattr(operator, rule) for rule, word in BOUNDS.items()}


@dataclass(frozen=True)
class Relaxation:
    """A limit that must be relaxed for a candidate.

    `given` is the present and `needed` the required value of the input, both in its SI unit.
    """

    limit: Limit
    candidate: int
    given: float
    needed: float

    @property
    def excess(self) -> float:
        """Relative difference of the candidate's value and the bound; positive if violated."""
        return float(self.limit.excess[self.candidate])

    @property
    def possible(self) -> bool:
        """Whether the allowed range of the input contains the required value."""
        bounds = bounds_of(Demands.model_fields[self.limit.key])
        return all(KEPT[word](self.needed, bound) for word, bound in bounds)


def relaxation(limit: Limit, i: int) -> Relaxation:
    """Relaxation of `limit` that candidate `i` needs."""
    given, needed = limit.bound - limit.offset, float(limit.value[i]) - limit.offset
    return Relaxation(limit, i, given, needed)


def _least(excess: NDArray[np.float64]) -> int:
    """Index of the candidate with the least excess; the first if several are equal to round-off."""
    return int(np.argmax(excess <= excess.min() + ROUND_OFF))


def nearest(judged: Judged) -> list[Relaxation]:
    """Relaxations for the candidate whose largest relative excess over its bounds is smallest.

    They are in descending order of the excess. The list is empty if no candidate can be made as a
    spring.
    """
    if not judged.possible.any():
        return []
    excess = np.array([limit.excess for limit in judged.limits])
    i = _least(np.where(judged.possible, excess.max(axis=0), np.inf))
    found = [relaxation(limit, i) for limit in judged.limits if limit.violated[i]]
    return sorted(found, key=lambda r: -r.excess)


def alone(judged: Judged) -> Sequence[Relaxation]:
    """Relaxations of single limits, each of which alone makes one candidate feasible.

    For each limit, the smallest sufficient relaxation is given. Relaxations beyond the allowed
    range of the input are omitted.
    """
    lonely = judged.possible & (judged.violations.sum(axis=0) == 1)
    found = []
    for limit, bad in zip(judged.limits, judged.violations, strict=True):
        which = np.flatnonzero(lonely & bad)
        if which.size:
            found.append(relaxation(limit, int(which[_least(limit.excess[which])])))
    return sorted((r for r in found if r.possible), key=lambda r: r.excess)
