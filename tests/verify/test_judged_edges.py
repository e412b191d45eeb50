"""What rows record beside their verdict, and the edges of the rules that judge them."""

import math

import numpy as np
import pytest

from tests.verify.test_checks import context, power_law
from verify.core.results import Status
from verify.judging import convergence, judge
from verify.judging.checks import Accepted, Approximation
from verify.judging.convergence import fit_order, grid_convergence

FOUR = (1 / 2, 1 / 4, 1 / 8, 1 / 16)


def accepted(margin, **more):
    return Accepted(
        name="near", symbol="m", unit="1", margin=lambda _c: (margin, 1e-6, "3 apart"), **more
    )


@pytest.mark.parametrize(
    ("margin", "fitted", "status"),
    [
        (0.1, "", Status.PASS),
        (-0.1, "", Status.FAIL),
        (0.1, "L is fitted", Status.CALIBRATED),
        (-0.1, "L is fitted", Status.FAIL),
    ],
)
def test_an_acceptance_figure_is_judged_on_the_paper_s_numbers(margin, fitted, status):
    (row,) = accepted(margin, fitted=fitted).rows(context((), sizes=()))
    assert row.status is status
    assert "3 apart" in row.reason
    assert not row.reason.startswith("measured")


@pytest.mark.parametrize("margin", [0.1, -0.1])
def test_at_a_user_s_own_numbers_it_is_shown(margin):
    (row,) = accepted(margin).rows(context((), sizes=(), is_paper=False))
    assert (row.status, row.reason) == (Status.SHOWN, "measured: 3 apart")


@pytest.mark.parametrize("share", [0.03, -0.03])
def test_parts_of_an_order_s_uncertainty_are_sizes(share):
    """Slopes grow or fall towards the limit, and half of what the last is off counts."""
    fit = fit_order(FOUR, [h**2 * (1 + share * h) for h in FOUR])
    assert min(fit.parts) >= 0
    # the slope between h and h/2 is off by log2((1 + a h)/(1 + a h/2)) = a h/(2 ln 2)
    assert fit.parts[1] == pytest.approx(abs(share) * FOUR[2] / (4 * math.log(2)), rel=0.05)


def test_a_point_without_a_difference_is_a_point_of_a_limit():
    """D = 0.3 eps^2 is exactly zero at one of the points but for what it is uncertain by."""
    eps = np.array([0.1, 0.05, 0.02, 0.01, 0.005])
    d = 0.3 * eps**2
    d[-1] = 0.0
    fit = judge.fit_limit(eps, d, np.full(5, 1e-5))
    assert abs(fit.d0) < fit.U0
    assert fit.q == pytest.approx(2.0, abs=fit.U_q)


def test_half_an_order_is_one(monkeypatch):
    monkeypatch.setattr(convergence, "observed_order", lambda *_: 0.5)
    found = grid_convergence((1.0, 0.5, 0.25), (1.0, 0.1, 0.0), formal=2.0, scale=1.0)
    assert (found.behaviour, found.order) == ("monotone", 0.5)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_negative_reference_is_a_scale_by_its_size(sign):
    claim = Approximation(
        name="near", symbol="v", unit="1", analytic="f", fem="v", formal=2, source="made up",
        interval=lambda _q, _v: (-0.005, 0.005),
    )  # fmt: skip
    values = [sign * x for x in power_law(2.0, 1e-3)]
    row, _ = claim.rows(context(values, analytic={"f": sign * 2.0}))
    assert (row.status, row.scale) == (Status.PASS, pytest.approx(2.0, rel=1e-4))
