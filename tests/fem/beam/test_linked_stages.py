"""Frames whose tips touch one after the other, and the lines and kinks of their curves."""

import numpy as np
import pytest

from fem.beam.linked_stages import LinkedFrame, opposite
from fem.beam.links import Link
from fem.beam.section import Section
from fem.beam.two_lines import fitted, on_common, retraced, touching

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


mm = 1e-3


def kinked(U, U_A=12 * mm, k1=600.0, k2=750.0):
    """Two straight lines and the normal force that grows from the kink on."""
    F = np.where(U > U_A, k1 * U_A + k2 * (U - U_A), k1 * U)
    return np.array([U, F, np.maximum(0, 300 * (U - U_A))])


def test_two_lines_are_found_again():
    found = fitted(kinked(np.arange(1, 18) * mm), 17 * mm)
    assert (found.k1, found.k2) == pytest.approx((600, 750), rel=1e-12)
    assert pytest.approx((12 * mm, 12 * mm), rel=1e-12) == (found.U_A, found.U)
    assert (found.F_A, found.c1, found.c2) == pytest.approx((7.2, 0, -1.8), abs=1e-12)
    # a stroke that ends before A has one line, one that ends at it no second slope
    found = fitted(kinked(np.arange(1, 11) * mm), 17 * mm)
    assert found.k1 == pytest.approx(600, rel=1e-12)
    assert np.isnan([found.k2, found.c2, found.U_A, found.F_A, found.U]).all()
    found = fitted(kinked(np.arange(1, 15) * mm), 17 * mm)
    assert pytest.approx(12 * mm) == found.U_A
    assert np.isnan(found.k2)
    assert np.isnan(fitted(kinked(np.arange(1, 3) * mm), 17 * mm).k1)
    # touching is read from two states past it
    U = np.array([11, 11.5, 12.2, 12.4, 13]) * mm
    assert touching(*kinked(U)) == pytest.approx((12 * mm, 7.2, 750), rel=1e-12)
    assert np.isnan(touching(*kinked(U[:2]))).all()
    assert np.isnan(touching(*kinked(U[:3]))).all(), "one state gives no slope"


def test_curves_are_compared_in_the_states_that_both_have():
    fine, coarse = kinked(np.arange(1, 18) * mm), kinked(np.arange(2, 24, 2) * mm * (1 + 1e-12))
    one, other = on_common(fine, coarse, 17 * mm)
    assert one[0] == pytest.approx(np.arange(2, 17, 2) * mm)
    assert other == pytest.approx(one, rel=1e-9, abs=1e-9)
    assert fitted(one, 17 * mm).apart(fitted(other, 17 * mm)) < 1e-9


def test_forces_that_are_not_retraced_are_found():
    U = np.array([1, 2, 3, 2, 1]) * mm
    assert retraced(U, 600 * U) < 1e-14
    assert retraced(U, np.where(np.arange(5) > 2, 1.01, 1.0) * U) == pytest.approx(0.01)
