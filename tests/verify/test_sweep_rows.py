"""A sweep compares what the rows of a run compare: one by one, on the paper's inputs."""

import math

import pytest

from verify.cases.registry import CASES
from verify.core import units
from verify.core.case import Context, FemResult
from verify.jobs.cache import default_folder
from verify.jobs.level import solve_level
from verify.studies.sweep.pairs import LEVELS, Known, compared, pairs

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
