"""Charts of rotating shafts: Campbell diagrams, animated modes, and sets of parameters."""

import re
from dataclasses import replace

import numpy as np
import pytest

from reports.figures import plot
from reports.html import anchors, page
from reports.labels import beside, spread
from reports.pdf_case import case_data
from reports.whirl import ALONG, RIGHT, UP, whirl
from tests.reports.paths import corners
from verify.core.figures import Campbell, Mode, Parallel, ParallelAxis, Whirl

SPEEDS = np.linspace(0.0, 6000.0, 13)
SPLIT = np.column_stack([100 - SPEEDS / 200, 100 + SPEEDS / 200, 0 * SPEEDS + 102])


CAMPBELL = Campbell(
    title="T", x_label="speed [r/min]", y_label="frequency [Hz]", speeds=SPEEDS, frequencies=SPLIT,
    whirl=(-1, 1, 0), names=("1B", "1F", "1T"), excitations=(("1×", 1 / 60), ("4×", 4 / 60)),
    critical=((4615.4, 76.92, "4615"),), range=(2000.0, 3000.0), peers_name="paper",
    peers=(np.array([0.0, 3000.0]), np.array([100.0, 113.0])),
)  # fmt: skip


def campbell(**changes):
    return str(plot(replace(CAMPBELL, **changes)))


def test_branches_have_the_style_of_their_whirl_and_a_dot_lies_where_an_excitation_meets_one():
    """Backward 100 - n/200 = n/60 at n = 100/(1/60 + 1/200) = 4615.4 r/min."""
    page = campbell()
    for css in ("fit s0 strokes", "fit s2 dashes", "fit s4 strokes"):
        assert page.count(f'class="{css}"') == 2  # the branch and its swatch
    for name in ("1B", "1F", "1T", "1×", "4×", "4615", "forward", "backward", "neither", "paper",
                 "speeds of operation"):  # fmt: skip
        assert f">{name}<" in page
    ((u, v),) = re.findall(r'class="mark" cx="([\d.]+)" cy="([\d.]+)"', page)
    for css in ("ray", "fit s2 dashes"):
        assert np.interp(float(u), *corners(page, css)[0].T) == pytest.approx(float(v), abs=0.2)
    for missing in ({"whirl": (1, 1)}, {"names": ("1B",)}):
        with pytest.raises(ValueError, match="shorter"):
            campbell(**missing)


def test_names_are_spread_no_farther_than_they_must_and_keep_in_their_frame():
    names = tuple(f"{k}F" for k in range(12))
    page = campbell(frequencies=100 + 0.1 * np.arange(12) + 0 * SPEEDS[:, None],
                    whirl=(1,) * 12, names=names)  # fmt: skip
    heights = sorted(float(y) for y in re.findall(r' y="([\d.]+)"[^>]*>\d+F<', page))
    assert len(heights) == 12
    assert np.diff(heights).min() >= 12
    # two wishes at 10 and 12 of width 6 stand around their mean; what is free stays
    assert spread([10.0, 12.0, 40.0], [6.0, 6.0, 6.0]) == pytest.approx([8.0, 14.0, 40.0])
    assert spread([0.0, 1.0], [4.0, 4.0], (0.0, 9.0)) == pytest.approx([0.0, 4.0])
    assert spread([9.0, 9.0], [4.0, 4.0], (0.0, 9.0)) == pytest.approx([5.0, 9.0])
    assert spread([], []) == []
    frame = (0.0, 0.0, 100.0, 100.0)
    (x, _, anchor), first = beside(95.0, 50.0, 30.0, frame, [])
    assert anchor == "end"
    assert x < 95
    _, second = beside(95.0, 50.0, 30.0, frame, [first])
    assert first[3] <= second[1] or second[3] <= first[1]


Z = np.linspace(0.0, 0.9, 13)
BOW = np.sin(np.pi * Z / 0.9).astype(complex)


def mode(name, x, y):
    return Mode(name=name, lines=((Z, x, y), (Z[3:9], 0.5 * x[3:9], 0.5 * y[3:9])))


FORWARD, BACKWARD = mode("1F 169.2 Hz", BOW, -1j * BOW), mode("1B 152.4 Hz", BOW, 1j * BOW)
STEPPED = np.array([0.0, 0.4, 0.4, 0.9]), np.array([0.02, 0.02, 0.03, 0.03])
BOTH = Whirl(title="Modes", unit="m", modes=(FORWARD, BACKWARD), outlines=(STEPPED,),
             supports=(0.0, 0.9), links=(0.3,))  # fmt: skip


def rows(drawn):
    """What moves each line: place, and parts of the displacement at the phases 0 and 90 degrees."""
    found = re.findall(r'data-line="([^"]*)"', str(drawn))
    return [np.array([r.split(",") for r in text.split(" ")], float) for text in found]


