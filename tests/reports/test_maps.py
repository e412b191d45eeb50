"""Maps of a quantity and of an error: colours at their positions, names and bounds."""

import base64
import io
import re

import numpy as np
import pytest
from PIL import Image

from reports import svg
from reports.density import density
from reports.error_cells import Cells, isoline
from reports.error_map import error_map, percent
from reports.error_scale import UNSOLVED, classes, css, edges
from reports.measured import LIMITS, Measured, all_within, undecided
from reports.ramps import UNSIGNED
from reports.validity_map import measured, validity_map
from verify.core.figures import Density, Map

NAMES = {"title": "K", "x_label": "z", "y_label": "b [mm]"}


def pixels(z, **more):
    x, y = np.linspace(0.0, 60.0, 61), np.linspace(-4.5, 4.5, 41)
    page = str(density(Density(**NAMES, z_label="p [MPa]", x=x, y=y, z=z, **more)))
    data = re.search(r'base64,([^"]*)"', page)[1]
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(data))).convert("RGBA")).astype(int)


def near(colour, name):
    return np.abs(colour[:3] - np.array(list(bytes.fromhex(name[1:])))).max() < 12


def test_a_density_begins_below_left_and_has_no_colour_without_a_value():
    z = np.zeros((41, 61))
    z[:10, :10] = 1.0
    z[20:] = np.nan
    seen = pixels(z)
    assert near(seen[-3, 3], UNSIGNED[-1])
    assert near(seen[-3, -3], UNSIGNED[0])
    assert (seen[10, 100, 3], seen[-10, 100, 3]) == (0, 255)


def test_every_cell_of_an_error_map_has_its_shade_its_number_and_its_mark():
    error = np.array([[0.004, -0.03, 0.08], [0.019, 0.051, np.nan]])
    given = {**NAMES, "columns": ("3", "6", "12"), "rows": ("0.05", "0.10"), "error": error,
             "without": "does not expand"}  # fmt: skip
    page = str(error_map(Map(**given)))
    for shade, cells in (("m0", 2), ("m1", 1), ("m2", 2), ("m3", 0), ("none", 1)):
        assert page.count(f'<rect class="{shade}"') == cells
    for words in ("0.4", "−3.0", "8.0", "1.9", "5.1", "·"):
        assert f">{words}<" in page
    errors = (-1e-6, 0.0123, -0.0996, 0.5, 3.0, -1.2)
    assert [*map(percent, errors)] == ["0.0", "1.2", "−10", "50", ">99", "<−99"]
    low, high = (
        float(page.split(f'">{row}<')[0].rsplit(' y="', 1)[1].split('"')[0])
        for row in ("0.05", "0.10")
    )
    assert low > high  # the first row is at the bottom
    assert "circle" not in page
    checked = np.array([[True, False, False], [False, True, False]])
    page = str(error_map(Map(**given, checked=checked, checked_name="by finite elements")))
    assert page.count('<circle class="fe"') == 2 + 1  # and in the key
    assert ">by finite elements<" in page


X, Y = np.array([3.0, 6.0, 12.0]), np.array([1.0, 2.0])
ERROR = np.array([[0.03, -0.3], [0.0, 0.0], [0.0, np.nan]])
NONE = np.zeros_like(ERROR)


def grid(**changes):
    return Measured(**NAMES | {"x": X, "y": Y, "error": ERROR, "U": NONE} | changes)


def line(error):
    error = np.asarray(error, dtype=float)
    return Measured(title="K", x=np.arange(float(error.size)), x_label="z", error=error,
                    U=np.zeros(error.size))  # fmt: skip


def paths(page, style):
    return [re.findall(r"-?[\d.]+", d)
            for d in re.findall(rf'<path class="{style}" d="([^"]*)"', str(page))]  # fmt: skip


def test_limits_are_edges_of_classes():
    assert edges(LIMITS) == pytest.approx((0.005, 0.01, 0.02, 0.035, 0.05, 0.075, 0.1, 0.2))
    error = np.array([0.0, 0.02, 0.0201, -0.05, -0.0501, 0.1, 0.11, -7.0, np.nan])
    assert classes(error, LIMITS).tolist() == [0, 2, 3, -4, -5, 6, 7, -8, UNSOLVED]
    assert [css(k) for k in (3, -3, 0, UNSOLVED)] == ["over3", "under3", "exact", "unsolved"]


def test_measured_cells_lie_by_columns_and_rows_from_the_bottom_and_a_region_takes_them_whole():
    page = measured(grid(box=((6.0, 12.0), (1.0, 1.0)), box_name="within 5 %"))
    (over,) = paths(page, "over3")  # error[0, 0]: the first x, the first y
    (under,) = paths(page, "under8")  # error[0, 1]
    (none,) = paths(page, "unsolved")[:1]  # error[2, 1]
    assert float(over[0]) == float(under[0]) < float(none[0])
    assert float(under[1]) == float(none[1]) < float(over[1])
    (box, _key) = paths(page, "region")
    cells = Cells((62.0, 26.0, 392.0, 26.0 + 56.0), 3, 2)
    wanted = [cells.X(1), cells.Y(0), cells.X(3), cells.Y(0), cells.X(3), cells.Y(1)]
    assert list(map(float, box[:6])) == pytest.approx(wanted, abs=0.06)


def test_cells_whose_bar_reaches_across_a_limit_are_hatched_and_curves_break():
    U = np.full_like(ERROR, 0.001)
    assert not undecided(ERROR, U, LIMITS).any()
    U[0, 0] = 0.011  # 3 % and 1.1 %: perhaps within 2 %
    assert undecided(ERROR, U, LIMITS).sum() == 1
    assert len(paths(validity_map(grid(U=U)), "hatch")) == 1
    assert "hatch" not in validity_map(grid())
    # a curve breaks where nothing is solved
    page = str(measured(line([0.0, 0.01, np.nan, 0.01, 0.02])))
    assert [len(paths(page, css)) for css in ("error", "bar", "none")] == [2, 2, 1]


def test_a_level_is_passed_where_a_plane_has_it():
    x, y = np.meshgrid(np.arange(5.0), np.arange(4.0), indexing="ij")
    pieces = isoline(x + 2 * y, 3.3)
    assert (pieces @ [1.0, 2.0]).ravel() == pytest.approx(np.full(2 * len(pieces), 3.3))
    lengths = np.hypot(*(pieces[:, 0] - pieces[:, 1]).T)  # from (3.3, 0) to (0, 1.65)
    assert lengths.sum() == pytest.approx(np.hypot(3.3, 1.65))


def test_errors_too_small_for_a_picture_are_stated_in_words():
    for largest, words in (
        (2.3e-8, "all errors within 0.000003 %"), (-4e-4, "all errors within 0.04 %"),
        (0.0, "no difference"),
        (6e-4, ""), (9.5e-7, "all errors within 0.0001 %"),
    ):  # fmt: skip
        error = np.zeros((3, 2))
        error[1, 1] = largest
        assert all_within(error, NONE) == words
        assert words in measured(grid(error=error))
        assert words in validity_map(line(error[:, 1]))
        assert not re.search(r'"(over|under)\d"', str(validity_map(grid(error=error))))


def test_ticks_of_a_logarithmic_axis():
    decade = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000]
    assert svg.log_ticks(1, 1000) == pytest.approx(decade)
    assert svg.log_ticks(35, 60) == pytest.approx([35, 40, 45, 50, 55, 60])
    assert svg.log_ticks(1e-3, 1e9) == pytest.approx([10.0**k for k in range(-3, 10, 2)])
