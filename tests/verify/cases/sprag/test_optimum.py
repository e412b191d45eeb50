"""Effects of crowns and the optimal crown: boxes, verdicts, Table 2, descriptions of maps."""

import math

import numpy as np
import pytest

from tests.verify.cases.rows import context, rows
from verify.cases.sprag.crown import table2
from verify.cases.sprag.crown.advice import verdict
from verify.cases.sprag.crown.case import CROWN, SpragCrown
from verify.cases.sprag.crown.formulas import box, factorial, unit
from verify.cases.sprag.crown.table2 import cell, relative_error, standardised
from verify.cases.sprag.engagement.model import gap
from verify.cases.sprag.optimum.case import OPTIMUM_25, SpragOptimum, SpragOptimum40
from verify.cases.sprag.optimum.comparisons import band, counted, over_K_1
from verify.cases.sprag.optimum.crown_claims import CELLS, STRIPPED, endless
from verify.cases.sprag.optimum.surrogate_claims import asked
from verify.cases.sprag.peaks import with_crown
from verify.core.case import Context, FemResult
from verify.core.results import Status
from verify.judging import judge

LINES = "true K_1, z_m"


def of(**arrays):
    """A context of these measurements alone."""
    fem = FemResult(h=1.0, values={}, arrays=arrays)
    return Context("sprag-optimum", SpragOptimum(), {}, [fem], is_paper=True)


def test_every_line_along_k_1_must_fall_and_rise_but_for_the_shallowest():
    p = context(OPTIMUM_25).fem[-1].arrays[LINES]
    for line in range(p.shape[2]):
        wrong = p.copy()
        wrong[0, :, line] = np.linspace(2, 1, p.shape[1]) * p[0, :, line].max()
        margin, U, words = over_K_1(context(OPTIMUM_25, arrays={LINES: wrong}))
        expected = Status.PASS if line == 0 else Status.FAIL
        assert judge.fact(margin, U).status is expected
        assert "the line at z_m = 5 µm in the map of K_1 and z_m is not judged" in words


def test_lines_that_turn_and_engagements_are_counted_and_a_flat_part_is_a_band():
    lines = np.tile([3.0, 2.0, 2.5, 2.6, 2.7], (5, 1))
    lines[0] = [3.0, 2.9, 2.8, 2.7, 2.6]
    words = counted(of(best=np.array([4.9, 0.7, 1e-5])), lines)
    assert words.startswith("on 4 of 5 lines of constant K_1, p_max falls, then rises by 35")
    assert words.endswith("nearest to the optimum, p_max falls, then rises by 35.00%")
    p = np.array([2.0, 1.004, 1.0, 1.004, 1.006])
    assert band(np.linspace(1, 5, 5), p) == "from 2.00 to 4.00, p_max is within 0.5% of the lowest"
    found = {"best true": np.array([1.0]), "X": np.zeros((125, 3)), "infill": np.zeros((2, 5))}
    tried = np.array([[0, 0, 0, 1.2], [0, 0, 0, 1.0009], [0, 0, 0, 1.0]])
    assert asked(of(**found, direct=tried)).endswith("optimum requires 2 computed engagements")
    assert asked(of(**found, direct=tried + 0.01)).endswith("more than 3 computed engagements")


@pytest.mark.parametrize(
    ("strips", "cells", "status"),
    [(1.08, 1.10, Status.PASS), (1.08, 1.015, Status.FAIL), (1.015, 1.10, Status.FAIL)],
)
def test_a_pressure_that_hardly_grows_with_the_cells_has_a_largest(strips, cells, status):
    arrays = {
        f"best: {by} {n}": 3e9 * np.array([0.9, growth**k])
        for by, counts, growth in (("strips", STRIPPED, strips), ("cells", CELLS, cells))
        for k, n in enumerate(counts)
    }
    margin, U, _ = endless(of(**arrays))
    assert judge.fact(margin, U).status is status


def test_the_design_variables_are_the_crown_s_three():
    q = SpragOptimum()
    assert q.box.low == (q.K_1_low, q.K_2_low, q.z_m_low) == (1.0, 0.4, 5e-6)
    assert q.box.high == (q.K_1_high, q.K_2_high, q.z_m_high) == (5.0, 0.7, 25e-6)
    less, more = (with_crown(p, (2.0, 0.5, 1e-5)) for p in (q, SpragOptimum40()))
    assert less.T != more.T
    assert gap(less) == pytest.approx(gap(more), rel=1e-12)


CROWNED = SpragCrown()


def test_the_box_is_eq_19_and_another_load_scales_its_drop_alone():
    low, high = box(CROWNED)
    assert low.tolist() == [1, 0.4, 5e-6]
    assert high.tolist() == [5, 0.7, 25e-6]
    assert (box(SpragCrown(Q=2 * 3407.0))[1] / high).tolist() == pytest.approx([1, 1, 2])
    assert len(factorial(CROWNED, 5)) == 125
    assert unit(CROWNED) == pytest.approx(
        2 * 3407 / (math.pi * 9e-3 * 206e9 / 0.91)
    )  # 2 Q/(π l E')


def test_table_2_s_errors_are_of_the_predicted_value(monkeypatch):
    for k in range(1, 10):
        assert round(100 * relative_error(k), 1 if k == 7 else 2) == cell(k, "error")
    right = relative_error
    monkeypatch.setattr(
        table2, "relative_error", lambda k: right(k) * cell(k, "predicted") / cell(k, "actual")
    )
    of = context(CROWN)
    failed = [k for k in range(1, 10) if any(
        row.status is Status.FAIL for row in rows(CROWN, f"Table 2, row {k}:", of))]  # fmt: skip
    assert failed == [1, 2]


def test_differences_over_the_root_of_mse_are_those_of_the_ledger():
    assert [round(standardised(k), 1) for k in (1, 2, 3, 5, 6, 7, 8, 9, 10)] == [
        11.6, 15.2, 11.6, 5.3, 1.9, 4.1, 4.4, 3.3, 3.1,
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("changes", "state"),
    [
        ({}, "too shallow"), ({"K_1": CROWNED.K_1_suits}, "suits"), ({"z_m": 0.0}, "no crown"),
        ({"K_1": 30.0, "z_m": 25e-6}, "uneven"), ({"T": 80.0}, "rolls over"),
        ({"T": 500.0, "alpha_max": 3.0}, "no state"),
    ],
)  # fmt: skip
def test_the_verdict_is_that_of_the_crown(changes, state):
    q = SpragCrown(**changes)
    assert verdict(q) == state
    assert CROWN.findings(q, CROWN.analytic(q))[0].startswith(state)
