"""Plots of curves, profiles, refinements and states: positions and names."""

import re
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest

from reports.axes import WIDTH, Axes
from reports.convergence import convergence
from reports.curves import curves
from reports.figures import plot
from reports.plots import profile
from reports.refinement import refinement
from reports.shapes import shapes
from reports.standalone import HERE
from tests.reports.paths import corners
from verify.core.figures import (
    Band,
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
from verify.core.results import Grid, Kind, Row, Status

X = np.linspace(0.0, 4.0, 5)
NAMES = {"title": "T", "x_label": "y [mm]", "y_label": "p [MPa]"}
THREE = (
    Curve(name="strips", x=X, y=X + 1),
    Curve(name="half-space", x=X, y=X + 2, style="dots", colour=4),
    Curve(name="", x=X, y=X + 3, style="dashes", colour=2),
)


def drawn(*lines, **changes):
    return str(curves(Curves(**NAMES, curves=lines or THREE, **changes)))


def test_curves_have_their_styles_and_names_and_are_cut_at_the_frame():
    page = drawn()
    assert page.count(">strips<") == page.count(">half-space<") == 1
    assert page.count('class="fit s0 strokes"') == 2  # the curve and its swatch
    assert page.count('class="fit s2 dashes"') == 1  # no name, no swatch
    assert page.count('class="dot s4"') == X.size + 1
    assert drawn(y_top=3.0).count('class="dot s4"') == 2 + 1  # 2 and 3 of 2 to 6
    assert drawn(y_bottom=4.0).count('class="dot s4"') == 3 + 1
    assert ">0<" not in drawn(Curve(name="a", x=X + 1, y=X + 3), y_bottom=2.5)  # where it begins
    # every colour has another pattern of strokes
    css = (HERE / "figures.css").read_text("utf-8")
    rules = dict(re.findall(r"\.chart \.([\w.]+) \{ stroke-dasharray: ([^;]+);", css))
    for style in ("line", "dashes"):
        page = drawn(*(Curve(name="a", x=X, y=X, style=style, colour=k) for k in range(6)))
        classes = re.findall(r'class="fit (s\d) (\w+)"', page)
        assert len({rules.get(f"{kind}.{colour}", "plain") for colour, kind in classes}) == 6


def test_a_band_lies_behind_between_its_curves_and_is_named():
    page = drawn(bands=(Band(name="ensemble", x=X, lower=X + 1, upper=X + 3, colour=1),))
    assert page.count('class="area s1"') == 2  # and in the key
    assert ">ensemble<" in page
    assert page.index('class="area s1"') < page.index('class="fit s0 strokes"')
    area, line = corners(page, "area s1")[0], corners(page, "fit s0 strokes")[0]
    assert set(map(tuple, line)) <= set(map(tuple, area))  # x + 1 is its lower edge


def test_on_a_logarithmic_axis_decades_are_equally_far_and_zero_is_left_out():
    y = np.array([0.0, 1.0, 10.0, 100.0, 1000.0])
    page = drawn(Curve(name="a", x=X, y=y, style="dots", colour=0), y_log=True)
    at = [float(v) for v in re.findall(r'class="dot s0" cx="[\d.]+" cy="([\d.]+)"', page)[:-1]]
    assert len(at) == 4
    assert np.ptp(np.diff(at)) < 0.21
    assert np.diff(at).max() < -40  # upwards
    assert page.count("</tspan></text>") == 4  # 1 to 1000 as powers of ten


def test_a_line_of_many_points_is_drawn_by_few_and_looks_the_same():
    axes = Axes((52, 28, 390, 262), (0.0, 4.0), (0.0, 1.0))
    x = np.linspace(0.0, 4.0, 400)
    y = np.clip(x - 1, 0, 1) ** 2  # a bend and two straight parts
    axes.curve(x, y, "fit")
    (line,) = corners(axes.body[0], "fit")
    assert len(line) < 40
    assert np.interp(52 + x * 338 / 4, *line.T) == pytest.approx(262 - 234 * y, abs=0.4)


def test_the_difference_of_a_profile_is_above_zero_and_named_by_what_divides_it():
    drawn = Profile(
        **NAMES, x=X, y=X, x_fem=X, y_fem=X - 1.0, y_ref=X, u=np.full(5, 0.02), scale=2.0
    )
    for changed, named in (
        ({}, "(formula − reference)/(2 MPa), in 10"),
        ({"scale_name": "p"}, "(formula − reference)/p, in 10"),
        ({"scale": 1.0}, "formula − reference, in 10"),
        ({"y_label": "p"}, "(formula − reference)/2, in 10"),
    ):
        page = str(profile(replace(drawn, **changed)))
        assert named in re.sub("<[^>]*>", "", re.sub('aria-label="[^"]*"', "", page))
        # the formula is larger: above the line of zero, in the middle of 204 and 262
        assert max(float(y) for y in re.findall(r'cy="([\d.]+)"', page)[-5:]) < 233


def test_errors_of_theory_lie_on_their_lines_and_those_of_zero_are_left_out():
    cells = np.array([8.0, 12.0, 24.0])
    errors = (("a", 1 / cells**2), ("b", 1 / cells**2))
    finer = Refinement(**NAMES, cells=cells, errors=errors, order=2.0)
    found = re.findall(r'circle class="s0" cx="([\d.]+)" cy="([\d.]+)"', refinement(finer))
    x, y = np.array(found, float)[:3].T
    ends = corners(refinement(finer), "fit s0")[0]
    assert np.interp(x, *ends[np.argsort(ends[:, 0])].T) == pytest.approx(y, abs=0.15)
    assert len(set(y)) == 3
    some = replace(finer, errors=(("a", np.array([1e-2, 0.0, 1e-4])),))
    assert refinement(some).count("<circle") == 2
    assert not refinement(replace(finer, errors=(("a", np.zeros(3)),)))


def test_rows_whose_levels_show_no_order_are_not_drawn_as_if_they_had_one():
    levels = ((1.0, 4.0), (0.5, 1.0), (0.25, 0.25))
    grid = Grid(unit="1", levels=levels, scale=1.0, allowed=1.0, behaviour="monotone", gci=0.1,
                u_it=0.0, order=2.0, formal=2.0, used=2.0, factor=1.25)  # fmt: skip
    row = Row(case="c", quantity="q", symbol="q", unit="1", kind=Kind.IDENTITY, status=Status.PASS,
              levels=levels, grid=grid, order=2.0, formal_order=2.0)  # fmt: skip
    assert convergence([row])
    noisy = replace(grid, behaviour="noisy", order=None, used=None, factor=None)
    assert not convergence([replace(row, grid=noisy, order="noisy")])


LONG = np.array([[0.0, 0.0], [20.0, 0.0], [20.0, 5.0]])
SHORT = np.array([[0.0, 0.0], [8.0, 0.0], [8.0, 5.0]])


def states(*panels, **changes):
    return str(shapes(Shapes(title="States", unit="mm", panels=panels, thickness=0.1, **changes)))


def test_all_states_have_one_scale_that_a_bar_names_and_contacts_are_dots():
    dots = np.array([[4.0, 0.0]])
    bent = Panel(name="A", lines=(SHORT,), faint=(LONG,), dots=dots)
    page = states(Panel(name="O", lines=(LONG,)), bent, dots_name="contact")
    free, bent = corners(page, "strip")
    assert np.ptp(free[:, 0]) / np.ptp(bent[:, 0]) == pytest.approx(20 / 8, rel=0.01)
    assert np.ptp(free[:, 1]) == pytest.approx(np.ptp(bent[:, 1]), abs=0.11)
    assert np.ptp(free[:, 0]) / np.ptp(free[:, 1]) == pytest.approx(4, rel=0.01)
    assert free[2, 1] < free[0, 1]  # up is up
    named = float(re.search(r">([\d.]+) mm<", page)[1])
    length = np.ptp(corners(page, "base")[0][:, 0]) / named
    assert length == pytest.approx(np.ptp(free[:, 0]) / 20, rel=0.01)
    assert page.count('<circle class="fe"') == 1 + 1  # and in the key
    assert len(corners(page, "fit faint")) == 1


def test_no_state_leaves_the_picture_or_lies_on_another():
    for count, size in ((1, (60, 1)), (9, (1, 60)), (9, (60, 1))):
        line = np.array([[0.0, 0.0], size])
        page = states(*(Panel(name=f"state {k}", lines=(line,)) for k in range(count)))
        height = float(re.search(rf'viewBox="0 0 {WIDTH:g} ([\d.]+)"', page)[1])
        boxes = [(p.min(axis=0), p.max(axis=0)) for p in corners(page, "strip")]
        for low, high in boxes:
            assert (low >= 0).all()
            assert (high <= (WIDTH, height)).all()
        for (low, high), (other_low, other_high) in combinations(boxes, 2):
            assert (low > other_high).any() or (other_low > high).any()


def curve(x, y, name="c"):
    return Curve(name=name, x=x, y=y)


@pytest.mark.parametrize("lost", [np.array([]), np.full(3, np.nan)], ids=["none", "nan"])
def test_a_figure_without_points_states_this(lost):
    z = np.full((lost.size, lost.size), np.nan)
    points = dict.fromkeys(("x", "y", "x_fem", "y_fem", "y_ref", "u"), lost)
    items = tuple(("a", float(v)) for v in lost)
    for figure in (
        Curves(**NAMES, curves=(curve(lost, lost),)), Curves(**NAMES, curves=()),
        Profile(**NAMES, **points, scale=1.0),
        Refinement(**NAMES, cells=lost, errors=(("e", lost),), order=2.0),
        Dots(title="T", label="l", items=tuple((*i, None, "fe") for i in items)),
        Bars(title="T", label="l", items=tuple((*i, "words") for i in items)),
        Shapes(title="T", unit="mm", panels=(Panel(name="p", lines=(lost[:, None] * (1, 1),)),)),
        Zones(**NAMES, x=lost, zones=(Zone(name="z", top=lost, tone="good"),), y_top=1.0),
        Density(**NAMES, z_label="z", x=lost, y=lost, z=z),
        Map(**NAMES, columns=(), rows=(), error=z),
    ):  # fmt: skip
        page = str(plot(figure))
        assert "nothing to draw" in page, type(figure)
        assert "nan" not in page


def test_curves_keep_their_finite_points_and_lose_those_without_any():
    for gap in (np.nan, np.inf):
        held = curve(X[:3], np.array([1.0, gap, 3.0]), "held")
        page = drawn(held, curve(X, np.full(5, np.nan), "lost"))
        assert not re.search("nan|inf|>lost<", page)
        assert ">held<" in page
