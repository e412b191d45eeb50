"""Pictures have the right colour at each place with each drawing program, and are drawn once.

Where pyvista fails, hangs or draws nothing, matplotlib draws them.
"""

import io
import os
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from reports import drawing_process, picture_cache, pictures
from reports.bitmaps import flaw
from reports.drawing_process import DrawingProcess
from reports.frames import frame as framed
from reports.pictures import draw
from reports.polygons import pieces
from reports.scene import compose
from verify.core.figures import Field, Picture
from verify.core.store import Store

WORDS = Picture(field="", data="s", symbol="σ", unit="MPa", factor=1e6, caption="")
RED, BLUE = (203, 58, 58), (42, 107, 200)  # the ends of the signed ramp


def squares(x, y):
    """Cells of a grid of points (columns, rows)."""
    i = np.arange(x.size).reshape(x.shape)
    cells = np.stack([i[:-1, :-1], i[1:, :-1], i[1:, 1:], i[:-1, 1:]], axis=-1).reshape(-1, 4)
    return np.column_stack([x.ravel(), y.ravel()]), cells


def sheet(columns: int = 40, rows: int = 20) -> Field:
    """4 m by 2 m; -1 MPa but for one cell of 1 MPa; the right edge moves 0.1 m to the right."""
    grid = np.meshgrid(np.linspace(0, 4, columns + 1), np.linspace(0, 2, rows + 1), indexing="ij")
    points, cells = squares(*grid)
    stress = np.full(len(cells), -1e6)
    if columns == 40:
        stress[10 * rows + 15] = 1e6  # x from 1.0 to 1.1 m, y from 1.5 to 1.6 m
    return Field(
        name="sheet", points=points, cells=cells,
        point_data={"displacement": points * (0.025, 0)}, cell_data={"s": stress},
    )  # fmt: skip


SMALL = sheet(4, 2)


def quarter() -> Field:
    """A quarter of a ring, with values of both signs."""
    r, angle = np.meshgrid(np.linspace(2, 3, 5), np.linspace(0, np.pi / 2, 25), indexing="ij")
    points, cells = squares(r * np.cos(angle), r * np.sin(angle))
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


def drawn_by(program: str) -> list[pictures.Drawn]:
    """Three bodies, drawn by this program."""
    ring = replace(WORDS, factor=1, mirror=("x", "y"))
    requests = [(sheet(), WORDS), (quarter(), ring), (frame(), WORDS)]
    with pytest.MonkeyPatch.context() as patch:
        if program == "matplotlib":
            patch.setattr(drawing_process, "PYVISTA", "reports.no_such_module")
        drawn = draw(requests, None)
    if program == "pyvista" and drawn[0].why:
        bare = "import pyvista; pyvista.Plotter(off_screen=True).screenshot(return_img=True)"
        if subprocess.run([sys.executable, "-c", bare], capture_output=True, timeout=60).returncode:
            pytest.skip("no OpenGL here")
    assert all(one.by.startswith(program) for one in drawn), drawn[0].why
    return drawn


def pixels_of(drawn: pictures.Drawn) -> np.ndarray:
    with Image.open(io.BytesIO(drawn.image)) as image:
        return np.asarray(image.convert("RGBA")).astype(int)


def is_near(pixels: np.ndarray, colour: tuple[int, ...]) -> np.ndarray:
    return (np.abs(pixels[..., :3] - colour).max(axis=-1) < 60) & (pixels[..., 3] > 127)


