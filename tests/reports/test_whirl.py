"""Modes of turning shafts: where they stand, which way they run, and that they move."""

import re
from dataclasses import replace

import numpy as np
import pytest

from reports.html import anchors, page, plot
from reports.pdf_case import case_data
from reports.whirl import ALONG, RIGHT, UP, whirl
from verify.core.figures import Mode, Whirl

Z = np.linspace(0.0, 0.9, 13)
BOW = np.sin(np.pi * Z / 0.9).astype(complex)


def mode(name, x, y):
    return Mode(name=name, lines=((Z, x, y), (Z[3:9], 0.5 * x[3:9], 0.5 * y[3:9])))


FORWARD, BACKWARD = mode("1F 169.2 Hz", BOW, -1j * BOW), mode("1B 152.4 Hz", BOW, 1j * BOW)
STEPPED = np.array([0.0, 0.4, 0.4, 0.9]), np.array([0.02, 0.02, 0.03, 0.03])
BOTH = Whirl(title="Modes", unit="m", modes=(FORWARD, BACKWARD), outlines=(STEPPED,),
             supports=(0.0, 0.9), links=(0.3,))  # fmt: skip


def rows(drawn, kind="line"):
    """What moves each line: place, and parts of the displacement at the phases 0 and 90 degrees."""
    found = re.findall(rf'data-{kind}="([^"]*)"', str(drawn))
    return [np.array([r.split(",") for r in text.split(" ")], float) for text in found]


@pytest.mark.parametrize(("shown", "sense"), [(FORWARD, 1), (BACKWARD, -1)])
def test_forward_whirl_runs_from_x_to_y_and_backward_the_other_way(shown, sense):
    drawn = whirl(replace(BOTH, modes=(shown,)))
    first = rows(drawn)[0]
    at, later = first[6, 2:4], first[6, 4:]  # in the middle, where the bow is 1
    size = np.hypot(*UP)
    assert at / np.hypot(*at) == pytest.approx(RIGHT / np.hypot(*RIGHT), abs=0.01)
    assert later / np.hypot(*later) == pytest.approx(sense * UP / size, abs=0.01)
    assert np.hypot(*at) / np.hypot(*later) == pytest.approx(np.hypot(*RIGHT) / size, rel=0.01)


def test_the_arrow_lies_on_the_orbit_and_points_along_it():
    for shown in (FORWARD, BACKWARD):
        drawn = str(whirl(replace(BOTH, modes=(shown,))))
        ((path),) = re.findall(r'class="sense s0" d="M([^z]*)z', drawn)
        tip, *back = np.array([p.split(",") for p in path.split("L")], float)
        angles = np.linspace(0, 2 * np.pi, 721)
        orbits = [
            np.column_stack([x + a * np.cos(angles) + e * np.sin(angles),
                             y + b * np.cos(angles) + f * np.sin(angles)])
            for x, y, a, b, e, f in rows(drawn)[0][5:8]
        ]  # fmt: skip
        orbit = min(orbits, key=lambda o: np.linalg.norm(o - tip, axis=1).min())
        near = np.linalg.norm(orbit - tip, axis=1)
        k = int(near.argmin())
        assert near[k] < 0.3
        assert 30 < np.degrees(angles[k]) < 70  # ahead of what is drawn
        assert (tip - np.mean(back, axis=0)) @ (orbit[k + 1] - orbit[k]) > 0


def test_the_drawing_holds_names_steps_bearings_and_a_bar():
    drawn = str(plot(BOTH))
    for name in ("1F 169.2 Hz", "1B 152.4 Hz", "0.1 m", "bearing to ground", "between shafts"):
        assert name in drawn
    (bar, *_) = re.findall(r'class="base" d="M8,[\d.]+L([\d.]+),', drawn)
    places = rows(drawn)[0][:, :2]
    along = (places[-1] - places[0])[0] / ALONG[0] / 0.9  # pixels of a metre
    assert float(bar) - 8 == pytest.approx(0.1 * along, abs=0.2)
    assert drawn.count('class="support"') == 2 * 2 + 1  # in each panel and in the key
    (outline, _) = re.findall(r'class="outline" d="M([^"]*)z"', drawn)
    assert outline.count("L") == 2 * 4 - 1
    assert len(drawn) < 12_000


@pytest.mark.parametrize(
    ("x", "y"), [(0 * BOW, 0 * BOW), (BOW, 0 * BOW), (BOW, BOW)], ids=["zero", "plane", "slanted"]
)
def test_a_mode_without_an_orbit_has_no_arrow(x, y):
    drawn = str(whirl(replace(BOTH, modes=(Mode(name="m", lines=((Z, x, y),)),))))
    assert 'class="sense' not in drawn
    assert "nan" not in drawn
    assert drawn.count("data-line") == 1


def test_page_and_pdf_take_it_and_only_then_its_script(wordy):
    case = replace(wordy.cases[0], figures=(BOTH,))
    shown, without = (page(replace(wordy, cases=(c,)), {}) for c in (case, wordy.cases[0]))
    assert "requestAnimationFrame(draw)" in shown
    assert "prefers-reduced-motion" in shown
    assert "<script" not in without
    (figure,) = [
        f
        for f in case_data(case, (), anchors(case.rows), [], "p")["figures"]
        if f["title"] == ["Modes"]
    ]
    assert "1F 169.2 Hz" in figure["drawing"]["svg"]


def test_shafts_are_named_in_their_colours():
    plain, named = whirl(BOTH), whirl(replace(BOTH, names=("outer", "inner")))
    assert "outer" not in plain
    for name, colour in (("outer", "s0"), ("inner", "s2")):
        assert re.search(rf'class="fit {colour} strokes"[^>]*/><text[^>]*>{name}<', named)
