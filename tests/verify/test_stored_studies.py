"""Stored studies and second solvers were measured with the present code, which can run them.

A record whose numbers cannot have changed may be given the present code without a new run; such a
record hides a comparison that the present code can no longer set up.
"""

import pytest

from verify.studies.crosscheck.registry import COMPARISONS
from verify.studies.crosscheck.store import current
from verify.studies.deep import STUDIES


@pytest.mark.parametrize("study", STUDIES.values(), ids=lambda study: study.name or "deep cases")
def test_every_study_is_stored_for_the_present_code(study):
    assert [study.title(case) for case in study.cases() if not study.is_measured(case)] == []


def test_every_second_solver_is_stored_for_the_present_code():
    assert [f"{one.case}: {one.id}" for one in COMPARISONS if current(one) is None] == []


@pytest.mark.soak  # levels of references are meshed; `freewheel crosscheck` sets up each as well
@pytest.mark.parametrize("comparison", COMPARISONS, ids=lambda one: one.id)
def test_every_second_solver_can_be_set_up(comparison):
    comparison.pose()
