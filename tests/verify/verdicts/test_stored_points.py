"""Stored studies point by point: all of them, with the errors on record."""

from types import SimpleNamespace

import numpy as np
import pytest

from verify.cases.registry import CASES, find
from verify.core import units
from verify.core.inputs import meta
from verify.core.verdicts import Safe
from verify.studies.validity.store import measured
from verify.verdicts.stored_points import studies

STUDIED = [case.id for case in CASES if case.scans]


def of(name):
    return studies([SimpleNamespace(id=name, rows=())])


@pytest.mark.parametrize("name", STUDIED)
def test_all_stored_points_are_there_with_their_errors(name):
    found, record = of(name), measured(find(name))
    assert len(found) == len(record.scans)
    for study, (plan, courses) in zip(found, record.scans, strict=True):
        assert [f.quantity for f in study.formulas] == [c.pair.name for c in courses]
        assert len(set(study.points)) == len(study.points)
        for formula, course in zip(study.formulas, courses, strict=True):
            known = dict(zip(study.points, zip(formula.error, formula.U, strict=True), strict=True))
            for point, e, U in zip(plan.points, course.error, course.U_error, strict=True):
                at = tuple(axis.shown(v) for axis, v in zip(plan.axes, point, strict=True))
                np.testing.assert_array_equal(known[at], (e, U))


def test_a_case_that_has_no_study_or_is_a_user_s_own_has_none():
    results = [SimpleNamespace(id=name, rows=()) for name in ("freewheel-clutch", "own-case")]
    assert studies(results) == ()


def test_a_ratio_is_the_input_over_other_inputs_in_any_unit():
    ((torque, *_),) = (study.axes for study in of("freewheel-torque"))
    case = find("freewheel-torque").inputs()
    shown = {one.name: one.own for one in torque.per}
    ratio = torque.factor * torque.own
    for one in torque.per:
        ratio /= shown[one.name] ** one.power
    assert torque.ratio == "T/(E R³)"
    assert ratio == pytest.approx(case.T / (case.E * case.R**3), rel=1e-9)
    assert torque.own * units.factor(torque.unit) == pytest.approx(case.T)


def test_the_safe_side_is_that_of_the_case_or_of_the_formula_that_rests_on_the_row():
    safe = {f.quantity: f.safe for f in of("polyhedral-ring")[0].formulas}
    assert safe["K of the paper"] is Safe.ABOVE


def test_a_value_that_differs_from_the_case_s_own_in_the_last_bit_is_one_point():
    study = next(s for s in of("spring-accordion") if "α" in s.over and "r " in s.over)
    assert len(study.points) == 1 + 3 + 4 + 3
    assert study.points[0] == tuple(axis.own for axis in study.axes)


def test_a_part_of_another_size_all_in_proportion_has_the_same_errors(judged, of_paper):
    """As the explorer supposes where every axis is a ratio, an angle, a number or a pressure."""
    case, own = find("polyhedral-pressure"), find("polyhedral-pressure").inputs()
    (study,) = of(case.id)
    assert all(axis.scales for axis in study.axes)
    lengths = {
        name: 1.25 * getattr(own, name) for name, field in type(own).model_fields.items()
        if meta(field)["unit"] == "mm"
    }  # fmt: skip
    assert "d_e" in lengths
    larger = judged(case, type(own)(**own.model_dump() | lengths), drawn=False)
    for row, known in zip(larger.rows, of_paper(case).rows, strict=True):
        if row.difference is not None and row.scale:
            error = known.difference / known.scale
            assert row.difference / row.scale == pytest.approx(error, abs=1e-9)
