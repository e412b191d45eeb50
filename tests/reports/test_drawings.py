"""Compact drawings of the page and images: every line and colour is unchanged."""

import itertools
import re
import xml.etree.ElementTree as ET

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from markupsafe import Markup

from reports import signature, svg
from reports.convergence import convergence
from reports.figures import plot
from reports.overview import overview
from reports.sketch import WIDTH, sketch
from reports.slim import MOST, slim, steps, too_large, unquoted
from reports.standalone import standalone
from tests.reports.paths import walked
from verify.cases.freewheel import star_sketch
from verify.cases.freewheel.star import Star

TENTHS = st.integers(-9999, 9999)


def within(p, a, b) -> bool:
    """Whether p lies on the straight piece from a to b, exactly."""
    across = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    along = (b[0] - a[0]) * (p[0] - a[0]) + (b[1] - a[1]) * (p[1] - a[1])
    return across == 0 and 0 <= along <= (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2


# the check of speed fails on a machine that others load
@settings(max_examples=30, suppress_health_check=[HealthCheck.too_slow])
@given(st.lists(st.tuples(TENTHS, TENTHS), min_size=1), st.booleans())
def test_no_corner_of_a_slim_path_moves(points, closed):
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


def test_a_path_is_written_by_its_steps_and_other_paths_stay():
    for path, short in {
        "M1,2L3.5,2z": "M1,2h2.5z",
        "M8,95.2L8,93.1L8,91.1L9,90": "M8,95.2v-4.1l1-1.1",
        "M0,0L1,1L2,3L2.5,2.4L2.1,2": "M0,0l1,1,1,2,.5-.6-.4-.4",
        "M0,0L5,0L2,0": "M0,0h5-3",  # back on itself: both ends count
        "M5,5L5,5": "M5,5v0",  # a round end shows as a dot
        "M0,0L1,0zM2,2L2,3": "M0,0h1zM2,2v1",
    }.items():
        assert steps(path) == short
    for path in ("M7.896-3.924L0.744-4.74Z", "M0.25,1L2,3", "M1,2H3V4z", "M1,2h0"):
        assert slim(f'<path d="{path}"/>') == f'<path d="{path}"/>'
    drawn = str(svg.text(1, 2, 'text-anchor="start" class=""'))
    assert slim(drawn) == '<text x="1" y="2">text-anchor=&#34;start&#34; class=&#34;&#34;</text>'
    assert 'text-anchor="end"' in slim(str(svg.text(1, 2, "words", "tick", "end")))


def test_quotes_are_left_out_where_html_does_not_require_them():
    for page, short in {
        '<td class="n fe" id="row-1-2" title="a">': '<td class="n fe" id=row-1-2 title=a>',
        '<use href="#a" x="3"/><path d="M1 2"/>': '<use href=#a x=3 /><path d="M1 2" />',
        '<a href="a?b=c" title="" data-x="it&#39;s">': '<a href="a?b=c" title="" data-x=it&#39;s>',
        '<script>"<p class="n">"</script>': '<script>"<p class="n">"</script>',
        '<style>a[b="c" ]</style><p id="d">': '<style>a[b="c" ]</style><p id=d>',
    }.items():
        assert unquoted(page) == short


def test_a_page_over_the_limit_is_named():
    files = {
        "report.html": b"x" * MOST,
        "report/a.html": b"x" * (MOST + 900),
        "b.json": b"x" * MOST * 2,
    }
    assert list(too_large(files)) == [
        "report/a.html has 400.9 kB, but a page must not exceed 400 kB"
    ]


def test_every_drawing_alone_is_xml_with_a_rule_for_each_class_and_no_variable(report):
    found = [overview(report.cases)]
    found += [signature.signature(row) for row in report.rows]
    for case in report.cases:
        found += [sketch(case.sketch), convergence([r for r in case.rows if r.levels])]
        found += [plot(figure) for figure in case.figures]
    drawings = [drawing for svg in found if (drawing := standalone(svg))]
    assert len(drawings) > 50
    hostile = standalone(svg.drawing(10, 5, [], 'a < "b" & c', "chart"))
    assert (hostile["alt"], hostile["ratio"]) == ('a < "b" & c', 0.5)
    assert standalone(Markup("")) is None
    for drawing in drawings:
        assert "var(" not in drawing["svg"]
        assert drawing["alt"]
        root = ET.fromstring(drawing["svg"])
        rules = root.find("{*}style").text
        for element in root.iter():
            names = element.get("class", "").split()
            if element.tag.endswith(("path", "circle", "rect")) and names:
                assert any(re.search(rf"\.{name}\b", rules) for name in names), names


LETTER, TALL, BESIDE = 6.6, 13.0, 44.0  # of a label; room beside a sketch on the page


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


def test_no_label_of_a_sketch_lies_on_another(report):
    sizes = {}, {"z": 14, "R_a": 18.5e-3, "r_b": 10e-3}, {"R_a": 40e-3, "r_b": 3e-3}
    stars = [star_sketch.sketch(Star(**size)) for size in sizes]  # many rollers, thin, thick walls
    for one in (*stars, *(case.sketch for case in report.cases)):
        named = list(labels(str(sketch(one))))
        for (word, a), (other, b) in itertools.combinations(named, 2):
            apart = a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]
            assert apart, f"{word} on {other}"
        assert all(left > -BESIDE and right < WIDTH + BESIDE for _, (left, _, right, _) in named)
    words = " ".join(words for words, _ in labels(str(sketch(stars[0]))))
    for name in ("X = 11.39565 mm", "R = 16.5 mm", "r = 2.5 mm", "Ra = 21 mm", "rb = 7.5 mm",
                 "ψ = 2α0 = 7°", "T", "Fn"):  # fmt: skip
        assert name in words
