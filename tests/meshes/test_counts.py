"""Numbers of cells that ratios ask for do not depend on the last digits of these."""

import math

import pytest

from meshes.counts import at_least, nearest

OFF = [-1e-13, 0.0, 1e-13]


@pytest.mark.parametrize("off", OFF)
def test_a_ratio_that_is_whole_but_for_round_off_asks_for_no_cell_more(off):
    whole = 4000
    assert at_least(whole * (1 + off)) == whole
    assert nearest(whole * (1 + off)) == whole


@pytest.mark.parametrize("off", OFF)
def test_a_ratio_that_is_halfway_but_for_round_off_asks_for_the_upper_number(off):
    below = 12
    assert nearest((below + 0.5) * (1 + off)) == below + 1


@pytest.mark.parametrize("ratio", [0.3, 11.001])
def test_any_other_ratio_is_rounded_as_usual(ratio):
    assert at_least(ratio) == math.ceil(ratio)
    assert nearest(ratio) == round(ratio)
