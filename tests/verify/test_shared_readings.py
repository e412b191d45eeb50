"""Assumptions common to both sides: each case states them, with effects by other models."""

import math

import pytest

from analytic.ring import lame
from analytic.spring import frame
from tests.conftest import solved
from verify.answers.shared.clutches import wedge_angle
from verify.answers.shared.rings import narrow_race
from verify.answers.shared_readings import SHARED, shared_readings
from verify.cases.registry import CASES, find
from verify.core.case import Context


def found(case_id, **changes):
    case = find(case_id)
    q = case.inputs(**changes)
    return shared_readings(case_id, q, case.analytic(q))


def effect(case_id, word, **changes):
    """The effect of the one record that has `word`."""
    (record,) = (r for r in found(case_id, **changes) if word in r.assumption)
    return record.effect


@pytest.mark.slow("the formulas of all cases")
def test_every_case_states_what_it_assumes_in_sentences_with_a_source():
    assert set(SHARED) == {case.id for case in CASES}
    for case in CASES:
        records = found(case.id)
        assert records, case.id
        for record in records:
            assert record.source
            assert record.sentence.startswith("formula and reference assume that ")
            assert math.isfinite(record.effect or 0)
            number = f"{100 * (record.effect or 0):+.3g}".rstrip("0").rstrip(".")[:4]
            assert record.effect is None or number in record.sentence
    assert shared_readings("curved-bar", None, {}) == ()  # of no case


@pytest.mark.parametrize(("b", "too_stiff"), [(0.1e-3, 0.0325), (0.4e-3, 0.1329)])
def test_the_inner_radius_makes_the_spring_too_stiff(b, too_stiff):
    case = find("spring-accordion")
    given = {k: v for k, v in case.inputs().model_dump().items() if v is not None and k != "b"}
    q = case.inputs.model_construct(**given, b=b)
    (record, *_) = shared_readings(case.id, q, case.analytic(q))
    part = frame.stiffness(n=q.n, L1=q.L1, radius=q.r + q.b / 2, alpha=q.alpha, b=q.b, h=q.h,
                           E=q.E, nu=q.nu, head="free", tail="arc")  # fmt: skip
    assert record.effect == pytest.approx(case.analytic(q)["k1"] / part - 1, rel=1e-12)
    assert record.effect == pytest.approx(too_stiff, abs=1e-4)


@pytest.mark.parametrize("bore", [True, False])
def test_a_narrow_race_follows_from_lame_in_both_states(bore):
    r_i, r_o, nu = 7.21, 11.11, 0.3
    at, pressure = (r_i, {"p_i": 1.0}) if bore else (r_o, {"p_i": 0.0, "p_o": 1.0})
    stress, strain = (
        float(lame.radial_displacement(at, r_i=r_i, r_o=r_o, E=206e3, nu=nu, ends=e, **pressure))
        for e in ("plane stress", "plane strain")
    )
    assert narrow_race(r_i, r_o, nu, bore=bore) == pytest.approx(stress / strain - 1, rel=1e-10)


def test_effects_follow_the_inputs_and_what_is_not_assumed_is_not_stated():
    case = find("freewheel-torque")
    q = case.inputs()
    assert wedge_angle(q.R, q.r, q.X) == pytest.approx(case.analytic(q)["alpha_0"], rel=1e-9)
    assert -0.09 < effect("spring-accordion", "bending stiffness") < -0.08
    assert not [r for r in found("spring-curve", arcs="r + b/2") if "centre line" in r.assumption]
    assert effect("freewheel-torque", "flats") < 0 < effect("freewheel-friction", "flats")
    assert effect("sprag-clutch", "Palmgren") == pytest.approx(
        effect("sprag-engagement", "Palmgren"), abs=1e-3
    )


@pytest.mark.soak  # the roller with two ends is solved on all levels
def test_effects_that_were_measured_are_those_of_their_case_s_inputs_alone():
    assert effect("contact-roller", "half-spaces", F=3000.0) is None
    case = find("contact-roller-end")
    q = case.inputs()
    levels = [level.result for level in solved(case, q)]
    context = Context(case.id, q, case.analytic(q), levels, is_paper=True)
    for case_id, which in (("contact-roller", "crowned"), ("contact-roller-flat", "flat")):
        name = (
            f"load in both end zones d, half-space, roller with {which} profile; reference: "
            "model with end faces"
        )
        (check,) = (check for check in case.checks if check.name == name)
        row = next(row for row in check.rows(context) if row.quantity == name)
        measured = row.analytic / row.reference - 1
        assert effect(case_id, "half-spaces") == pytest.approx(measured, abs=1e-3)
