"""States of a spring side by side: one scale, nothing outside the picture, named and measured."""

import re

import numpy as np
import pytest

from reports.plots import WIDTH
from reports.shapes import shapes
from verify.core.figures import Panel, Shapes

LONG = np.array([[0.0, 0.0], [20.0, 0.0], [20.0, 5.0]])
SHORT = np.array([[0.0, 0.0], [8.0, 0.0], [8.0, 5.0]])


def drawn(*panels, **changes):
    given = {"title": "States", "unit": "mm", "panels": panels, "thickness": 0.1}
    return str(shapes(Shapes(**given | changes)))


def paths(page, css):
    found = re.findall(rf'<path class="{css}" d="M([^"]*)"', page)
    return [np.array([p.split(",") for p in d.split("L")], float) for d in found]


def test_all_states_have_one_scale():
    free, pressed = paths(drawn(Panel(name="O", lines=(LONG,)), Panel(name="A", lines=(SHORT,))),
                          "strip")  # fmt: skip
    assert np.ptp(free[:, 0]) / np.ptp(pressed[:, 0]) == pytest.approx(20 / 8, rel=0.01)
    assert np.ptp(free[:, 1]) == pytest.approx(np.ptp(pressed[:, 1]), abs=0.11)
    assert np.ptp(free[:, 0]) / np.ptp(free[:, 1]) == pytest.approx(4, rel=0.01)


def test_up_is_up():
    (line,) = paths(drawn(Panel(name="O", lines=(LONG,))), "strip")
    assert line[2, 1] < line[0, 1]


@pytest.mark.parametrize("count", [1, 9])
@pytest.mark.parametrize("size", [(60, 1), (1, 60)])
def test_nothing_leaves_the_picture_and_panels_do_not_overlap(count, size):
    line = np.array([[0.0, 0.0], size])
    page = drawn(*(Panel(name=f"state {k}", lines=(line,)) for k in range(count)))
    height = float(re.search(rf'viewBox="0 0 {WIDTH:g} ([\d.]+)"', page)[1])
    boxes = [(p.min(axis=0), p.max(axis=0)) for p in paths(page, "strip")]
    for low, high in boxes:
        assert (low >= 0).all()
        assert high[0] <= WIDTH
        assert high[1] <= height
    for i, (low, high) in enumerate(boxes):
        for other_low, other_high in boxes[:i]:
            assert (low > other_high).any() or (other_low > high).any()


def test_the_bar_has_the_length_that_it_names():
    page = drawn(Panel(name="O", lines=(LONG,)))
    (line,), bar = paths(page, "strip"), paths(page, "base")[0]
    named = float(re.search(r">([\d.]+) mm<", page)[1])
    assert np.ptp(bar[:, 0]) / named == pytest.approx(np.ptp(line[:, 0]) / 20, rel=0.01)


def test_contacts_are_dots_that_the_key_explains():
    dots = np.array([[4.0, 0.0]])
    page = drawn(Panel(name="A", lines=(LONG,), faint=(SHORT,), dots=dots), dots_name="contact")
    assert page.count('<circle class="fe"') == 1 + 1
    assert ">contact<" in page
    assert len(paths(page, "fit faint")) == 1
    assert "contact" not in drawn(Panel(name="A", lines=(LONG,)), dots_name="contact")
