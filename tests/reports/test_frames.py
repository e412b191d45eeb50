"""Colour bars of pictures whose data are powers of ten."""

import re

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
