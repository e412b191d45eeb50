"""Bars from zero and zones of a plane: their positions; names remain inside the picture."""

import re
from itertools import pairwise

import numpy as np
import pytest

from reports.axes import WIDTH
from reports.bars import LETTER, bars
from reports.zones import zones
from tests.reports.paths import corners
from verify.core.figures import Bars, Curve, Zone, Zones

LONG = "contact of the sprag with its outer race, both ends"


def bar_chart(*items):
    return str(bars(Bars(title="t", label="%", items=items)))


def texts(page):
    """Ends of each text: left, right, y, words."""
    tick = r'<text class="tick" x="([\d.-]+)" y="([\d.-]+)" text-anchor="(\w+)">([^<]+)'
    for x, y, anchor, words in re.findall(tick, page):
        wide = LETTER * len(words) * {"start": 0, "middle": 0.5, "end": 1}[anchor]
        yield float(x) - wide, float(x) - wide + LETTER * len(words), float(y), words


def test_bars_begin_at_zero_and_no_word_leaves_the_picture_or_runs_into_another():
    page = bar_chart(("X", 60.0, "60 %"), ("r", -30.0, ""))
    (x, w), (x2, w2) = [
        tuple(map(float, found))
        for found in re.findall(r'<rect[^>]*x="([\d.]+)"[^>]*width="([\d.]+)"', page)
    ]
    assert w == pytest.approx(2 * w2, abs=0.11)
    assert x2 + w2 == pytest.approx(x, abs=0.11)
    words = "60 % of the wind-up, 3.4 deg"
    for name, value in (("X", 60.0), (LONG, -60.0)):
        for left, right, _, message in texts(bar_chart((name, 40.0, words), ("r", value, "r"))):
            assert left >= 0, message
            assert right <= WIDTH, message
    page = bar_chart(*((LONG, value, "word " * 9) for value in (1.0, 2.0, 3.0)))
    names = sorted(y for *_, y, words in texts(page) if words in LONG)
    assert len(names) >= 3 * 3
    assert min(b - a for a, b in pairwise(names)) > 10


X = np.linspace(0.0, 10.0, 51)
HOLDS = Zone(name="holds", top=3 + 0.2 * X, tone="good")
SLIPS = Zone(name="slips", top=np.full(51, 10.0), tone="bad")


def drawn(**changes):
    given = {"title": "t", "x_label": "T [N m]", "y_label": "F [kN]", "x": X,
             "zones": (HOLDS, SLIPS), "y_top": 10.0}  # fmt: skip
    return str(zones(Zones(**given | changes)))


def edges(box, x):
    """Heights of a zone's upper and lower edge at x in the image."""
    right = int(box[:, 0].argmax()) + 1
    return [np.interp(x, *line.T) for line in (box[:right], box[right:][::-1])]


def test_a_zone_lies_on_the_one_below_and_its_name_inside():
    page = drawn()
    (low,), (high,) = corners(page, "good"), corners(page, "bad")
    x = np.linspace(52, 390, 51)
    assert np.allclose(edges(low, x)[0], edges(high, x)[1], atol=0.1)
    assert np.ptp(edges(low, x)[0]) > 20
    assert high[:, 1].min() == pytest.approx(28, abs=0.1)  # the top of the plot
    for name, box in (("holds", low), ("slips", high)):
        ((x, y),) = re.findall(rf'class="zone" x="([\d.]+)" y="([\d.]+)"[^>]*>{name}<', page)
        top, bottom = edges(box, float(x))
        assert top < float(y) - 4 < bottom


def test_a_point_and_curves_over_zones_stay_in_the_picture_and_have_their_names():
    for x, side in ((2.0, "start"), (9.0, "end"), (30.0, "end")):
        page = drawn(point=(x, 5.0, "26 N m, 5 kN"))
        ((u, anchor),) = re.findall(r'class="named" x="([\d.]+)"[^>]*anchor="(\w+)"', page)
        assert anchor == side
        assert float(u) <= 390
    page = drawn(curves=(Curve(name="limit", x=X, y=2 * X),))
    assert corners(page, "fit s0 strokes")[0][:, 1].min() >= 28
    assert ">limit<" in page
