"""Pareto front, its thinning and the choice, against definitions spelled out."""

import numpy as np
import pytest

from verify.studies.design.front import distance_to_ideal, pareto, scaled, thinned


def beaten(rows, i):
    """The definition, by hand: somebody is as good everywhere and better somewhere."""
    return any(
        all(a <= b for a, b in zip(other, rows[i], strict=True))
        and any(a < b for a, b in zip(other, rows[i], strict=True))
        for other in rows
    )


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("levels", [4, 1000])  # with many ties, and nearly none
def test_the_front_is_what_its_definition_says(seed, levels):
    rows = np.random.default_rng(seed).integers(0, levels, (120, 4)).astype(float)
    expected = [i for i in range(len(rows)) if not beaten(rows.tolist(), i)]
    assert pareto(rows).tolist() == expected


def test_equal_springs_do_not_beat_each_other():
    assert pareto(np.array([[1.0, 2.0], [1.0, 2.0], [2.0, 2.0]])).tolist() == [0, 1]


def test_one_spring_is_its_own_front():
    assert pareto(np.array([[3.0, 1.0, 2.0, 5.0]])).tolist() == [0]


def test_every_objective_is_to_be_small():
    rows = np.array([[1.0, 9.0], [9.0, 1.0], [9.0, 9.0]])
    assert pareto(rows).tolist() == [0, 1]


def test_scaled_objectives_run_from_the_best_to_the_worst():
    rows = np.array([[2.0, 7.0], [4.0, 7.0], [3.0, 7.0]])
    assert scaled(rows).tolist() == [[0, 0], [1, 0], [0.5, 0]]  # all equal: no difference


def test_the_ideal_point_has_the_best_of_everything():
    rows = np.array([[0.0, 4.0], [3.0, 0.0], [1.0, 1.0]])
    assert distance_to_ideal(rows) == pytest.approx([1, 1, np.hypot(1 / 3, 1 / 4)])


def test_a_thinned_front_keeps_the_extremes_and_the_nearest_and_is_sorted_by_distance():
    angle = np.linspace(0, np.pi / 2, 500)
    rows = np.column_stack([1 - np.cos(angle), 1 - np.sin(angle)])
    kept = thinned(rows, 20)
    distance = distance_to_ideal(rows)
    assert len(kept) == len(set(kept.tolist())) == 20
    assert {0, 499, int(distance.argmin())} <= set(kept.tolist())
    assert np.all(np.diff(distance[kept]) >= 0)
    apart = np.diff(np.sort(angle[kept]))
    assert apart.max() < 0.12  # 20 of them over a quarter circle leave no gap: 0.083 if even


def test_a_short_front_stays_whole():
    rows = np.random.default_rng(1).random((7, 3))
    assert sorted(thinned(rows, 20).tolist()) == list(range(7))


def test_equal_rows_are_shown_once():
    assert len(thinned(np.ones((30, 4)), 20)) == 1
