"""Rows of every kind of claim, from finite-element levels that are made up by hand.

The made-up series is v = v0 (1 + a h^p) on h = 1/2, 1/4, 1/8: its finest value is off by v0 a/8^p,
its index (formal order p) 1.25 times that, so U = 2 GCI/2 = 1.25 v0 a/8^p.
"""

import math

import numpy as np
import pytest

from verify.core.case import Context, FemResult
from verify.core.results import Kind, Status
from verify.judging.checks import Approximation, Exact, Fact, Identity, Limit, Order
from verify.judging.published_checks import Contradiction, PrintedMeasurement, PrintedTheory

SIZES = (1 / 2, 1 / 4, 1 / 8)


def context(series, *, analytic=None, u_it=0.0, is_paper=True, sizes=SIZES, inputs=None):
    """A context whose finite elements gave `series` of the one quantity "v"."""
    levels = [
        FemResult(h=h, values={"v": v}, u_it={"v": u_it})
        for h, v in zip(sizes, series, strict=True)
    ]
    return Context("ring-made-up", inputs, analytic or {}, levels, is_paper)


def power_law(v0, a, p=2, sizes=SIZES):
    return [v0 * (1 + a * h**p) for h in sizes]


def identity(**more):
    return Identity(
        **({"name": "gap", "symbol": "g", "unit": "µm", "analytic": "g", "fem": "v", "formal": 2}
           | more)
    )  # fmt: skip


def rows_of(claim, *args, **more):
    return claim.rows(context(*args, **more))


# Identity: 5 µm against 5 µm (1 + h²/1000).

SHARE = 1e-3 / 64  # what the finest value is off, relative


def test_an_identity_is_judged_in_si_and_shown_in_its_unit():
    row, _ = rows_of(identity(), power_law(5e-6, 1e-3), analytic={"g": 5e-6})
    assert row.status is Status.PASS
    assert (row.kind, row.unit, row.symbol) == (Kind.IDENTITY, "µm", "g")
    assert row.id == "ring-made-up/gap"
    # Differences of 1e-5 relative carry the round-off of the values, 1e-16: 1e-10 at the most.
    assert row.analytic == pytest.approx(5.0, rel=1e-14)
    assert row.fem == pytest.approx(5.0 * (1 + SHARE), rel=1e-14)
    assert row.difference == pytest.approx(5.0 * SHARE, rel=1e-9)
    assert row.tolerance == pytest.approx(1.25 * 5.0 * SHARE, rel=1e-9)
    assert row.u_num == pytest.approx(1.25 * 5.0 * SHARE / 2, rel=1e-9)
    assert row.scale == pytest.approx(5.0, rel=1e-14)
    assert row.detects == pytest.approx(2.25 * SHARE, rel=1e-9)
    assert row.order == pytest.approx(2.0, abs=1e-6)
    assert row.formal_order == 2
    assert (row.u_ref, row.u_input) == (0.0, 0.0)
    expected = [(h, 5.0 * (1 + 1e-3 * h**2)) for h in SIZES]
    assert row.levels == tuple(pytest.approx(level, rel=1e-14) for level in expected)


@pytest.mark.parametrize(
    ("formula", "status"),
    [
        pytest.param(1 + 2.2 * SHARE, Status.PASS, id="off by 1.2 e, U = 1.25 e"),
        pytest.param(1 + 2.3 * SHARE, Status.FAIL, id="off by 1.3 e"),
        pytest.param(1 - 0.2 * SHARE, Status.PASS, id="off by 1.2 e the other way"),
        pytest.param(1 - 0.3 * SHARE, Status.FAIL, id="off by 1.3 e the other way"),
    ],
)
def test_an_identity_fails_where_the_formula_is_off_by_more_than_the_mesh(formula, status):
    row, convergence = rows_of(identity(), power_law(1e-6, 1e-3), analytic={"g": 1e-6 * formula})
    assert row.status is status
    assert convergence.status is Status.PASS  # another matter


