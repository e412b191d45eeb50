"""Portions give what their cases' finite elements give on the same mesh, and nothing else."""

import pytest

from verify.cases.polyhedral.ring.case import RING
from verify.cases.spring.accordion.case import ACCORDION

PORTIONS = [pytest.param(case, part, id=case.id) for case in (RING, ACCORDION)
            for part in case.portions]  # fmt: skip


@pytest.mark.parametrize(("case", "portion"), PORTIONS)
def test_a_portion_has_the_values_of_its_case_on_the_same_mesh(case, portion):
    level = portion.levels[0]
    part, whole = (fem(case.inputs(), level) for fem in (portion.fem, case.reference))
    assert set(part.values) == set(portion.keys)
    assert part.h == whole.h
    assert part.values == {key: whole.values[key] for key in portion.keys}
    assert part.u_it == {key: whole.u_it[key] for key in portion.keys}
    # rows of the case ask for it, on levels enough for its convergence
    assert set(portion.keys) <= {getattr(check, "fem", None) for check in case.checks}
    assert len(portion.levels) >= 3
    assert list(portion.levels) == sorted(portion.levels)
