"""What crowns do: the box by hand, the verdict on a crown, and the paper's Table 2."""

import math

import pytest

from tests.verify.cases.rows import context, rows
from verify.cases.sprag.crown import table2
from verify.cases.sprag.crown.advice import verdict
from verify.cases.sprag.crown.case import CROWN, SpragCrown
from verify.cases.sprag.crown.formulas import box, factorial, unit
from verify.cases.sprag.crown.table2 import cell, relative_error
from verify.core.results import Status

Q = SpragCrown()


def test_the_box_is_eq_19_and_another_load_scales_its_drop_alone():
    low, high = box(Q)
    assert low.tolist() == [1, 0.4, 5e-6]
    assert high.tolist() == [5, 0.7, 25e-6]
    assert (box(SpragCrown(Q=2 * 3407.0))[1] / high).tolist() == pytest.approx([1, 1, 2])
    assert len(factorial(Q, 5)) == 125
    assert unit(Q) == pytest.approx(2 * 3407 / (math.pi * 9e-3 * 206e9 / 0.91))  # 2 Q/(π l E')


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


@pytest.mark.parametrize(
    ("changes", "state"),
    [
        ({}, "too shallow"), ({"K_1": Q.K_1_suits}, "suits"), ({"z_m": 0.0}, "no crown"),
        ({"K_1": 30.0, "z_m": 25e-6}, "uneven"), ({"T": 80.0}, "rolls over"),
        ({"T": 500.0, "alpha_max": 3.0}, "no state"),
    ],
)  # fmt: skip
def test_the_verdict_is_that_of_the_crown(changes, state):
    q = SpragCrown(**changes)
    assert verdict(q) == state
    assert CROWN.findings(q, CROWN.analytic(q))[0].startswith(state)
