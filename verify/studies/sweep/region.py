"""Range of use of a formula: points at which its error stays within a limit.

A point is inside a limit if the whole error bar is within the limit, and outside if the whole error
bar is beyond the limit. Otherwise, the point is undecided. It is unsolved if formula or finite
elements have no value. A box is a product of ranges of the axes in which all points are inside.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from verify.core.figures import Array
from verify.studies.sweep.axes import Axis
from verify.studies.sweep.boxes import largest_box
from verify.studies.sweep.outcome import Course
from verify.studies.sweep.plan import Plan

LIMITS = (0.02, 0.05, 0.10)  # of the error
INSIDE, OUTSIDE, UNDECIDED, UNSOLVED = 1, -1, 0, -9
SAME = 1e-9  # of an axis: places and distances along it that differ by less are equal
NAMES = {INSIDE: "inside", OUTSIDE: "outside", UNDECIDED: "undecided", UNSOLVED: "unsolved"}

Verdicts = NDArray[np.int8]
Points = NDArray[np.intp]


@dataclass(frozen=True)
class Range:
    """Range of values [SI] of an axis; `whole` is True if it contains the complete axis."""

    axis: Axis
    low: float
    high: float
    whole: bool


@dataclass(frozen=True)
class Break:
    """The first violation of the limit if one input is changed from the base point.

    `last` is the last value [SI] inside, and `first` the next value, which is not inside. `at` is
    the value between them at which the end of the error bar reaches the limit by linear
    interpolation. It is None if `first` is unsolved or the input is a whole number. `why` is the
    reason if `first` is unsolved.
    """

    axis: Axis
    last: float
    first: float
    at: float | None
    verdict: int
    why: str

    @property
    def up(self) -> bool:
        """Whether the violation occurs at larger values of the input."""
        return self.first > self.last


@dataclass(frozen=True)
class Region:
    """Region of a sweep in which one formula is within one `limit`.

    `box` is the largest box, with `held` points; it is empty if no point is inside. For a star, it
    contains the longest range on each axis. `base` [SI] is the point from which `breaks` is
    searched. If the point nearest to the nominal inputs is inside, this point is the base, and
    `nominal` is True. Otherwise, the base is the middle of the box, or None for a star.
    `at_nominal` is the verdict at the point nearest to the nominal inputs, None if these are
    outside the grid.
    """

    limit: float
    inside: int
    outside: int
    undecided: int
    unsolved: int
    box: tuple[Range, ...]
    held: int
    base: tuple[float, ...] | None
    nominal: bool
    at_nominal: int | None
    breaks: Break | None

    @property
    def points(self) -> int:
        """Number of all points of the sweep."""
        return self.inside + self.outside + self.undecided + self.unsolved

    @property
    def everywhere(self) -> bool:
        """Whether every point is inside the limit."""
        return self.inside == self.points


@dataclass(frozen=True)
class Line:
    """Points along one axis with the other inputs constant.

    `x` are the values [SI] in ascending order, and `points` the rows of the plan.
    """

    axis: Axis
    x: Array
    points: Points
    base: int  # index in x


def verdicts(error: Array, U_error: Array, limit: float) -> Verdicts:
    """INSIDE, OUTSIDE, UNDECIDED or UNSOLVED for errors with uncertainties, arrays of any shape."""
    size = np.abs(error)
    found = np.full(size.shape, UNDECIDED, dtype=np.int8)
    with np.errstate(invalid="ignore"):
        found[size + U_error <= limit] = INSIDE
        found[size - U_error > limit] = OUTSIDE
    found[~(np.isfinite(error) & np.isfinite(U_error))] = UNSOLVED
    return found


def regions(plan: Plan, course: Course, limits: Sequence[float] = LIMITS) -> tuple[Region, ...]:
    """Regions of the pair `course` within each limit.

    Raises ValueError for a sample, which has no axes.
    """
    if not plan.axes:
        raise ValueError("a region requires a grid or a star, got a sample")
    return tuple(_region(plan, course, limit) for limit in limits)


def _region(plan: Plan, course: Course, limit: float) -> Region:
    found = verdicts(course.error, course.U_error, limit)
    counts = {name: int((found == verdict).sum()) for verdict, name in NAMES.items()}
    ranges, middle, held = (_of_star if plan.star else _of_grid)(plan, found)
    nominal = nominal_point(plan)
    at_nominal = None if nominal is None else int(found[nominal])
    base = nominal if at_nominal == INSIDE else middle
    return Region(
        limit=limit, **counts, box=ranges, held=held,
        base=None if base is None else tuple(float(v) for v in plan.points[base]),
        nominal=base is not None and base == nominal, at_nominal=at_nominal,
        breaks=None if base is None else _first_break(course, found, lines(plan, base), limit),
    )  # fmt: skip


def _of_grid(plan: Plan, found: Verdicts) -> tuple[tuple[Range, ...], int | None, int]:
    """Ranges of the largest box, row number of its middle, and its number of points."""
    box = largest_box((found == INSIDE).reshape(plan.shape))
    if box is None:
        return (), None, 0
    middle = [(i + j) // 2 for i, j in box.ranges]
    ranges = tuple(
        _range(one, one.values[i], one.values[j])
        for one, (i, j) in zip(plan.axes, box.ranges, strict=True)
    )
    return ranges, int(np.ravel_multi_index(middle, plan.shape)), box.points


def _of_star(plan: Plan, found: Verdicts) -> tuple[tuple[Range, ...], int | None, int]:
    """Longest range on each axis, None instead of a middle, and number of points in the ranges."""
    ranges, rows = [], set[int]()
    for line in lines(plan, 0):
        if box := largest_box(found[line.points] == INSIDE):
            i, j = box.ranges[0]
            ranges.append(_range(line.axis, line.x[i], line.x[j]))
            rows |= set(line.points[i : j + 1].tolist())
    return tuple(ranges), None, len(rows)


def _range(axis: Axis, low: float, high: float) -> Range:
    whole = low <= axis.values[0] and high >= axis.values[-1]
    return Range(axis, float(low), float(high), bool(whole))


def nominal_point(plan: Plan) -> int | None:
    """Row number of the point nearest to the nominal inputs; None if they are outside the grid.

    A star contains the nominal inputs as its first row.
    """
    if plan.star:
        return 0
    near = []
    for one in plan.axes:
        room = SAME * (one.values[-1] - one.values[0])
        if one.nominal is None or not (
            one.values[0] - room <= one.nominal <= one.values[-1] + room
        ):
            return None
        place = _places(one, np.array([*one.values, one.nominal]))
        apart = np.abs(place[:-1] - place[-1])
        near.append(int(np.argmax(apart <= apart.min() + SAME * np.ptp(place))))
    return int(np.ravel_multi_index(near, plan.shape))


def lines(plan: Plan, base: int) -> Iterator[Line]:
    """Line along each axis through the point in row `base` (for a star, through its centre)."""
    at = plan.points[base]
    for k, axis in enumerate(plan.axes):
        rows = np.flatnonzero((np.delete(plan.points, k, axis=1) == np.delete(at, k)).all(axis=1))
        rows = rows[np.argsort(plan.points[rows, k], kind="stable")]
        x = plan.points[rows, k]
        yield Line(axis, x, rows, int(np.flatnonzero(x == at[k])[0]))


def _first_break(
    course: Course, found: Verdicts, every: Iterator[Line], limit: float
) -> Break | None:
    """First violation of the limit, or None.

    The first violation has the least distance from the base point, relative to the length of the
    axis. A violation is a point that is outside the limit or undecided. An unsolved point ends a
    line, and is reported only if no line has a violation.
    """
    best, least = None, (True, np.inf)
    for line in every:
        for way in (range(line.base + 1, len(line.x)), range(line.base - 1, -1, -1)):
            out = next((i for i in way if found[line.points[i]] != INSIDE), None)
            if out is None:
                continue
            one = _break(course, found, line, out - way.step, out, limit)
            reached = one.first if one.at is None else one.at
            place = _places(line.axis, np.array([line.x[line.base], reached, *line.x[[0, -1]]]))
            share = abs(place[1] - place[0]) / (place[3] - place[2])
            unsolved = one.verdict == UNSOLVED
            if (unsolved, share + SAME) < least:  # of equal ones the first
                best, least = one, (unsolved, float(share))
    return best


def _break(
    course: Course, found: Verdicts, line: Line, last: int, out: int, limit: float
) -> Break:  # fmt: skip
    inner, outer = line.points[last], line.points[out]
    at = None
    if found[outer] != UNSOLVED and not line.axis.whole:
        # the end of the bar that lies beyond, as a straight line between the two points
        sign = np.sign(course.error[outer]) or 1.0
        a, b = (sign * course.error[k] + course.U_error[k] - limit for k in (inner, outer))
        at = float(line.x[last] + (line.x[out] - line.x[last]) * a / (a - b))
    return Break(
        line.axis, float(line.x[last]), float(line.x[out]), at, int(found[outer]),
        course.problems[outer],
    )  # fmt: skip


def _places(axis: Axis, values: Array) -> Array:
    """Positions of the values on the axis: logarithms if the spacing is logarithmic."""
    return np.log(np.maximum(values, np.finfo(float).tiny)) if axis.spacing == "log" else values
