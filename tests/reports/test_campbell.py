"""Campbell diagrams: branches, lines of excitation, dots, and names that do not meet."""

import re

import numpy as np
import pytest

from reports.html import plot
from reports.labels import beside, spread
from verify.core.figures import Campbell

SPEEDS = np.linspace(0.0, 6000.0, 13)
SPLIT = np.column_stack([100 - SPEEDS / 200, 100 + SPEEDS / 200, 0 * SPEEDS + 102])


def drawn(**changes):
    given = {
        "title": "T", "x_label": "speed [r/min]", "y_label": "frequency [Hz]", "speeds": SPEEDS,
        "frequencies": SPLIT, "whirl": (-1, 1, 0), "names": ("1B", "1F", "1T"),
        "excitations": (("1×", 1 / 60), ("4×", 4 / 60)), "critical": ((4615.4, 76.92, "4615"),),
        "range": (2000.0, 3000.0), "peers": (np.array([0.0, 3000.0]), np.array([100.0, 113.0])),
        "peers_name": "paper",
    }  # fmt: skip
    return str(plot(Campbell(**given | changes)))


def text(page, name):
    """Where a name stands."""
    ((x, y),) = re.findall(rf'<text class="[^"]*" x="([\d.]+)" y="([\d.]+)"[^>]*>{name}<', page)
    return float(x), float(y)


def test_branches_have_the_style_of_their_whirl_and_all_is_named():
    page = drawn()
    for css in ("fit s0 strokes", "fit s2 dashes", "fit s4 strokes"):
        assert page.count(f'class="{css}"') == 2  # the branch and its swatch
    for name in ("1B", "1F", "1T", "1×", "4×", "4615", "forward", "backward", "neither", "paper",
                 "speeds of operation", "speed [r/min]", "frequency [Hz]"):  # fmt: skip
        assert f">{name}<" in page
    assert page.count('class="cross"') == 3
    assert page.count('class="mark"') == 1


def test_a_dot_lies_where_the_line_of_excitation_meets_the_branch():
    """Backward 100 - n/200 = n/60 at n = 100/(1/60 + 1/200) = 4615.4 r/min."""
    page = drawn()
    ((u, v),) = re.findall(r'class="mark" cx="([\d.]+)" cy="([\d.]+)"', page)
    for css in ("ray", "fit s2 dashes"):
        path = re.search(rf'class="{css}" d="M([^"]*)"', page)[1]
        x, y = np.array([p.split(",") for p in path.split("L")], float).T
        assert np.interp(float(u), x, y) == pytest.approx(float(v), abs=0.2)


def test_names_of_branches_that_meet_keep_their_lines_apart():
    names = tuple(f"{k}F" for k in range(12))
    page = drawn(frequencies=100 + 0.1 * np.arange(12) + 0 * SPEEDS[:, None], whirl=(1,) * 12,
                 names=names)  # fmt: skip
    heights = sorted(text(page, name)[1] for name in names)
    assert np.diff(heights).min() >= 12


def test_a_branch_without_a_whirl_or_a_name_is_a_mistake():
    with pytest.raises(ValueError, match="shorter"):
        drawn(whirl=(1, 1))
    with pytest.raises(ValueError, match="shorter"):
        drawn(names=("1B",))


def test_names_are_spread_no_farther_than_they_must():
    """Two wishes at 10 and 12 of width 6 stand around their mean; what is free stays."""
    assert spread([10.0, 12.0, 40.0], [6.0, 6.0, 6.0]) == pytest.approx([8.0, 14.0, 40.0])
    assert spread([0.0, 1.0], [4.0, 4.0], (0.0, 9.0)) == pytest.approx([0.0, 4.0])
    assert spread([9.0, 9.0], [4.0, 4.0], (0.0, 9.0)) == pytest.approx([5.0, 9.0])
    assert spread([], []) == []


def test_a_name_beside_a_point_keeps_in_the_frame_and_off_the_others():
    frame = (0.0, 0.0, 100.0, 100.0)
    (x, _, anchor), first = beside(95.0, 50.0, 30.0, frame, [])
    assert anchor == "end"
    assert x < 95
    _, second = beside(95.0, 50.0, 30.0, frame, [first])
    assert first[3] <= second[1] or second[3] <= first[1]
