"""The half-space's own uncertainty: what neighbouring grids differ by is what is claimed."""

import pytest

from verify.cases.contact.roller.case import ROLLER
from verify.cases.contact.roller.crowns import CROWNS, REFERENCES
from verify.cases.contact.roller.half_space import pressed
from verify.cases.contact.roller.tilted import TILTED

LEVEL = 20
SHARP = 1e-4  # of the value, that a row of the acceptance's 0.3 % can use
CLAIMED = ("peak", "mid", "approach", "low end", "high end", "ends", "moment")


@pytest.mark.parametrize("case", [ROLLER, TILTED], ids=lambda case: case.id)
def test_what_neighbouring_grids_differ_by_is_claimed_and_little(case):
    q = case.inputs()
    found = case.reference(q, LEVEL)
    beside = [pressed(q, LEVEL + step).values for step in (-1, 1)]
    for key in CLAIMED:
        apart = max(abs(values[key] - found.values[key]) for values in beside)
        assert found.u_it[key] >= apart, key
    assert 0 < found.u_it["best top"] < 1e-3 * found.values["best top"]
    for key in ("peak", "mid", "approach"):
        assert found.u_it[key] < SHARP * found.values[key], key


def test_so_it_is_for_crowns_of_an_even_pressure():
    q = CROWNS.inputs()
    found = CROWNS.reference(q, LEVEL)
    for name, gap in REFERENCES.items():
        beside = [pressed(q, LEVEL + step, crown=gap(q)).values for step in (-1, 1)]
        for key in ("mid", "approach", "ends"):
            value, claimed = found.values[f"{name} {key}"], found.u_it[f"{name} {key}"]
            assert claimed >= max(abs(values[key] - value) for values in beside), key
        for key in ("mid", "approach"):
            assert found.u_it[f"{name} {key}"] < SHARP * found.values[f"{name} {key}"], key
