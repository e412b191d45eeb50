"""Bars with their names: no word leaves the picture or runs over a bar."""

import re
from itertools import pairwise

import pytest

from reports.bars import LETTER, bars
from reports.plots import WIDTH
from verify.core.figures import Bars

LONG = "contact of the sprag with its outer race, both ends"


def texts(page):
    """Ends of each text: left, right, y, words."""
    tick = r'<text class="tick" x="([\d.-]+)" y="([\d.-]+)" text-anchor="(\w+)">([^<]+)'
    found = re.findall(tick, page)
    for x, y, anchor, words in found:
        wide = LETTER * len(words) * {"start": 0, "middle": 0.5, "end": 1}[anchor]
        yield float(x) - wide, float(x) - wide + LETTER * len(words), float(y), words


@pytest.mark.parametrize("name", ["X", LONG])
@pytest.mark.parametrize("value", [60.0, -60.0])
def test_no_word_leaves_the_picture(name, value):
    words = "60 % of the turn of the races, 3.4 deg"
    items = ((name, 40.0, words), ("r", value, "r"))
    page = str(bars(Bars(title="t", label="%", items=items)))
    for left, right, _, said in texts(page):
        assert left >= 0, said
        assert right <= WIDTH, said


def test_lines_of_names_do_not_run_into_each_other():
    items = tuple((LONG, value, "word " * 9) for value in (1.0, 2.0, 3.0))
    page = str(bars(Bars(title="t", label="%", items=items)))
    names = sorted(y for left, right, y, words in texts(page) if words in LONG)
    assert len(names) >= 3 * 3
    assert min(b - a for a, b in pairwise(names)) > 10
