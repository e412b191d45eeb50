"""Rows judged again from what they keep: the same numbers, the same verdict."""

import math
from dataclasses import replace

import pytest

from verify.cases.registry import CASES
from verify.core.case import Context, FemResult
from verify.core.results import Kind, Status
from verify.judging.checks import Approximation, Fact, Identity, Limit
from verify.judging.explain.grid import regrid
from verify.judging.explain.steps import derive, steps
from verify.judging.profile_checks import Coefficient

EACH = pytest.mark.parametrize(
    "case", [pytest.param(c, id=c.id, marks=pytest.mark.xdist_group(c.id)) for c in CASES]
)


# Each kind of row is in one of these; the others take many seconds on parameters of their own. Only
# this one is solved anew in less than a second.
QUICK = ("ring-lame",)
CHEAP = pytest.mark.parametrize(
    "case",
    [
        pytest.param(c, id=c.id, marks=() if c.id in QUICK else pytest.mark.soak)
        for c in CASES
        if c.id.startswith(("ring-", "spring-", "contact-pair"))
    ],
)


def agrees(again, kept, digits):
    if again is None or kept is None:
        return again is None and kept is None
    return again == kept or math.isclose(again, kept, rel_tol=1e-5, abs_tol=digits)


def assert_the_same(row):
    """Equal but for the round-off of values that were converted to the row's unit."""
    found = derive(row)
    digits = 1e-14 * max([abs(v) for _, v in row.levels] + [row.scale or 0.0])
    assert found.verdict.status is row.status, row.id
    assert agrees(found.verdict.difference, row.difference, digits), row.id
    assert agrees(found.verdict.tolerance, row.tolerance, digits), row.id
    assert agrees(found.verdict.detects, row.detects, 1e-14), row.id
    if found.u_num is not None:
        assert agrees(found.u_num, row.u_num, digits), row.id
    if row.grid:
        again, _ = regrid(row.grid)
        digits = max(digits, 1e-14 * max(abs(v) for _, v in row.grid.levels))
        assert again.behaviour == row.grid.behaviour
        assert agrees(again.gci, row.grid.gci, digits)
        assert agrees(again.order, row.grid.order, 1e-4)
        assert agrees(again.used, row.grid.used, 1e-4)
        assert again.factor == row.grid.factor


@EACH
def test_every_row_of_the_paper_follows_from_what_it_keeps(case, of_paper):
    for row in of_paper(case).rows:
        assert_the_same(row)


# Slip zones grow node by node, and the rim of a contact cell by cell: no order. Forces in balance
# are the same on every mesh. Steps of an engagement differ by less than its table leaves open, a
# wedged sprag's meshes by where its contacts end within a cell; strips of a best crown too.
STEPPED = (
    "contact-slip", "contact-roller-tilted", "contact-roller-crowns", "polyhedral-wedge",
    "freewheel-friction", "freewheel-paths", "freewheel-clutch", "sprag-engagement", "sprag-wedge",
    "sprag-optimum", "sprag-optimum-40",
)  # fmt: skip


@EACH
def test_the_index_follows_from_the_order_and_factor_that_a_row_names(case, of_paper):
    ordered = [row.grid for row in of_paper(case).rows if row.grid and row.grid.used is not None]
    assert ordered or case.id in STEPPED
    for grid in ordered:
        (_, _), (h2, v2), (h1, v1) = grid.levels[-3:]
        index = grid.factor * abs(v1 - v2) / ((h2 / h1) ** grid.used - 1)
        floor = 1e-12 * grid.scale
        assert grid.gci == pytest.approx(max(index, floor), rel=1e-5)


@CHEAP
def test_so_does_every_row_of_other_parameters(case, judged):
    others = {"E": 100e9, "E_1": 100e9, "nu": 0.25}
    name = next(name for name in others if name in case.inputs.model_fields)
    own = case.inputs(**{name: others[name]})
    for row in judged(case, own).rows:
        assert_the_same(row)


@EACH
def test_steps_end_with_the_verdict_and_tell_more_of_every_row(case, of_paper):
    for row in of_paper(case).rows:
        said = steps(row)
        plain = row.kind is Kind.FACT and row.grid is None  # a margin and its uncertainty
        unjudged = row.status is Status.SHOWN or row.tolerance is None
        told = 1 if unjudged else 2  # what nothing judges has words alone
        assert len(said) >= (told if plain else 4), row.id
        assert said[-1][0] == "verdict"
        assert said[-1][1].startswith(row.status.value)


# What no case shows: series that oscillate, diverge, are noisy, limits, facts.

SIZES = (1 / 2, 1 / 4, 1 / 8)
ABOUT = {"name": "gap", "symbol": "g", "unit": "µm"}


def context(series, u_it=0.0, sizes=SIZES):
    levels = [
        FemResult(h=h, values={"v": v}, u_it={"v": u_it})
        for h, v in zip(sizes, series, strict=True)
    ]
    return Context("ring-made-up", None, {"g": 5e-6}, levels, is_paper=True)


