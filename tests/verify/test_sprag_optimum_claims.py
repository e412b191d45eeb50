"""What the claims about the best crown say of maps, flatness, refinement and searches."""

import numpy as np
import pytest

from tests.conftest import solved
from verify.cases.sprag.optimum.case import OPTIMUM_25, OPTIMUM_40, SpragOptimum
from verify.cases.sprag.optimum.comparisons import (
    band,
    counted,
    course,
    over_K_1,
    reductions,
    taken_off,
)
from verify.cases.sprag.optimum.crown_claims import CELLS, STRIPPED, endless
from verify.cases.sprag.optimum.surrogate_claims import asked
from verify.core.case import Context, FemResult
from verify.core.results import Status
from verify.jobs.level import Job, judge_case
from verify.judging import judge

pytestmark = pytest.mark.xdist_group("sprag-optimum")
BOTH = pytest.mark.parametrize("case", [OPTIMUM_25, OPTIMUM_40], ids=lambda case: case.id)


def context(q=None, **arrays):
    fem = FemResult(h=1.0, values={}, arrays=arrays)
    return Context("sprag-optimum", q or SpragOptimum(), {}, [fem], is_paper=True)


@BOTH
@pytest.mark.parametrize("line", [None, 1, 2, 3, 4])
def test_one_line_that_only_falls_along_k_1_is_told(case, line):
    arrays = dict(solved(case, case.inputs())[-1].result.arrays)
    p = arrays["true K_1, z_m"].copy()
    if line is not None:
        p[0, :, line] = np.linspace(2, 1, p.shape[1]) * p[0, :, line].max()
    margin, U, words = over_K_1(context(case.inputs(), **arrays | {"true K_1, z_m": p}))
    assert judge.fact(margin, U).status is (Status.PASS if line is None else Status.FAIL)
    assert "left out: z_m = 5 µm" in words
    assert "which only falls" in words


@pytest.mark.parametrize(
    ("name", "turning"), [("p_max along K_2", "on 2 of 5 lines"), ("p_max along z_m", "on 1 of 5")]
)
def test_where_the_paper_s_lines_turn_stands_with_where_they_do_not(name, turning):
    rows = judge_case(
        Job(OPTIMUM_25, SpragOptimum(), drawn=False), solved(OPTIMUM_25, SpragOptimum())
    ).rows
    (row,) = [row for row in rows if row.quantity == name]
    assert row.status is Status.SHOWN
    assert turning in row.reason
    assert "at K_1 = 2, the nearest to the best, it only falls" in row.reason


@BOTH
def test_a_crown_takes_off_the_same_in_both_rows(case):
    found = solved(case, case.inputs())[-1].result.arrays
    said = taken_off(context(case.inputs(), **found))
    assert f"{reductions(found)[0]:.1%} by 41 slices" in said
    assert f"({found['none: pressures'][0].max() / 1e6:.0f} to" in said


@pytest.mark.parametrize(
    ("line", "said"),
    [([3.0, 2.0, 2.5], "falls, then rises by 25.00%"),
     ([3.0, 2.0, 2.001], "only falls, but for 0.1% at most"),
     ([1.0, 2.0, 3.0], "only rises, but for 0.1% at most")],
)  # fmt: skip
def test_the_course_of_a_line_is_told(line, said):
    assert course(np.array(line)) == said


def test_lines_that_turn_are_counted():
    lines = np.tile([3.0, 2.0, 2.5, 2.6, 2.7], (5, 1))
    lines[0] = [3.0, 2.9, 2.8, 2.7, 2.6]
    said = counted(context(best=np.array([4.9, 0.7, 1e-5])), lines)
    assert said.startswith("on 4 of 5 lines of constant K_1 it falls, then rises, by 35.00% at")
    assert said.endswith("at K_1 = 5, the nearest to the best, it falls, then rises by 35.00%")


def test_what_lies_within_half_a_per_cent_is_a_band():
    p = np.array([2.0, 1.004, 1.0, 1.004, 1.006])
    assert band(np.linspace(1, 5, 5), p) == "2.00 to 4.00 within 0.5%"


@pytest.mark.parametrize(
    ("strips", "cells", "status"),
    [(1.08, 1.10, Status.PASS), (1.08, 1.015, Status.FAIL), (1.015, 1.10, Status.FAIL),
     (1.0, 1.0, Status.FAIL)],
)  # fmt: skip
def test_a_pressure_that_hardly_grows_has_a_largest(strips, cells, status):
    arrays = {
        f"best: {by} {n}": 3e9 * np.array([0.9, growth**k])
        for by, counts, growth in (("strips", STRIPPED, strips), ("cells", CELLS, cells))
        for k, n in enumerate(counts)
    }
    margin, U, _ = endless(context(**arrays))
    assert judge.fact(margin, U).status is status


@BOTH
def test_a_crown_with_free_ends_has_a_largest_pressure(case):
    found = solved(case, case.inputs())[-1].result.arrays
    arrays = {
        name.replace("free", "best"): p for name, p in found.items() if name.startswith("free: ")
    }
    margin, U, _ = endless(context(**arrays))
    assert judge.fact(margin, U).status is Status.FAIL


def test_engagements_are_counted_until_one_is_near_the_best():
    found = {"best true": np.array([1.0]), "X": np.zeros((125, 3)), "infill": np.zeros((2, 5))}
    tried = np.array([[0, 0, 0, 1.2], [0, 0, 0, 1.0009], [0, 0, 0, 1.0]])
    assert asked(context(**found, direct=tried)).endswith("from the crown at hand: 2")
    assert asked(context(**found, direct=tried + 0.01)).endswith("not within 3")