@pytest.mark.parametrize("program", ["pyvista", "matplotlib"])
def test_cells_mirrored_quarters_and_lines_are_at_their_places_in_the_rectangle(program):
    drawn, whole, bent = drawn_by(program)
    assert drawn.exaggeration == 2.0  # 0.1 m of 4 m is 2.5 %
    at = np.argwhere(is_near(pixels_of(drawn), RED))[:, ::-1]
    moved = np.array([[1.0, 1.6], [1.1, 1.5]]) * (1 + 2 * 0.025, 1)
    assert np.abs(np.array([at.min(axis=0), at.max(axis=0) + 1]) - drawn.pixels(moved)).max() < 1.5

    alike = pixels_of(whole)
    for image in (alike[:, ::-1], alike[::-1]):
        assert (np.abs(alike - image).max(axis=-1) > 60).mean() < 0.01
    assert np.allclose(whole.rectangle, -np.array(whole.rectangle)[[2, 3, 0, 1]])
    assert len(whole.outline) == 2  # bore and rim, and no cut between the quarters

    pixels = pixels_of(bent)
    corner, foot, middle = bent.pixels(np.array([[0, 3], [0, 0.05], [2, 3.0]])).astype(int)
    assert is_near(pixels[corner[1], corner[0]], RED)
    out = np.floor(bent.pixels(np.array([[0.0, 3]]))[0] - 1.2).astype(int)
    assert pixels[out[1], out[0], 3] > 127  # outside the corner, where neither stroke reaches
    assert is_near(pixels[foot[1], foot[0]], BLUE)
    assert is_near(pixels[middle[1], middle[0]], (179, 179, 173))


def test_shear_changes_sign_in_each_image_and_a_vector_in_its_mirror():
    field = replace(sheet(), cell_data={"s": np.tile([3e6, 5e6, 2e6, 1e6], (800, 1))})
    for component, values in ((0, {3}), (1, {5}), (2, {-2, 2}), (3, {1})):
        scene = compose(field, replace(WORDS, component=component, mirror=("x",)))
        assert {scene.scale.low, scene.scale.high} == values
    vector = replace(WORDS, data="displacement", factor=1, component=0, mirror=("x",))
    assert compose(sheet(), vector).scale.low == pytest.approx(-0.1, rel=0.05)


def test_exaggeration_is_round_and_makes_displacements_readable_and_a_window_is_larger():
    factors = {0.065: 1.0, 0.2: 1.0, 0.5: 0.1, 1e-3: 50.0, 6.5e-7: 1e5, 0.0: 0.0, 3.0: 0.02}
    for share, factor in factors.items():
        moved = replace(SMALL, point_data={"displacement": SMALL.points * (share, 0)})
        assert compose(moved, WORDS).exaggeration == factor
    scene = compose(sheet(), replace(WORDS, window=(0.9, 1.4, 1.2, 1.6)))
    assert scene.rectangle == pytest.approx((0.9, 1.4, 1.2, 1.6), abs=1e-3)
    assert (scene.width, scene.height) == (1290, 860)


@pytest.mark.parametrize(
    ("change", "window", "message"),
    [
        ({"cells": np.zeros((0, 4), dtype=np.int64)}, None, "no cells"),
        ({"cell_data": {}}, None, "no data 's'; it has displacement"),
        ({"cell_data": {"s": np.full(8, np.nan)}}, None, "must be finite"),
        ({}, (7, 7, 8, 8), "no cells in the window"),
    ],
)
def test_a_field_that_cannot_be_drawn_is_refused_in_words(change, window, message):
    with pytest.raises(ValueError, match=message):
        draw([(replace(SMALL, **change), replace(WORDS, window=window))], None)


def test_values_at_nodes_run_evenly_through_a_large_cell_whose_pieces_cover_it():
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

    corners = np.array([[[0.0, 0, 0], [60, 0, 0], [70, 30, 0], [0, 20, 0]]])
    cut, values = pieces(corners, np.array([[0.0, 1, 1, 0]]))
    assert len(cut) == len(values) == 81  # the longest edge, 70.7 pixels, in pieces of 8
    (whole,), areas = area(corners), area(cut)
    assert areas.sum() == pytest.approx(whole, rel=1e-12)
    assert np.all(areas > 0)
    assert np.all((values > 0) & (values < 1))