def test_convergence_is_a_row_of_its_own_beside_agreement():
    _, row = rows_of(identity(), power_law(5e-6, 1e-3), analytic={"g": 5e-6})
    assert row.id == "ring-made-up/gap: convergence"
    assert (row.kind, row.status, row.unit) == (Kind.FACT, Status.PASS, "1")
    assert row.fem == pytest.approx(2.0, abs=1e-6)
    assert row.reason.startswith("order 2.00")
    assert row.difference == pytest.approx(2.0 - 0.5, abs=1e-6)  # margin over the least order


def test_agreement_without_convergence_is_seen():
    series = (1.3e-6, 1.2e-6, 1.0e-6)  # hits the formula and runs away from it
    rows = rows_of(identity(), series, analytic={"g": 1e-6})
    assert [row.status for row in rows] == [Status.FAIL, Status.FAIL]
    assert all(row.reason.startswith("does not converge") for row in rows)


@pytest.mark.parametrize(
    "claim",
    [
        pytest.param(identity(), id="identity"),
        pytest.param(
            Approximation(name="gap", symbol="g", unit="µm", analytic="g", fem="v", formal=2,
                          interval=lambda q, v: (-0.01, 0.01), source="made up"),
            id="approximation",
        ),
        pytest.param(
            Exact(name="balance", symbol="F", unit="N", fem="v", scale="g", bound=1e-9,
                  bound_reason="made up"),
            id="exact",
        ),
    ],
)  # fmt: skip
def test_a_level_that_is_no_number_is_a_red_row_and_no_crash(claim):
    series = [0.0, 0.0, 0.0] if isinstance(claim, Exact) else power_law(5e-6, 1e-3)
    series[2] = math.nan
    row, *_ = rows_of(claim, series, analytic={"g": 5e-6})
    assert row.status is Status.FAIL


def test_an_oscillating_series_is_as_uncertain_as_three_times_its_spread():
    series = (5.00e-6, 5.01e-6, 5.005e-6)  # spread 0.01 µm
    row, convergence = rows_of(identity(demand=0.01), series, analytic={"g": 5.005e-6})
    assert row.tolerance == pytest.approx(0.03, rel=1e-9)
    assert row.detects == pytest.approx(0.03 / 5.005, rel=1e-9)
    assert row.order is None
    assert row.status is convergence.status is Status.PASS
    row, convergence = rows_of(identity(demand=0.005), series, analytic={"g": 5.005e-6})
    assert row.reason.startswith("not sharp")
    assert convergence.status is Status.FAIL


def test_iteration_error_adds_to_the_mesh_error():
    # GCI/2 = 1.25 5e-6 a/128 = 3e-8 and u_it = 4e-8 make u = 5e-8; u_it is 0.3 % of |v1 - v2|
    a = 128 * 3e-8 / (1.25 * 5e-6)
    row, _ = rows_of(identity(demand=1.0), power_law(5e-6, a), analytic={"g": 5e-6}, u_it=4e-10)
    assert row.u_num == pytest.approx(math.hypot(0.03, 0.0004), rel=1e-6)
    row, _ = rows_of(identity(demand=1.0), power_law(5e-6, a), analytic={"g": 5e-6}, u_it=4e-8)
    # above 1 % of |v1 - v2| = 3 5e-6 a/64: noisy, GCI = 3 (max - min) = 3 5e-6 a (1/4 - 1/64)
    noisy = 3 * 5.0 * a * 15 / 64 / 2
    assert row.u_num == pytest.approx(math.hypot(noisy, 0.04), rel=1e-6)
    assert row.order is None


def test_the_scale_is_the_magnitude_that_the_claim_names():
    values = {"g": 0.0, "load": -8e-6}
    series = [8e-6 * 1e-4 * h**2 for h in SIZES]
    row, _ = rows_of(identity(scale="load"), series, analytic=values)
    assert row.status is Status.PASS
    assert row.scale_name == "load"
    assert row.scale == pytest.approx(8.0)
    assert row.detects == pytest.approx(2.25 * 1e-4 / 64, rel=1e-9)  # (U + |d|)/scale


