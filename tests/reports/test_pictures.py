"""Pictures show the right place in the right colour, by either way of drawing, and only once."""

import io
import subprocess
import sys
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from PIL import Image

from reports import pictures
from reports.pictures import draw
from reports.polygons import pieces
from reports.scene import compose
from verify.core.figures import Field, Picture

WORDS = Picture(field="", data="s", symbol="σ", unit="MPa", factor=1e6, caption="")
RED, BLUE = (203, 58, 58), (42, 107, 200)  # the ends of the signed ramp
WAYS = ("pyvista", "matplotlib")


def sheet(columns: int = 40, rows: int = 20) -> Field:
    """4 m by 2 m; -1 MPa but for one cell of 1 MPa; the right edge moves 0.1 m to the right."""
    x, y = np.meshgrid(np.linspace(0, 4, columns + 1), np.linspace(0, 2, rows + 1), indexing="ij")
    i = np.arange(x.size).reshape(x.shape)
    cells = np.stack([i[:-1, :-1], i[1:, :-1], i[1:, 1:], i[:-1, 1:]], axis=-1).reshape(-1, 4)
    points = np.column_stack([x.ravel(), y.ravel()])
    stress = np.full(len(cells), -1e6)
    stress[10 * rows + 15] = 1e6  # x from 1.0 to 1.1 m, y from 1.5 to 1.6 m
    return Field(
        name="sheet", points=points, cells=cells,
        point_data={"displacement": points * (0.025, 0)}, cell_data={"s": stress},
    )  # fmt: skip


def quarter() -> Field:
    """A quarter of a ring, with values of both signs."""
    r, angle = np.meshgrid(np.linspace(2, 3, 5), np.linspace(0, np.pi / 2, 25), indexing="ij")
    i = np.arange(r.size).reshape(r.shape)
    cells = np.stack([i[:-1, :-1], i[1:, :-1], i[1:, 1:], i[:-1, 1:]], axis=-1).reshape(-1, 4)
    points = np.column_stack([(r * np.cos(angle)).ravel(), (r * np.sin(angle)).ravel()])
    points[np.abs(points) < 1e-12] = 0
    middle = points[cells].mean(axis=1)
    return Field(name="ring", points=points, cells=cells, point_data={"displacement": points / 50},
                  cell_data={"s": middle[:, 0] - middle[:, 1]})  # fmt: skip


def frame() -> Field:
    """A bent line with a bending stress that crosses zero."""
    return Field(
        name="frame", points=np.array([[0.0, 0], [0, 3], [4, 3]]), cells=np.array([[0, 1], [1, 2]]),
        point_data={"s": np.array([-1e6, 1e6, -1e6])},
    )  # fmt: skip


@cache
def drawn_by(way: str) -> dict[str, pictures.Drawn]:
    """The bodies of this file, each way of drawing started once."""
    requests = {
        "sheet": (sheet(), WORDS), "frame": (frame(), WORDS),
        "ring": (quarter(), replace(WORDS, factor=1, mirror=("x", "y"))),
    }  # fmt: skip
    with pytest.MonkeyPatch.context() as patch:
        if way == "matplotlib":
            patch.setattr(pictures, "PYVISTA", "reports.no_such_module")
        drawn = draw(list(requests.values()), None)
    if way == "pyvista" and drawn[0].why:
        bare = "import pyvista; pyvista.Plotter(off_screen=True).screenshot(return_img=True)"
        if subprocess.run([sys.executable, "-c", bare], capture_output=True, timeout=60).returncode:
            pytest.skip("no OpenGL here")
    assert all(one.by.startswith(way) for one in drawn), drawn[0].why
    return dict(zip(requests, drawn, strict=True))


def pixels_of(drawn: pictures.Drawn) -> np.ndarray:
    with Image.open(io.BytesIO(drawn.image)) as image:
        return np.asarray(image.convert("RGBA")).astype(int)


def is_near(pixels: np.ndarray, colour: tuple[int, ...]) -> np.ndarray:
    return (np.abs(pixels[..., :3] - colour).max(axis=-1) < 60) & (pixels[..., 3] > 127)


@pytest.mark.parametrize("way", WAYS)
def test_a_cell_lands_on_the_pixels_that_the_rectangle_says(way):
    drawn = drawn_by(way)["sheet"]
    assert drawn.exaggeration == 2.0  # 0.1 m of 4 m is 2.5 %
    at = np.argwhere(is_near(pixels_of(drawn), RED))[:, ::-1]
    moved = np.array([[1.0, 1.6], [1.1, 1.5]]) * (1 + 2 * 0.025, 1)
    assert np.abs(np.array([at.min(axis=0), at.max(axis=0) + 1]) - drawn.pixels(moved)).max() < 1.5


@pytest.mark.parametrize("body", ["sheet", "frame", "ring"])
def test_both_ways_show_the_same(body):
    first, second = (drawn_by(way)[body] for way in WAYS)
    for name in ("width", "height", "rectangle", "low", "high", "ramp", "exaggeration"):
        assert getattr(first, name) == getattr(second, name)
    difference = np.abs(pixels_of(first) - pixels_of(second)).max(axis=-1)
    assert (difference > 40).mean() < 0.02  # rims and grid lines, by less than a pixel


