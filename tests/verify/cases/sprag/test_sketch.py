"""The sketch of a sprag clutch at any ratio of its races: labels lie beside the races."""

import re

import pytest

from reports.sketch import LETTER, LINE, SHARE, sketch
from verify.cases.sprag.clutch.sketch import sketch as of_clutch
from verify.cases.sprag.inputs import SpragInputs

LABEL = re.compile(r'<text class="sym" x="(\S+)" y="(\S+)" text-anchor="(\w+)">(.*?)</text>')
POINT = re.compile(r"(-?[\d.]+)[ ,](-?[\d.]+)")
RACE = re.compile(r'class="modelled" d="([^"]*)"')


def boxes(drawn: str) -> dict[str, tuple[float, float, float, float]]:
    """Left, right, top, bottom of each label."""
    found = {}
    for x, y, anchor, inner in LABEL.findall(drawn):
        words = re.sub("<[^>]*>|\u200b", "", inner)
        wide = LETTER * len(words)
        left = float(x) - wide * SHARE[anchor]
        found[words] = (left, left + wide, float(y) - 0.7 * LINE, float(y))
    return found


@pytest.mark.parametrize("R_i", [8.0, 11.11, 14.0, 16.0, 18.0, 19.0])
def test_no_angle_is_written_on_a_race_or_on_another_angle(R_i: float) -> None:
    height = (19.44 - R_i) / (19.44 - 11.11)
    default = SpragInputs()
    q = default.model_copy(update={
        "R_i": R_i * 1e-3, "R_id": R_i * 1e-3 - 3.9e-3, "r_i": height * default.r_i,
        "b": height * default.b,
    })  # fmt: skip
    drawn = str(sketch(of_clutch(q)))
    found = {k: v for k, v in boxes(drawn).items() if "°" in k}
    assert len(found) == 4
    for name, (left, right, top, bottom) in found.items():
        for path in RACE.findall(drawn):
            corners = [(float(x), float(y)) for x, y in POINT.findall(path)]
            inside = [(x, y) for x, y in corners if left < x < right and top < y < bottom]
            assert inside == [], name
        for other, box in found.items():
            apart = right <= box[0] or box[1] <= left or bottom <= box[2] or box[3] <= top
            assert apart or other == name