@pytest.mark.parametrize(("mode", "sense"), [(FORWARD, 1), (BACKWARD, -1)])
def test_forward_whirl_runs_from_x_to_y_and_its_arrow_points_along_the_orbit(mode, sense):
    drawn = whirl(replace(BOTH, modes=(mode,)))
    line = rows(drawn)[0]
    at, later = line[6, 2:4], line[6, 4:]  # in the middle, where the bow is 1
    size = np.hypot(*UP)
    assert at / np.hypot(*at) == pytest.approx(RIGHT / np.hypot(*RIGHT), abs=0.01)
    assert later / np.hypot(*later) == pytest.approx(sense * UP / size, abs=0.01)
    assert np.hypot(*at) / np.hypot(*later) == pytest.approx(np.hypot(*RIGHT) / size, rel=0.01)
    tip, *back = corners(drawn, "sense s0")[0]
    angles = np.linspace(0, 2 * np.pi, 721)[:, None]
    orbits = [p[:2] + p[2:4] * np.cos(angles) + p[4:] * np.sin(angles) for p in line[5:8]]
    orbit = min(orbits, key=lambda o: np.linalg.norm(o - tip, axis=1).min())
    k = int(np.linalg.norm(orbit - tip, axis=1).argmin())
    assert np.linalg.norm(orbit[k] - tip) < 0.3
    assert 30 < np.degrees(angles[k]) < 70  # ahead of what is drawn
    assert (tip - np.mean(back, axis=0)) @ (orbit[k + 1] - orbit[k]) > 0


def test_the_bar_of_modes_has_its_length_and_every_panel_its_bearings():
    drawn = str(plot(replace(BOTH, names=("outer", "inner"))))
    for name in ("1F 169.2 Hz", "0.1 m", "bearing to ground", "between shafts", "outer", "inner"):
        assert name in drawn
    (bar, *_) = re.findall(r'class="base" d="M8,[\d.]+L([\d.]+),', drawn)
    places = rows(drawn)[0][:, :2]
    along = (places[-1] - places[0])[0] / ALONG[0] / 0.9  # pixels of a metre
    assert float(bar) - 8 == pytest.approx(0.1 * along, abs=0.2)
    assert drawn.count('class="support"') == 2 * 2 + 1  # in each panel and in the key


def test_page_and_pdf_take_modes_and_only_then_their_script(wordy):
    case = replace(wordy.cases[0], figures=(BOTH,))
    shown, without = (page(replace(wordy, cases=(c,)), {}) for c in (case, wordy.cases[0]))
    assert "requestAnimationFrame(draw)" in shown
    assert "<script" not in without
    figures = case_data(case, (), anchors(case.rows), [], "p")["figures"]
    (figure,) = [f for f in figures if f["title"] == ["Modes"]]
    assert "1F 169.2 Hz" in figure["drawing"]["svg"]
    for x in (0 * BOW, BOW):  # no orbit, and one that is a line: no arrow
        drawn = str(whirl(replace(BOTH, modes=(Mode(name="m", lines=((Z, x, x),)),))))
        assert 'class="sense' not in drawn
        assert "nan" not in drawn


AXES = (
    ParallelAxis(name="k_1", unit="N/m", low=1e6, high=1e8, log=True),
    ParallelAxis(name="κ", unit="1", low=0.5, high=1.0),
    ParallelAxis(name="I_d", unit="kg m^2", low=0.0, high=2.5e-4),
)
MEMBERS = np.array([[1e7, 0.75, 1.25e-4], [1e6, 0.5, 0.0], [1e8, 1.0, 2.5e-4]])


SETS = Parallel(title="T", axes=AXES, members=MEMBERS, members_name="sets",
                highlighted=((0, "best", 2),))  # fmt: skip


def test_the_middle_of_every_parallel_axis_and_its_ends_lie_on_level_lines():
    """10^7 is the middle of 10^6 to 10^8 on a logarithmic axis; 10^9 stops at its end."""
    beyond = np.vstack([MEMBERS, MEMBERS[2] * [10, 1, 1]])
    page = str(plot(replace(SETS, members=beyond)))
    (middle, *_), (low, high, end) = (
        corners(page, "fit s2 strokes chosen"), corners(page, "member")[:3],
    )  # fmt: skip
    for line in (low, middle, high):
        assert np.ptp(line[:, 1]) < 0.11
    assert middle[0, 1] == pytest.approx((low[0, 1] + high[0, 1]) / 2, abs=0.11)
    assert end[0, 1] == high[0, 1] < low[0, 1]  # up is more
    for words in ("κ", "10⁸", "10⁶", "0.5", "2.5·10⁻⁴", "N/m", "kg m²", "best", "sets"):
        assert f">{words}<" in page
    assert page.count(">1</text>") == 1  # the high end of κ; its unit 1 is left out
