"""What plots draw and how they name it."""

import re
from dataclasses import replace

import numpy as np
import pytest

from reports.plots import Axes, convergence, profile
from reports.refinement import refinement
from verify.core.figures import Profile, Refinement
from verify.core.results import Grid, Kind, Row, Status

X = np.linspace(0.0, 1.0, 5)
PROFILE = Profile(
    title="p", x_label="x", y_label="p [MPa]", x=X, y=X, x_fem=X, y_fem=X + 0.02, y_ref=X,
    u=np.full(5, 0.02), scale=2.0,
)  # fmt: skip
CELLS = np.array([8.0, 12.0, 24.0])
FINER = Refinement(
    title="finer", x_label="cells", y_label="error", cells=CELLS,
    errors=(("a", 1 / CELLS**2), ("b", 1 / CELLS**2)), order=2.0,
)  # fmt: skip


def words(drawing):
    return re.sub("<[^>]*>", "", re.sub('aria-label="[^"]*"', "", drawing))


@pytest.mark.parametrize(
    ("changed", "told"),
    [
        ({}, "(formula − reference)/(2 MPa), in 10"),
        ({"scale_name": "p"}, "(formula − reference)/p, in 10"),
        ({"scale": 1.0}, "formula − reference, in 10"),
        ({"y_label": "p"}, "(formula − reference)/2, in 10"),
    ],
)
def test_a_difference_is_named_by_what_divides_it(changed, told):
    drawn = words(profile(replace(PROFILE, **changed)))
    assert told in drawn
    assert ("/" in drawn) == ("/" in told)


def test_a_line_of_many_points_is_drawn_by_few_and_looks_the_same():
    """Four hundred points of a bend and of two straight parts."""
    axes = Axes((52, 28, 390, 262), (0.0, 4.0), (0.0, 1.0))
    x = np.linspace(0.0, 4.0, 400)
    y = np.clip(x - 1, 0, 1) ** 2
    axes.curve(x, y, "fit")
    (path,) = re.findall(r'd="M([^"]*)"', str(axes.body[0]))
    u, v = np.array([point.split(",") for point in path.split("L")], float).T
    assert u.size < 40
    assert np.interp(52 + x * 338 / 4, u, v) == pytest.approx(
        262 - 234 * y, abs=0.4
    )  # x is to a tenth


def test_errors_of_theory_lie_on_their_lines_and_the_line_has_the_order():
    drawn = refinement(FINER)
    x, y = np.array(
        re.findall(r'circle class="s0" cx="([\d.]+)" cy="([\d.]+)"', drawn), float
    )[:3].T  # fmt: skip
    line = re.search(r'class="fit s0" d="M([^"]*)"', drawn)[1]
    ends = np.array([point.split(",") for point in line.split("L")], float)
    order = np.argsort(ends[:, 0])
    assert np.interp(x, *ends[order].T) == pytest.approx(y, abs=0.15)
    assert len(set(y)) == 3


def test_an_error_of_zero_is_left_out_and_zeros_alone_draw_nothing():
    some = replace(FINER, errors=(("a", np.array([1e-2, 0.0, 1e-4])),))
    assert refinement(some).count("<circle") == 2
    assert not refinement(replace(FINER, errors=(("a", np.zeros(3)),)))


def test_rows_whose_levels_show_no_order_are_not_drawn_as_if_they_had_one():
    levels = ((1.0, 4.0), (0.5, 1.0), (0.25, 0.25))
    grid = Grid(unit="1", levels=levels, scale=1.0, allowed=1.0, behaviour="monotone", gci=0.1,
                u_it=0.0, order=2.0, formal=2.0, used=2.0, factor=1.25)  # fmt: skip
    row = Row(case="c", quantity="q", symbol="q", unit="1", kind=Kind.IDENTITY, status=Status.PASS,
              levels=levels, grid=grid, order=2.0, formal_order=2.0)  # fmt: skip
    assert convergence([row])
    noisy = replace(grid, behaviour="noisy", order=None, used=None, factor=None)
    assert not convergence([replace(row, grid=noisy, order="noisy")])