def test_a_user_s_inputs_are_judged_with_one_per_cent_or_a_coarser_demand():
    series, values = power_law(5e-6, 1e-3), {"g": 5e-6}  # detects 3.5e-5
    fine = identity(demand=1e-5, demand_reason="because")
    row, _ = rows_of(fine, series, analytic=values, is_paper=False)
    assert (row.status, row.demand) == (Status.PASS, 0.01)
    row, _ = rows_of(identity(demand=0.05), series, analytic=values, is_paper=False)
    assert row.demand == 0.05
    row, _ = rows_of(approximation(lambda q, v: (-0.02, 0.02), demand=1e-5), series,
                     analytic={"k": 5e-6}, is_paper=False)  # fmt: skip
    assert row.reason.startswith("not sharp")  # detects 0.02
    assert row.demand == 0.01


# Approximation: formula 3 % above the finite elements.


def approximation(interval, **more):
    return Approximation(
        name="k", symbol="k", unit="N/mm", analytic="k", fem="v", formal=2, interval=interval,
        source="an estimate", **more,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("interval", "status"),
    [
        pytest.param((0.02, 0.04), Status.PASS, id="inside"),
        pytest.param((0.031, 0.04), Status.FAIL, id="below"),
        pytest.param((0.02, 0.029), Status.FAIL, id="above"),
        pytest.param((0.02, 0.03), Status.FAIL, id="at the end, not inside by U_m"),
    ],
)
def test_an_approximation_is_inside_an_interval_known_beforehand(interval, status):
    series = power_law(700.0, 1e-4)
    seen = []

    def known(q, v):
        seen.append((q, v))
        return interval

    row, convergence = rows_of(
        approximation(known, demand=0.05), series, analytic={"k": 1.03 * series[-1]}, inputs="q"
    )
    assert row.status is status
    assert convergence.status is Status.PASS
    assert (row.kind, row.interval, row.interval_source) == (
        Kind.APPROXIMATION, interval, "an estimate",
    )  # fmt: skip
    assert seen == [("q", {"k": 1.03 * series[-1]})]  # and not the finite elements
    assert row.analytic == pytest.approx(1.03 * series[-1] / 1e3)  # N/m to N/mm
    assert row.difference == pytest.approx(0.03 * series[-1] / 1e3, rel=1e-9)
    assert row.tolerance == pytest.approx(1.25 * 0.7 * 1e-4 / 64, rel=1e-6)


@pytest.mark.parametrize("interval", [None, lambda q, v: None], ids=["none", "none here"])
def test_an_approximation_without_interval_is_shown_and_still_has_to_converge(interval):
    claim = approximation(interval)
    rows = rows_of(claim, power_law(700.0, 1e-4), analytic={"k": 720.0})
    assert [row.status for row in rows] == [Status.SHOWN, Status.PASS]
    assert rows[0].reason.startswith("measured")
    rows = rows_of(claim, (700.0, 710.0, 730.0), analytic={"k": 720.0})
    assert [row.status for row in rows] == [Status.FAIL, Status.FAIL]
    assert rows[0].reason == "does not converge"


def test_printed_values_stand_beside_a_row_for_the_paper_s_inputs_only():
    claim = approximation(None, printed=("wang2023:k1-fea",))
    series = power_law(600.0, 1e-4)
    row, _ = rows_of(claim, series, analytic={"k": 601.0})
    (entry,) = row.published
    assert (entry.document, entry.id, entry.kind) == ("wang2023", "k1-fea", "FEA")
    assert (entry.printed, entry.value) == ("0.613", pytest.approx(0.613))  # Table 1
    row, _ = rows_of(claim, series, analytic={"k": 601.0}, is_paper=False)
    assert row.published == ()


# Trend: the order of errors.


