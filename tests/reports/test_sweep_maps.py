"""Maps and curves of a measured error: the right class at the right place, lines and strips."""

import re

import numpy as np
import pytest

from reports import svg
from reports.error_cells import Cells, isoline
from reports.error_scale import UNSOLVED, classes, css, edges
from reports.measured import LIMITS, Measured, all_within, undecided
from reports.validity_map import measured, validity_map

X, Y = np.array([3.0, 6.0, 12.0]), np.array([1.0, 2.0])
ERROR = np.array([[0.03, -0.3], [0.0, 0.0], [0.0, np.nan]])
NONE = np.zeros_like(ERROR)


def grid(**changes):
    given = {"title": "K", "x": X, "x_label": "z", "y": Y, "y_label": "b [mm]",
             "error": ERROR, "U": NONE}  # fmt: skip
    return Measured(**given | changes)


def line(error, U=0.0, **changes):
    error = np.asarray(error, dtype=float)
    given = {"title": "K", "x": np.arange(float(len(error))), "x_label": "z", "error": error,
             "U": np.full(len(error), U)}  # fmt: skip
    return Measured(**given | changes)


def paths(page, style):
    return [re.findall(r"-?[\d.]+", d)
            for d in re.findall(rf'<path class="{style}" d="([^"]*)"', str(page))]  # fmt: skip


def test_limits_are_edges_of_classes():
    assert edges(LIMITS) == pytest.approx((0.005, 0.01, 0.02, 0.035, 0.05, 0.075, 0.1, 0.2))
    error = np.array([0.0, 0.02, 0.0201, -0.05, -0.0501, 0.1, 0.11, -7.0, np.nan])
    assert classes(error, LIMITS).tolist() == [0, 2, 3, -4, -5, 6, 7, -8, UNSOLVED]
    assert [css(k) for k in (3, -3, 0, UNSOLVED)] == ["over3", "under3", "exact", "unsolved"]


def test_columns_are_x_and_rows_are_y_from_the_bottom():
    page = measured(grid())
    (over,) = paths(page, "over3")  # error[0, 0]: the first x, the first y
    (under,) = paths(page, "under8")  # error[0, 1]
    (none,) = paths(page, "unsolved")[:1]  # error[2, 1]
    assert float(over[0]) == float(under[0]) < float(none[0])
    assert float(under[1]) == float(none[1]) < float(over[1])


def test_cells_whose_bar_reaches_across_a_limit_are_hatched():
    U = np.full_like(ERROR, 0.001)
    assert not undecided(ERROR, U, LIMITS).any()
    U[0, 0] = 0.011  # 3 % and 1.1 %: perhaps within 2 %
    assert undecided(ERROR, U, LIMITS).sum() == 1
    assert "error bar across a limit" in measured(grid(U=U))
    assert len(paths(validity_map(grid(U=U)), "hatch")) == 1
    assert "hatch" not in validity_map(grid())


def test_a_level_is_passed_where_a_plane_has_it():
    x, y = np.meshgrid(np.arange(5.0), np.arange(4.0), indexing="ij")
    pieces = isoline(x + 2 * y, 3.3)
    assert len(pieces)
    assert (pieces @ [1.0, 2.0]).ravel() == pytest.approx(np.full(2 * len(pieces), 3.3))
    lengths = np.hypot(*(pieces[:, 0] - pieces[:, 1]).T)  # from (3.3, 0) to (0, 1.65)
    assert lengths.sum() == pytest.approx(np.hypot(3.3, 1.65))


def test_the_region_takes_its_cells_whole():
    page = measured(grid(box=((6.0, 12.0), (1.0, 1.0)), box_name="within 5 %"))
    (corners, _key) = paths(page, "region")
    cells = Cells((62.0, 26.0, 392.0, 26.0 + 56.0), 3, 2)
    wanted = [cells.X(1), cells.Y(0), cells.X(3), cells.Y(0), cells.X(3), cells.Y(1)]
    assert list(map(float, corners[:6])) == pytest.approx(wanted, abs=0.06)
    assert ">within 5 %<" in page


@pytest.mark.parametrize(
    ("largest", "words"),
    [(2.3e-8, "all within 0.000003 %"), (-4e-4, "all within 0.04 %"), (0.0, "no difference"),
     (6e-4, ""), (9.5e-7, "all within 0.0001 %")],
)  # fmt: skip
def test_errors_too_small_for_a_picture_are_stated_in_words(largest, words):
    error = np.zeros((3, 2))
    error[1, 1] = largest
    assert all_within(error, NONE) == words
    assert words in measured(grid(error=error))
    assert words in validity_map(line(error[:, 1]))
    assert not re.search(r'"(over|under)\d"', str(validity_map(grid(error=error))))


@pytest.mark.parametrize(
    ("low", "high", "values"),
    [(1, 1000, [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000]), (35, 60, [35, 40, 45, 50, 55, 60]),
     (1e-3, 1e9, [10.0**k for k in (-3, -1, 1, 3, 5, 7, 9)])],
)  # fmt: skip
def test_ticks_of_a_logarithmic_axis(low, high, values):
    assert svg.log_ticks(low, high) == pytest.approx(values)


def test_a_curve_breaks_where_nothing_is_solved():
    page = str(measured(line([0.0, 0.01, np.nan, 0.01, 0.02])))
    assert len(paths(page, "error")) == 2
    assert len(paths(page, "bar")) == 2
    assert len(paths(page, "none")) == 1
