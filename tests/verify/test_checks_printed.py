"""Formulas against printed numbers: Wang et al. 2023, Table 1, k_1: theory 0.601, FEA 0.613 N/mm.

The theory's last digit leaves 2 u = 2 (0.0005/sqrt 3) = 0.000577 N/mm around 0.601.
"""

import math

import pytest

from tests.verify.test_checks import approximation, power_law, rows_of
from verify.core.results import Kind, Status
from verify.judging.published_checks import Contradiction, PrintedMeasurement, PrintedTheory

K_1 = {"name": "k_1", "symbol": "k_1", "unit": "N/mm", "analytic": "k"}
THEORY = PrintedTheory(**K_1, reference="wang2023:k1-theory")
TEST = PrintedMeasurement(**K_1, reference="wang2023:k1-test")
CONTRADICTION = Contradiction(
    **K_1, reference="wang2023:k1-theory", erratum="wang2023:yield-strength"
)


def row_of(claim, k):
    (row,) = rows_of(claim, analytic={"k": k})
    return row


@pytest.mark.parametrize(
    ("k", "status"),
    [(601.57, Status.PASS), (601.58, Status.FAIL), (600.43, Status.PASS), (600.42, Status.FAIL)],
)
def test_the_last_printed_digit_decides_on_a_formula(k, status):
    row = row_of(THEORY, k)
    assert (row.status, row.kind, row.fem) == (status, Kind.IDENTITY, None)
    assert row.analytic == pytest.approx(k / 1e3)
    assert (row.partner.by, row.partner.value) == ("printed 0.601", pytest.approx(0.601))
    assert row.difference == pytest.approx(k / 1e3 - 0.601, abs=1e-15)
    assert row.u_ref == pytest.approx(0.0005 / math.sqrt(3))
    assert row.tolerance == pytest.approx(2 * 0.0005 / math.sqrt(3))
    assert row.scale == pytest.approx(0.601)


def test_a_number_printed_as_approximate_is_shown_and_no_identity():
    """Belcin's K ≈ 1. Identity rows are PASS or FAIL only."""
    about_one = PrintedTheory(
        name="K", symbol="K", unit="1", analytic="k", reference="belcin:k-predimensioning"
    )
    row = row_of(about_one, 1.003)
    assert (row.status, row.kind) == (Status.SHOWN, Kind.APPROXIMATION)
    assert row.difference == pytest.approx(0.003)


def test_a_measurement_without_stated_scatter_is_shown_and_not_judged():
    row = row_of(TEST, 6100.0)
    assert (row.status, row.kind, row.tolerance) == (Status.SHOWN, Kind.APPROXIMATION, None)
    assert (row.partner.by, row.partner.value) == ("printed test 0.610", pytest.approx(0.61))
    assert row.difference == pytest.approx(6.1 - 0.61, abs=1e-12)
    assert row.reason.startswith("difference of the formula from the printed value +900.0 %")


@pytest.mark.parametrize(
    ("k", "status"), [(601.58, Status.NOTE), (601.57, Status.FAIL), (500.0, Status.FAIL)]
)
def test_a_printed_number_is_contradicted_by_what_surely_exceeds_it(k, status):
    row = row_of(CONTRADICTION, k)
    assert (row.status, row.kind) == (status, Kind.FACT)
    assert "wang2023:yield-strength" in row.reason
    assert (row.partner.by, row.partner.value) == ("printed 0.601", pytest.approx(0.601))
    assert row.difference == pytest.approx(k / 1e3 - 0.601, abs=1e-12)
    assert row.tolerance == pytest.approx(2 * 0.0005 / math.sqrt(3))


def test_printed_numbers_apply_to_the_paper_s_inputs_only():
    for claim in (THEORY, TEST, CONTRADICTION):
        assert not claim.needs_fem
        assert rows_of(claim, analytic={"k": 601.0}, is_paper=False) == []
    claim = approximation(None, printed=("wang2023:k1-fea",))
    series = power_law(600.0, 1e-4)
    row, _ = rows_of(claim, series, analytic={"k": 601.0})
    (entry,) = row.published
    assert (entry.document, entry.id, entry.kind) == ("wang2023", "k1-fea", "FEA")
    assert (entry.printed, entry.value) == ("0.613", pytest.approx(0.613))  # Table 1
    row, _ = rows_of(claim, series, analytic={"k": 601.0}, is_paper=False)
    assert row.published == ()
