"""The rule from errors to a verdict, and its errors: of studies and of sweeps."""

from types import SimpleNamespace

import numpy as np
import pytest

from verify.core.verdicts import Safe, Verdict
from verify.verdicts import of_sweep
from verify.verdicts.evidence import Evidence, NoEvidenceError, point_of
from verify.verdicts.rule import Point, accuracy, judged


def test_each_line_of_the_rule():
    for errors, U, safe, has_range, verdict in (
        ((0.004, -0.009), 0.0, Safe.ABOVE, True, Verdict.ACCURATE),
        ((0.004,), 0.0, Safe.ABOVE, False, Verdict.PART),
        ((0.09, -0.09), 0.02, Safe.NEITHER, True, Verdict.UNSAFE),  # the bar counts
        ((0.02, -0.3), 0.0, Safe.ABOVE, True, Verdict.PART),  # the paper's inputs hold
        ((0.3, -0.019), 0.0, Safe.ABOVE, True, Verdict.CONSERVATIVE),
        ((0.3, -0.019), 0.002, Safe.ABOVE, True, Verdict.PART),  # 2 % to 10 % on the unsafe side
        ((-0.3, 0.019), 0.002, Safe.BELOW, True, Verdict.PART),
        ((0.3,), 0.0, Safe.BELOW, False, Verdict.UNSAFE),
        ((-0.3,), 0.0, Safe.BELOW, False, Verdict.CONSERVATIVE),
        ((-0.3,), 0.0, Safe.NEITHER, False, Verdict.UNSAFE),
    ):
        points = [Point(e, U, is_paper=i == 0) for i, e in enumerate(errors)]
        assert judged(points, safe, has_range=has_range) is verdict


def test_the_accuracy_class_is_the_least_that_holds_error_and_bar():
    classes = {0.0099: 0.01, 0.0101: 0.02, 0.05: 0.05, 0.0999: 0.1, 0.1001: None}
    for size, limit in classes.items():
        assert accuracy([Point(size - 0.001, 0.001), Point(0.0, 0.0)]) == limit
        assert accuracy([Point(0.001 - size, 0.001)]) == limit


def test_a_range_counts_where_every_point_of_each_case_has_an_answer(row):
    def study(*errors):
        plan = SimpleNamespace(
            points=np.zeros((len(errors), 1)), case=SimpleNamespace(id="ring-lame")
        )
        return plan, SimpleNamespace(error=np.array(errors), U_error=np.zeros(len(errors)))

    for errors, is_studied in (((0.01, 0.02), True), ((0.01, np.nan), False), ((0.01,), False)):
        found = Evidence((row("x", 0.01),), (study(*errors),))
        assert found.is_studied is is_studied
        assert len(found.points) == 1 + np.isfinite(errors).sum()
    both = row("x", 0.01), row("x", 0.01, case="ring-rotation")
    assert not Evidence(both, (study(0.01, 0.02),)).is_studied
    for wrong in ({"error": np.nan}, {"error": 0.1, "U": np.nan}):
        with pytest.raises(NoEvidenceError, match="not a finite number"):
            point_of(row("x", **wrong))


def swept(errors, safe, nominal, name="k"):
    """A grid over one input, 1 to 4, with these errors."""
    values = (1.0, 2.0, 3.0, 4.0)[: len(errors)]
    quantity = SimpleNamespace(name="k", safe=safe)
    plan = SimpleNamespace(
        case=SimpleNamespace(id="ring-lame", inputs=SimpleNamespace(quantities=lambda: [quantity])),
        axes=(SimpleNamespace(name="x", values=values, nominal=nominal, spacing="even"),),
        star=False, shape=(len(values),), points=np.array(values)[:, None],
    )  # fmt: skip
    course = SimpleNamespace(
        pair=SimpleNamespace(analytic="k", name=name),
        error=np.array(errors), U_error=np.zeros(len(errors)),
    )  # fmt: skip
    return plan, course


PART = (
    "accurate in part of the range: up to 30 % below and up to 5 % above; neither higher nor lower "
    "values are safe"
)


def test_a_sweep_s_verdict_follows_the_rule_at_the_inputs_of_the_case():
    for errors, safe, nominal, words in (
        ((0.01, -0.02), "too high", 1.0, "accurate: within 2 %"),
        ((0.01, np.nan), "too high", 1.0, "accurate in part of the range: within 1 %"),
        ((-0.3, 0.1), "too high", 1.0,
         "unsafe: up to 30 % below and up to 10 % above; values above the reference are safe"),
        ((-0.3, -0.1), "too low", 1.0,
         "conservative: up to 30 % below; values below the reference are safe"),
        ((-0.3, 0.05), "", 2.0, PART),
        # inputs of the file are a point only where the sweep has them
        ((-0.3, 0.05), "", 1.9, PART.replace("accurate in part of the range", "unsafe")),
        ((0.05, -0.3), "", None, PART.replace("accurate in part of the range", "unsafe")),
        ((np.nan, np.nan), "", 1.0, ""),
    ):  # fmt: skip
        assert of_sweep.verdict_in_words(*swept(errors, safe, nominal)) == words


def test_the_safe_side_is_that_of_the_formula_or_else_of_the_quantity(monkeypatch):
    monkeypatch.setattr(of_sweep, "safe_sides", lambda: {"ring-lame/row": Safe.ABOVE})
    assert of_sweep.safe_side(*swept((0.0,), "too low", 1.0, name="row")) is Safe.ABOVE
    assert of_sweep.safe_side(*swept((0.0,), "too low", 1.0)) is Safe.BELOW
    assert of_sweep.safe_side(*swept((0.0,), "", 1.0)) is Safe.NEITHER
