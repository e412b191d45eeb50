"""Verdict and margin of criteria, limits with their sources, usual ranges, identifiers."""

import math

import pytest

from verify.answers.answer import Answer, Criterion, Verdict
from verify.answers.assessment import Assessment
from verify.answers.console import limits, number
from verify.answers.keys import identifier
from verify.answers.strengths import contact_pressure, strip_strength, yield_strength
from verify.answers.usual import unusual
from verify.cases.registry import find

STEEL = 206e9


def criterion(value, limit, **more):
    given = {"key": "stress", "what": "stress", "unit": "MPa", "source": "given", **more}
    return Criterion(value=value, limit=limit, **given)


@pytest.mark.parametrize(
    ("value", "limit", "minimum", "margin", "met"),
    [
        (200e6, 400e6, False, 2.0, True),
        (400e6 * (1 + 1e-12), 400e6, False, 1.0, True),
        (400e6 * (1 + 1e-6), 400e6, False, 1.0, False),
        (200e6, 400e6, True, 0.5, False),
        (-5.0, 400e6, True, 0.0, False),
    ],
)
def test_margin_is_limit_over_value_or_value_over_a_minimum(value, limit, minimum, margin, met):
    found = criterion(value, limit, minimum=minimum)
    assert found.margin == pytest.approx(margin, rel=1e-5)
    assert found.is_met is met


def test_one_criterion_that_is_not_met_decides_before_what_is_unknown():
    met, broken = criterion(1.0, 2.0), criterion(3.0, 2.0)
    assert Answer(design=None, criteria=(met,)).verdict is Verdict.HOLDS
    assert Answer(design=None, criteria=(met,), unknowns=("no F",)).verdict is Verdict.CANNOT_SAY
    assert Answer(design=None, criteria=(met, broken), unknowns=("no F",)).verdict is Verdict.FAILS
    assert Answer(design=None, criteria=(met,), failures=("open",)).verdict is Verdict.FAILS
    assert Answer(design=None).verdict is Verdict.CANNOT_SAY


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


@pytest.mark.parametrize(
    ("pressure", "given", "verdict"),
    [(4300e6, 4500e6, Verdict.CANNOT_SAY), (3900e6, 4500e6, Verdict.HOLDS),
     (4300e6, None, Verdict.FAILS)],
)  # fmt: skip
def test_a_pressure_beyond_the_standard_and_within_the_given_limit_is_not_decided(
    pressure, given, verdict
):
    part = Assessment()
    part.pressure("p", "pressure", pressure, STEEL, given=given)
    assert part.answer().verdict is verdict
    if verdict is Verdict.CANNOT_SAY:
        assert "ISO 76" in part.answer().reasons[0]
        assert limits(part.answer())[0][0] == "undecided"


def test_keys_are_identifiers_and_numbers_have_four_digits():
    assert identifier("a/R") == "a_per_R"
    assert identifier("1 %") == "_1_percent"
    assert number(22236.8 * math.pi / 30, "r/min") == "22237 r/min"
    assert number(1.2345678e-3, "1") == "0.001235"


@pytest.mark.parametrize(
    ("name", "value", "part"),
    [("E", 206e6, "60 to 420 GPa"), ("m_g", 4.5, "steel block"), ("density", 7.85, "1500 to")],
)
def test_an_unusual_input_is_named_with_its_range(name, value, part):
    q = find("sprag-clutch").inputs().model_copy(update={name: value})
    assert part in unusual(q)[name]
