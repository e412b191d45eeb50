"""What `deep` and `crosscheck` stored in the repository was measured with the present code."""

import pytest

from verify.studies.crosscheck.registry import COMPARISONS
from verify.studies.crosscheck.store import current
from verify.studies.deep import STUDIES


@pytest.mark.parametrize("study", STUDIES.values(), ids=lambda study: study.name or "deep cases")
def test_every_study_is_stored_for_the_present_code(study):
    assert [study.title(case) for case in study.cases() if not study.is_measured(case)] == []


def test_every_second_solver_is_stored_for_the_present_code():
    assert [f"{one.case}: {one.id}" for one in COMPARISONS if current(one) is None] == []
