"""Plots of several curves, and rows whose reference is another method than finite elements."""

import re

import numpy as np
import pytest

from reports import formats
from reports.curves import curves
from reports.rows import HEADER, cells
from reports.standalone import HERE
from verify.core.figures import Band, Curve, Curves

X = np.linspace(0.0, 4.0, 5)


def plot(**changes):
    given = {
        "title": "T", "x_label": "y [mm]", "y_label": "p [MPa]",
        "curves": (
            Curve(name="strips", x=X, y=X + 1),
            Curve(name="half-space", x=X, y=X + 2, style="dots", colour=4),
            Curve(name="", x=X, y=X + 3, style="dashes", colour=2),
        ),
    }  # fmt: skip
    return str(curves(Curves(**given | changes)))


def test_curves_have_their_styles_and_names_and_one_without_a_name_has_none():
    drawn = plot()
    assert drawn.count(">strips<") == drawn.count(">half-space<") == 1
    assert drawn.count('class="fit s0 strokes"') == 2  # the curve and its swatch
    assert drawn.count('class="fit s2 dashes"') == 1
    assert drawn.count('class="dot s4"') == X.size + 1
    assert "<title>" not in drawn
    assert 'aria-label="T"' in drawn


@pytest.mark.parametrize("style", ["line", "dashes"])
def test_every_colour_has_its_own_pattern_of_strokes(style):
    drawn = plot(curves=tuple(Curve(name="a", x=X, y=X, style=style, colour=k) for k in range(6)))
    css = (HERE / "figures.css").read_text("utf-8")
    rules = dict(re.findall(r"\.chart \.([\w.]+) \{ stroke-dasharray: ([^;]+);", css))
    classes = re.findall(r'class="fit (s\d) (\w+)"', drawn)
    patterns = {rules.get(f"{kind}.{colour}", "plain") for colour, kind in classes}
    assert len(patterns) == 6


def test_what_runs_off_is_cut_at_the_top_and_at_the_bottom():
    assert plot(y_top=3.0).count('class="dot s4"') == 2 + 1  # 2 and 3 of 2 to 6
    assert plot(y_bottom=4.0).count('class="dot s4"') == 3 + 1


def test_axes_start_at_zero_unless_values_are_negative_or_stated_otherwise():
    assert ">0<" in plot()
    assert ">0<" not in plot(y_bottom=2.5, curves=(Curve(name="a", x=X + 1, y=X + 3),))


@pytest.fixture(scope="module")
def by_half_space(report):
    return next(
        row for case in report.cases for row in case.rows
        if row.grid is not None and row.by == "half-space" and row.analytic and row.interval
    )  # fmt: skip


def test_another_method_stands_where_finite_elements_do_with_its_name(by_half_space):
    row = by_half_space
    assert row.fem is None
    assert row.reference == row.partner.value == row.grid.levels[-1][1]
    shown = formats.values(row)
    assert shown.by == "half-space"
    assert "(" in shown.fem
    found = dict(zip(HEADER, cells(row), strict=True))
    assert (found["by"], found["fem"], found["reference"]) == ("half-space", None, row.reference)


BAND = Band(name="ensemble", x=X, lower=X + 1, upper=X + 3, colour=1)


def test_a_band_lies_between_its_curves_and_is_named():
    drawn = plot(bands=(BAND,))
    assert drawn.count('class="area s1"') == 2  # and in the key
    assert ">ensemble<" in drawn
    assert drawn.index('class="area s1"') < drawn.index('class="fit s0 strokes"')  # behind
    (area,) = re.findall(r'<path class="area s1" d="M([^"]*)z"', drawn)
    line = re.search(r'class="fit s0 strokes" d="M([^"]*)"', drawn)[1]
    points = {tuple(p.split(",")) for p in area.split("L")}
    assert {tuple(p.split(",")) for p in line.split("L")} <= points  # x + 1 is its lower edge


def test_on_a_logarithmic_axis_decades_are_equally_far_and_zero_is_left_out():
    y = np.array([0.0, 1.0, 10.0, 100.0, 1000.0])
    drawn = plot(curves=(Curve(name="a", x=X, y=y, style="dots", colour=0),), y_log=True)
    at = [float(v) for v in re.findall(r'class="dot s0" cx="[\d.]+" cy="([\d.]+)"', drawn)[:-1]]
    assert len(at) == 4
    assert np.ptp(np.diff(at)) < 0.21
    assert np.diff(at).max() < -40  # upwards
    assert drawn.count("</tspan></text>") == 4  # 1 to 1000 as powers of ten
