"""The rotatable ribbon: its data are read back completely, its words are escaped."""

import base64
import json
import re
from dataclasses import replace

import numpy as np
import pytest

from reports.environment import HERE
from reports.scene import compose
from reports.viewer import viewer
from verify.core.figures import Field, Picture

SPRING = Field(
    name="spring", points=np.array([[0.0, 0], [0, 2], [3, 2]]), cells=np.array([[0, 1], [1, 2]]),
    point_data={"displacement": np.array([[0.001, 0], [0.002, 0], [0.004, 0]])},
    cell_data={"s": np.array([-5e6, 10e6])},
)  # fmt: skip
RIBBON = Picture(
    field="spring", data="s", symbol="σ", unit="MPa", factor=1e6, width=7.0,
    caption='<script>alert(1)</script>" onload="x',
)  # fmt: skip


def packed(html: str) -> dict:
    [text] = re.findall(r'<script type="application/json">(.*?)</script>', html)
    return json.loads(text)


def array(text: str, kind: str) -> np.ndarray:
    return np.frombuffer(base64.b64decode(text), dtype=kind)


def test_points_displacements_and_colours_come_back_as_they_were():
    data = packed(viewer(SPRING, RIBBON))
    assert array(data["points"], "<f4").tolist() == SPRING.points.ravel().tolist()
    assert array(data["displacement"], "<f4")[[0, 2, 4]] == pytest.approx([0.001, 0.002, 0.004])
    assert array(data["cells"], "<u2").tolist() == [0, 1, 1, 2]
    assert array(data["shares"], "<f4").tolist() == [0.25, 1.0]  # of a range from -10 to 10 MPa
    assert data["width"] == 7.0
    assert data["ramp"] == list(compose(SPRING, RIBBON).scale.stops)
    at = np.arange(70_000)  # points, more than 16 bits count
    line = Field(name="line", points=np.column_stack([at, 0.0 * at]),
                 cells=np.column_stack([at[:-1], at[1:]]))  # fmt: skip
    data = packed(viewer(line, replace(RIBBON, data="")))
    assert data["wide"]
    assert array(data["cells"], "<u4").max() == at[-1]


def test_words_of_users_cannot_become_markup():
    html = viewer(SPRING, RIBBON)
    assert html.count("<script") == 1
    assert "&lt;script&gt;" in html
    assert '" onload' not in html
    script = (HERE / "viewer.js").read_text("utf-8")
    for word in ("eval(", "new Function", "innerHTML", "onclick", "http", 'setAttribute("style'):
        assert word not in script  # a strict policy forbids it


def test_what_cannot_be_swept_is_refused():
    with pytest.raises(ValueError, match="requires a width"):
        viewer(SPRING, replace(RIBBON, width=None))
    for change in ({"cells": np.array([[0, 1, 2]])}, {"points": np.eye(3)}):
        with pytest.raises(ValueError, match="requires lines in a plane"):
            viewer(replace(SPRING, **change), RIBBON)
