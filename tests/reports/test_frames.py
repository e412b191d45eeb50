"""Colour bars of pictures whose data are powers of ten."""

import re
from dataclasses import replace

from reports.frames import frame
from reports.picture_cache import Drawn
from verify.core.figures import Picture

STRESS = Picture(
    field="f", data="d", symbol="σ_v", unit="MPa", factor=1.0, caption="stress", decades=True
)
DRAWN = Drawn(
    image=b"", width=4, height=3, rectangle=(0.0, 0.0, 4.0, 3.0), low=1.0, high=3.2,
    ramp=("#000000", "#ffffff"), exaggeration=0.0, outline=(), by="", why="",
)  # fmt: skip


def numbers(picture, drawn):
    """The numbers below the bar with their places."""
    found = re.findall(r'x="([\d.]+)" y="[\d.]+" text-anchor="\w+">([\d.]+)<', str(
        frame(picture, drawn).svg
    ))  # fmt: skip
    return {name: float(x) for x, name in found}


def test_decades_are_named_in_the_unit_at_the_places_of_their_powers():
    assert numbers(STRESS, DRAWN) == {"10": 0.0, "100": 81.8, "1000": 163.6}


def test_less_than_two_decades_are_parted():
    assert set(numbers(STRESS, replace(DRAWN, high=2.0))) == {"10", "20", "50", "100"}


def test_other_data_keep_round_numbers():
    assert set(numbers(replace(STRESS, decades=False), DRAWN)) >= {"1", "2", "3"}