@pytest.mark.parametrize("way", WAYS)
def test_a_quarter_becomes_a_whole_ring_that_is_symmetric(way):
    whole = drawn_by(way)["ring"]
    alike = pixels_of(whole)
    for image in (alike[:, ::-1], alike[::-1]):
        assert (np.abs(alike - image).max(axis=-1) > 60).mean() < 0.01
    assert np.allclose(whole.rectangle, -np.array(whole.rectangle)[[2, 3, 0, 1]])
    assert len(whole.outline) == 2  # bore and rim, and no cut between the quarters


def test_shear_changes_sign_in_each_image_and_normal_stress_does_not():
    field = replace(sheet(), cell_data={"s": np.tile([3e6, 5e6, 2e6, 1e6], (800, 1))})
    for component, values in ((0, {3}), (1, {5}), (2, {-2, 2}), (3, {1})):
        scene = compose(field, replace(WORDS, component=component, mirror=("x",)))
        assert {scene.scale.low, scene.scale.high} == values


def test_a_component_of_a_vector_is_odd_in_its_own_mirror():
    picture = replace(WORDS, data="displacement", factor=1, component=0, mirror=("x",))
    assert compose(sheet(), picture).scale.low == pytest.approx(-0.1, rel=0.05)


@pytest.mark.parametrize(
    ("share", "factor"),
    [(0.065, 1.0), (0.2, 1.0), (0.5, 0.1), (1e-3, 50.0), (6.5e-7, 1e5), (0.0, 0.0), (3.0, 0.02)],
)
def test_exaggeration_is_a_round_number_that_makes_displacements_readable(share, factor):
    field = sheet()
    moved = replace(field, point_data={"displacement": field.points * (share, 0)})
    assert compose(moved, WORDS).exaggeration == factor
    assert factor in (0.0, 1.0) or 0.03 < factor * share < 0.11


@pytest.mark.parametrize("way", WAYS)
def test_lines_take_colours_along_their_length_and_corners_have_no_gap(way):
    drawn = drawn_by(way)["frame"]
    pixels = pixels_of(drawn)
    corner, foot, middle = drawn.pixels(np.array([[0, 3], [0, 0.05], [2, 3.0]])).astype(int)
    assert is_near(pixels[corner[1], corner[0]], RED)
    out = np.floor(drawn.pixels(np.array([[0.0, 3]]))[0] - 1.2).astype(int)
    assert pixels[out[1], out[0], 3] > 127  # outside the corner, where neither stroke reaches
    assert is_near(pixels[foot[1], foot[0]], BLUE)
    assert is_near(pixels[middle[1], middle[0]], (179, 179, 173))
    assert [len(line) for line in drawn.outline] == [3]


def test_a_window_shows_its_part_larger():
    scene = compose(sheet(), replace(WORDS, window=(0.9, 1.4, 1.2, 1.6)))
    assert scene.rectangle == pytest.approx((0.9, 1.4, 1.2, 1.6), abs=1e-3)
    assert scene.width == 1290
    assert scene.height == 860
    with pytest.raises(ValueError, match="no cells in the window"):
        compose(sheet(), replace(WORDS, window=(7, 7, 8, 8)))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"cells": np.zeros((0, 4), dtype=np.int64)}, "no cells"),
        ({"cell_data": {}}, "no data 's'; it has displacement"),
        ({"cell_data": {"s": np.full(800, np.nan)}}, "not all finite"),
    ],
)
def test_a_field_that_cannot_be_drawn_is_refused_in_words(change, message):
    with pytest.raises(ValueError, match=message):
        draw([(replace(sheet(), **change), WORDS)], None)


def test_values_at_nodes_run_evenly_through_a_large_cell():
    points = np.array([[0.0, 0], [4, 0], [4, 2], [0, 2]])
    field = Field(name="cell", points=points, cells=np.array([[0, 1, 2, 3]]),
                  point_data={"s": 1e6 * points[:, 0]})  # fmt: skip
    scene = compose(field, WORDS)
    filled = scene.vertices[scene.faces][:-4]  # the last four are the cell's edges
    left, right = filled[..., 0].min(), filled[..., 0].max()
    share = (filled[..., 0].mean(axis=1) - left) / (right - left)
    assert (scene.scale.low, scene.scale.high) == (0.0, 4.0)
    drawn, wanted = scene.colours[:-4].astype(int), scene.scale.colours(4 * share).astype(int)
    assert np.abs(drawn - wanted).max() <= 1  # rounding
    assert len(np.unique(drawn, axis=0)) > 10


def test_pieces_of_cells_cover_them_and_no_more():
    corners = np.array([[[0.0, 0, 0], [60, 0, 0], [70, 30, 0], [0, 20, 0]]])
    cut, values = pieces(corners, np.array([[0.0, 1, 1, 0]]))
    assert len(cut) == len(values) == 81  # the longest edge, 70.7 pixels, in pieces of 8
    assert area(cut).sum() == pytest.approx(area(corners).sum(), rel=1e-12)
    assert np.all(area(cut) > 0)
    assert np.all((values > 0) & (values < 1))


def area(corners):
    """Signed areas (m,) of quadrilaterals (m, 4, 3)."""
    (x0, y0), (x1, y1) = ((corners[:, i + 2] - corners[:, i])[:, :2].T for i in (0, 1))
    return (x0 * y1 - y0 * x1) / 2