def order(errors, p=2.0, demand=0.05):
    return Order(name="order", symbol="p", unit="1", errors=errors, order=p, demand=demand)


FOUR = (1 / 2, 1 / 4, 1 / 8, 1 / 16)


@pytest.mark.parametrize(
    ("p", "status"),
    [(2.0, Status.PASS), (1.9, Status.FAIL), (2.1, Status.FAIL), (3.0, Status.FAIL)],
)
def test_errors_fall_with_the_order_of_theory(p, status):
    claim = order(lambda c: (list(FOUR), [0.3 * h**2 * (1 + 0.1 * h) for h in FOUR]), p=p)
    (row,) = claim.rows(context((), sizes=()))
    assert row.status is status
    assert row.kind is Kind.TREND
    assert row.analytic == row.formal_order == p
    # a tenth of h: slopes from 2 + 0.1 h/ln 4, of which the fit leaves half of the last, 0.003
    assert row.fem == pytest.approx(2.0, abs=0.003)
    assert row.scale == p


def test_an_order_speaks_of_the_elements_and_not_of_a_user_s_inputs():
    claim = order(lambda c: (list(FOUR), [h**3 for h in FOUR]))
    assert claim.rows(context((), sizes=(), is_paper=False)) == []


@pytest.mark.parametrize(
    "errors",
    [
        pytest.param([1e-2, 1e-3, 0.0, 1e-5], id="an error of zero"),
        pytest.param([1e-2, 1e-3, math.nan, 1e-5], id="no number"),
        pytest.param([1e-2, 1e-3, 1e-4], id="three levels"),
    ],
)
def test_errors_without_an_order_fail(errors):
    claim = order(lambda c: (list(FOUR[: len(errors)]), errors))
    (row,) = claim.rows(context((), sizes=()))
    assert row.status is Status.FAIL
    assert row.reason.startswith("no order")


# Balances.


@pytest.mark.parametrize(("residual", "status"), [(1e-6, Status.PASS), (3e-6, Status.FAIL)])
@pytest.mark.parametrize("sign", [1, -1])
def test_a_balance_is_taken_on_the_finest_mesh_in_its_own_unit(residual, status, sign):
    claim = Exact(
        name="balance", symbol="F", unit="kN", fem="v", scale="load", bound=1e-9,
        bound_reason="direct solve",
    )  # fmt: skip
    (row,) = rows_of(claim, (5.0, 1.0, sign * residual), analytic={"load": -2e3})
    assert (row.kind, row.status) == (Kind.EXACT, status)
    assert row.tolerance == pytest.approx(1e-9 * 2.0)  # of 2 kN
    assert row.fem == pytest.approx(sign * residual / 1e3)
    assert row.detects == pytest.approx(1e-9 + residual / 2e3)
    assert (row.scale_name, row.interval_source) == ("load", "direct solve")


# Limits.


def limit(points, exponent, demand=0.01):
    return Limit(
        name="limit", symbol="d", unit="1", points=points, exponent=exponent, demand=demand
    )


@pytest.mark.parametrize(
    ("d0", "exponent", "status"),
    [
        pytest.param(0.0, 2.0, Status.PASS, id="right"),
        pytest.param(0.0, None, Status.PASS, id="no exponent from theory"),
        pytest.param(0.0, 1.0, Status.FAIL, id="wrong exponent"),
        pytest.param(1e-3, 2.0, Status.FAIL, id="limit not zero"),
    ],
)
def test_a_formula_becomes_exact_with_the_exponent_of_theory(d0, exponent, status):
    eps = np.geomspace(0.1, 0.01, 5)
    points = (list(eps), list(d0 + 0.3 * eps**2), [1e-6] * 5)
    (row,) = limit(lambda c: points, exponent).rows(context((), sizes=()))
    assert (row.kind, row.status) == (Kind.ASYMPTOTIC, status)
    assert row.order == pytest.approx(2.0, abs=1e-4)
    assert row.fem == pytest.approx(d0, abs=1e-7)
    assert (row.scale, row.analytic) == (1.0, 0.0)


