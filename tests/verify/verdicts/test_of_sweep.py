"""The verdict of a formula over a user's sweep follows the rule and the case's safe side."""

from types import SimpleNamespace

import numpy as np
import pytest

from verify.core.verdicts import Safe
from verify.verdicts import of_sweep


def found(errors, safe, own=0, name="k"):
    quantity = SimpleNamespace(name="k", safe=safe)
    case = SimpleNamespace(id="ring-lame", inputs=SimpleNamespace(quantities=lambda: (quantity,)))
    plan = SimpleNamespace(case=case, own=own)
    course = SimpleNamespace(
        pair=SimpleNamespace(analytic="k", name=name),
        error=np.array(errors),
        U_error=np.zeros(len(errors)),
    )
    return plan, course


@pytest.mark.parametrize(
    ("errors", "safe", "words"),
    [
        ((0.01, -0.02), "too high", "accurate: within 2 %"),
        ((0.01, np.nan), "too high", "accurate in part of the range: within 1 %"),
        ((-0.3, 0.1), "too high",
         "unsafe: up to 30 % below and up to 10 % above; a higher value is safe"),
        ((-0.3, -0.1), "too low", "conservative: up to 30 % below; a lower value is safe"),
        ((0.05, -0.3), "",
         "accurate in part of the range: up to 30 % below and up to 5 % above; "
         "neither side is safe"),
        ((np.nan,), "", ""),
    ],
)  # fmt: skip
def test_the_words_are_those_of_the_rule(monkeypatch, errors, safe, words):
    monkeypatch.setattr(of_sweep, "_own", lambda plan: plan.own)
    assert of_sweep.verdict_in_words(*found(errors, safe)) == words


def test_a_sweep_that_leaves_out_the_own_inputs_cannot_be_accurate_in_part(monkeypatch):
    monkeypatch.setattr(of_sweep, "_own", lambda plan: plan.own)
    plan, course = found((0.05, -0.3), "", own=None)
    assert of_sweep.verdict_in_words(plan, course).startswith("unsafe")


def test_the_safe_side_is_that_of_the_formula_or_else_of_the_quantity(monkeypatch):
    monkeypatch.setattr(of_sweep, "safe_sides", lambda: {"ring-lame/row": Safe.ABOVE})
    assert of_sweep.safe_side(*found((0.0,), "too low", name="row")) is Safe.ABOVE
    assert of_sweep.safe_side(*found((0.0,), "too low")) is Safe.BELOW
    assert of_sweep.safe_side(*found((0.0,), "")) is Safe.NEITHER


@pytest.mark.parametrize(("nominal", "own"), [(2.0, 1), (2.1, None), (None, None)])
def test_own_inputs_are_a_point_only_where_the_sweep_has_them(nominal, own):
    axis = SimpleNamespace(name="x", values=(1.0, 2.0, 3.0), nominal=nominal, spacing="even")
    plan = SimpleNamespace(star=False, axes=(axis,), shape=(3,),
                           points=np.array([[1.0], [2.0], [3.0]]))  # fmt: skip
    assert of_sweep._own(plan) == own
