from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from analytic.surrogate.box import Box
from analytic.surrogate.evolution import evolve
from analytic.surrogate.genetic import crossed, decoded, genetic, mutated, selected

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


def test_evolution_settles_on_a_kink_closely() -> None:
    assert evolve(planes, BOX).value == pytest.approx(1, abs=1e-6)


@pytest.mark.parametrize("search", SEARCHES, ids=["genetic", "evolution"])
def test_history_falls_to_the_value_and_evaluations_are_counted(search: Callable[..., Any]) -> None:
    seen: list[Array] = []

    def watched(x: Array) -> Array:
        seen.append(planes(x))
        return seen[-1]

    found = search(watched, BOX)
    assert found.evaluations == sum(len(values) for values in seen)
    lowest = np.minimum.accumulate([values.min() for values in seen])
    np.testing.assert_array_equal(found.history, lowest)
    assert found.value == lowest[-1]


@pytest.mark.parametrize("search", SEARCHES, ids=["genetic", "evolution"])
def test_one_seed_one_course(search: Callable[..., Any]) -> None:
    one, same, other = search(hilly, BOX), search(hilly, BOX), search(hilly, BOX, seed=1)
    np.testing.assert_array_equal(one.history, same.history)
    assert one.history[0] != other.history[0]


def test_the_papers_algorithm_asks_for_50_000_points() -> None:
    asked: list[tuple[int, ...]] = []

    def watched(x: Array) -> Array:
        asked.append(x.shape)
        return planes(x)

    found = genetic(watched, BOX)
    assert asked == [(500, 2)] * 100
    assert found.evaluations == 50_000


def test_gray_codes_reach_both_ends_and_neighbours_differ_in_one_bit() -> None:
    codes = np.array([[int(bit) for bit in f"{code:06b}"] for code in range(64)], dtype=bool)
    u = decoded(codes, 6).ravel()
    order = np.argsort(u)
    np.testing.assert_allclose(u[order], np.arange(64) / 63, rtol=1e-15)
    assert np.all(np.sum(codes[order][1:] != codes[order][:-1], axis=1) == 1)
    two = decoded(np.hstack([codes[:3], codes[5:8]]), 6)  # parameters one behind the other
    np.testing.assert_array_equal(two, np.column_stack([u[:3], u[5:8]]))


@pytest.mark.parametrize("bits", [1, 3])
def test_as_many_values_of_a_parameter_as_bits_allow(bits: int) -> None:
    seen: list[Array] = []

    def watched(x: Array) -> Array:
        seen.append(x)
        return planes(x)

    genetic(watched, BOX, population=200, generations=2, bits=bits)
    for column, low, high in zip(np.vstack(seen).T, BOX.low, BOX.high, strict=True):
        values = np.unique(column)
        np.testing.assert_allclose(values, np.linspace(low, high, 2**bits), rtol=1e-12)


def test_a_tournament_of_two_takes_the_smaller_value() -> None:
    values = np.random.default_rng(1).permutation(20_000).astype(float)
    chosen = values[selected(values, np.random.default_rng(2))]
    # the smaller of two uniform ranks: mean 1/3, below the median with probability 3/4
    assert chosen.mean() / 20_000 == pytest.approx(1 / 3, abs=0.01)
    assert np.mean(chosen < 10_000) == pytest.approx(0.75, abs=0.02)


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


def test_mutation_turns_the_share_of_bits_it_should() -> None:
    codes = np.random.default_rng(4).random((2000, 32)) < 0.5
    turned = codes ^ mutated(codes, 0.01, np.random.default_rng(5))
    assert turned.mean() == pytest.approx(0.01, abs=0.0016)  # 4 deviations of 64 000 bits


def visited(**options: float) -> list[Array]:
    """Different points of each generation."""
    seen: list[Array] = []

    def watched(x: Array) -> Array:
        seen.append(np.unique(x, axis=0))
        return planes(x)

    genetic(watched, BOX, population=100, generations=4, **options)  # type: ignore[arg-type]
    return seen


def among(x: Array, others: Array) -> float:
    return float(np.mean([np.any(np.all(point == others, axis=1)) for point in x]))


def test_only_crossover_and_mutation_make_new_points() -> None:
    first, *_, last = visited(crossover=0.0, mutation=0.0)
    assert among(last, first) == 1
    first, *_, last = visited(crossover=0.9, mutation=0.0)
    assert among(last, first) < 0.5
    first, second, *_ = visited(crossover=0.0, mutation=0.01)
    assert 0.5 < among(second, first) < 0.95  # 0.99³² = 0.72 go through unturned


def test_the_best_is_not_lost_where_every_bit_is_turned_at_random() -> None:
    found = genetic(planes, BOX, population=20, generations=50, mutation=0.5)
    assert np.all(np.diff(found.history) <= 0)
    assert found.value == planes(found.x[None])[0]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"population": 5}, "even and at least 2, got 5"),
        ({"population": 0}, "even and at least 2, got 0"),
        ({"generations": 0}, "generations must be at least 1, got 0"),
        ({"bits": 0}, "bits must lie between 1 and 52, got 0"),
        ({"crossover": 1.1}, "crossover must lie in .0, 1., got 1.1"),
        ({"mutation": -0.1}, "mutation must lie in .0, 1., got -0.1"),
    ],
)
def test_no_genetics(options: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        genetic(planes, BOX, **options)


@pytest.mark.parametrize("search", SEARCHES, ids=["genetic", "evolution"])
def test_an_objective_that_is_not_finite_is_named(search: Callable[..., Any]) -> None:
    with pytest.raises(ArithmeticError, match="the objective is not finite at"):
        search(lambda x: np.where(x[:, 0] > 4, np.nan, 1.0), BOX)


def test_evolution_that_does_not_settle_says_so() -> None:
    rng = np.random.default_rng(6)
    with pytest.raises(ArithmeticError, match="differential evolution has not settled"):
        evolve(lambda x: rng.random(len(x)) - 0.5, BOX)