@pytest.mark.parametrize(
    ("eps", "d", "u"),
    [
        pytest.param([0.1, 0.05, 0.01], [0.1, 0.05, 0.01], [1e-6] * 3, id="three points"),
        pytest.param([0.1, 0.08, 0.05, 0.02], [0.1] * 4, [1e-6] * 4, id="no decade"),
        pytest.param([0.1, 0.05, 0.02, 0.01], [0.1, math.nan, 0, 0], [1e-6] * 4, id="NaN"),
        pytest.param([0.1, 0.05, 0.02, 0.01], [0.1, 0.05, 0.02, 0.01], [math.nan] * 4, id="u NaN"),
        pytest.param([0.1, 0.05, 0.02, 0.01], [0.0] * 4, [0.0] * 4, id="all zero"),
    ],
)
def test_points_without_a_limit_fail(eps, d, u):
    (row,) = limit(lambda c: (eps, d, u), 1.0).rows(context((), sizes=()))
    assert row.status is Status.FAIL
    assert row.reason.startswith("no limit")


# Facts.


@pytest.mark.parametrize(
    ("margin", "status", "reason"),
    [(0.2, Status.PASS, "held"), (0.05, Status.FAIL, "undecided"), (-0.2, Status.FAIL, "not held")],
)
def test_a_fact_is_held_or_not_or_undecided(margin, status, reason):
    claim = Fact(name="first", symbol="m", unit="MPa", margin=lambda c: (margin * 1e6, 0.1e6))
    (row,) = claim.rows(context((), sizes=()))
    assert (row.kind, row.status) == (Kind.FACT, status)
    assert row.reason.startswith(reason)
    assert row.difference == pytest.approx(margin)
    assert row.tolerance == pytest.approx(0.1)


# Printed numbers: Wang et al. 2023, Table 1, row k_1: theory 0.601, FEA 0.613, test 0.610 N/mm.


def printed_theory(unit="N/mm", reference="wang2023:k1-theory"):
    return PrintedTheory(name="k_1", symbol="k_1", unit=unit, analytic="k", reference=reference)


# 2 u = 2 (0.0005/sqrt 3) = 0.000577 N/mm around 0.601
@pytest.mark.parametrize(
    ("k", "status"),
    [
        pytest.param(601.0, Status.PASS, id="as printed"),
        pytest.param(601.57, Status.PASS, id="0.57 N/m above"),
        pytest.param(601.58, Status.FAIL, id="0.58 N/m above"),
        pytest.param(600.43, Status.PASS, id="0.57 N/m below"),
        pytest.param(600.42, Status.FAIL, id="0.58 N/m below"),
    ],
)
def test_the_last_printed_digit_decides_on_a_formula(k, status):
    (row,) = rows_of(printed_theory(), (), sizes=(), analytic={"k": k})
    assert row.status is status
    assert row.kind is Kind.IDENTITY
    assert row.analytic == pytest.approx(k / 1e3)
    assert row.fem is None
    assert (row.partner.by, row.partner.value) == ("printed 0.601", pytest.approx(0.601))
    assert row.difference == pytest.approx(k / 1e3 - 0.601, abs=1e-15)
    assert row.u_ref == pytest.approx(0.0005 / math.sqrt(3))
    assert row.tolerance == pytest.approx(2 * 0.0005 / math.sqrt(3))
    assert row.scale == pytest.approx(0.601)


def test_a_number_printed_as_approximate_is_shown_and_no_identity():
    """Belcin's K ≈ 1. Identity rows are PASS or FAIL only."""
    claim = printed_theory("1", "belcin:k-predimensioning")
    (row,) = rows_of(claim, (), sizes=(), analytic={"k": 1.003})
    assert row.status is Status.SHOWN
    assert row.difference == pytest.approx(0.003)
    assert row.kind is not Kind.IDENTITY


