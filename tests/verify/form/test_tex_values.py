"""What an equation gives for numbers by its symbols."""

import pytest

from verify.cases.contact.roller.case import ROLLER
from verify.form import equations
from verify.form.tex import evaluate, with_raised_stars

ROOT = r"\sqrt{(\frac{\mu}{t})^2 - 1}"


def test_a_root_is_evaluated():
    assert evaluate(ROOT, {r"\mu": 5.0, "t": 3.0}) == pytest.approx(4 / 3)


@pytest.mark.parametrize("t", [10.0, 0.0])
def test_an_equation_without_a_value_at_these_numbers_is_not_evaluated(t):
    assert evaluate(ROOT, {r"\mu": 5.0, "t": t}) is None


def test_the_star_of_a_symbol_is_raised_and_no_product():
    found = {e.tex for e in equations.stated(ROLLER.inputs())}
    assert r"p_0 = \sqrt{\frac{F E^*}{\pi l R}}" in found
    assert not [tex for tex in found if "*" in tex.replace("^*", "")]
    assert with_raised_stars("E*^2 a*^{1/3}", ["E*", "a*"]) == "E^{*2} a^{*1/3}"
    assert with_raised_stars("a * b", ["a", "b"]) == "a * b"
