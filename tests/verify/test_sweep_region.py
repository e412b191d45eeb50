"""Range of validity of a formula: verdicts, the largest box, the first violated limit."""

from itertools import product

import hypothesis.extra.numpy as hnp
import numpy as np
import pytest
from hypothesis import given

from tests.verify.sweep_made import CASE, Plate, chosen, course
from verify.studies.sweep import boxes
from verify.studies.sweep import region as area
from verify.studies.sweep.boxes import Box, largest_box
from verify.studies.sweep.plan import grid
from verify.studies.sweep.region import nominal_point, regions, verdicts

INSIDE, OUTSIDE, UNDECIDED, UNSOLVED = area.NAMES
NAN = np.nan


def planned(*vary, star=False, **inputs):
    return grid(CASE, "plate", Plate(**inputs), chosen(), vary, star=star)


def region(plan, *given, limit=0.05):
    (found,) = regions(plan, course(plan, *given), (limit,))
    return found


def mm(*values):
    return pytest.approx([v * 1e-3 for v in values], rel=1e-12)


def test_a_point_is_inside_with_its_whole_bar_and_outside_with_all_of_it():
    for error, U, verdict in (
        (0.25, 0.25, INSIDE), (0.25, 0.375, UNDECIDED),  # the bar ends at the limit
        (0.75, 0.25, UNDECIDED), (0.75, 0.125, OUTSIDE),  # it begins there
        (NAN, NAN, UNSOLVED), (0.25, NAN, UNSOLVED),
    ):  # fmt: skip
        found = verdicts(np.array([error, -error]), np.array([U, U]), 0.5)
        assert list(found) == [verdict, verdict], (error, U)


# The largest box

small_grids = hnp.arrays(bool, hnp.array_shapes(min_dims=1, max_dims=3, max_side=5))


def holds(inside, ranges):
    return inside[tuple(slice(i, j + 1) for i, j in ranges)].all()


@given(small_grids)
def test_no_box_inside_holds_more_points_than_the_largest(inside):
    ends_of = [[(i, j) for i in range(n) for j in range(i, n)] for n in inside.shape]
    every = (
        Box(ranges, int(np.prod([j - i + 1 for i, j in ranges])))
        for ranges in product(*ends_of) if holds(inside, ranges)
    )  # fmt: skip
    best = max(every, key=lambda box: box.points, default=None)
    assert largest_box(inside) == best  # of equal boxes the first one, as with max


@given(small_grids)
def test_a_box_of_a_grid_too_large_to_search_cannot_be_widened(inside):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(boxes, "MOST_BOXES", 0)
        box = largest_box(inside)
    if box is None:
        assert not inside.any()
        return
    assert holds(inside, box.ranges)
    assert box.points == np.prod([j - i + 1 for i, j in box.ranges])
    for axis, (i, j) in enumerate(box.ranges):
        for wider in ((i - 1, j), (i, j + 1)):
            if wider[0] >= 0 and wider[1] < inside.shape[axis]:
                assert not holds(inside, [*box.ranges[:axis], wider, *box.ranges[axis + 1 :]])


# Regions of a grid


def test_a_grid_gives_shares_the_box_and_what_breaks_it_first():
    plan = planned("a=1:10mm:10", "b=1:5mm:5")  # 4 and 2 mm in the file
    a, b = plan.points.T * 1e3
    found = region(plan, np.where(b < 5, 0.01 * a, 0.2), 0.005)
    # 1 % a + 0.5 % <= 5 % to a = 4; 1 % a - 0.5 % > 5 % from a = 6; 5 mm between
    assert (found.inside, found.undecided, found.outside, found.unsolved) == (16, 4, 30, 0)
    assert [(r.axis.name, r.whole) for r in found.box] == [("a", False), ("b", False)]
    assert [v for r in found.box for v in (r.low, r.high)] == mm(1, 4, 1, 4)
    assert (found.held, found.everywhere) == (16, False)
    assert list(found.base) == mm(4, 2)
    assert (found.nominal, found.at_nominal) == (True, INSIDE)
    by = found.breaks
    assert (by.axis.name, by.up, by.verdict) == ("a", True, UNDECIDED)
    assert [by.last, by.first, by.at] == mm(4, 5, 4.5)


