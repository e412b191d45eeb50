"""Rows of every kind of claim, from finite-element levels made by hand.

The made-up series is v = v0 (1 + a h^p) on h = 1/2, 1/4, 1/8: its finest value is off by v0 a/8^p,
its index (formal order p) 1.25 times that, so U = 2 GCI/2 = 1.25 v0 a/8^p.
"""

import math

import numpy as np
import pytest

from verify.core.case import Context, FemResult
from verify.core.results import Kind, Status
from verify.judging.checks import Approximation, Exact, Fact, Identity, Limit, Order

SIZES = (1 / 2, 1 / 4, 1 / 8)
FOUR = (*SIZES, 1 / 16)
SIGNS = pytest.mark.parametrize("sign", [1, -1], ids=["positive", "negative"])


def context(series=(), *, analytic=None, u_it=0.0, is_paper=True, sizes=SIZES, inputs=None):
    """A context whose finite elements gave `series` of the one quantity "v"."""
    levels = [
        FemResult(h=h, values={"v": v}, u_it={"v": u_it})
        for h, v in zip(sizes[: len(series)], series, strict=True)
    ]
    return Context("ring-made-up", inputs, analytic or {}, levels, is_paper)


def power_law(v0, a, p=2, sizes=SIZES):
    return [v0 * (1 + a * h**p) for h in sizes]


def identity(**more):
    return Identity(
        **({"name": "gap", "symbol": "g", "unit": "µm", "analytic": "g", "fem": "v", "formal": 2}
           | more)
    )  # fmt: skip


def approximation(interval, unit="N/mm", **more):
    return Approximation(
        name="k", symbol="k", unit=unit, analytic="k", fem="v", formal=2, interval=interval,
        source="an estimate", **more,
    )  # fmt: skip


def order(errors, p=2.0, demand=0.05):
    return Order(name="order", symbol="p", unit="1", errors=errors, order=p, demand=demand)


def limit(points, exponent, demand=0.01):
    return Limit(
        name="limit", symbol="d", unit="1", points=points, exponent=exponent, demand=demand
    )


BALANCE = Exact(
    name="balance", symbol="F", unit="kN", fem="v", scale="load", bound=1e-9,
    bound_reason="direct solve",
)  # fmt: skip


def rows_of(claim, *args, **more):
    return claim.rows(context(*args, **more))


# Identity: 5 µm against 5 µm (1 + h²/1000).

SHARE = 1e-3 / 64  # what the finest value is off, relative


def test_an_identity_is_judged_in_si_and_displayed_in_its_unit_and_its_convergence_is_another_row():
    row, convergence = rows_of(identity(), power_law(5e-6, 1e-3), analytic={"g": 5e-6})
    assert (row.id, row.status) == ("ring-made-up/gap", Status.PASS)
    assert (row.kind, row.unit, row.symbol) == (Kind.IDENTITY, "µm", "g")
    # Differences of 1e-5 relative carry the round-off of the values, 1e-16: 1e-10 at the most.
    assert row.analytic == pytest.approx(5.0, rel=1e-14)
    assert row.fem == pytest.approx(5.0 * (1 + SHARE), rel=1e-14)
    assert row.difference == pytest.approx(5.0 * SHARE, rel=1e-9)
    assert row.tolerance == pytest.approx(1.25 * 5.0 * SHARE, rel=1e-9)
    assert row.u_num == pytest.approx(1.25 * 5.0 * SHARE / 2, rel=1e-9)
    assert row.scale == pytest.approx(5.0, rel=1e-14)
    assert row.detects == pytest.approx(2.25 * SHARE, rel=1e-9)
    assert row.order == pytest.approx(2.0, abs=1e-6)
    assert (row.formal_order, row.u_ref, row.u_input) == (2, 0.0, 0.0)
    expected = [(h, 5.0 * (1 + 1e-3 * h**2)) for h in SIZES]
    assert row.levels == tuple(pytest.approx(level, rel=1e-14) for level in expected)
    assert convergence.id == "ring-made-up/gap: convergence"
    assert (convergence.kind, convergence.status, convergence.unit) == (Kind.FACT, Status.PASS, "1")
    assert convergence.fem == pytest.approx(2.0, abs=1e-6)
    assert convergence.reason.startswith("order 2.00")
    assert convergence.difference == pytest.approx(2.0 - 0.5, abs=1e-6)  # over the least order


