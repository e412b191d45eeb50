"""Verdicts, margins and limits of answers, against hand calculations of parts."""

import math
from dataclasses import replace

import pytest

from verify.answers.answer import Answer, Criterion, Verdict
from verify.answers.answer_units import in_units
from verify.answers.assessment import Assessment
from verify.answers.console import limits, number
from verify.answers.evidence import reference_of_design, why_not_solved, with_rows
from verify.answers.keys import identifier
from verify.answers.record import answer_record
from verify.answers.registry import answer
from verify.answers.strengths import contact_pressure, strip_strength, yield_strength
from verify.answers.usual import unusual
from verify.cases.registry import find
from verify.core.results import Status

STEEL = 206e9
E_STAR = STEEL / (2 * (1 - 0.3**2))  # Pa, both bodies of steel
RPM = math.pi / 30


def criterion(value, limit, **more):
    given = {"key": "stress", "what": "stress", "unit": "MPa", "source": "given", **more}
    return Criterion(value=value, limit=limit, **given)


def found(case_id, **changed):
    """The answer to the paper's inputs with some changed."""
    case = find(case_id)
    q = case.inputs(**(case.inputs().model_dump() | changed))
    return answer(case, q, case.analytic(q))


def named(result, key):
    (one,) = (c for c in result.criteria if c.key == key)
    return one


def test_margin_is_limit_over_value_or_value_over_a_minimum():
    for value, minimum, margin, met in (
        (200e6, False, 2.0, True), (400e6 * (1 + 1e-12), False, 1.0, True),
        (400e6 * (1 + 1e-6), False, 1.0, False), (200e6, True, 0.5, False),
        (-5.0, True, 0.0, False),
    ):  # fmt: skip
        one = criterion(value, 400e6, minimum=minimum)
        assert one.margin == pytest.approx(margin, rel=1e-5)
        assert one.is_met is met


def test_one_criterion_that_is_not_met_decides_before_what_is_unknown():
    met, broken = (criterion(value, 2.0) for value in (1.0, 3.0))
    for more, verdict in (
        ({"criteria": (met,)}, Verdict.HOLDS),
        ({"criteria": (met,), "unknowns": ("no F",)}, Verdict.CANNOT_SAY),
        ({"criteria": (met, broken), "unknowns": ("no F",)}, Verdict.FAILS),
        ({"criteria": (met,), "failures": ("open",)}, Verdict.FAILS),
        ({}, Verdict.CANNOT_SAY),
    ):
        assert Answer(design=None, **more).verdict is verdict


def test_steel_has_limits_with_a_source_and_another_material_has_none():
    assert contact_pressure(None, STEEL).value == 4000e6
    assert contact_pressure(None, STEEL, point=True).value == 4200e6
    assert "ISO 76" in contact_pressure(None, STEEL).source
    assert yield_strength(None, STEEL, wall=8e-3).value == 900e6
    assert yield_strength(None, STEEL, wall=8.1e-3).value == 750e6
    assert "ISO 683-2" in yield_strength(None, STEEL, wall=8e-3).source
    assert strip_strength(None, STEEL).value == pytest.approx(840e6)
    for soft in (contact_pressure(None, 70e9), yield_strength(None, STEEL, 70e9, wall=1e-3),
                 strip_strength(None, 110e9), yield_strength(None, STEEL, wall=0.2)):  # fmt: skip
        assert soft.value is None
    assert yield_strength(300e6, 70e9, wall=1.0).value == 300e6


def test_a_pressure_beyond_the_standard_and_within_the_given_limit_is_not_decided():
    for pressure, given, verdict in (
        (3900e6, 4500e6, Verdict.HOLDS),
        (4300e6, None, Verdict.FAILS),
        (4300e6, 4500e6, Verdict.CANNOT_SAY),
    ):
        part = Assessment()
        part.pressure("p", "pressure", pressure, STEEL, given=given)
        assert part.answer().verdict is verdict
    assert "ISO 76" in part.answer().reasons[0]
    assert limits(part.answer())[0][0] == "undecided"


