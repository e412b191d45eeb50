"""Drawings of the page as images: every colour resolved, every one well-formed."""

import re
import xml.etree.ElementTree as ET

import pytest
from markupsafe import Markup

from reports import plots, signature, svg
from reports.html import anchors, plot
from reports.sketch import sketch
from reports.standalone import standalone


@pytest.fixture
def drawings(report):
    found = [signature.overview(report.cases, anchors(report.rows))]
    found += [signature.signature(row) for row in report.rows]
    for case in report.cases:
        found += [sketch(case.sketch), plots.convergence([r for r in case.rows if r.levels])]
        found += [plot(figure) for figure in case.figures]
    return [drawing for svg in found if (drawing := standalone(svg))]


def test_every_drawing_is_xml_without_a_variable(drawings):
    assert len(drawings) > 50
    for drawing in drawings:
        assert ET.fromstring(drawing["svg"]).find("{*}style").text
        assert "var(" not in drawing["svg"]
        assert drawing["alt"]


def test_every_class_of_a_drawing_has_a_rule(drawings):
    for drawing in drawings:
        root = ET.fromstring(drawing["svg"])
        rules = root.find("{*}style").text
        for element in root.iter():
            if element.tag.endswith(("path", "circle", "rect")) and element.get("class"):
                assert any(
                    re.search(rf"\.{name}\b", rules) for name in element.get("class").split()
                ), element.get("class")


def test_no_drawing_is_none():
    assert standalone(Markup("")) is None


def test_a_label_of_hostile_signs_is_read_as_it_was():
    drawing = standalone(svg.drawing(10, 5, [], 'a < "b" & c', "chart"))
    assert drawing["alt"] == 'a < "b" & c'
    assert drawing["ratio"] == 0.5
