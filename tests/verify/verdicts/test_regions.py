"""How far the errors of a study are off straight lines between neighbours."""

from types import SimpleNamespace

import numpy as np
import pytest

from verify.verdicts import regions


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
