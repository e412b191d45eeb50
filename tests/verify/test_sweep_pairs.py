"""Comparison and uncertainty at a point of a sweep: equal to the rows of a run."""

import math
from dataclasses import replace

import pytest

from tests.verify.sweep_made import CASE, Plate
from verify.cases.registry import CASES
from verify.core import units
from verify.core.case import Context, FemResult, Portion
from verify.core.inputs import InputError
from verify.core.results import Kind
from verify.jobs.cache import default_folder
from verify.jobs.level import solve_level
from verify.judging.checks import Exact, Identity
from verify.studies.sweep import outcome as outcomes
from verify.studies.sweep.pairs import LEVELS, Known, compared, pairs, portion, selected, whole
from verify.studies.sweep.plan import grid
from verify.studies.sweep.point import Solution
from verify.studies.sweep.run import Solved, Timing

H = (1.0, 0.5, 0.25)


def identity(**more):
    stated = {"name": "twist", "symbol": "φ", "unit": "deg", "analytic": "t", "fem": "t"} | more
    return Identity(**stated)


def case(*checks):
    return replace(CASE, checks=checks)


def point(fe, formulas, *, u_it=None, check=None, **more):
    """What a sweep compares at a point with these values on the levels."""
    (pair,) = pairs(case(check or identity(formal=2, **more)))
    h = H[: len(fe)]
    return compared(pair, Known("made-up-plate", Plate(), formulas, h, {"t": fe}, u_it or {}))


def second_order(exact, c):
    return tuple(exact + c * h**2 for h in H)


V = second_order(2.0, 0.032)  # finest 2.002, the two before 2.008 and 2.032
INDEX = 1.25 * 0.006 / 3  # 1.25 · 0.006/(4 - 1), which is two standard uncertainties


def test_rows_are_chosen_by_parts_of_their_names_or_a_whole_one():
    rows = ("K", "K in the mean", "force")
    balance = Exact(name="balance", symbol="R", unit="N", fem="R", scale="F", bound=1e-9,
                    bound_reason="")  # fmt: skip
    of = case(balance, *(identity(name=name) for name in rows))  # which compares no values
    for only, expected in (
        ((), rows), (("k in",), rows[1:2]), (("K",), rows[:1]), (("k",), rows[:2]),
        (("force", "mean"), rows[1:]), (("o",), rows[2:]),
    ):  # fmt: skip
        assert tuple(p.name for p in selected(of, only)) == expected
    many = case(*(identity(name=f"row {k}") for k in range(7)))
    for some, only, words in (
        (
            of,
            ("force", "torque"),
            "--only torque: no row of made-up-plate contains this text: K;",
        ),
        (of, ("the maen",), r"contains this text: near it are K in the mean$"),
        (many, ("torque",), "this text: row 0; row 1; row 2; row 3; row 4 and 2 more"),
        (case(), (), "has no row that compares a formula"),
    ):
        with pytest.raises(InputError, match=words):
            selected(some, only)


def test_the_portion_is_the_first_that_gives_all_values_else_the_whole():
    of = case(identity(), identity(name="force", fem="F"))
    cheap = Portion(name="cheap", fem=lambda q, level: None, levels=(1, 2, 3), keys=("t",))
    of = replace(of, portions=(cheap,), levels=(1, 2, 4, 8))
    assert portion(of, selected(of, ("twist",))) is cheap
    assert portion(of, selected(of, ("force",))) == whole(of)
    assert (whole(of).levels, whole(of).keys) == ((1, 2, 4), ("t", "F"))


# Errors and bars


def test_an_error_is_relative_to_the_finest_value_or_its_scale_and_its_bar_to_the_order():
    (pair,) = pairs(case(identity(by="series", scale="s")))
    assert (pair.name, pair.kind, pair.by, pair.scale) == ("twist", Kind.IDENTITY, "series", "s")
    found = point(V, {"t": 2.2})
    assert (found.formula, found.fe, found.problem) == (2.2, V[-1], "")
    assert found.error == pytest.approx(2.2 / 2.002 - 1, rel=1e-12)
    assert pytest.approx(INDEX, rel=1e-9) == found.U
    # of 2.2/v - 1: v enters with 2.2/v²
    assert found.U_error == pytest.approx(found.U * 2.2 / 2.002**2, rel=1e-9)
    scaled = point(second_order(0.0, 0.032), {"t": 0.01, "s": -0.5}, scale="s")
    assert scaled.error == pytest.approx((0.01 - 0.002) / 0.5, rel=1e-12)
    assert scaled.U_error == pytest.approx(scaled.U / 0.5, rel=1e-12)
    assert point(V, {"t": 0.01, "s": 0.0}, scale="s").problem.startswith("nothing to relate a")


