"""Sensitivity indices of a sample: closed forms, confidence, noise, missing points."""

import math

import numpy as np
import pytest

from tests.verify.sweep_made import CASE, Plate, chosen, course
from verify.studies.sweep.indices import estimates, indices, terms
from verify.studies.sweep.plan import sample

ALL = ("a=±1mm", "b=±0.5mm")


def planned(count=256, tolerances=ALL, **more):
    """A sample, and its inputs at each point as shares of their tolerances, -1 to 1."""
    plan = sample(CASE, "plate", Plate(), chosen(), f"sobol:{count}", tolerances, **more)
    mid, off = zip(*((t.nominal, t.off) for t in plan.tolerances), strict=True)
    return plan, ((plan.points - np.array(mid)) / np.array(off)).T


def found(plan, error, U_error=0.0, **more):
    return indices(plan, course(plan, error, U_error, **more))


def values(scatter, which="first"):
    return [getattr(index, which).value for index in scatter.indices]


def test_the_indices_of_ishigamis_function():
    plan, x = planned(2048, [*ALL, "c=±0.5mm"])
    x = np.pi * x
    # T. Ishigami and T. Homma, ISUMA 1990: with a = 7 and b = 0.1
    of = found(plan, np.sin(x[0]) + 7 * np.sin(x[1]) ** 2 + 0.1 * x[2] ** 4 * np.sin(x[0])).error
    # V_1 = (1 + b π⁴/5)²/2, V_2 = a²/8, V_13 = b² π⁸ (1/18 - 1/50)
    v1, v2 = (1 + 0.1 * np.pi**4 / 5) ** 2 / 2, 49 / 8
    v13 = 0.01 * np.pi**8 * (1 / 18 - 1 / 50)
    v = v1 + v2 + v13
    assert values(of) == pytest.approx([v1 / v, v2 / v, 0], abs=0.02)
    assert values(of, "total") == pytest.approx([(v1 + v13) / v, v2 / v, v13 / v], abs=0.02)
    assert of.sd**2 == pytest.approx(v, rel=0.02)
    assert [index.tolerance.name for index in of.ranked] == ["a", "b", "c"]


def test_intervals_contain_the_true_index_about_as_often_as_stated():
    hits = trials = 0
    for seed in range(30):
        plan, (x, y) = planned(64, seed=seed)
        of = found(plan, 0.02 * x + 0.01 * y + 0.01 * x * y).error
        # V = 4/3, 1/3 and 1/9 of 1e-4
        for index, first, total in zip(of.indices, (12, 3), (13, 4), strict=True):
            for of_index, true in ((index.first, first / 16), (index.total, total / 16)):
                trials += 1
                hits += of_index.low <= true <= of_index.high
                assert of_index.low < of_index.value < of_index.high
    assert hits >= 0.9 * trials


def test_what_does_not_vary_beyond_its_bars_has_no_indices():
    plan, (x, _) = planned(64)
    of = found(plan, 0.03, fe=np.linspace(1, 2, len(plan.points)))
    assert (of.error.why, of.error.indices) == ("the quantity does not vary", ())
    assert of.fe.indices
    u = 0.01 / math.sqrt(3)  # the standard deviation of 0.01 x
    drowned = found(plan, 0.01 * x, 2 * 1.01 * u).error
    assert drowned.why == "the variation is within the uncertainty of finite elements"
    assert drowned.noise == pytest.approx(1.01**2, rel=0.02)
    heard = found(plan, 0.01 * x, 2 * 0.5 * u)
    assert heard.error.indices
    assert heard.error.noise == pytest.approx(0.25, rel=0.02)
    assert heard.formula.noise == 0


def test_rows_with_an_unsolved_point_drop_out_and_are_counted():
    plan, (x, _) = planned(16)
    error = 0.02 * x + 0.01
    error[[3, 16 + 5, 2 * 16 + 3, 3 * 16 + 9]] = np.nan  # rows 3, 5, 3 and 9
    of = found(plan, error)
    assert (of.rows, of.dropped, of.error.n) == (13, 3, 30)  # of A and B
    left = np.setdiff1d(np.arange(16), [3, 5, 9])
    a, b, *mixed = error.reshape(-1, 16)[:, left]
    first, _ = estimates(terms(a, b, np.array(mixed)).mean(axis=0))
    assert values(of.error) == list(first)
    plan, (x, _) = planned(8)
    x[2] = np.nan
    assert (
        found(plan, x).error.why
        == "only 7 rows of the sample are complete, at least 8 are required"
    )
    nothing = found(plan, np.nan)
    assert (nothing.rows, nothing.error.n) == (0, 0)
    assert nothing.error.why == nothing.fe.why == "no point is solved"
    assert [(w.inside, w.unsolved) for w in nothing.within] == [(0, 16)] * 3


def test_moments_and_shares_are_those_of_the_independent_points():
    plan, (x, _) = planned(256)
    error = 0.05 * (x + 1)  # even in 0..10 %
    error[512:] = 7.0  # the mixed rows are no part of them
    of = found(plan, error, 0.001)
    assert (of.error.n, of.error.mean) == (512, pytest.approx(0.05, abs=1e-4))
    quantiles = of.error.low, of.error.median, of.error.high
    assert quantiles == pytest.approx((0.0025, 0.05, 0.0975), abs=5e-4)
    shares = [(w.limit, w.inside / 512, w.undecided / 512, w.outside / 512) for w in of.within]
    expected = [(0.02, 0.19, 0.02, 0.79), (0.05, 0.49, 0.02, 0.49), (0.1, 0.99, 0.01, 0)]
    assert np.array(shares) == pytest.approx(np.array(expected), abs=0.005)
