"""The half-space's own uncertainty: what neighbouring grids differ by is what is claimed."""

import pytest

from verify.cases.contact.roller.case import ROLLER
from verify.cases.contact.roller.crowns import CROWNS
from verify.cases.contact.roller.half_space import pressed
from verify.cases.contact.roller.inputs import ending
from verify.cases.contact.roller.profiles import even_crowns
from verify.cases.contact.roller.tilted import TILTED

LEVEL = 20
SHARP = 1e-4  # of the value, that a row of the acceptance's 0.3 % can use
CLAIMED = ("p_max", "p_mid", "delta", "F_low", "F_high", "F_d", "M")


@pytest.mark.parametrize("case", [ROLLER, TILTED], ids=lambda case: case.id)
def test_what_neighbouring_grids_differ_by_is_claimed_and_little(case):
    q = case.inputs()
    found = case.reference(q, LEVEL)
    beside = [pressed(q, LEVEL + step).values for step in (-1, 1)]
    for key in CLAIMED:
        apart = max(abs(values[key] - found.values[key]) for values in beside)
        assert found.u_it[key] >= apart, key
    assert 0 < found.u_it["p_best"] < 1e-3 * found.values["p_best"]
    for key in ("p_max", "p_mid", "delta"):
        assert found.u_it[key] < SHARP * found.values[key], key


def test_so_it_is_for_crowns_of_an_even_pressure():
    q = CROWNS.inputs()
    found = CROWNS.reference(q, LEVEL)
    for name, crown in even_crowns(q).items():
        beside = [pressed(q, LEVEL + step, crown=crown).values for step in (-1, 1)]
        for key in ("p_mid", "delta", "F_d"):
            named = f"{key}{ending(name)}"
            value, claimed = found.values[named], found.u_it[named]
            assert claimed >= max(abs(values[key] - value) for values in beside), key
        for key in ("p_mid", "delta"):
            named = f"{key}{ending(name)}"
            assert found.u_it[named] < SHARP * found.values[named], key