def test_what_cannot_be_compared_has_a_reason():
    for fe, formula, problem in (
        ((2.0, 2.0, 2.001), 2.0, ""),  # differences grow, but the scatter is small
        ((2.0, 2.0, 2.01), 2.0, "does not converge"),  # 3 · 0.01 is more than 1 % of 2
        ((2.0, 2.0), 2.0, "does not converge"),
        ((1.0, 1.0, math.nan), 2.0, "finite elements have no finite value"),
        ((), 2.0, "finite elements have no finite value"),
        ((1.0, 1.0, 1.0), math.nan, "the formula has no finite value"),
        ((0.0, 0.0, 0.0), 2.0, "nothing to relate a difference to"),
    ):
        found = point(fe, {"t": formula})
        assert found.problem == problem
        assert math.isnan(found.error) is math.isnan(found.U_error) is bool(problem)
        if not problem:
            assert pytest.approx(0.003) == found.U  # three times the scatter


def test_an_outcome_has_the_points_in_their_order_with_their_problems():
    plan = grid(CASE, "plate", Plate(), selected(CASE, ("stiffness",)), ["a=1:4mm:4"])
    of, values = {"k": V, "s": V}, {"k": 2.0, "s": 1.0}
    whys = ("", "refused: no", "level 2: ValueError: no", "formulas: ValueError: no")
    solutions = (
        Solution(values, H, of, {}),
        Solution({}, (), {}, {}, problem_fe=whys[1]),
        Solution(values, (), {}, {}, problem_fe=whys[2]),
        Solution({}, H, of, {}, problem_formulas=whys[3]),
    )
    solved = Solved(plan, whole(CASE), (Plate(),) * 4, solutions, Timing(4, 1.0, 1.0, 1, 0))
    found = outcomes.outcome(solved)
    (course,) = found.courses
    assert course.problems == found.problems == whys
    assert course.error[0] == pytest.approx(2 / 2.002 - 1)
    assert [math.isnan(e) for e in course.error] == [False, True, True, True]
    assert course.formula[2] == 2.0  # known without finite elements


# The rows of a run, on the paper's inputs

# boundary values, a series beside formulas, contact, values that a claim derives
QUICK = ("ring-lame", "ring-loads-outer", "contact-sphere", "polyhedral-locking")
MEASURED = [
    pytest.param(case, id=case.id, marks=() if case.id in QUICK else pytest.mark.soak)
    for case in CASES if pairs(case)
]  # fmt: skip


@pytest.mark.parametrize("case", MEASURED)
def test_a_point_of_a_sweep_has_value_error_and_bar_of_the_row(case):
    q = case.inputs()
    some = [solve_level(case, q, n, default_folder()).result for n in case.levels[:LEVELS]]
    # a point has values alone, no courses along a line
    levels = [FemResult(h=one.h, values=one.values, u_it=one.u_it) for one in some]
    formulas = {key: float(value) for key, value in case.analytic(q).items()}
    keys = dict.fromkeys(key for level in levels for key in level.values)
    known = Known(
        case.id, q, formulas, [level.h for level in levels],
        {key: [level.values.get(key, math.nan) for level in levels] for key in keys},
        {key: max(level.u_it.get(key, 0.0) for level in levels) for key in keys},
    )  # fmt: skip
    compared_some = False
    for pair in pairs(case):
        rows = pair.claim.rows(Context(case.id, q, formulas, levels, is_paper=False))
        row = next((row for row in rows if row.levels and row.analytic is not None), None)
        point = compared(pair, known)
        if point.problem:
            # what has no row has no point; a row without a bar, as of zeros, gives none either
            assert row is None or not math.isfinite(row.u_num or math.inf), pair.name
            continue
        f = units.factor(pair.unit)
        assert point.formula == pytest.approx(row.analytic * f, rel=1e-12)
        assert point.fe == pytest.approx(row.reference * f, rel=1e-12)
        bar = pytest.approx(2 * f * math.hypot(row.u_num, row.u_ref or 0))
        # differences that grow in round-off have no order, and a sweep takes their scatter
        assert bar == point.U or math.isinf(row.u_num)
        scale = row.scale * f if pair.scale else abs(row.reference * f)
        assert point.error == pytest.approx((row.analytic - row.reference) * f / scale)
        compared_some = True
    assert compared_some