def area(corners):
    """Signed areas (m,) of quadrilaterals (m, 4, 3)."""
    (x0, y0), (x1, y1) = ((corners[:, i + 2] - corners[:, i])[:, :2].T for i in (0, 1))
    return (x0 * y1 - y0 * x1) / 2


@pytest.fixture
def stub(tmp_path, monkeypatch):
    """Put a module in pyvista's place for the process that draws."""

    def place(source: str) -> None:
        (tmp_path / "pyvista.py").write_text(source)
        monkeypatch.setenv("PYTHONPATH", str(tmp_path), prepend=os.pathsep)

    return place


BLANK = """
import numpy as np
class Plotter:
    def __init__(self, off_screen, window_size): self.size = window_size
    camera = type("Camera", (), {})()
    def disable_anti_aliasing(self): pass
    add_mesh = lambda *a, **k: None
    close = disable_anti_aliasing
    def screenshot(self, **k): return np.full((SIZE, 4), 0, dtype=np.uint8)
PolyData = lambda *a, **k: None
"""


@pytest.mark.parametrize(
    ("source", "reason"),
    [
        ("import os, signal; os.kill(os.getpid(), signal.SIGSEGV)", "signal 11"),
        ("import time; time.sleep(600)", "not finished after 1 s"),
        ("raise ImportError('libEGL.so.1')", "libEGL.so.1"),
        (BLANK.replace("SIZE", "*self.size[::-1]"), "blank picture"),
        (BLANK.replace("SIZE", "300, 600"), "picture of 200x100 instead of"),
    ],
    ids=["segmentation fault", "hangs", "import", "blank", "other size"],
)
def test_where_pyvista_fails_matplotlib_draws(stub, source, reason):
    stub(source)
    [drawn] = draw([(SMALL, WORDS)], None, hint="install libegl1",
                   **({"seconds": 1} if "sleep" in source else {}))  # fmt: skip
    assert drawn.by.startswith("matplotlib")
    assert reason in drawn.why
    assert drawn.why.endswith("matplotlib was used; install libegl1")
    assert "\n" not in drawn.why
    assert not flaw(drawn.image, drawn.width, drawn.height)


FULL = f"""{BLANK}
def screenshot(self, **k):
    if self.size == SIZE:
        raise MemoryError("too large")
    image = np.zeros((*self.size[::-1], 4), np.uint8)
    image[::2] = 255
    return image
Plotter.screenshot = screenshot
"""


@pytest.mark.parametrize(
    ("source", "starts", "by"),
    [
        (FULL.replace("SIZE", "None"), 1, ["pyvista"] * 3),
        (FULL.replace("SIZE", "[3 * 860, 3 * 860]"), 2, ["pyvista", "matplotlib", "pyvista"]),
        ("raise ImportError('libEGL.so.1')", 1, ["matplotlib"] * 3),
    ],
    ids=["drawn", "the second fails", "none"],
)
def test_one_process_draws_what_comes_one_after_the_other(tmp_path, stub, source, starts, by):
    stub(f"open(__file__ + '.starts', 'a').write('x')\n{source}")
    looks = (WORDS, replace(WORDS, window=(0, 0, 1, 1)), replace(WORDS, mirror=("y",)))
    with DrawingProcess() as process:
        drawn = [draw([(SMALL, look)], None, process=process)[0] for look in looks]
    assert [one.by.split()[0] for one in drawn] == by
    assert len((tmp_path / "pyvista.py.starts").read_text()) == starts


@pytest.fixture
def no_pyvista(stub):
    """Spare the seconds that pyvista takes to start."""
    stub("raise ImportError('libEGL.so.1')")


def stored(folder):
    return Store(folder).all(picture_cache.KIND, picture_cache.SUBJECT)


