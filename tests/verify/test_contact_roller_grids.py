"""The half-space's own uncertainty: what neighbouring grids differ by is what is claimed."""

from itertools import pairwise

import pytest

from verify.cases.contact_roller import ROLLER
from verify.cases.contact_roller_crowns import CROWNS, even_crowns
from verify.cases.contact_roller_half_space import noise, pressed
from verify.cases.contact_roller_tilted import TILTED

STRAIGHT = ("peak", "mid", "approach", "low end", "high end", "ends")
EVEN = even_crowns(CROWNS.inputs())


@pytest.mark.parametrize(
    ("case", "how", "keys"),
    [
        pytest.param(ROLLER, {}, STRAIGHT, id="crowned"),
        pytest.param(TILTED, {}, (*STRAIGHT, "moment"), id="tilted"),
        pytest.param(CROWNS, {"crown": EVEN["Lundberg"]}, ("mid",), id="Lundberg's crown"),
        pytest.param(CROWNS, {"crown": EVEN["Johns"]}, ("mid",), id="Johns and Gohar's crown"),
    ],
)
def test_neighbouring_grids_differ_by_less_than_is_claimed(case, how, keys):
    q = case.inputs()
    finest = case.levels[-1]
    found = [pressed(q, level, **how).values for level in range(finest - 2, finest + 3)]
    claimed = noise(found[2], q)
    for key in keys:
        apart = max(abs(b[key] - a[key]) for a, b in pairwise(found))
        assert apart < claimed[key], key


def test_the_claim_is_no_hundred_times_what_is_seen():
    """An uncertainty that forgives everything would judge nothing."""
    q = TILTED.inputs()
    low, high = (pressed(q, level).values for level in (31, 32))
    claimed = noise(high, q)
    for key in ("peak", "approach", "high end", "moment"):
        assert claimed[key] < 100 * abs(high[key] - low[key]) + 1e-6 * abs(high[key]), key
