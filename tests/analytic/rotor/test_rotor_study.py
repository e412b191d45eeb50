"""A rotor of two shafts: critical speeds by the unbalance of each shaft, frequency branches."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.rotor.rotor_study import branches, opposite_criticals, ratios, study
from analytic.rotor.transfer_model import (
    Segment,
    SegmentedShaft,
    StationDisc,
    StationLink,
    StationSupport,
    TransferMatrixRotor,
)

NAMES = ("outer", "inner")


def shaft(ratio):
    one = Segment(length=0.2, d_o=0.03, d_i=0.0, E=210e9, nu=0.3, rho=7850.0)
    return SegmentedShaft(segments=(one, one), ratio=ratio)


@pytest.fixture
def rotor():
    """The inner shaft turns against the outer one; stations 0 to 2 and 3 to 5."""
    return TransferMatrixRotor(
        shafts=(shaft(1.0), shaft(-1.5)),
        discs=(StationDisc(node=1, mass=2.0, polar=8e-3, diametral=4e-3),),
        supports=tuple(StationSupport(node=n, kxx=5e7) for n in (0, 2, 5)),
        links=(StationLink(a=1, b=4, kxx=1e8),),
    )  # fmt: skip


def unlike(rotor):
    first, *rest = rotor.supports
    return replace(rotor, supports=(replace(first, kyy=2e7), *rest))


def test_branches_begin_in_pairs_and_part_with_the_speed(rotor):
    at_speed = study(rotor, NAMES, 100.0, {}, 6).modes
    speeds, w, sense = branches(rotor, 500.0, at_speed, 6)
    assert (len(speeds), w.shape, sense) == (20, (20, 6), (1, 1, 1, -1, -1, -1))
    assert w[0, :3] == pytest.approx(w[0, 3:])
    assert not np.allclose(w[-1, :3], w[-1, 3:], rtol=1e-4)
    other = unlike(rotor)
    at_speed = study(other, NAMES, 100.0, {}, 6).modes
    assert branches(other, 500.0, at_speed, 6)[2] == tuple(at_speed.whirl)


def test_each_shaft_has_its_critical_speeds_and_opposite_ones_with_equal_bearings(rotor):
    found = study(rotor, NAMES, 100.0, {1.0: {1: 1e-5}, -1.5: {4: 1e-5}, 0.0: {}}, 6)
    assert [one.shafts for one in found.excited] == [("outer",), ("inner",)]
    assert [one.ratio for one in found.excited] == ratios(rotor) == [1.0, -1.5]
    assert len(found.responses) == 2
    forward, backward = (one.modes for one in found.excited)
    assert set(forward.whirl) == {1}
    assert set(backward.whirl) == {-1}
    assert backward.w == pytest.approx(1.5 * backward.speeds)
    assert ratios(replace(rotor, shafts=(shaft(1.0), shaft(0.0)))) == [1.0]
    found = opposite_criticals(rotor)
    assert found == sorted(found)
    assert len(found) > 2
    assert opposite_criticals(unlike(rotor)) == []