@pytest.mark.parametrize("claim", [identity(), approximation(lambda q, v: (-0.01, 0.01))])
@pytest.mark.parametrize("finest", [1.0, math.nan])
def test_agreement_without_convergence_fails(claim, finest):
    """A series that hits the formula and runs away from it, or ends with no number."""
    rows = rows_of(claim, (1.3, 1.2, finest), analytic={"g": 1.0, "k": 1.0})
    assert [row.status for row in rows] == [Status.FAIL, Status.FAIL]
    assert all(row.reason.startswith("does not converge") for row in rows)


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
    series, values = power_law(5e-6, 1e-3), {"g": 5e-6, "k": 5e-6}  # detects 3.5e-5
    fine = identity(demand=1e-5, demand_reason="because")
    row, _ = rows_of(fine, series, analytic=values, is_paper=False)
    assert (row.status, row.demand) == (Status.PASS, 0.01)
    row, _ = rows_of(identity(demand=0.05), series, analytic=values, is_paper=False)
    assert row.demand == 0.05
    wide = approximation(lambda q, v: (-0.02, 0.02), demand=1e-5)
    row, _ = rows_of(wide, series, analytic=values, is_paper=False)
    assert row.reason.startswith("insufficient sensitivity")  # detects 0.02
    assert row.demand == 0.01


# Convergence by the spread: 5.00, 5.01 and 5.005 µm, three times 0.01 µm of 5 % of 5 µm.


@SIGNS
@pytest.mark.parametrize("kind", ["identity", "approximation"])
def test_a_series_without_an_order_is_as_uncertain_as_three_times_its_spread(kind, sign):
    def judged(demand):
        of_kind = {
            "identity": identity(demand=demand),
            "approximation": approximation(lambda q, v: (-0.02, 0.02), unit="µm", demand=demand),
        }
        series = [sign * v for v in (5.00e-6, 5.01e-6, 5.005e-6)]
        formula = {"g": sign * 5e-6, "k": sign * 5e-6}
        return rows_of(of_kind[kind], series, analytic=formula, u_it=2e-11)

    row, convergence = judged(demand=0.05)
    assert row.status is convergence.status is Status.PASS
    assert (row.order, row.tolerance) == (None, pytest.approx(0.03, rel=1e-5))  # with u_it
    assert convergence.difference == pytest.approx(1 - 0.03 / 0.25, rel=1e-9)
    for grid in (row.grid, convergence.grid):
        assert (grid.unit, grid.behaviour, grid.order) == ("µm", "oscillating", None)
        assert grid.levels[0][1] == pytest.approx(sign * 5.0)
        numbers = (grid.scale, grid.allowed, grid.gci, grid.u_it)
        assert numbers == pytest.approx((5.0, 0.25, 0.03, 2e-5), rel=1e-9)
    row, convergence = judged(demand=0.005)
    assert row.status is convergence.status is Status.FAIL
    assert row.reason.startswith("insufficient sensitivity")


# Approximation: formula 3 % above the finite elements.


