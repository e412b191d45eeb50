"""Plots of several curves, and rows whose reference is another method than finite elements."""

import re

import numpy as np
import pytest

from reports import formats
from reports.curves import curves
from reports.html import plot as html_plot
from reports.rows import HEADER, cells
from reports.standalone import HERE
from verify.core.figures import Band, Curve, Curves
from verify.core.results import Status
from verify.judging.explain.steps import derive

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


def test_every_colour_has_its_own_mark_and_shows_it_in_the_key():
    drawn = plot(curves=tuple(Curve(name="a", x=X, y=X, style="dots", colour=k) for k in range(6)))
    shapes = {
        k: {_shape(tag) for tag in re.findall(rf'<(?:path|circle) class="dot s{k}"[^>]*>', drawn)}
        for k in range(6)
    }
    assert all(len(found) <= 2 for found in shapes.values())  # the key's is a little larger
    assert len({min(found) for found in shapes.values()}) == 6


def _shape(tag):
    """A mark's path from its first point on, to a tenth as drawn."""
    if tag.startswith("<circle"):
        return "circle"
    points = np.array([p.split(",") for p in re.search(r'd="M([^z]*)z', tag)[1].split("L")], float)
    return str(np.round((points - points.mean(axis=0)) / 2.5).astype(int).tolist())


def test_what_runs_off_is_cut_at_the_top_and_at_the_bottom():
    assert plot(y_top=3.0).count('class="dot s4"') == 2 + 1  # 2 and 3 of 2 to 6
    assert plot(y_bottom=4.0).count('class="dot s4"') == 3 + 1


def test_axes_start_at_zero_unless_values_are_negative_or_told_otherwise():
    assert ">0<" in plot()
    assert ">0<" not in plot(y_bottom=2.5, curves=(Curve(name="a", x=X + 1, y=X + 3),))


def test_places_on_the_axis_may_have_names():
    named = plot(x_names=((1.0, "three"), (3.0, "twelve")))
    assert ">three<" in named
    assert ">twelve<" in named
    assert ">4<" not in named.split("y [mm]")[0].rsplit(">three<", 1)[-1]


def test_many_names_take_more_lines_and_a_taller_picture():
    few = plot(curves=(Curve(name="a", x=X, y=X),))
    many = plot(curves=tuple(Curve(name=f"a rather long name {i}", x=X, y=X) for i in range(6)))
    height = [float(p.split('viewBox="0 0 400 ')[1].split('"')[0]) for p in (few, many)]
    assert height[1] > height[0] + 30


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


def test_its_judging_names_it(by_half_space):
    steps = dict(derive(by_half_space).steps)
    assert "half-space" in steps
    assert "formula/half-space" in steps["m"]
    assert derive(by_half_space).verdict.status is Status.PASS


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


def test_a_band_alone_is_drawn_and_cut_at_the_top():
    drawn = str(html_plot(Curves(title="T", x_label="x", y_label="y", curves=(), bands=(BAND,),
                                 y_top=4.0)))  # fmt: skip
    (area,) = re.findall(r'<path class="area s1" d="M([^"]*)z"', drawn)
    assert min(float(p.split(",")[1]) for p in area.split("L")) == 28


def test_on_a_logarithmic_axis_decades_are_equally_far_and_zero_is_left_out():
    y = np.array([0.0, 1.0, 10.0, 100.0, 1000.0])
    drawn = plot(curves=(Curve(name="a", x=X, y=y, style="dots", colour=0),), y_log=True)
    at = [float(v) for v in re.findall(r'class="dot s0" cx="[\d.]+" cy="([\d.]+)"', drawn)[:-1]]
    assert len(at) == 4
    assert np.ptp(np.diff(at)) < 0.21
    assert np.diff(at).max() < -40  # upwards
    assert drawn.count("</tspan></text>") == 4  # 1 to 1000 as powers of ten


def test_less_than_two_decades_have_numbers_between_them():
    drawn = plot(curves=(Curve(name="a", x=X, y=X + 1),), y_log=True)
    assert all(f">{v}<" in drawn for v in ("1", "2", "5"))


def test_nothing_positive_on_a_logarithmic_axis_says_so():
    none = Curves(title="T", x_label="x", y_label="y", curves=(Curve(name="a", x=X, y=-X),),
                  y_log=True)  # fmt: skip
    assert "nothing to draw" in html_plot(none)
