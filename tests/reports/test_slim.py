"""A page in fewer bytes: the same lines in the same place."""

import re

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from reports import svg
from reports.slim import slim, steps
from tests.reports.paths import walked

TENTHS = st.integers(-9999, 9999)


def within(p, a, b) -> bool:
    """Whether p lies on the straight piece from a to b, exactly."""
    across = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    along = (b[0] - a[0]) * (p[0] - a[0]) + (b[1] - a[1]) * (p[1] - a[1])
    return across == 0 and 0 <= along <= (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2


# the check of speed fails on a machine that others load
@settings(max_examples=30, suppress_health_check=[HealthCheck.too_slow])
@given(st.lists(st.tuples(TENTHS, TENTHS), min_size=1), st.booleans())
def test_no_corner_moves(points, closed):
    drawn = str(svg.polyline([(x / 10, y / 10) for x, y in points], "c", closed=closed))
    (path,) = re.findall(r'd="([^"]*)"', slim(drawn))
    (kept,) = walked(path)
    assert path.endswith("z") == closed
    assert kept[0] == points[0]
    assert kept[-1] == points[-1]
    left = iter(points)
    assert all(corner in left for corner in kept)  # in their order
    at = 0  # every point lies on the piece that is drawn between the corners around it
    for p in points:
        while at + 1 < len(kept) - 1 and not within(p, kept[at], kept[at + 1]):
            at += 1
        assert p == kept[at] or within(p, kept[at], kept[min(at + 1, len(kept) - 1)])


@pytest.mark.parametrize(
    ("path", "short"),
    [
        ("M1,2L3.5,2z", "M1,2h2.5z"),
        ("M8,95.2L8,93.1L8,91.1L9,90", "M8,95.2v-4.1l1-1.1"),
        ("M0,0L1,1L2,3L2.5,2.4L2.1,2", "M0,0l1,1,1,2,.5-.6-.4-.4"),
        ("M0,0L5,0L2,0", "M0,0h5-3"),  # back on itself: both ends count
        ("M5,5L5,5", "M5,5v0"),  # a round end shows as a dot
        ("M0,0L1,0zM2,2L2,3", "M0,0h1zM2,2v1"),
    ],
)
def test_a_path_by_its_steps(path, short):
    assert steps(path) == short


@pytest.mark.parametrize("path", ["M7.896-3.924L0.744-4.74Z", "M0.25,1L2,3", "M1,2H3V4z", "M1,2h0"])
def test_a_path_of_other_kind_stays(path):
    assert slim(f'<path d="{path}"/>') == f'<path d="{path}"/>'


def test_only_attributes_that_say_nothing_go():
    drawn = str(svg.text(1, 2, 'text-anchor="start" class=""'))
    assert slim(drawn) == '<text x="1" y="2">text-anchor=&#34;start&#34; class=&#34;&#34;</text>'
    assert 'text-anchor="end"' in slim(str(svg.text(1, 2, "words", "tick", "end")))


def test_a_repeated_equation_refers_to_its_first_drawing():
    first, other = (f'<svg class="maths" width="9">{d}</svg>' for d in ("<p/>", "<q/>"))
    again = first.replace('"9"', '"8"')
    assert slim(first + other) == first + other
    assert slim(first + other + again) == (
        f'<svg class="maths" width="9"><g id="e0"><p/></g></svg>{other}'
        '<svg class="maths" width="8"><use href="#e0"/></svg>'
    )
