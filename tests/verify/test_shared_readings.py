"""What both sides assume: every case states it, with effects that follow from other models."""

import math

import pytest

from analytic.ring import lame
from analytic.spring import frame
from verify.answers.shared.clutches import wedge_angle
from verify.answers.shared.rings import narrow_race
from verify.answers.shared_readings import SHARED, shared_readings
from verify.cases.registry import CASES, find

KNOWN = {  # how many assumptions each case shares at the paper's inputs: none may be lost
    "ring-lame": 2, "ring-loads-outer": 4, "ring-loads-inner": 3, "ring-loads-map": 2,
    "ring-rotation": 2, "polyhedral-pressure": 2, "polyhedral-ring": 1, "polyhedral-map": 1,
    "polyhedral-locking": 3, "polyhedral-wedge": 3, "polyhedral-clutch": 3, "freewheel-torque": 5,
    "freewheel-cup": 4, "freewheel-friction": 5, "freewheel-paths": 5, "freewheel-clutch": 5,
    "sprag-wedge": 4, "sprag-engagement": 5, "sprag-friction": 4, "sprag-clutch": 4,
    "sprag-crown": 5, "sprag-optimum": 5, "sprag-optimum-40": 5, "spring-accordion": 3,
    "spring-continuum": 2, "spring-stages": 3, "spring-width": 2, "spring-curve": 2,
    "spring-buckling": 2, "spring-map": 2, "contact-flat": 3, "contact-pair": 3, "contact-ring": 4,
    "contact-slip": 3, "contact-sphere": 3, "contact-press-fit": 2, "contact-roller": 4,
    "contact-roller-tilted": 3, "contact-roller-flat": 4, "contact-roller-crowns": 4,
    "contact-roller-end": 3, "rotor-clutch": 2, "rotor-shaft": 1, "rotor-step": 2,
    "rotor-system": 2, "rotor-sprag": 2,
}  # fmt: skip


def found(case_id, **changes):
    case = find(case_id)
    q = case.inputs(**changes)
    return shared_readings(case_id, q, case.analytic(q))


def effect(case_id, word, **changes):
    """The effect of the one record that speaks of `word`."""
    (record,) = (r for r in found(case_id, **changes) if word in r.assumption)
    return record.effect


def test_every_case_has_an_entry_and_no_other():
    assert set(SHARED) == {case.id for case in CASES} == set(KNOWN)


@pytest.mark.parametrize("case", [pytest.param(c, id=c.id) for c in CASES])
def test_no_shared_reading_is_lost_and_each_is_a_sentence(case):
    records = found(case.id)
    assert len(records) == KNOWN[case.id]
    for record in records:
        assert record.effect is None or math.isfinite(record.effect)
        assert record.source
        assert record.sentence.startswith("formula and reference assume that ")
        number = f"{100 * (record.effect or 0):+.3g}".rstrip("0").rstrip(".")[:4]
        assert record.effect is None or number in record.sentence


def test_a_case_outside_the_suite_states_none():
    assert shared_readings("curved-bar", None, {}) == ()


@pytest.mark.parametrize(("b", "too_stiff"), [("0.1 mm", 0.0325), ("0.4 mm", 0.1329)])
def test_the_inner_radius_makes_the_spring_too_stiff(b, too_stiff):
    case = find("spring-accordion")
    given = {k: v for k, v in case.inputs().model_dump().items() if v is not None and k != "b"}
    q = case.inputs.model_construct(**given, b=float(b.removesuffix(" mm")) * 1e-3)
    (record, *_) = shared_readings(case.id, q, case.analytic(q))
    part = frame.stiffness(n=q.n, L1=q.L1, radius=q.r + q.b / 2, alpha=q.alpha, b=q.b, h=q.h,
                           E=q.E, nu=q.nu, head="free", tail="arc")  # fmt: skip
    assert record.quantity.startswith("k_1 (")
    assert record.effect == pytest.approx(case.analytic(q)["k1"] / part - 1, rel=1e-12)
    assert record.effect == pytest.approx(too_stiff, abs=1e-4)


def test_the_curve_on_the_true_centre_line_shares_no_radius():
    assert effect("spring-curve", "centre line") == pytest.approx(0.0350, abs=1e-4)
    assert not [r for r in found("spring-curve", arcs="r + b/2") if "centre line" in r.assumption]


def test_a_wide_strip_is_stiffer_by_less_than_the_plate():
    assert -0.09 < effect("spring-accordion", "bending stiffness") < -0.08
    assert not [r for r in found("spring-stages") if "bending stiffness" in r.assumption]


@pytest.mark.parametrize("bore", [True, False])
def test_a_narrow_race_follows_from_lame_in_both_states(bore):
    r_i, r_o, E, nu = 7.21, 11.11, 206e3, 0.3
    pressure = {"p_i": 1.0} if bore else {"p_i": 0.0, "p_o": 1.0}
    at = r_i if bore else r_o
    stress, strain = (
        float(lame.radial_displacement(at, r_i=r_i, r_o=r_o, E=E, nu=nu, ends=ends, **pressure))
        for ends in ("plane stress", "plane strain")
    )
    assert narrow_race(r_i, r_o, nu, bore=bore) == pytest.approx(stress / strain - 1, rel=1e-10)


def test_the_wedge_angle_is_that_of_the_case():
    case = find("freewheel-torque")
    q = case.inputs()
    assert wedge_angle(q.R, q.r, q.X) == pytest.approx(case.analytic(q)["alpha_0"], rel=1e-9)
    assert effect("freewheel-torque", "flats") < 0 < effect("freewheel-friction", "flats")


def test_effects_that_were_measured_are_no_others_inputs(of_paper):
    assert effect("contact-roller", "half-spaces", F=3000.0) is None
    ends = {row.quantity: row for row in of_paper(find("contact-roller-end")).rows}
    for case_id, which in (("contact-roller", "crowned"), ("contact-roller-flat", "flat")):
        row = ends[f"load within d of the ends, half-space, {which}, end face"]
        measured = row.analytic / row.reference - 1
        assert effect(case_id, "half-spaces") == pytest.approx(measured, abs=1e-3)


def test_the_rotation_of_elastic_sprags_is_that_of_the_clutch():
    assert effect("sprag-clutch", "Palmgren") == pytest.approx(
        effect("sprag-engagement", "Palmgren"), abs=1e-3
    )
