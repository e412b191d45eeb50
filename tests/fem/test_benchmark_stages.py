"""The benchmarks time functions by their names, which move."""

import pytest

from benchmarks import ours, ours_contact

TABLES = {"plane": ours.STAGES, "contact": ours_contact.SET_UP, "steps": ours_contact.STEP}


@pytest.mark.parametrize("table", TABLES)
def test_what_is_timed_is_there(table):
    for stage, (owner, names) in TABLES[table].items():
        for name in names:
            assert callable(getattr(owner, name)), stage


def test_stages_of_a_ring_are_timed():
    stages: dict[str, float] = {}
    with ours.timed(stages, ours.STAGES):
        ours.solve_ring(ours.ring_mesh("triangles", 28))
    assert set(stages) == set(ours.STAGES)
