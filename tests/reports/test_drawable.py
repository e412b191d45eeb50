"""Figures without points say so; none has an axis of "nan"."""

import numpy as np
import pytest

from reports.html import plot
from verify.core.figures import (
    Bars,
    Curve,
    Curves,
    Density,
    Dots,
    Map,
    Panel,
    Profile,
    Refinement,
    Shapes,
    Zone,
    Zones,
)

NAMES = {"title": "T", "x_label": "x", "y_label": "y"}
NONE, LOST, X = np.array([]), np.full(3, np.nan), np.linspace(0.0, 1.0, 3)
SAID = "nothing to draw"


def curve(x, y, name="c"):
    return Curve(name=name, x=x, y=y)


@pytest.mark.parametrize("lost", [NONE, LOST], ids=["no points", "nan"])
def test_a_figure_without_points_says_so(lost):
    z = np.full((lost.size, lost.size), np.nan)
    profile = dict.fromkeys(("x", "y", "x_fem", "y_fem", "y_ref", "u"), lost)
    items = tuple(("a", float(v)) for v in lost)
    for figure in (
        Curves(**NAMES, curves=(curve(lost, lost),)), Curves(**NAMES, curves=()),
        Profile(**NAMES, **profile, scale=1.0),
        Refinement(**NAMES, cells=lost, errors=(("e", lost),), order=2.0),
        Dots(title="T", label="l", items=tuple((*i, None, "fe") for i in items)),
        Bars(title="T", label="l", items=tuple((*i, "words") for i in items)),
        Shapes(title="T", unit="mm", panels=(Panel(name="p", lines=(lost[:, None] * (1, 1),)),)),
        Zones(**NAMES, x=lost, zones=(Zone(name="z", top=lost, tone="good"),), y_top=1.0),
        Density(**NAMES, z_label="z", x=lost, y=lost, z=z),
        Map(**NAMES, columns=(), rows=(), error=z),
    ):  # fmt: skip
        drawn = str(plot(figure))
        assert SAID in drawn, type(figure)
        assert "nan" not in drawn


@pytest.mark.parametrize("gap", [np.nan, np.inf])
def test_curves_keep_their_finite_points(gap):
    held = curve(X, np.array([1.0, gap, 3.0]), "held")
    drawn = str(plot(Curves(**NAMES, curves=(held, curve(X, LOST, "lost")))))
    assert "nan" not in drawn
    assert "inf" not in drawn
    assert ">held<" in drawn
    assert ">lost<" not in drawn
