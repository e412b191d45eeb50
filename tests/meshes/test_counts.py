"""Numbers of cells that ratios ask for do not depend on the last digits of these."""

import pytest

from meshes.counts import at_least, nearest


@pytest.mark.parametrize("off", [-1e-13, 0.0, 1e-13])
def test_round_off_of_a_ratio_asks_for_no_cell_more_or_less(off):
    assert at_least(4000 * (1 + off)) == nearest(4000 * (1 + off)) == 4000
    assert nearest(12.5 * (1 + off)) == 13
    assert (at_least(0.3 + off), at_least(11.001 + off)) == (1, 12)
    assert (nearest(0.3 + off), nearest(11.001 + off)) == (0, 11)