def test_what_the_cache_holds_is_not_drawn_again_unless_it_is_damaged(
    tmp_path, monkeypatch, no_pyvista
):
    requests = [(SMALL, WORDS), (SMALL, replace(WORDS, mirror=("y",))), (SMALL, WORDS)]
    first = draw(requests, tmp_path)
    kept = stored(tmp_path)
    assert len(kept) == 2
    with monkeypatch.context() as patch:
        patch.setattr(pictures, "compose", None)
        patch.setattr(DrawingProcess, "draw", None)
        for old, new in zip(first, draw(requests, tmp_path), strict=True):
            assert all(np.array_equal(a, b) for a, b in zip(old.outline, new.outline, strict=True))
            assert replace(old, outline=()) == replace(new, outline=())
    for damaged in (
        lambda _: b"",
        lambda _: b"PK\x03\x04",
        lambda whole: whole[:400] + bytes([whole[400] ^ 255]) + whole[401:],
    ):
        torn = {key: damaged(whole) for key, whole in kept.items()}
        Store(tmp_path).store(picture_cache.KIND, picture_cache.SUBJECT, torn)
        assert draw(requests, tmp_path)[0].image == first[0].image
        assert stored(tmp_path) == kept


def test_anything_that_changes_the_look_changes_the_key_and_words_do_not():
    field = SMALL
    stressed = replace(field, cell_data={"s": field.cell_data["s"] * 2})
    moved = replace(field, point_data={"displacement": field.points})
    looks = [
        (field, WORDS), (stressed, WORDS), (moved, WORDS), (field, replace(WORDS, factor=1e3)),
        (field, replace(WORDS, mirror=("x",))), (field, replace(WORDS, window=(0, 0, 1, 1))),
        (field, replace(WORDS, data="displacement")),
        (field, replace(WORDS, data="displacement", component=0)),
    ]  # fmt: skip
    assert len({picture_cache.key(*look) for look in looks}) == len(looks)
    words = replace(WORDS, caption="other words", symbol="τ")
    assert picture_cache.key(field, words) == picture_cache.key(field, WORDS)


def test_pyvista_is_tried_again_once_the_machine_changed(tmp_path, no_pyvista, monkeypatch):
    [first] = draw([(SMALL, WORDS)], tmp_path)
    monkeypatch.setattr(DrawingProcess, "draw", lambda *_: ([first.image], ""))
    assert draw([(SMALL, WORDS)], tmp_path)[0].why == first.why  # not tried in vain every time
    monkeypatch.setattr(picture_cache, "opengl", lambda: "libEGL.so.1 is there now")
    assert draw([(SMALL, WORDS)], tmp_path)[0].by.startswith("pyvista")


def test_the_key_covers_every_module_that_draws():
    folder = Path(picture_cache.__file__).parent
    reached, found = set(), {"pictures", "render"}
    while todo := found - reached:
        reached |= todo
        text = "\n".join((folder / f"{name}.py").read_text("utf-8") for name in todo)
        found |= set(re.findall(r"^ *from reports\.(\w+) import", text, re.MULTILINE))
        for names in re.findall(r"^ *from reports import ([\w, ]*\w)", text, re.MULTILINE):
            found |= set(names.split(", "))
    assert set(picture_cache.CODE) == reached


def test_decades_of_a_colour_bar_are_named_at_the_places_of_their_powers():
    drawn = picture_cache.Drawn(
        image=b"", width=4, height=3, rectangle=(0.0, 0.0, 4.0, 3.0), low=1.0, high=3.2,
        ramp=("#000000", "#ffffff"), exaggeration=0.0, outline=(), by="", why="",
    )  # fmt: skip
    svg = str(framed(replace(WORDS, factor=1.0, decades=True), drawn).svg)
    found = re.findall(r'x="([\d.]+)" y="[\d.]+" text-anchor="\w+">([\d.]+)<', svg)
    assert {name: float(x) for x, name in found} == {"10": 0.0, "100": 81.8, "1000": 163.6}
