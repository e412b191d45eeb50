"""Where a formula holds: verdicts, the largest box, what breaks it first."""

from itertools import pairwise, product

import hypothesis.extra.numpy as hnp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.verify.sweep_made import CASE, Plate, chosen, course
from verify.studies.sweep import boxes
from verify.studies.sweep.boxes import Box, largest_box
from verify.studies.sweep.plan import grid, sample
from verify.studies.sweep.region import (
    INSIDE,
    OUTSIDE,
    UNDECIDED,
    UNSOLVED,
    lines,
    nominal_point,
    regions,
    verdicts,
)

NAN = np.nan


def planned(*vary, star=False, **inputs):
    return grid(CASE, "plate", Plate(**inputs), chosen(), vary, star=star)


def region(plan, limit, *given, **more):
    (found,) = regions(plan, course(plan, *given, **more), (limit,))
    return found


def mm(*values):
    return pytest.approx([v * 1e-3 for v in values], rel=1e-12)


# Verdicts


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(
    ("error", "U", "verdict"),
    [
        (0.0, 0.0, INSIDE),
        (0.5, 0.0, INSIDE),
        (0.25, 0.25, INSIDE),  # the bar ends at the limit
        (0.25, 0.375, UNDECIDED),
        (0.5, 0.125, UNDECIDED),
        (0.75, 0.25, UNDECIDED),  # it begins there
        (0.75, 0.125, OUTSIDE),
        (0.75, 0.0, OUTSIDE),
        (0.25, 2.0, UNDECIDED),
        (NAN, NAN, UNSOLVED),
        (0.25, NAN, UNSOLVED),
        (np.inf, 0.0, UNSOLVED),
    ],
)
def test_a_point_is_inside_with_its_whole_bar_and_outside_with_all_of_it(sign, error, U, verdict):
    assert verdicts(np.array([sign * error]), np.array([U]), 0.5) == [verdict]


# The largest box

small_grids = hnp.arrays(bool, hnp.array_shapes(min_dims=1, max_dims=3, max_side=5))


def holds(inside, ranges):
    return inside[tuple(slice(i, j + 1) for i, j in ranges)].all()


def every_box(inside):
    ends_of = [[(i, j) for i in range(n) for j in range(i, n)] for n in inside.shape]
    for ranges in product(*ends_of):
        if holds(inside, ranges):
            yield Box(ranges, int(np.prod([j - i + 1 for i, j in ranges])))


@given(small_grids)
def test_no_box_inside_holds_more_points_than_the_largest(inside):
    best = max(every_box(inside), key=lambda box: box.points, default=None)
    assert largest_box(inside) == best  # of boxes alike the first one, as max has it


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


def test_a_box_grows_where_a_grid_is_inside_deepest(monkeypatch):
    monkeypatch.setattr(boxes, "MOST_BOXES", 0)
    inside = np.zeros((9, 9), bool)
    inside[0, :] = inside[:, 0] = inside[8, :] = True  # the edges, not across the grid's ends
    inside[3:7, 3:8] = True
    assert largest_box(inside) == Box(((3, 6), (3, 7)), 20)
    assert largest_box(np.array([inside, inside])) == Box(((0, 1), (3, 6), (3, 7)), 40)
    assert largest_box(np.ones((4, 5), bool)) == Box(((0, 3), (0, 4)), 20)


# Regions of a grid


def test_a_grid_gives_shares_the_box_and_what_breaks_it_first():
    plan = planned("a=1:10mm:10", "b=1:5mm:5")  # 4 and 2 mm in the file
    a, b = plan.points.T * 1e3
    found = region(plan, 0.05, np.where(b < 5, 0.01 * a, 0.2), 0.005)
    # 1 % a + 0.5 % <= 5 % to a = 4; 1 % a - 0.5 % > 5 % from a = 6; 5 mm between
    assert (found.inside, found.undecided, found.outside, found.unsolved) == (16, 4, 30, 0)
    assert found.points == 50
    assert not found.everywhere
    assert [(r.axis.name, r.whole) for r in found.box] == [("a", False), ("b", False)]
    assert [v for r in found.box for v in (r.low, r.high)] == mm(1, 4, 1, 4)
    assert found.held == 16
    assert list(found.base) == mm(4, 2)
    assert (found.nominal, found.at_nominal) == (True, INSIDE)
    by = found.breaks
    assert (by.axis.name, by.up, by.verdict) == ("a", True, UNDECIDED)
    assert [by.last, by.first, by.at] == mm(4, 5, 4.5)


