"""Pareto front of the feasible candidates, selection of members, and choice of one member."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
MEMBERS = 20


def pareto(objectives: Array) -> Indices:
    """Indices of the rows of `objectives` (N, m) that no other row dominates.

    All objectives are minimised. A row dominates another row if it is at least as good in all
    objectives and better in at least one. Equal rows do not dominate each other.
    """
    order = np.lexsort(objectives.T[::-1])  # nobody is beaten by one that comes later
    left, found = order, []
    while left.size:
        first, rest = left[0], left[1:]
        found.append(first)
        a, b = objectives[first], objectives[rest]
        beaten = np.all(a <= b, axis=1) & np.any(a < b, axis=1)
        left = rest[~beaten]
    return np.sort(np.array(found, dtype=np.int64))


def scaled(objectives: Array) -> Array:
    """Objectives scaled from 0 (best value of the set) to 1 (worst); 0 if all values are equal."""
    low, high = objectives.min(axis=0), objectives.max(axis=0)
    return np.asarray((objectives - low) / np.where(high > low, high - low, 1.0))


def distance_to_ideal(objectives: Array) -> Array:
    """Distance of each row from the ideal point, in scaled objectives.

    The ideal point has the best value of every objective.
    """
    return np.asarray(np.linalg.norm(scaled(objectives), axis=1))


def thinned(objectives: Array, most: int = MEMBERS) -> Indices:
    """Indices of at most `most` rows that represent the set, nearest to the ideal point first.

    First, the row nearest to the ideal point and the best row of each objective are selected. Then
    the row with the largest distance from all selected rows, in scaled objectives, is added until
    `most` rows are selected.
    """
    at, ideal = scaled(objectives), distance_to_ideal(objectives)
    taken = list(dict.fromkeys([int(ideal.argmin()), *map(int, at.argmin(axis=0))]))[:most]
    apart = np.min([np.linalg.norm(at - at[i], axis=1) for i in taken], axis=0)
    while len(taken) < most and apart.max() > 0:
        taken.append(int(apart.argmax()))
        apart = np.minimum(apart, np.linalg.norm(at - at[taken[-1]], axis=1))
    members = np.array(taken, dtype=np.int64)
    return members[np.argsort(ideal[members], kind="stable")]
