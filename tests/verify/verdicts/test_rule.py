"""The rule that makes a verdict of errors, each line of its table and its edges."""

import pytest

from verify.core.verdicts import Safe, Verdict
from verify.verdicts.rule import Point, accuracy, judged, on_unsafe_side


def points(*errors, U=0.0):
    """The first error is at the paper's inputs, the others are of a study."""
    return [Point(e, U, is_paper=i == 0) for i, e in enumerate(errors)]


@pytest.mark.parametrize(
    ("errors", "U", "safe", "has_range", "verdict"),
    [
        ((0.004, -0.009), 0.0, Safe.ABOVE, True, Verdict.ACCURATE),
        ((0.004,), 0.0, Safe.ABOVE, False, Verdict.PART),
        ((0.09, -0.09), 0.02, Safe.NEITHER, True, Verdict.UNSAFE),  # the bar counts
        ((0.02, -0.3), 0.0, Safe.ABOVE, True, Verdict.PART),  # the paper's inputs hold
        ((0.3, -0.019), 0.0, Safe.ABOVE, True, Verdict.CONSERVATIVE),
        ((0.3, -0.03), 0.0, Safe.ABOVE, True, Verdict.PART),  # 2 % to 10 % on the unsafe side
        ((0.3,), 0.0, Safe.BELOW, False, Verdict.UNSAFE),
        ((-0.3,), 0.0, Safe.BELOW, False, Verdict.CONSERVATIVE),
        ((-0.3,), 0.0, Safe.NEITHER, False, Verdict.UNSAFE),
    ],
)
def test_each_line_of_the_rule(errors, U, safe, has_range, verdict):
    assert judged(points(*errors, U=U), safe, has_range=has_range) is verdict


@pytest.mark.parametrize(
    ("size", "limit"), [(0.0099, 0.01), (0.0101, 0.02), (0.05, 0.05), (0.0999, 0.1), (0.1001, None)]
)
def test_the_accuracy_class_is_the_least_that_holds_error_and_bar(size, limit):
    assert accuracy([Point(size - 0.001, 0.001), Point(0.0, 0.0)]) == limit
    assert accuracy([Point(0.001 - size, 0.001)]) == limit


def test_the_bar_counts_on_the_unsafe_side():
    both = points(0.05, -0.02, U=0.01)
    assert on_unsafe_side(both, Safe.BELOW) == pytest.approx(0.06)
    assert on_unsafe_side(both, Safe.ABOVE) == pytest.approx(0.03)
    assert on_unsafe_side(both, Safe.NEITHER) == pytest.approx(0.06)
