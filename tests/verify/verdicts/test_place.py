"""Inputs of a user against the ranges that a verdict compared."""

import math
from dataclasses import replace

import pytest

from verify.cases.registry import find
from verify.core.verdicts import Form, FormulaVerdict, Safe, Side, Verdict, VerdictRange
from verify.verdicts import independent, record
from verify.verdicts.place import DEFAULT, DEFAULT_ERROR, WITHOUT_RANGE, Where, place

R_I = Side(name="r_i", symbol="r_i", unit="mm", low=5.0, high=24.0)
NU = Side(name="nu", symbol="ν", unit="1", low=0.1, high=0.4)


def study(*box, studied=(), limit=0.05, **changes):
    """A study of the ring; all of it is within the limit unless `studied` is wider."""
    return VerdictRange(
        case="ring-lame", limit=limit, words="", over="", box=box, studied=studied or box,
        inside=4, points=5, **changes,
    )  # fmt: skip


def placed(*ranges, inputs=(), case="ring-lame", **changes):
    given = {"verdict": Verdict.PART, "rows": ("ring-lame/x",)} | changes
    one = FormulaVerdict(
        id="x", paper="huang2018", source="", name="Eq. 6", form=Form.PRINTED, what="",
        words="", safe=Safe.ABOVE, ranges=ranges, **given,
    )  # fmt: skip
    return place(one, case, find(case).inputs(**dict(inputs)))


def of_record(name):
    return next(one for one in record.kept() if one.id == name)


def test_a_user_s_inputs_lie_inside_outside_or_were_not_compared():
    wide = tuple(replace(side, low=side.low / 2, high=side.high * 1.1) for side in (R_I, NU))
    for star, inputs, where in (
        (True, {}, Where.INSIDE),
        (True, {"r_i": 6e-3}, Where.INSIDE),
        (True, {"r_i": 4e-3}, Where.OUTSIDE),
        (True, {"r_i": 6e-3, "nu": 0.2}, Where.NOT_COMPARED),
        (False, {"r_i": 6e-3, "nu": 0.2}, Where.INSIDE),
        (False, {"r_i": 6e-3, "nu": 0.43}, Where.OUTSIDE),
        (False, {"r_i": 6e-3, "nu": 0.45}, Where.NOT_COMPARED),
        (False, {"E": 1e11}, Where.NOT_COMPARED),
    ):
        found = placed(study(R_I, NU, studied=wide, is_star=star), inputs=inputs)
        assert found.where is where, (star, inputs)


def test_a_study_with_constant_inputs_is_about_parts_with_these_values():
    held = replace(R_I, low=6.0, high=6.0)
    for inputs, where in (
        ({"r_i": 6e-3}, Where.INSIDE),
        ({"r_i": 6e-3, "nu": 0.2}, Where.INSIDE),
        ({"nu": 0.2}, Where.NOT_COMPARED),
        ({"r_i": 7e-3}, Where.NOT_COMPARED),
        ({"r_i": 7e-3, "nu": 0.2}, Where.NOT_COMPARED),
        ({"r_i": 6e-3, "nu": 0.45}, Where.NOT_COMPARED),
    ):
        assert placed(study(NU, held=(held,)), inputs=inputs).where is where, inputs


def test_a_study_that_varies_an_input_away_from_its_default_does_not_hold_at_the_default():
    """Torque of the sprag clutch: 25 N m by default; at ν_0 = 2.5° and z = 8 only to 22 N m."""
    one, sprag = of_record("huang2018/Eq. 9, corrected"), find("sprag-wedge").inputs
    for T, where in ((12.5, Where.INSIDE), (18.0, Where.INSIDE), (25.0, Where.NOT_COMPARED)):
        found = place(one, "sprag-wedge", sprag(T=T, z=8, nu_0=math.radians(2.5)))
        assert found.where is where, T
    assert found.words == "outside the compared range: T 12.5 to 22 N m at ν_0 = 2.5 deg, n_s = 8"


def test_the_centre_of_a_star_with_constant_inputs_can_be_beyond_a_limit():
    """At the default of the varied input, outside the range within the limit."""
    held, box = replace(NU, low=0.2, high=0.2), replace(R_I, low=1.0, high=2.0)
    star = study(box, studied=(R_I,), held=(held,), is_star=True)
    assert placed(star, inputs={"nu": 0.2}).where is Where.OUTSIDE
    star = study(box, studied=(replace(R_I, low=1.0),), held=(held,), is_star=True)
    assert placed(star, inputs={"nu": 0.2, "r_i": 1.5e-3}).where is Where.INSIDE