@pytest.mark.parametrize(
    ("interval", "status"), [((0.02, 0.04), Status.PASS), ((0.02, 0.03), Status.FAIL)]
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


# Trend: the order of errors.


@pytest.mark.parametrize(
    ("p", "status"), [(2.0, Status.PASS), (1.9, Status.FAIL), (2.1, Status.FAIL)]
)
def test_errors_fall_with_the_order_of_theory(p, status):
    claim = order(lambda c: (list(FOUR), [0.3 * h**2 * (1 + 0.1 * h) for h in FOUR]), p=p)
    (row,) = rows_of(claim)
    assert row.status is status
    assert row.kind is Kind.TREND
    assert row.analytic == row.formal_order == row.scale == p
    # a tenth of h: slopes from 2 + 0.1 h/ln 4, of which the fit leaves half of the last, 0.003
    assert row.fem == pytest.approx(2.0, abs=0.003)
    assert row.reason.startswith("order 2.00 ± ") == (status is Status.FAIL)
    assert rows_of(claim, is_paper=False) == []  # of the elements, not of a user's inputs


# Balances, limits and facts.


@pytest.mark.parametrize(
    ("residual", "status"),
    [(1e-6, Status.PASS), (-3e-6, Status.FAIL), (math.nan, Status.FAIL)],
)
def test_a_balance_is_taken_on_the_finest_mesh_in_its_unit(residual, status):
    (row,) = rows_of(BALANCE, (5.0, 1.0, residual), analytic={"load": -2e3})
    assert (row.kind, row.status) == (Kind.EXACT, status)
    if math.isnan(residual):
        return
    assert row.tolerance == pytest.approx(1e-9 * 2.0)  # of 2 kN
    assert row.fem == pytest.approx(residual / 1e3)
    assert row.detects == pytest.approx(1e-9 + abs(residual) / 2e3)
    assert (row.scale_name, row.interval_source) == ("load", "direct solve")


@pytest.mark.parametrize(
    ("d0", "exponent", "status"),
    [(0.0, 2.0, Status.PASS), (0.0, None, Status.PASS), (0.0, 1.0, Status.FAIL),
     (-1e-3, 2.0, Status.FAIL)],
)  # fmt: skip
def test_a_formula_becomes_exact_with_the_exponent_of_theory(d0, exponent, status):
    eps = np.geomspace(0.1, 0.01, 5)
    points = (list(eps), list(d0 + 0.3 * eps**2), [1e-6] * 5)
    (row,) = rows_of(limit(lambda c: points, exponent))
    assert (row.kind, row.status) == (Kind.ASYMPTOTIC, status)
    assert row.order == pytest.approx(2.0, abs=1e-4)
    assert row.fem == pytest.approx(d0, abs=1e-7)
    assert (row.scale, row.analytic) == (1.0, 0.0)
    assert row.detects == pytest.approx(row.tolerance + abs(row.difference), rel=1e-12)


def test_points_and_errors_without_a_fit_fail():
    (row,) = rows_of(limit(lambda c: ([0.1, 0.08, 0.05, 0.02], [0.1] * 4, [1e-6] * 4), 1.0))
    assert row.status is Status.FAIL
    assert row.reason.startswith(
        "the limit cannot be computed: a limit requires at least four points that span a decade"
    )
    (row,) = rows_of(order(lambda c: (list(FOUR), [1e-2, 1e-3, 0.0, 1e-5])))
    assert row.status is Status.FAIL
    assert row.reason.startswith(
        "the order cannot be computed: the order of convergence requires at least four"
    )


def test_a_fact_has_its_margin_in_its_unit():
    claim = Fact(name="first", symbol="m", unit="MPa", margin=lambda c: (-0.2e6, 0.1e6))
    (row,) = rows_of(claim)
    assert (row.kind, row.status, row.reason) == (Kind.FACT, Status.FAIL, "not confirmed")
    assert (row.difference, row.tolerance) == pytest.approx((-0.2, 0.1))


# Rows that were not run.

SQUARES = (list(FOUR), [h**2 for h in FOUR])
EVERY = {
    "identity": identity(demand=0.5), "approximation": approximation(None), "balance": BALANCE,
    "trend": order(lambda c: SQUARES), "limit": limit(lambda c: (*SQUARES, [1e-3] * 4), 2.0),
    "fact": Fact(name="fact", symbol="m", unit="1", margin=lambda c: (1.0, 0.0)),
}  # fmt: skip


@pytest.mark.parametrize("claim", EVERY.values(), ids=EVERY)
def test_skipped_rows_are_the_same_rows_not_run(claim):
    def identify(rows):
        return [(r.id, r.kind, r.symbol, r.unit, r.demand, r.demand_reason) for r in rows]

    skipped = claim.skipped("ring-made-up", "quick")
    assert {(row.status, row.reason) for row in skipped} == {(Status.SKIP, "quick")}
    assert all(row.fem is row.analytic is row.difference is None for row in skipped)
    run = rows_of(claim, power_law(5e-6, 1e-3), analytic=dict.fromkeys(("g", "k", "load"), 5e-6))
    assert identify(skipped) == identify(run)
