"""Studies as evidence: a range with a point that has no answer does not count as compared."""

from types import SimpleNamespace

import numpy as np
import pytest

from verify.verdicts.evidence import Evidence, NoEvidenceError, point_of

CASE = "ring-lame"


def study(*errors):
    plan = SimpleNamespace(points=np.zeros((len(errors), 1)), case=SimpleNamespace(id=CASE))
    course = SimpleNamespace(error=np.array(errors), U_error=np.zeros(len(errors)))
    return plan, course


@pytest.mark.parametrize(
    ("errors", "is_studied"),
    [((0.01, 0.02), True), ((0.01, np.nan), False), ((0.01,), False)],
)
def test_a_range_counts_where_every_point_has_an_answer(row, errors, is_studied):
    found = Evidence((row("x", 0.01),), (study(*errors),))
    assert found.is_studied is is_studied
    assert len(found.points) == 1 + np.isfinite(errors).sum()


def test_each_case_needs_a_study(row):
    both = row("x", 0.01), row("x", 0.01, case="ring-rotation")
    found = Evidence(both, (study(0.01, 0.02),))
    assert not found.is_studied
    assert found.cases == (CASE, "ring-rotation")


@pytest.mark.parametrize("wrong", [{"error": float("nan")}, {"error": 0.1, "U": float("nan")}])
def test_an_error_that_is_no_number_is_no_evidence(row, wrong):
    with pytest.raises(NoEvidenceError, match="no number"):
        point_of(row("x", **wrong))