def test_keys_are_identifiers_numbers_have_four_digits_and_unusual_inputs_their_range():
    assert (identifier("a/R"), identifier("1 %")) == ("a_per_R", "_1_percent")
    assert number(22236.8 * RPM, "r/min") == "22237 r/min"
    assert number(1.2345678e-3, "1") == "0.001235"
    q = find("sprag-clutch").inputs().model_copy(update={"E": 206e6, "m_g": 4.5, "density": 7.85})
    unusual_ones = unusual(q)
    for name, part in (("E", "60 to 420 GPa"), ("m_g", "steel block"), ("density", "1500 to")):
        assert part in unusual_ones[name]


def test_a_limit_that_is_an_input_is_named_by_its_symbol_and_meaning():
    q = find("sprag-friction").inputs()
    for assumed, start in (((), "given "), (("mu_s",), "")):
        part = Assessment(assumed=frozenset(assumed))
        part.below_input("friction", "tan ν", 0.05, q, "mu_s")
        (one,) = part.criteria
        assert (one.limit, one.assumed) == (q.mu_s, bool(assumed))
        assert one.source == f"{start}μ_s, coefficient of static friction"


def test_contact_pressures_are_those_of_hertz():
    same = {"E_2": 206e9, "nu_2": 0.3}
    spheres = found("contact-sphere", R_1=11.11e-3, R_2=2e-3, P=700.0, **same)
    R = 1 / (1 / 11.11e-3 + 1 / 2e-3)
    p = (6 * 700 * E_STAR**2 / (math.pi**3 * R**2)) ** (1 / 3)
    assert named(spheres, "contact_pressure_sphere").value == pytest.approx(p, rel=1e-6)
    # on the convex ring the curvatures add up
    wedge = found("polyhedral-wedge", alpha=math.radians(9), N=60e3)
    R = 1 / (1 / 5e-3 + 1 / (50.03e-3 - 10e-3))
    p = math.sqrt(60e3 / 30e-3 * (210e9 / (2 * 0.91)) / (math.pi * R))
    assert named(wedge, "contact_pressure").value == pytest.approx(p, rel=1e-6)
    assert spheres.verdict is wedge.verdict is Verdict.FAILS


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


def test_a_backward_critical_speed_in_the_operating_range_is_not_decided():
    assert any("opposite" in text for text in found("rotor-system").remarks)  # within the margin
    wider = found("rotor-system", speed_to=9100 * RPM)
    assert any("opposite" in text for text in wider.unknowns)
    assert wider.verdict is not Verdict.HOLDS
    assert found("rotor-shaft", n=3e5 * RPM).verdict is not Verdict.HOLDS  # beyond all modes


def test_a_spring_beyond_its_critical_force_needs_a_guide():
    for F, needed in ((0.5, False), (5.0, True)):
        remarks = found("spring-accordion", F=F).remarks
        assert any("needs a guide" in text for text in remarks) is needed


def test_the_polyhedral_torque_is_the_safe_bound_and_requires_a_cage():
    result = found("polyhedral-clutch")
    values = find("polyhedral-clutch").analytic(find("polyhedral-clutch").inputs())
    assert result.design.value == values["M_wide"] < values["M_el"]
    assert any("requires a cage" in text for text in result.remarks)
    assert result.verdict is Verdict.CANNOT_SAY
    # one that fails for another reason has no margin
    record = answer_record(found("polyhedral-clutch", p_t=10e6))
    assert (record["verdict"], record["margin"], record["limited_by"]) == ("fails", None, None)


def test_a_thin_ring_under_outside_pressure_buckles():
    result = found("ring-lame", r_i=0.1, r_o=0.101, p_i=0.0, p_o=1e6)
    limit = named(result, "buckling_pressure").limit
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


def test_a_reference_without_a_value_does_not_refute_the_formulas(judged):
    case = find("ring-lame")
    result = judged(case, drawn=False)
    of_paper = answer(case, case.inputs(), case.analytic(case.inputs()))
    lost = {"fem": None, "partner": None, "status": Status.FAIL, "reason": "not converged: level 4"}
    rows = [replace(row, **lost) for row in result.rows]
    assert why_not_solved(rows).startswith("not converged")
    unsolved = with_rows(of_paper, rows)
    assert unsolved.verdict is Verdict.CANNOT_SAY
    assert "no value was compared" in unsolved.reasons[0]
    assert not why_not_solved([*rows, replace(result.rows[0], status=Status.FAIL)])
    for system in ("mm", "inch", "si"):
        shown = in_units(result, system).rows
        assert reference_of_design(of_paper, shown).startswith("finite elements")
