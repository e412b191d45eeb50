"""Stored studies: every point with its error, resulting ranges, and other sizes of a part."""

from types import SimpleNamespace

import numpy as np
import pytest

from verify.cases.registry import CASES, find
from verify.core import units
from verify.core.inputs import meta
from verify.core.verdicts import Safe
from verify.studies.sweep.outcome import Course
from verify.studies.validity.messages import over
from verify.studies.validity.store import measured
from verify.verdicts import evidence, regions
from verify.verdicts.stored_points import studies


def of(name):
    return studies([SimpleNamespace(id=name, rows=())])


@pytest.mark.parametrize("name", [case.id for case in CASES if case.scans])
def test_all_stored_points_are_there_with_their_errors(name):
    found, record = of(name), measured(find(name))
    assert len(found) == len(record.scans)
    for study, (plan, courses) in zip(found, record.scans, strict=True):
        assert [f.quantity for f in study.formulas] == [c.pair.name for c in courses]
        assert len(set(study.points)) == len(study.points)
        for formula, course in zip(study.formulas, courses, strict=True):
            known = dict(zip(study.points, zip(formula.error, formula.U, strict=True), strict=True))
            for point, e, U in zip(plan.points, course.error, course.U_error, strict=True):
                at = tuple(axis.in_unit(v) for axis, v in zip(plan.axes, point, strict=True))
                np.testing.assert_array_equal(known[at], (e, U))


def test_a_study_has_its_ratio_in_any_unit_its_safe_side_and_each_point_once():
    torque, *_ = of("freewheel-torque")[0].axes
    case = find("freewheel-torque").inputs()
    shown = {one.name: one.own for one in torque.per}
    ratio = torque.factor * torque.own
    for one in torque.per:
        ratio /= shown[one.name] ** one.power
    assert torque.ratio == "T/(E R³)"
    assert ratio == pytest.approx(case.T / (case.E * case.R**3), rel=1e-9)
    assert torque.own * units.factor(torque.unit) == pytest.approx(case.T)
    # a side that a formula on the row declares
    safe = {f.quantity: f.safe for f in of("polyhedral-ring")[0].formulas}
    assert safe["K of the paper"] is Safe.ABOVE
    # a value that differs from that of the case in the last bit is the same point
    study = next(s for s in of("spring-accordion") if "α" in s.over and "r " in s.over)
    assert len(study.points) == 1 + 3 + 4 + 3
    assert study.points[0] == tuple(axis.own for axis in study.axes)
    # no study: of a case without one, or of a user's case
    results = [SimpleNamespace(id=name, rows=()) for name in ("freewheel-clutch", "own-case")]
    assert studies(results) == ()


def test_a_part_of_another_size_all_in_proportion_has_the_same_errors(judged, of_paper):
    """As the explorer supposes where every axis is a ratio, an angle, a number or a pressure."""
    case, own = find("polyhedral-pressure"), find("polyhedral-pressure").inputs()
    (study,) = of(case.id)
    assert all(axis.scales for axis in study.axes)
    lengths = {
        name: 1.25 * getattr(own, name) for name, field in type(own).model_fields.items()
        if meta(field)["unit"] == "mm"
    }  # fmt: skip
    assert "d_e" in lengths
    larger = judged(case, type(own)(**own.model_dump() | lengths), drawn=False)
    for row, known in zip(larger.rows, of_paper(case).rows, strict=True):
        if row.difference is not None and row.scale:
            error = known.difference / known.scale
            assert row.difference / row.scale == pytest.approx(error, abs=1e-9)


def test_at_each_point_of_two_studies_the_worse_error_counts():
    """An error of larger size with its bar, and none before any other."""
    plan = SimpleNamespace(case=SimpleNamespace(id="x"), names=("T",), points=np.arange(4.0))
    none = np.full(4, np.nan)

    def course(*error):
        return Course(pair=None, formula=none, fe=none, U=none, error=np.array(error),
                      U_error=np.array([0.1, 0.0, 0.0, 0.0]), problems=("",) * 4)  # fmt: skip

    one, other = course(0.1, -0.3, np.nan, 0.1), course(-0.2, 0.2, 0.1, np.nan)
    for both in ((one, other), (other, one)):
        ((_, found),) = evidence.joined([(plan, course) for course in both])
        np.testing.assert_array_equal(found.error, (-0.2, -0.3, np.nan, np.nan))


def test_interpolation_is_tried_at_each_point_between_two_others(monkeypatch):
    for x, error, spacing, off in (
        ((1, 2, 5), (0.0, 0.1, 0.4), "even", 0.0),
        ((1, 2, 3), (0.0, 0.15, 0.2), "even", 0.05),
        ((1, 10, 100), (0.0, 0.1, 0.2), "log", 0.0),
        ((1, 2, 3, 4), (0.0, np.nan, 0.2, 0.4), "even", 0.2 / 3),
    ):
        axis, points = SimpleNamespace(spacing=spacing), np.arange(len(x))
        line = SimpleNamespace(axis=axis, x=np.array(x, float), points=points)
        monkeypatch.setattr(regions, "lines", lambda *_, line=line: [line])
        plan = SimpleNamespace(star=True, points=points[:, None])
        found = regions.interpolation(plan, SimpleNamespace(error=np.array(error)))
        assert found == pytest.approx(off, rel=0.3, abs=1e-12)
    two = SimpleNamespace(axis=axis, x=np.array([1.0, 2.0]), points=points[:2])
    monkeypatch.setattr(regions, "lines", lambda *_: [two])
    assert regions.interpolation(plan, SimpleNamespace(error=np.zeros(4))) is None


def test_each_point_inside_a_range_keeps_its_limit():
    """Of stored studies; the ends of a range are values that were compared."""
    for row in (
        "polyhedral-pressure/hoop stress, Eq. 9, against the hoop stress at the outer surface",
        "polyhedral-ring/K of the paper",
    ):
        case, _, quantity = row.partition("/")
        stored = evidence._studies(SimpleNamespace(case=case, quantity=quantity))
        assert stored
        for found in (one for one in regions.ranges(stored) if one.box):
            plan, course = next(s for s in stored if over(s[0]) == found.over)
            inside = np.ones(len(plan.points), bool)
            for k, axis in enumerate(plan.axes):
                shown = np.array([axis.in_unit(x) for x in plan.points[:, k]])
                held = np.zeros(len(shown), bool)
                for side in (one for one in found.box if one.name == axis.name):
                    assert {side.low, side.high} <= set(shown)
                    held = (shown >= side.low) & (shown <= side.high)
                alone = found.is_star & (plan.points != plan.points[0]).any(axis=1)
                varied = plan.points[:, k] != plan.points[0, k]
                inside &= held | (alone & ~varied)  # of a star another input is varied there
            size = np.abs(course.error) + course.U_error
            assert (size[inside] <= found.limit).all()
