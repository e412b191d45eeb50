"""What convergence is judged by: an order above what iteration explains, or a spread."""

import math

import pytest

from verify.claims import convergence_verdict
from verify.convergence import GridConvergence, grid_convergence
from verify.results import Status

H = [0.4, 0.2, 0.05]  # ratios 2 and 4


def series(p):
    return [1 + h**p for h in H]


@pytest.mark.parametrize("p", [1.0, 2.0])
def test_iteration_explains_no_more_of_an_order_than_four_times_its_share_of_the_last_step(p):
    """Both differences may be wrong by 2 u_it; on halved meshes the last one is the smaller."""
    u = 1e-5
    v = series(p)
    verdict = convergence_verdict(grid_convergence(H, v, formal=p, scale=1.0), H, v, u, 0.01)
    assert verdict.tolerance == pytest.approx(4 * u / (v[1] - v[2]) / math.log(4), rel=1e-9)
    halved = [0.4, 0.2, 0.1]
    exact = [1 + h**p for h in halved]
    grid = grid_convergence(halved, exact, formal=p, scale=1.0)
    noise = convergence_verdict(grid, halved, exact, u, 0.01).tolerance
    worst = max(
        abs(grid_convergence(halved, moved, formal=p, scale=1.0).order - p)
        for moved in ([a + s * e for a, e in zip(exact, (u, -u, u), strict=True)] for s in (1, -1))
    )
    assert 0.2 * noise < worst < noise


def test_an_order_within_the_noise_of_a_half_is_undecided():
    grid = GridConvergence("monotone", 1e-3, order=0.6)
    verdict = convergence_verdict(grid, H, [1.4, 1.2, 1.1], 0.01, 0.01)
    assert verdict.status is Status.FAIL
    assert verdict.reason.startswith("undecided")


def test_a_series_that_is_slow_is_judged_by_its_spread_though_it_has_an_order():
    grid = GridConvergence("slow", 0.02, order=0.9)
    verdict = convergence_verdict(grid, H, [1.4, 1.2, 1.1], 0.0, 0.01)
    assert verdict.status is Status.FAIL
    assert "slow: spread" in verdict.reason
