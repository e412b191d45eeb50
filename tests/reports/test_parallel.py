"""Parallel coordinates: where values lie on their axes, and names that do not meet."""

import re

import numpy as np
import pytest

from reports.html import plot
from verify.core.figures import Parallel, ParallelAxis

AXES = (
    ParallelAxis(name="k_1", unit="N/m", low=1e6, high=1e8, log=True),
    ParallelAxis(name="κ", unit="1", low=0.5, high=1.0),
    ParallelAxis(name="I_d", unit="kg m^2", low=0.0, high=2.5e-4),
)
MEMBERS = np.array([[1e7, 0.75, 1.25e-4], [1e6, 0.5, 0.0], [1e8, 1.0, 2.5e-4]])


def drawn(**changes):
    given = {"title": "T", "axes": AXES, "members": MEMBERS, "members_name": "sets",
             "highlighted": ((0, "best", 2),)}  # fmt: skip
    return str(plot(Parallel(**given | changes)))


def lines(page, css):
    found = re.findall(rf'class="{css}" d="M([^"]*)"', page)
    return [np.array([p.split(",") for p in d.split("L")], float) for d in found]


def test_the_middle_of_every_axis_and_its_ends_lie_on_level_lines():
    """10^7 is the middle of 10^6 to 10^8 on a logarithmic axis."""
    page = drawn()
    middle, *_ = lines(page, "fit s2 strokes chosen")
    low, high = lines(page, "member")[:2]
    for line in (low, middle, high):
        assert np.ptp(line[:, 1]) < 0.11
    assert middle[0, 1] == pytest.approx((low[0, 1] + high[0, 1]) / 2, abs=0.11)
    assert high[0, 1] < low[0, 1]  # up is more


def test_axes_have_names_ends_and_units():
    page = drawn()
    for words in ("κ", "10⁸", "10⁶", "0.5", "2.5·10⁻⁴", "N/m", "kg m²", "best", "sets"):
        assert f">{words}<" in page
    assert ">1</text>" in page  # the high end of κ; its unit 1 is left out
    assert page.count(">1</text>") == 1


def test_what_lies_beyond_an_axis_stops_at_its_end():
    page = drawn(members=MEMBERS * [[10.0, 1, 1]], highlighted=())
    assert lines(page, "member")[2][0, 1] == lines(drawn(), "member")[1][0, 1]