def test_a_measurement_without_stated_scatter_is_shown_and_not_judged():
    claim = PrintedMeasurement(
        name="k_1, test", symbol="k_1", unit="N/mm", analytic="k", reference="wang2023:k1-test"
    )
    for k in (610.0, 6100.0):
        (row,) = rows_of(claim, (), sizes=(), analytic={"k": k})
        assert row.status is Status.SHOWN
        assert row.kind is Kind.APPROXIMATION
        assert (row.partner.by, row.partner.value) == ("printed test 0.610", pytest.approx(0.61))
        assert row.difference == pytest.approx(k / 1e3 - 0.61, abs=1e-12)
        assert row.tolerance is None
    assert row.reason.startswith("formula +900.0 %")


# 2 u = 0.577 N/m around the printed 601
@pytest.mark.parametrize(
    ("k", "status"),
    [(601.58, Status.NOTE), (601.57, Status.FAIL), (601.0, Status.FAIL), (500.0, Status.FAIL)],
)
def test_a_printed_number_is_contradicted_by_what_surely_exceeds_it(k, status):
    claim = Contradiction(
        name="k_1", symbol="k_1", unit="N/mm", analytic="k", reference="wang2023:k1-theory",
        erratum="wang2023:yield-strength",
    )  # fmt: skip
    assert not claim.needs_fem
    (row,) = rows_of(claim, (), sizes=(), analytic={"k": k})
    assert (row.status, row.kind) == (status, Kind.FACT)
    assert "wang2023:yield-strength" in row.reason
    assert (row.partner.by, row.partner.value) == ("printed 0.601", pytest.approx(0.601))
    assert row.difference == pytest.approx(k / 1e3 - 0.601, abs=1e-12)
    assert row.tolerance == pytest.approx(2 * 0.0005 / math.sqrt(3))
    assert rows_of(claim, (), sizes=(), analytic={"k": k}, is_paper=False) == []


@pytest.mark.parametrize("kind", [PrintedTheory, PrintedMeasurement])
def test_printed_numbers_speak_of_the_paper_s_inputs_alone(kind):
    claim = kind(
        name="k_1", symbol="k_1", unit="N/mm", analytic="k", reference="wang2023:k1-theory"
    )
    assert not claim.needs_fem
    assert rows_of(claim, (), sizes=(), analytic={"k": 601.0}, is_paper=False) == []


# Rows that were not run.

CLAIMS = [
    pytest.param(identity(demand=0.5), id="identity"),
    pytest.param(
        Approximation(name="k", symbol="k", unit="N/mm", analytic="g", fem="v", formal=2,
                      interval=None, source="none"),
        id="approximation",
    ),
    pytest.param(order(lambda c: (list(FOUR), [h**2 for h in FOUR])), id="trend"),
    pytest.param(
        Exact(name="balance", symbol="F", unit="kN", fem="v", scale="g", bound=1.0,
              bound_reason="made up"),
        id="exact",
    ),
    pytest.param(
        limit(lambda c: ([1.0, 0.5, 0.2, 0.1], [0.1, 0.05, 0.02, 0.01], [1e-3] * 4), 1.0),
        id="asymptotic",
    ),
    pytest.param(Fact(name="fact", symbol="m", unit="1", margin=lambda c: (1.0, 0.0)), id="fact"),
]  # fmt: skip


@pytest.mark.parametrize("claim", CLAIMS)
def test_skipped_rows_are_the_same_rows_not_run(claim):
    def identify(rows):
        return [(r.id, r.kind, r.symbol, r.unit, r.demand, r.demand_reason) for r in rows]

    skipped = claim.skipped("ring-made-up", "quick")
    assert {row.status for row in skipped} == {Status.SKIP}
    assert {row.reason for row in skipped} == {"quick"}
    assert all(row.fem is row.analytic is row.difference is None for row in skipped)
    run = rows_of(claim, power_law(5e-6, 1e-3), analytic={"g": 5e-6})
    assert identify(skipped) == identify(run)