def test_the_smallest_limit_that_all_studies_keep_is_stated():
    half = replace(R_I, high=10.0)
    two, five, ten = study(half, studied=(R_I,), limit=0.02), study(R_I), study(R_I, limit=0.1)
    for ranges, r_i, expected in (
        ((ten, five, two), 8e-3, "inside the range with errors within 2 %"),
        ((ten, five, two), 20e-3, "inside the range with errors within 5 %"),
        ((two,), 20e-3, "outside the range with all errors within 2 %: r_i 5 to 10 mm"),
        ((five, replace(two, limit=0.05)), 20e-3, "inside a range with errors within 5 %, outside "
         "such a range of another study: r_i 5 to 10 mm"),
        ((study(studied=(R_I,)),), 20e-3, "no compared error is within 5 %"),
        ((two,), 25e-3, "outside the compared range: r_i 5 to 24 mm"),
        ((study(R_I, NU),), 25e-3, "outside the compared range: r_i 5 to 24 mm"),
        ((study(NU, R_I),), 25e-3, "outside the compared range: r_i 5 to 24 mm"),
    ):  # fmt: skip
        assert placed(*ranges, inputs={"r_i": r_i}).words == expected


def test_inputs_that_no_study_varies_are_named():
    star = study(R_I, NU, is_star=True)
    for inputs, expected in (
        ({"E": 1e11, "nu": 0.2}, "not compared with other values of E"),
        ({"r_i": 6e-3, "nu": 0.2}, "not compared with r_i, ν changed at once"),
        ({}, DEFAULT),
    ):
        assert placed(star, inputs=inputs).words == expected
    at = study(NU, held=(replace(R_I, low=6.0, high=6.0),))
    for inputs, expected in (
        ({"r_i": 7e-3}, "not compared with other values of r_i"),
        ({"r_i": 7e-3, "nu": 0.2}, "not compared with other values of r_i"),
        ({"r_i": 6e-3, "E": 1e11}, "not compared with other values of E"),
        ({"nu": 0.2}, "not compared with ν as the only changed input"),
    ):
        assert placed(at, inputs=inputs).words == expected
    assert placed(star, case="ring-rotation").words == "compared only in ring-lame"
    for verdict in WITHOUT_RANGE:
        assert placed(star, verdict=verdict).where is Where.NONE


def test_default_inputs_are_outside_if_the_error_there_is_beyond_all_classes():
    for error, row, where in (
        (-0.3, "ring-lame/x", Where.OUTSIDE),
        (-0.3, "ring-rotation/x", Where.INSIDE),
        (-0.09, "ring-lame/x", Where.INSIDE),
    ):
        found = placed(study(R_I), error=error, U=0.0, worst_row=row)
        assert (found.where, found.words) == (where, DEFAULT)


def test_an_input_that_changes_no_error_is_not_named():
    """The hub's contact at e has no effect on K, which was compared at e = 2 mm."""
    K, ring = of_record("belcin/Eq. 11, printed"), find("polyhedral-ring").inputs
    for inputs, where in (
        ({"e": 5e-3}, Where.OUTSIDE),
        ({"e": 5e-3, "z": 7, "delta_1": 4.5e-3}, Where.OUTSIDE),
        ({"z": 3, "delta_1": 7e-3}, Where.INSIDE),
        ({"e": 5e-3, "nu": 0.2}, Where.NOT_COMPARED),
    ):
        assert place(K, "polyhedral-ring", ring(**inputs)).where is where
    offset = find("rotor-clutch").inputs(e=0.5e-6)
    for name, expected in (
        ("huang2022/Eq. 4, printed", DEFAULT_ERROR),
        ("huang2022/Eq. 8, corrected", "not compared with other values of Δx"),
        ("huang2022/Eq. 9, corrected", "inside the range with errors within 2 %"),
    ):
        assert place(of_record(name), "rotor-clutch", offset).words == expected


@pytest.mark.slow("finite elements of each case are solved with other inputs")
@pytest.mark.parametrize("one", independent.declared(), ids=lambda one: f"{one.case}-{one.inputs}")
def test_inputs_that_are_declared_to_change_no_error_change_none(one, judged, of_paper):
    case = find(one.case)
    own = case.inputs().model_dump()
    other = {
        name: own[name] + 1 if isinstance(own[name], int) else 0.8 * own[name]
        for name in one.inputs
    }
    evidence = {
        row.partition("/")[2] for of in record.kept()
        for row in of.rows + of.model_rows if row.startswith(f"{case.id}/")
    }  # fmt: skip
    assert set(one.rows) <= evidence
    found = judged(case, case.inputs(**own | other), drawn=False)
    rows = {row.quantity: row for row in found.rows}
    known = {row.quantity: row for row in of_paper(case).rows}
    for name in one.rows or evidence:
        error, was = (of[name].difference / of[name].scale for of in (rows, known))
        assert error == pytest.approx(was, abs=1e-8), name
