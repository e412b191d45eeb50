"""Sketch of a star's pitch: what it names, and that no label lies on another."""

import itertools
import re

import pytest

from reports.sketch import WIDTH, sketch
from verify.cases.freewheel import star_sketch
from verify.cases.freewheel.star import Star

LETTER, TALL, BESIDE = 6.6, 13.0, 44.0  # of a label; room beside a sketch on the page
SIZES = [  # m: as given, many rollers on thin walls, thick walls
    {}, {"z": 14, "R_a": 18.5e-3, "r_b": 10e-3}, {"R_a": 40e-3, "r_b": 3e-3},
]  # fmt: skip


def labels(drawn):
    """Words of each label and its box (left, top, right, bottom)."""
    found = re.findall(
        r'<text class="sym" x="([-\d.]+)" y="([-\d.]+)" text-anchor="(\w+)">(.*?)</text>', drawn
    )
    for x, y, anchor, inner in found:
        words = re.sub(r"<[^>]*>|&#8203;|\u200b", "", inner)
        wide = LETTER * len(words)
        left = float(x) - wide * {"start": 0, "middle": 0.5, "end": 1}[anchor]
        if words:
            yield words, (left, float(y) - TALL, left + wide, float(y))


@pytest.mark.parametrize("size", SIZES)
def test_no_label_lies_on_another_or_leaves_the_page(size):
    named = list(labels(str(sketch(star_sketch.sketch(Star(**size))))))
    for (one, a), (other, b) in itertools.combinations(named, 2):
        apart = a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]
        assert apart, f"{one} on {other}"
    assert all(left > -BESIDE and right < WIDTH + BESIDE for _, (left, _, right, _) in named)


def test_all_lengths_the_angle_and_the_torque_are_named():
    words = " ".join(words for words, _ in labels(str(sketch(star_sketch.sketch(Star())))))
    for name in ("X = 11.39565 mm", "R = 16.5 mm", "r = 2.5 mm", "Ra = 21 mm", "rb = 7.5 mm",
                 "ψ = 2α0 = 7°", "T", "Fn"):  # fmt: skip
        assert name in words