def test_the_break_is_the_one_next_to_the_nominal_point_as_a_share_of_the_axis():
    plan = planned("a=1:5mm:5", "b=1:9mm:9", a=3e-3, b=5e-3)
    a, b = np.round(plan.points.T * 1e3)
    # a passes 5 % at 3.91 mm, 23 % of its axis away, b at 3.8 mm, 15 %
    by = region(plan, np.where(a > 3, 0.051, np.where(b < 4, 0.09, 0.04))).breaks
    assert (by.axis.name, by.up) == ("b", False)
    assert [by.last, by.first, by.at] == mm(4, 3, 3.8)
    # a at 3.2 mm, 5 %, b at 3.52 mm, 18 %
    by = region(plan, np.where(a > 3, 0.09, np.where(b < 4, 0.061, 0.04))).breaks
    assert (by.axis.name, by.at) == ("a", pytest.approx(3.2e-3))
    # an axis in equal ratios is measured in ratios:
    # up from 10 mm to 46 mm is a third of two decades, b = 2 to 2.8 mm two fifths of its axis
    plan = planned("a=1:100mm:3:log", "b=1:3mm:3", a=10e-3)
    a, b = np.round(plan.points.T * 1e3)
    up = np.where(a > 10, 0.11, np.where(b > 2, 0.0625, 0.0))
    by = region(plan, up).breaks
    assert (by.axis.name, by.at) == ("a", pytest.approx(10e-3 + 90e-3 * 5 / 11))
    assert region(plan, np.where(a > 10, 0.0501, up)).breaks.axis.name == "b"


def test_where_an_error_passes_the_limit_between_two_points():
    for sign in (1, -1):  # through zero, from -3 % to 7 %, the bar's upper end from -2 % to 8 %
        errors = sign * np.array([-0.04, -0.03, 0.07])
        by = region(planned("a=1:3mm:3", a=2e-3), errors, 0.01).breaks
        assert [by.last, by.first, by.at] == mm(2, 3, 2.7)
    by = region(planned("n=1:6:6"), [0, 0, 0, 0.04, 0.08, 0.2]).breaks  # whole numbers
    assert (by.last, by.first, by.at, by.verdict, by.why) == (4, 5, None, OUTSIDE, "")
    by = region(planned("a=1:6mm:6"), [0.01, 0.01, 0.01, 0.01, NAN, 0.2]).breaks
    assert (by.first, by.at, by.verdict) == (pytest.approx(5e-3), None, UNSOLVED)
    assert by.why == "does not converge"
    # an unsolved point hides no true limit
    by = region(planned("a=1:6mm:6"), [0.2, 0.01, 0.01, 0.01, NAN, 0.01]).breaks
    assert (by.up, by.first, by.verdict) == (False, pytest.approx(1e-3), OUTSIDE)


def test_breaks_are_looked_for_from_the_middle_of_the_box_where_the_nominal_point_is_outside():
    plan = planned("a=1:9mm:9", a=1.2e-3)
    found = region(plan, [0.2, 0.2, 0.2, 0.01, 0.01, 0.01, 0.01, 0.01, 0.2])
    assert (found.nominal, found.at_nominal, list(found.base)) == (False, OUTSIDE, mm(6))
    beyond = region(planned("a=1:9mm:9", a=20e-3), 0.01)
    assert (beyond.nominal, beyond.at_nominal, list(beyond.base)) == (False, None, mm(5))
    # it is the point of the grid next to the file's inputs
    near = planned("a=1:4mm:4", "n=2:6:5", a=2.4e-3, n=4)
    assert near.points[nominal_point(near)].tolist() == [pytest.approx(2e-3), 4]
    log = planned("a=1:100mm:3:log", a=40e-3)
    assert log.points[nominal_point(log)] == pytest.approx(100e-3)  # 32 mm is the middle
    assert nominal_point(planned("a=1:4mm:4", a=4e-3)) == 3
    assert nominal_point(planned("a=1:4mm:4", a=4.1e-3)) is None


def test_a_star_has_a_range_for_each_axis_and_breaks_from_its_middle():
    plan = planned("a=1:7mm:4", "b=1:4mm:4", star=True)  # a = 4 mm is none of the values
    a, b = np.round(plan.points.T * 1e3)
    found = region(plan, np.where(a > 4, 0.09, np.where(b > 3, 0.2, 0.01)))
    assert [v for r in found.box for v in (r.low, r.high)] == mm(1, 4, 1, 3)
    assert (found.held, found.inside, found.outside) == (5, 5, 3)  # the middle once
    assert list(found.base) == mm(4, 2)
    assert [found.breaks.last, found.breaks.first, found.breaks.at] == mm(4, 5, 4.5)
    outside = region(plan, np.where(a > 4, 0.01, 0.2))
    assert [(r.low, r.high) for r in outside.box] == [mm(5, 7)]
    assert (outside.base, outside.breaks, outside.at_nominal) == (None, None, OUTSIDE)
