"""Zones of a plane: named where they lie, never where they do not; bars from zero."""

import re

import numpy as np
import pytest

from reports.bars import bars
from reports.zones import zones
from verify.core.figures import Bars, Curve, Zone, Zones

X = np.linspace(0.0, 10.0, 51)
HOLDS = Zone(name="holds", top=3 + 0.2 * X, tone="good")
SLIPS = Zone(name="slips", top=np.full(51, 10.0), tone="bad")


def drawn(*layers, **changes):
    given = {"title": "t", "x_label": "T [N m]", "y_label": "F [kN]", "x": X, "zones": layers}
    return str(zones(Zones(**given | {"y_top": 10.0} | changes)))


def area(page, css):
    """Points of the zone drawn with `css`, closed."""
    (found,) = re.findall(rf'<path class="{css}" d="M([^"]*)z"', page)
    return np.array([point.split(",") for point in found.split("L")], float)


def edges(box, x):
    """Heights of a zone's upper and lower edge at x in the image."""
    right = int(box[:, 0].argmax()) + 1
    return [np.interp(x, *line.T) for line in (box[:right], box[right:][::-1])]


def test_a_zone_lies_on_the_one_below():
    page = drawn(HOLDS, SLIPS)
    low, high = area(page, "good"), area(page, "bad")
    x = np.linspace(52, 390, 51)
    assert np.allclose(edges(low, x)[0], edges(high, x)[1], atol=0.1)
    assert np.ptp(edges(low, x)[0]) > 20
    assert high[:, 1].min() == pytest.approx(28, abs=0.1)  # the top of the plot


def test_names_stand_inside_their_zones():
    page = drawn(HOLDS, SLIPS)
    for name, css in (("holds", "good"), ("slips", "bad")):
        ((x, y),) = re.findall(rf'class="zone" x="([\d.]+)" y="([\d.]+)"[^>]*>{name}<', page)
        top, bottom = edges(area(page, css), float(x))
        assert top < float(y) - 4 < bottom


@pytest.mark.parametrize("x", [2.0, 9.0, 30.0])
def test_a_point_is_named_within_the_picture(x):
    page = drawn(HOLDS, SLIPS, point=(x, 5.0, "26 N m, 5 kN"))
    ((u, anchor),) = re.findall(r'class="named" x="([\d.]+)"[^>]*anchor="(\w+)"', page)
    assert anchor == ("start" if x < 5 else "end")
    assert float(u) <= 390


def test_curves_are_cut_at_the_plot_and_named_in_the_key():
    far = Curve(name="limit", x=X, y=2 * X)
    page = drawn(HOLDS, SLIPS, curves=(far,))
    (path,) = re.findall(r'<path class="fit s0 strokes" d="M([^"]*)"', page)[:1]
    assert min(float(p.split(",")[1]) for p in path.split("L")) >= 28
    assert ">limit<" in page


def test_bars_begin_at_zero_and_end_at_their_value():
    page = str(bars(Bars(title="t", label="%", items=(("X", 60.0, "60 %"), ("r", -30.0, "")))))
    (x, w), (x2, w2) = [
        tuple(map(float, found))
        for found in re.findall(r'<rect[^>]*x="([\d.]+)"[^>]*width="([\d.]+)"', page)
    ]
    assert w == pytest.approx(2 * w2, abs=0.11)
    assert x2 + w2 == pytest.approx(x, abs=0.11)
