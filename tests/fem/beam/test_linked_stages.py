"""Frames whose tips touch one after the other: a bar with two stops in closed form."""

import numpy as np
import pytest

from fem.beam.linked_stages import LinkedFrame, opposite
from fem.beam.links import Link
from fem.beam.section import Section

EA, L = 100.0, 1.0


def bar(gaps):
    """Three pieces in a row, and two beside them that nodes 0 and 1 come to touch."""
    points = np.array([[0.0, 0], [1, 0], [2, 0], [3, 0], [0.5, 1], [1.5, 1], [3, 1]])
    chords = np.array([[0, 1], [1, 2], [2, 3], [4, 5], [5, 6]])
    ends = np.array([[0, 4], [1, 5]])
    links = [Link(first=i, second=j, direction=(1.0, 0.0), value=-g)
             for (i, j), g in zip(ends.tolist(), gaps, strict=True)]  # fmt: skip
    return LinkedFrame(
        points, chords, ends, Section(EA=EA, EI=1.0), head=0,
        supports={0: "yr", 1: "yr", 3: "xyr", 4: "yr", 5: "yr", 6: "xyr"}, links=links,
    )  # fmt: skip


def test_a_bar_touches_its_stops_in_turn():
    """Three pieces in a row under F move node 0 by 3 F L/(E A) and node 1 by 2 F L/(E A)."""
    found = bar((10.0, 0.2)).stages()
    assert found["k1"] == pytest.approx(EA / (3 * L), rel=1e-9)
    assert found["F_A"] == pytest.approx(0.2 * EA / (2 * L), rel=1e-9)
    assert found["U_A"] == pytest.approx(0.3, rel=1e-9)
    rest = EA / (2 * L) + EA / (1.5 * L)  # of both rows behind the first stop
    assert found["k2"] == pytest.approx(1 / (L / EA + 1 / rest), rel=1e-9)
    assert found["k3"] == pytest.approx(1 / (L / (2 * EA) + 1 / rest), rel=1e-9)
    assert found["F_B"] == pytest.approx(found["F_A"] + (10.0 - 0.3) * EA / L, rel=1e-9)
    assert abs(found["push"]) < 1e-9 * found["F_A"]


@pytest.mark.parametrize("normal", ["force", "leaf"])
def test_the_place_opposite_of_a_tip_lies_on_the_normal_of_force_or_leaf(normal):
    slope = np.radians(80)
    along = np.array([np.cos(slope), np.sin(slope)])
    points = np.vstack([[0.0, 5.0], *(np.array([3.0, 0.0]) + s * along for s in range(11))])
    leaf = np.column_stack([np.arange(1, 11), np.arange(2, 12)])
    found = opposite(points, leaf, 0, normal, 0.0)
    ends = points[leaf[found.element]]
    place = ends[0] + found.share * (ends[1] - ends[0])
    n = np.array(found.direction)
    assert place - points[0] == pytest.approx(found.gap * n, abs=1e-12)
    wanted = (1.0, 0.0) if normal == "force" else (np.sin(slope), -np.cos(slope))
    assert n == pytest.approx(wanted, abs=1e-12)