SERIES = {
    "monotone": [5.032e-6, 5.008e-6, 5.002e-6],
    "far from its order": [5.1e-6, 5.01e-6, 5.001e-6],
    "oscillating": [5.01e-6, 4.99e-6, 5.005e-6],
    "slow": [5.03e-6, 5.02e-6, 5.012e-6],
    "diverging": [5.0e-6, 5.01e-6, 5.04e-6],
    "round-off": [5e-6, 5e-6, 5e-6],
    "short": [5.01e-6, 5.0e-6],
    "not a number": [5.1e-6, 5.01e-6, math.nan],
}


@pytest.mark.parametrize("u_it", [0.0, 1e-9])
@pytest.mark.parametrize("name", SERIES)
@pytest.mark.parametrize(
    "claim",
    [
        Identity(**ABOUT, analytic="g", fem="v", formal=2),
        Identity(**ABOUT, analytic="g", fem="v"),
        Approximation(
            **ABOUT, analytic="g", fem="v", formal=2, source="made up",
            interval=lambda _q, _v: (-0.01, 0.01),
        ),
        Approximation(**ABOUT, analytic="g", fem="v", interval=None, source="none"),
    ],
    ids=["identity", "no order in theory", "approximation", "no interval"],
)  # fmt: skip
def test_series_of_every_behaviour_are_judged_alike_again(claim, name, u_it):
    series = SERIES[name]
    for row in claim.rows(context(series, u_it, SIZES[: len(series)])):
        assert_the_same(row)
        assert steps(row)


def test_a_limit_is_fitted_again():
    eps = [0.01, 0.02, 0.05, 0.1]
    claim = Limit(
        name="limit", symbol="d", unit="1", exponent=2.0,
        points=lambda _c: (eps, [3 * e**2 for e in eps], [1e-6] * 4),
    )  # fmt: skip
    (row,) = claim.rows(context(SERIES["monotone"]))
    assert row.status is Status.PASS
    assert_the_same(row)
    assert "q = 2.0000" in dict(steps(row))["fit"]


@pytest.mark.parametrize(("theory", "status"), [(3.0, Status.PASS), (3.1, Status.FAIL)])
def test_a_coefficient_is_fitted_again(theory, status):
    eps = [0.02, 0.05, 0.1]
    claim = Coefficient(
        name="coefficient", symbol="c", unit="1", theory=theory,
        points=lambda _c: (eps, [3 * e**2 - 2 * e**4 for e in eps], [1e-6] * 3),
    )  # fmt: skip
    (row,) = claim.rows(context(SERIES["monotone"]))
    assert row.status is status
    assert_the_same(row)
    said = dict(steps(row))
    assert "c = +3.00000" in said["fit"]
    assert said["theory"] == f"{theory:g}"


@pytest.mark.parametrize(
    ("margin", "word"), [(2e-6, "holds"), (-2e-6, "does not hold"), (1e-7, "does not hold")]
)
def test_a_fact_says_its_margin(margin, word):
    (row,) = Fact(**ABOUT, margin=lambda _c: (margin, 1e-6)).rows(context(SERIES["monotone"]))
    assert_the_same(row)
    assert dict(steps(row))["test"].endswith(word)


def test_the_index_is_shown_with_its_numbers_put_in():
    """By hand: p = log2(24/6) = 2, GCI = 1.25 0.006/(4 - 1) = 0.0025 µm, U = 2 GCI/2."""
    row, _ = Identity(**ABOUT, analytic="g", fem="v", formal=2).rows(context(SERIES["monotone"]))
    said = dict(steps(row))
    assert said["GCI"] == "F |v1 − v2|/(r^p − 1) = 1.25 × 0.006/(2^2.0000 − 1) = 0.0025 µm"
    assert said["u_num"] == "√((GCI/2)² + u_it²) = √((0.0025/2)² + 0²) = 0.00125 µm"
    assert said["U"].endswith("= 2 √(0.00125² + 0² + 0²) = 0.0025 µm")
    assert said["test"] == "|d| ≤ U, that is 0.002 ≤ 0.0025: holds"
    assert said["detects"].startswith("(U + |d|)/scale = (0.0025 + 0.002)/5 = 0.090 %")


def test_a_row_that_was_not_run_keeps_its_verdict():
    row = replace(
        Identity(**ABOUT, analytic="g", fem="v").skipped("ring-made-up", "quick")[0],
        status=Status.FAIL, reason="level 2: MemoryError",
    )  # fmt: skip
    assert row.kind is Kind.IDENTITY
    assert derive(row).verdict.status is Status.FAIL
    assert steps(row) == (("verdict", "FAIL: level 2: MemoryError"),)


def test_an_order_far_from_theory_takes_the_larger_factor():
    """By hand: p = log2(0.09/0.009) = 3.32 against 2, so 3 0.009/(2^2 - 1) = 0.009 µm."""
    claim = Identity(**ABOUT, analytic="g", fem="v", formal=2)
    row, _ = claim.rows(context(SERIES["far from its order"]))
    assert (row.grid.factor, row.grid.used) == (3.0, 2.0)
    said = dict(steps(row))
    assert said["F"] == "3: observed and theory are 1.3 apart, beyond 0.5"
    assert said["GCI"] == "F |v1 − v2|/(r^p − 1) = 3 × 0.009/(2^2.0000 − 1) = 0.009 µm"
