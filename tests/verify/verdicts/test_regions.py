"""How far the errors of a study are off straight lines between neighbours."""

from types import SimpleNamespace

import numpy as np
import pytest

from verify.studies.validity.messages import over
from verify.verdicts import evidence, regions


def line(x, spacing="even"):
    axis = SimpleNamespace(spacing=spacing)
    return SimpleNamespace(axis=axis, x=np.array(x, float), points=np.arange(len(x)))


@pytest.mark.parametrize(
    ("x", "error", "spacing", "off"),
    [
        ((1, 2, 3), (0.0, 0.1, 0.2), "even", 0.0),
        ((1, 2, 3), (0.0, 0.15, 0.2), "even", 0.05),
        ((1, 2, 5), (0.0, 0.1, 0.4), "even", 0.0),
        ((1, 10, 100), (0.0, 0.1, 0.2), "log", 0.0),
        ((1, 2, 3, 4), (0.0, np.nan, 0.2, 0.4), "even", 0.2 / 3),
        ((1, 2), (0.0, 0.1), "even", None),
    ],
)
def test_interpolation_is_tried_at_each_point_between_two_others(
    monkeypatch, x, error, spacing, off
):
    monkeypatch.setattr(regions, "lines", lambda *_: [line(x, spacing)])
    plan = SimpleNamespace(star=True, points=np.zeros((len(x), 1)))
    course = SimpleNamespace(error=np.array(error))
    assert regions.interpolation(plan, course) == (
        None if off is None else pytest.approx(off, rel=0.3, abs=1e-12)
    )


@pytest.mark.parametrize(
    "row",
    [
        "polyhedral-pressure/hoop stress, Eq. 9, against that of the outside",
        "polyhedral-ring/K of the paper",
    ],
)
def test_each_point_inside_a_range_keeps_its_limit(row):
    """Of stored studies; the ends of a range are values that were compared."""
    case, _, quantity = row.partition("/")
    studies = evidence._studies(SimpleNamespace(case=case, quantity=quantity))
    assert studies
    for found in (one for one in regions.ranges(studies) if one.box):
        plan, course = next(s for s in studies if over(s[0]) == found.over)
        inside = np.ones(len(plan.points), bool)
        for k, axis in enumerate(plan.axes):
            shown = np.array([axis.shown(x) for x in plan.points[:, k]])
            held = np.zeros(len(shown), bool)
            for side in (one for one in found.box if one.name == axis.name):
                assert {side.low, side.high} <= set(shown)
                held = (shown >= side.low) & (shown <= side.high)
            alone = found.is_star & (plan.points != plan.points[0]).any(axis=1)
            varied = plan.points[:, k] != plan.points[0, k]
            inside &= held | (alone & ~varied)  # of a star another input is varied there
        size = np.abs(course.error) + course.U_error
        assert (size[inside] <= found.limit).all()