def test_a_whole_grid_inside_has_nothing_that_breaks_it():
    found = region(planned("a=1:4mm:4", "n=2:6:5"), 0.05, 0.01)
    assert found.everywhere
    assert [r.whole for r in found.box] == [True, True]
    assert found.held == found.points == 20
    assert found.breaks is None


def test_a_formula_that_holds_nowhere_has_no_box():
    found = region(planned("a=1:4mm:4"), 0.05, 0.2)
    assert (found.outside, found.box, found.held, found.base) == (4, (), 0, None)
    assert (found.breaks, found.at_nominal) == (None, OUTSIDE)


def test_the_break_is_the_one_next_to_the_nominal_point_as_a_share_of_the_axis():
    plan = planned("a=1:5mm:5", "b=1:9mm:9", a=3e-3, b=5e-3)
    a, b = np.round(plan.points.T * 1e3)
    # a passes 5 % at 3.91 mm, 23 % of its axis away, b at 3.8 mm, 15 %
    by = region(plan, 0.05, np.where(a > 3, 0.051, np.where(b < 4, 0.09, 0.04))).breaks
    assert (by.axis.name, by.up) == ("b", False)
    assert [by.last, by.first, by.at] == mm(4, 3, 3.8)
    # a at 3.2 mm, 5 %, b at 3.52 mm, 18 %
    by = region(plan, 0.05, np.where(a > 3, 0.09, np.where(b < 4, 0.061, 0.04))).breaks
    assert (by.axis.name, by.at) == ("a", pytest.approx(3.2e-3))


@pytest.mark.parametrize("off", [-1e-13, 0.0, 1e-13])
def test_round_off_chooses_no_point_and_no_break(off):
    halfway = planned("a=1:4mm:2:log", a=2e-3 * (1 + off))
    assert nominal_point(halfway) == 0
    plan = planned("a=1:3mm:3", "b=1:3mm:3", a=2e-3, b=2e-3 * (1 + off))
    a, b = np.round(plan.points.T * 1e3)
    by = region(plan, 0.05, np.where((a != 2) | (b != 2), 0.06 * (1 + off), 0.04)).breaks
    assert (by.axis.name, by.up) == ("a", True)


def test_an_error_that_changes_its_sign_is_followed_through_zero():
    plan = planned("a=1:3mm:3", a=2e-3)
    found = region(plan, 0.05, [-0.04, -0.03, 0.07], 0.01)
    # from -3 % to 7 %, the bar's upper end from -2 % to 8 %
    assert [found.breaks.last, found.breaks.first, found.breaks.at] == mm(2, 3, 2.7)
    found = region(plan, 0.05, [0.04, 0.03, -0.07], 0.01)
    assert [found.breaks.last, found.breaks.first, found.breaks.at] == mm(2, 3, 2.7)


def test_an_axis_in_equal_ratios_is_measured_in_ratios():
    plan = planned("a=1:100mm:3:log", "b=1:3mm:3", a=10e-3)
    a, b = np.round(plan.points.T * 1e3)
    # up from 10 mm to 46 mm is a third of two decades, b = 2 to 2.8 mm two fifths of its axis
    up = np.where(a > 10, 0.11, np.where(b > 2, 0.0625, 0.0))
    by = region(plan, 0.05, up).breaks
    assert (by.axis.name, by.at) == ("a", pytest.approx(10e-3 + 90e-3 * 5 / 11))
    assert region(plan, 0.05, np.where(a > 10, 0.0501, up)).breaks.axis.name == "b"


def test_whole_numbers_have_no_crossing_between_them():
    by = region(planned("n=1:6:6"), 0.05, [0, 0, 0, 0.04, 0.08, 0.2]).breaks
    assert (by.last, by.first, by.at, by.verdict, by.why) == (4, 5, None, OUTSIDE, "")


def test_an_unsolved_point_breaks_and_says_why_and_counts_on_no_side():
    found = region(planned("a=1:6mm:6"), 0.05, [0.01, 0.01, 0.01, 0.01, NAN, 0.2])
    assert (found.inside, found.outside, found.unsolved) == (4, 1, 1)
    by = found.breaks
    assert (by.first, by.at, by.verdict) == (pytest.approx(5e-3), None, UNSOLVED)
    assert by.why == "does not converge"
    assert [found.box[0].low, found.box[0].high] == mm(1, 4)


