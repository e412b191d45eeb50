"""Criteria of convergence: an order above the effect of the iteration error, or a spread."""

from itertools import product

import pytest

from verify.core.results import Status
from verify.judging.claims import convergence_verdict
from verify.judging.convergence import (
    ORDER_LIMITS,
    GridConvergence,
    grid_convergence,
    observed_order,
    order_from_iteration,
)

H = (0.4, 0.2, 0.1)


def worst_order(h, v, u):
    """The lowest order of all series whose values are off by ± u or by none."""
    return min(
        observed_order((v[0] + a - v[1] - b) / (v[1] + b - v[2] - c), h[1] / h[2], h[0] / h[1])
        for a, b, c in product((-u, 0.0, u), repeat=3)
    )


@pytest.mark.parametrize("h", [H, (0.4, 0.2, 0.05), (0.4, 0.1, 0.05), (0.4, 0.3, 0.25)])
@pytest.mark.parametrize("p", [0.6, 2.0])
@pytest.mark.parametrize("share", [1e-2, 1e-4])
def test_iteration_explains_what_the_worst_signs_take_from_an_order(h, p, share):
    v = [1 + x**p for x in h]
    u = share * (v[1] - v[2])
    grid = grid_convergence(h, v, formal=p, scale=1.0)
    noise = convergence_verdict(grid, h, v, u, 0.01).tolerance
    worst = p - worst_order(h, v, u)
    # on uneven meshes the smallest slope between both orders counts
    assert worst <= noise * (1 + 1e-7)
    assert worst == pytest.approx(noise, rel=share)


def test_a_step_as_large_as_both_errors_may_be_none():
    v = (1.25, 1.125, 1.0625)  # order 1, the first step 2/16
    assert order_from_iteration(H, v, 1 / 16) == pytest.approx(1 - ORDER_LIMITS[0])


@pytest.mark.parametrize(
    ("allowed", "margin", "status"),
    [(1.0, 0.125, Status.FAIL), (1.5, 0.125, Status.FAIL), (2.0, 0.25, Status.PASS)],
)
def test_an_order_that_iteration_may_take_away_is_replaced_by_the_spread(allowed, margin, status):
    """The spread is 0.5; the margin of the order over a half is 0.125, and u_it is as the steps."""
    grid = GridConvergence("monotone", 1e-3, order=0.625)
    verdict = convergence_verdict(grid, (4.0, 2.0, 1.0), (1.5, 1.25, 1.0), 0.25, allowed)
    assert (verdict.status, verdict.difference) == (status, margin)
    assert verdict.reason.startswith("undecided") == (status is Status.FAIL)


def test_a_series_that_is_slow_is_judged_by_its_spread_though_it_has_an_order():
    grid = GridConvergence("slow", 0.02, order=0.9)
    verdict = convergence_verdict(grid, H, [1.4, 1.2, 1.1], 0.0, 0.01)
    assert verdict.status is Status.FAIL
    assert "slow series of values" in verdict.reason


@pytest.mark.parametrize("p", [0.5 - 1e-3, 0.5 + 1e-3])
def test_an_order_of_about_a_half_has_one_verdict(p):
    """Iteration may take it to either side: the spread decides on both."""
    v = [1 + 1e-4 * x**p for x in H]
    u = 1e-3 * (v[1] - v[2])
    spread = v[0] - v[2]
    grid = grid_convergence(H, v, formal=2, scale=1.0, u_it=u)
    assert grid.behaviour == ("slow" if p < 0.5 else "monotone")
    assert convergence_verdict(grid, H, v, u, 3.01 * spread).status is Status.PASS
    assert convergence_verdict(grid, H, v, u, 2.99 * spread).status is Status.FAIL
