"""What an equation gives for numbers by its symbols."""

import pytest

from verify.form.tex import evaluate

ROOT = r"\sqrt{(\frac{\mu}{t})^2 - 1}"


def test_a_root_is_evaluated():
    assert evaluate(ROOT, {r"\mu": 5.0, "t": 3.0}) == pytest.approx(4 / 3)


@pytest.mark.parametrize("t", [10.0, 0.0])
def test_an_equation_without_a_value_at_these_numbers_is_not_evaluated(t):
    assert evaluate(ROOT, {r"\mu": 5.0, "t": t}) is None