def test_a_point_without_an_answer_hides_no_true_limit_that_lies_further_off():
    found = region(planned("a=1:6mm:6"), 0.05, [0.2, 0.01, 0.01, 0.01, NAN, 0.01])
    by = found.breaks
    assert (by.up, by.first, by.verdict) == (False, pytest.approx(1e-3), OUTSIDE)


def test_breaks_are_looked_for_from_the_middle_of_the_box_where_the_nominal_point_is_outside():
    plan = planned("a=1:9mm:9", a=1.2e-3)
    found = region(plan, 0.05, [0.2, 0.2, 0.2, 0.01, 0.01, 0.01, 0.01, 0.01, 0.2])
    assert (found.nominal, found.at_nominal) == (False, OUTSIDE)
    assert list(found.base) == mm(6)
    beyond = region(planned("a=1:9mm:9", a=20e-3), 0.05, 0.01)
    assert (beyond.nominal, beyond.at_nominal, list(beyond.base)) == (False, None, mm(5))


def test_the_nominal_point_is_the_one_of_the_grid_next_to_it():
    plan = planned("a=1:4mm:4", "n=2:6:5", a=2.4e-3, n=4)
    assert plan.points[nominal_point(plan)].tolist() == [pytest.approx(2e-3), 4]
    log = planned("a=1:100mm:3:log", a=40e-3)
    assert log.points[nominal_point(log)] == pytest.approx(100e-3)  # 32 mm lies half way
    assert nominal_point(planned("a=1:4mm:4", a=4e-3)) == 3
    assert nominal_point(planned("a=1:4mm:4", a=4.1e-3)) is None


def test_lines_run_through_a_point_along_each_axis():
    plan = planned("a=1:3mm:3", "b=1:2mm:2", "n=1:2:2")
    found = list(lines(plan, 7))  # a = 2, b = 2, n = 2
    assert [line.points.tolist() for line in found] == [[3, 7, 11], [5, 7], [6, 7]]
    assert [line.base for line in found] == [1, 1, 1]


# A star


def test_a_star_has_a_range_for_each_axis_and_breaks_from_its_middle():
    plan = planned("a=1:7mm:4", "b=1:4mm:4", star=True)  # a = 4 mm is none of the values
    a, b = np.round(plan.points.T * 1e3)
    found = region(plan, 0.05, np.where(a > 4, 0.09, np.where(b > 3, 0.2, 0.01)))
    assert [(r.axis.name, r.whole) for r in found.box] == [("a", False), ("b", False)]
    assert [v for r in found.box for v in (r.low, r.high)] == mm(1, 4, 1, 3)
    assert found.held == 5  # the middle once
    assert (found.inside, found.outside) == (5, 3)
    assert (found.nominal, found.at_nominal) == (True, INSIDE)
    assert list(found.base) == mm(4, 2)
    assert found.breaks.axis.name == "a"
    assert [found.breaks.last, found.breaks.first, found.breaks.at] == mm(4, 5, 4.5)


def test_a_star_whose_middle_is_outside_has_ranges_but_nothing_to_break_from():
    plan = planned("a=1:7mm:4", "b=1:4mm:4", star=True)
    a, _ = np.round(plan.points.T * 1e3)
    found = region(plan, 0.05, np.where(a > 4, 0.01, 0.2))
    assert [r.axis.name for r in found.box] == ["a"]
    assert [found.box[0].low, found.box[0].high] == mm(5, 7)
    assert (found.base, found.breaks, found.at_nominal) == (None, None, OUTSIDE)


def test_a_sample_has_no_region():
    plan = sample(CASE, "plate", Plate(), chosen(), "sobol:8", ["a=±1mm"])
    with pytest.raises(ValueError, match="needs axes"):
        regions(plan, course(plan, 0.0))


@given(
    hnp.arrays(float, (4, 3), elements=st.floats(-0.2, 0.2)),
    hnp.arrays(float, (4, 3), elements=st.floats(0, 0.05)),
)
def test_limits_that_allow_more_hold_more(error, U):
    plan = planned("a=1:4mm:4", "b=1:3mm:3")
    found = regions(plan, course(plan, error.ravel(), U.ravel()))
    for tight, wide in pairwise(found):
        assert tight.inside <= wide.inside
        assert tight.outside >= wide.outside
        assert tight.held <= wide.held
