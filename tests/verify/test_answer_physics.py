"""Answers against hand calculations: no part holds that a standard or equilibrium rules out."""

import math
from dataclasses import replace

import pytest

from verify.answers.answer import Verdict
from verify.answers.answer_units import in_units
from verify.answers.evidence import reference_of_design, why_not_solved, with_rows
from verify.answers.record import answer_record
from verify.answers.registry import answer
from verify.cases.registry import find
from verify.core.results import Status

E_STAR = 206e9 / (2 * (1 - 0.3**2))  # Pa, both bodies of steel
RPM = math.pi / 30


def found(case_id, **changed):
    """The answer to the paper's inputs with some changed."""
    case = find(case_id)
    q = case.inputs(**(case.inputs().model_dump() | changed))
    return answer(case, q, case.analytic(q))


def criterion(result, key):
    (one,) = (c for c in result.criteria if c.key == key)
    return one


def pressure_of(result):
    return criterion(result, "contact_pressure").value


def test_contact_pressures_are_those_of_hertz():
    same = {"E_2": 206e9, "nu_2": 0.3}
    spheres = found("contact-sphere", R_1=11.11e-3, R_2=2e-3, P=700.0, **same)
    R = 1 / (1 / 11.11e-3 + 1 / 2e-3)
    p = (6 * 700 * E_STAR**2 / (math.pi**3 * R**2)) ** (1 / 3)
    assert criterion(spheres, "contact_pressure_sphere").value == pytest.approx(p, rel=1e-6)
    clutch = found("freewheel-friction", T=400.0, mu=0.12)
    p = math.sqrt(29623.0 / 10e-3 * E_STAR / (math.pi * 2.5e-3))
    assert pressure_of(clutch) == pytest.approx(p, rel=0.02)  # rollers' tilt adds to it
    # on the convex ring the curvatures add up
    wedge = found("polyhedral-wedge", alpha=math.radians(9), N=60e3)
    R = 1 / (1 / 5e-3 + 1 / (50.03e-3 - 10e-3))
    p = math.sqrt(60e3 / 30e-3 * (210e9 / (2 * 0.91)) / (math.pi * R))
    assert pressure_of(wedge) == pytest.approx(p, rel=1e-6)
    assert {one.verdict for one in (spheres, clutch, wedge)} == {Verdict.FAILS}


@pytest.mark.parametrize(
    ("case_id", "changed"),
    [
        pytest.param("rotor-shaft", {"n": 86000 * RPM}, id="speed at a higher mode"),
        pytest.param("sprag-engagement", {"T": 70.0}, id="sprags roll over in the first peak"),
        pytest.param("sprag-friction", {"T": 115.0}, id="sprags roll over at rest"),
        pytest.param("sprag-friction", {"p_lim": 1000e6}, id="the given limit of pressure"),
        pytest.param("sprag-crown", {"mu_s": 0.05, "mu_c": 0.04}, id="crowned sprag slips"),
        pytest.param("spring-buckling", {"F": 0.9}, id="free head beyond its critical force"),
    ],
)
def test_a_part_that_equilibrium_stability_or_its_limit_rules_out_fails(case_id, changed):
    result = found(case_id, **changed)
    assert result.verdict is Verdict.FAILS
    assert "T" not in changed or "roll over" in result.failures[0]
    assert "p_lim" not in changed or result.limiting.key == "contact_pressure"


def test_what_the_formulas_do_not_reach_is_not_decided():
    beyond_all_modes = found("rotor-shaft", n=3e5 * RPM)
    optimum_under_static_load = found("sprag-optimum")
    assert beyond_all_modes.verdict is not Verdict.HOLDS
    assert optimum_under_static_load.verdict is Verdict.CANNOT_SAY


def test_a_spring_beyond_its_critical_force_needs_a_guide():
    assert any("needs a guide" in text for text in found("spring-accordion", F=5.0).remarks)
    assert not any("needs a guide" in text for text in found("spring-accordion", F=0.5).remarks)


def test_the_polyhedral_torque_is_the_safe_bound_and_requires_a_cage():
    result = found("polyhedral-clutch")
    values = find("polyhedral-clutch").analytic(find("polyhedral-clutch").inputs())
    assert result.design.value == values["M_wide"] < values["M_el"]
    assert any("requires a cage" in text for text in result.remarks)
    assert result.verdict is Verdict.CANNOT_SAY


def test_a_thin_ring_under_outside_pressure_buckles():
    result = found("ring-lame", r_i=0.1, r_o=0.101, p_i=0.0, p_o=1e6)
    limit = criterion(result, "buckling_pressure").limit
    E = find("ring-lame").inputs().E
    assert limit == pytest.approx(3 * E * (1e-3**3 / 12) / 0.1005**3, rel=1e-9)
    assert result.verdict is Verdict.FAILS


EXACT = {"F_ax": 0.0, "X_tol": 0.0, "r_tol": 0.0, "R_tol": 0.0, "s_mu": 0.0}


@pytest.mark.parametrize(
    ("case_id", "changed", "words"),
    [
        ("freewheel-clutch", {"R_a": 18.5e-3, "mu": 0.12, **EXACT}, "hoop stress"),
        ("freewheel-clutch", EXACT, "the contacts slip"),
        ("sprag-clutch", {"p_lim": 4e9}, "the inner contacts reach p_lim"),
    ],
)
def test_the_permissible_torque_as_the_torque_has_a_margin_of_one(case_id, changed, words):
    design = found(case_id, **changed).design
    assert words in design.what
    again = found(case_id, **changed | {"T": design.value})
    assert again.limiting.margin == pytest.approx(1, abs=1e-3)
    if again.design is not None:
        assert again.design.value == pytest.approx(design.value, rel=1e-3)


def test_a_backward_critical_speed_in_the_operating_range_is_not_decided():
    result = found("rotor-system")
    assert any("opposite" in text for text in result.remarks)  # within the margin
    wider = found("rotor-system", speed_to=9100 * RPM)
    assert any("opposite" in text for text in wider.unknowns)
    assert wider.verdict is not Verdict.HOLDS


def test_a_part_that_fails_for_another_reason_has_no_margin():
    record = answer_record(found("polyhedral-clutch", p_t=10e6))
    assert (record["verdict"], record["margin"], record["limited_by"]) == ("fails", None, None)


def test_a_reference_without_a_value_does_not_refute_the_formulas(judged):
    case = find("ring-lame")
    result = judged(case, drawn=False)
    of_paper = answer(case, case.inputs(), case.analytic(case.inputs()))
    lost = {"fem": None, "partner": None, "status": Status.FAIL, "reason": "not converged: level 4"}
    rows = [replace(row, **lost) for row in result.rows]
    assert why_not_solved(rows).startswith("not converged")
    unsolved = with_rows(of_paper, rows)
    assert unsolved.verdict is Verdict.CANNOT_SAY
    assert "nothing was compared" in unsolved.reasons[0]
    assert not why_not_solved([*rows, replace(result.rows[0], status=Status.FAIL)])
    for system in ("mm", "inch", "si"):
        shown = in_units(result, system).rows
        assert reference_of_design(of_paper, shown).startswith("finite elements")
