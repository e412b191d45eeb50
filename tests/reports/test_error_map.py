"""Maps of a formula's error: shades, numbers, steps between regions, and what was checked."""

import numpy as np
import pytest

from reports.error_map import error_map, percent
from verify.core.figures import Map

ERROR = np.array([[0.004, -0.03, 0.08], [0.019, 0.051, np.nan]])


def drawn(**changes):
    given = {
        "title": "Error of T", "x_label": "z", "y_label": "d_1/d_e", "columns": ("3", "6", "12"),
        "rows": ("0.05", "0.10"), "error": ERROR, "without": "does not expand",
    }  # fmt: skip
    return str(error_map(Map(**given | changes)))


def test_every_cell_has_its_shade_and_its_number_in_per_cent():
    page = drawn()
    for shade, cells in (("m0", 2), ("m1", 1), ("m2", 2), ("m3", 0), ("none", 1)):
        assert page.count(f'<rect class="{shade}"') == cells
    for words in ("0.4", "−3.0", "8.0", "1.9", "5.1", "·"):
        assert f">{words}<" in page
    assert 'aria-label="Error of T"' in page


def test_the_first_row_is_at_the_bottom():
    page = drawn()
    height = {row: float(page.split(f'">{row}<')[0].rsplit(' y="', 1)[1].split('"')[0])
              for row in ("0.05", "0.10")}  # fmt: skip
    assert height["0.05"] > height["0.10"]


def test_cells_with_finite_elements_are_marked_and_the_key_says_so():
    checked = np.array([[True, False, False], [False, True, False]])
    page = drawn(checked=checked, checked_name="also by finite elements")
    assert page.count('<circle class="fe"') == 2 + 1
    assert ">also by finite elements<" in page
    assert "circle" not in drawn()


@pytest.mark.parametrize(
    ("error", "words"),
    [(0.0, "0.0"), (-1e-6, "0.0"), (0.0123, "1.2"), (-0.0996, "−10"), (0.5, "50"), (3.0, ">99"),
     (-1.2, "<−99")],
)  # fmt: skip
def test_per_cent_has_two_digits(error, words):
    assert percent(error) == words
