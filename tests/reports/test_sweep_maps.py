"""Maps and curves of a measured error: the right class at the right place, lines and strips."""

import re

import numpy as np
import pytest

from reports import svg
from reports.curves import curves
from reports.error_cells import Cells, isoline
from reports.error_scale import UNSOLVED, classes, css, edges, scale
from reports.measured import LIMITS, Measured, all_within, undecided
from reports.validity_map import measured, scale_key, validity_map
from verify.core.figures import Curve, Curves

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


def test_the_scale_names_a_limit_where_its_class_ends():
    drawn = [str(part) for part in scale(0.0, 0.0, 170.0, LIMITS)]
    starts = {re.search(r'class="(\w+)"', p)[1]: float(re.search(r' x="([-\d.]+)"', p)[1])
              for p in drawn if p.startswith("<rect")}  # fmt: skip
    named = {re.sub("<.*?>", "", p): float(re.search(r' x="([-\d.]+)"', p)[1])
             for p in drawn if p.startswith("<text")}  # fmt: skip
    assert named["+2"] == starts["over3"]
    assert named["+5"] == starts["over5"]
    assert named["+10"] == starts["over7"]
    assert named["−2"] == starts["under2"]
    assert named["−10"] == starts["under6"]


def test_columns_are_x_and_rows_are_y_from_the_bottom():
    page = measured(grid())
    (over,) = paths(page, "over3")  # error[0, 0]: the first x, the first y
    (under,) = paths(page, "under8")  # error[0, 1]
    (none,) = paths(page, "unsolved")[:1]  # error[2, 1]
    assert float(over[0]) == float(under[0]) < float(none[0])
    assert float(under[1]) == float(none[1]) < float(over[1])


def test_neighbours_of_one_class_are_one_piece():
    cells = Cells((0.0, 0.0, 30.0, 20.0), 3, 2)
    member = np.array([[True, False], [True, False], [False, True]])
    d = re.search(r'd="([^"]*)"', str(cells.filled(member, "s")))[1]
    assert d == "M0,10H20V20H0zM20,0H30V10H20z"


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


def test_no_line_of_equal_error_passes_what_is_not_solved():
    x, _ = np.meshgrid(np.arange(5.0), np.arange(4.0), indexing="ij")
    x[2, 1] = np.nan
    pieces = isoline(x, 1.5)
    assert (pieces[..., 1] >= 2).all()
    assert not len(isoline(x[:1], 0.5))


def test_the_inputs_of_the_file_are_marked_between_cells_and_not_outside():
    at = re.search(r'class="at" cx="([\d.]+)"', str(validity_map(grid(nominal=(4.5, 1.0)))))
    cells = Cells((52.0, 0.0, 312.0, 1.0), 3, 2)
    assert float(at[1]) == pytest.approx(cells.X(1.0), abs=0.1)  # halfway from 3 to 6
    assert "circle" not in validity_map(grid(nominal=(2.0, 1.0)))


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
def test_errors_too_small_for_a_picture_are_told_in_words(largest, words):
    error = np.zeros((3, 2))
    error[1, 1] = largest
    assert all_within(error, NONE) == words
    assert words in measured(grid(error=error))
    assert words in validity_map(line(error[:, 1]))
    assert not re.search(r'"(over|under)\d"', str(validity_map(grid(error=error))))


def test_bars_count_among_errors_too_small_for_a_picture():
    error, U = np.array([2e-6, np.nan]), np.array([5e-6, np.nan])
    assert all_within(error, U) == "all within 0.0007 %"
    assert not all_within(error, np.array([0.03, np.nan]))
    assert not all_within(error, np.array([np.nan, np.nan]))


def test_the_value_in_the_file_is_marked_on_the_axis_of_a_curve():
    error = [0.0, 0.01, np.nan]
    inner, outer = (measured(line(error, nominal=(v,))) for v in (1.5, 2.5))
    x, y = re.search(r'<circle class="at" cx="([\d.]+)" cy="([\d.]+)"', str(inner)).groups()
    assert float(x) == pytest.approx(46 + 0.75 * (400 - 46 - 10), abs=0.1)
    assert float(y) == pytest.approx(330 - 38 - 30, abs=0.1)  # not on the curve
    assert 'class="at"' not in outer


def test_a_place_between_equal_ratios_is_told_by_ratio():
    where = grid(x=np.array([1.0, 10.0, 100.0]), log=(True, False), nominal=(10**0.5, 1.0))
    at = re.search(r'class="at" cx="([\d.]+)"', str(validity_map(where)))
    assert float(at[1]) == pytest.approx(Cells((52.0, 0.0, 312.0, 1.0), 3, 2).X(1.0), abs=0.1)


@pytest.mark.parametrize(
    ("low", "high", "values"),
    [(1, 1000, [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000]), (35, 60, [35, 40, 45, 50, 55, 60]),
     (1e-3, 1e9, [10.0**k for k in (-3, -1, 1, 3, 5, 7, 9)])],
)  # fmt: skip
def test_ticks_of_a_logarithmic_axis(low, high, values):
    assert svg.log_ticks(low, high) == pytest.approx(values)


def test_points_of_equal_ratios_are_evenly_apart():
    x = np.array([1.0, 10.0, 100.0])
    page = str(curves(Curves(title="", x_label="F", y_label="", x_log=True,
                             curves=(Curve(name="", x=x, y=x, style="dots"),))))  # fmt: skip
    places = [float(v) for v in re.findall(r'<circle class="dot s0" cx="([\d.]+)"', page)]
    assert places == pytest.approx([52, 221, 390], abs=0.1)


def test_strips_are_filled_where_the_whole_band_is_within():
    page = str(measured(line([0.0, 0.03, 0.06, 0.2], U=0.001)))
    lengths = [float(d[2]) - float(d[0]) for d in paths(page, "held")]
    whole = 400.0 - 46.0 - 10.0
    # halfway to the neighbours: half a step, one, one and a half a step, of three
    assert lengths == pytest.approx(
        [whole / 6, *[whole / 6, whole / 3], *[whole / 6, whole / 3, whole / 3]], abs=0.11
    )


def test_a_curve_breaks_where_nothing_is_solved():
    page = str(measured(line([0.0, 0.01, np.nan, 0.01, 0.02])))
    assert len(paths(page, "error")) == 2
    assert len(paths(page, "bar")) == 2
    assert len(paths(page, "none")) == 1


def test_small_errors_stay_small_beside_the_first_limit():
    heights = [float(y) for y in paths(measured(line([1e-6, -1e-6, 1e-6])), "error")[0][1::2]]
    assert max(heights) - min(heights) < 0.2


def test_large_errors_do_not_hide_the_limits():
    page = str(measured(line([0.01, 5.0, 30.0])))
    assert "NaN" not in page
    assert all(f">{words}<" in page for words in ("5", "100", "1000"))


def test_nothing_solved_is_drawn_as_such():
    for m in (line([np.nan] * 3), grid(error=np.full((3, 2), np.nan))):
        assert "nan" not in str(measured(m)) + str(validity_map(m))
    assert len(str(scale_key())) < 4000
