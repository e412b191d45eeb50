"""Margins, scales and records of rows, from levels whose convergence is known by hand."""

import numpy as np
import pytest

from tests.verify.test_checks import context, limit, order
from verify.core.results import Status
from verify.judging import checks
from verify.judging.checks import Approximation
from verify.judging.claims import convergence_verdict
from verify.judging.convergence import GridConvergence, OrderFit

SIGNS = pytest.mark.parametrize("sign", [1, -1], ids=["positive", "negative"])


def near(series, formula, u_it=0.0):
    """The rows of an approximation and of its convergence, in µm."""
    claim = Approximation(
        name="near", symbol="v", unit="µm", analytic="f", fem="v", formal=2, source="made up",
        interval=lambda _q, _v: (-0.02, 0.02), demand=0.05,
    )  # fmt: skip
    return claim.rows(context(series, analytic={"f": formula}, u_it=u_it))


# Convergence by the spread: 5.00, 5.01 and 5.005 µm, three times 0.01 µm of 5 % of 5 µm.


@SIGNS
def test_a_series_without_an_order_is_recorded_with_what_it_was_judged_by(sign):
    series = [sign * v for v in (5.00e-6, 5.01e-6, 5.005e-6)]
    row, convergence = near(series, sign * 5e-6, u_it=2e-11)
    assert convergence.status is Status.PASS
    assert convergence.difference == pytest.approx(1 - 0.03 / 0.25, rel=1e-9)
    for grid in (row.grid, convergence.grid):
        assert (grid.unit, grid.behaviour, grid.order) == ("µm", "oscillating", None)
        assert grid.levels[0][1] == pytest.approx(sign * 5.0)
        told = (grid.scale, grid.allowed, grid.gci, grid.u_it)
        assert told == pytest.approx((5.0, 0.25, 0.03, 2e-5), rel=1e-9)


@SIGNS
def test_levels_alike_are_round_off_of_a_scale_of_either_sign(sign):
    row, convergence = near([sign * 5e-6] * 3, sign * 5e-6)
    assert (row.status, row.order) == (Status.PASS, "round-off")
    assert (convergence.status, convergence.difference) == (Status.PASS, 1.0)


@pytest.mark.parametrize(
    ("allowed", "margin", "status"),
    [
        pytest.param(1.0, 0.125, Status.FAIL, id="less than three times the spread"),
        pytest.param(1.5, 0.125, Status.FAIL, id="three times the spread"),
        pytest.param(2.0, 0.25, Status.PASS, id="four times the spread"),
        pytest.param(6.0, 0.75, Status.PASS, id="twelve times the spread"),
    ],
)
def test_an_order_that_iteration_may_take_away_is_replaced_by_the_spread(allowed, margin, status):
    """The spread is 0.5; the order's own margin over a half is 0.125, and u_it is as the steps."""
    grid = GridConvergence("monotone", 1e-3, order=0.625)
    verdict = convergence_verdict(grid, (4.0, 2.0, 1.0), (1.5, 1.25, 1.0), 0.25, allowed)
    assert (verdict.status, verdict.difference) == (status, margin)


@pytest.mark.parametrize("d0", [0.0, 1e-3, -1e-3])
def test_a_limit_detects_its_uncertainty_and_what_it_is_off(d0):
    eps = np.geomspace(0.1, 0.01, 5)
    points = (list(eps), list(d0 + 0.3 * eps**2), [1e-6] * 5)
    (row,) = limit(lambda _c: points, 2.0).rows(context((), sizes=()))
    assert row.detects == pytest.approx(row.tolerance + abs(row.difference), rel=1e-12)


# What trends and limits are judged by.


@pytest.mark.parametrize(
    ("u", "status", "told"),
    [
        pytest.param(0.25, Status.PASS, "", id="as far off as is allowed"),
        pytest.param(0.125, Status.FAIL, "order 2.50 ± 0.2, theory 2", id="further off"),
        pytest.param(0.0, Status.FAIL, "order 2.50 ± 0, theory 2", id="nothing allowed"),
    ],
)
def test_the_reason_compares_an_order_with_theory_only_where_it_is_missed(
    monkeypatch, u, status, told
):
    monkeypatch.setattr(checks, "fit_order", lambda *_: OrderFit(2.5, u, (), (u, 0.0, 0.0)))
    (row,) = order(lambda _c: ([1.0], [1.0]), demand=1.0).rows(context((), sizes=()))
    assert (row.status, row.reason) == (status, told)
