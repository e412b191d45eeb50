from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from analytic.surrogate.box import Box
from analytic.surrogate.evolution import evolve
from analytic.surrogate.genetic import crossed, genetic

Array = NDArray[np.float64]
BOX = Box((-3.0, 1e-6), (5.0, 9e-6))
SEARCHES = [partial(genetic, population=200, generations=60), evolve]


def hilly(x: Array) -> Array:
    """Rastrigin's function: 1 at (1, 4e-6), in the middle of nearly eighty other minima."""
    z = (x - [1.0, 4e-6]) * [1, 1e6]
    return np.asarray(1 + np.sum(z**2 + 10 * (1 - np.cos(2 * np.pi * z)), axis=1))


def planes(x: Array) -> Array:
    """The largest of four planes: 1 at (1, 4e-6), with a kink in every direction."""
    u, v = ((x - [1.0, 4e-6]) * [1, 1e6]).T
    return np.asarray(1 + np.max([2 * u + v, -3 * u + v, -u - 2 * v, u - 2 * v], axis=0))


def rising(x: Array) -> Array:
    """Smallest in a corner: 1 at (5, 1e-6)."""
    return np.asarray(1 + (5 - x[:, 0]) + (x[:, 1] * 1e6 - 1))


@pytest.mark.parametrize("search", SEARCHES, ids=["genetic", "evolution"])
@pytest.mark.parametrize(
    ("objective", "where"),
    [(hilly, (1, 4e-6)), (planes, (1, 4e-6)), (rising, (5, 1e-6))],
    ids=["hills", "kinks", "corner"],
)
def test_a_known_smallest_value_is_found(
    search: Callable[..., Any], objective: Callable[[Array], Array], where: tuple[float, float]
) -> None:
    found = search(objective, BOX)
    assert found.value == pytest.approx(1, abs=5e-3)
    assert BOX.to_unit(found.x[None]) == pytest.approx(BOX.to_unit(np.array([where])), abs=1e-3)
    assert objective(found.x[None])[0] == found.value
    assert BOX.contains(found.x[None])[0]


def test_crossover_swaps_tails_of_the_pairs_it_meets() -> None:
    rng = np.random.default_rng(3)
    mothers, fathers = np.zeros((5000, 8), dtype=bool), np.ones((5000, 8), dtype=bool)
    one, other = np.split(crossed(np.vstack([mothers, fathers]), 0.9, rng), 2)
    np.testing.assert_array_equal(one, ~other)  # nothing lost
    assert np.all(np.diff(one.astype(int), axis=1) >= 0)  # the mother's head, the father's tail
    assert not one[:, 0].any()
    assert np.mean(one.any(axis=1)) == pytest.approx(0.9, abs=0.02)
    heads = np.bincount(8 - one[one.any(axis=1)].sum(axis=1), minlength=8)
    assert heads[1:] / heads.sum() == pytest.approx(np.full(7, 1 / 7), abs=0.02)
