"""Pictures survive a failing renderer, and are drawn only once."""

import ast
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from reports import picture_cache, pictures
from reports.bitmaps import flaw
from reports.pictures import draw
from verify.core.figures import Field, Picture
from verify.core.store import Store

WORDS = Picture(field="", data="s", symbol="σ", unit="MPa", factor=1e6, caption="")


def sheet() -> Field:
    """A beam of ten squares."""
    x, y = np.meshgrid(np.arange(11.0), np.arange(2.0), indexing="ij")
    i = np.arange(x.size).reshape(x.shape)
    cells = np.stack([i[:-1, :-1], i[1:, :-1], i[1:, 1:], i[:-1, 1:]], axis=-1).reshape(-1, 4)
    points = np.column_stack([x.ravel(), y.ravel()])
    return Field(
        name="beam", points=points, cells=cells, point_data={"displacement": points / 100},
        cell_data={"s": np.linspace(-1e6, 1e6, 10)},
    )  # fmt: skip


@pytest.fixture
def stub(tmp_path_factory, monkeypatch):
    """Put a module in pyvista's place for the process that draws."""

    def place(source: str) -> None:
        folder = tmp_path_factory.mktemp("stub")
        (folder / "pyvista.py").write_text(source)
        monkeypatch.setenv("PYTHONPATH", str(folder))

    return place


@pytest.fixture
def no_pyvista(stub):
    """Spare the seconds that pyvista takes to start."""
    stub("raise ImportError('libEGL.so.1')")


def test_a_segmentation_fault_leaves_the_drawing_to_matplotlib(stub):
    stub("import os, signal; os.kill(os.getpid(), signal.SIGSEGV)")
    [drawn] = draw([(sheet(), WORDS)], None, hint="install libegl1")
    assert drawn.by.startswith("matplotlib")
    assert "signal 11" in drawn.why
    assert drawn.why.endswith("drawn by matplotlib; install libegl1")
    assert "\n" not in drawn.why
    assert not flaw(drawn.image, drawn.width, drawn.height)


def test_a_renderer_that_hangs_is_ended(stub):
    stub("import time; time.sleep(600)")
    [drawn] = draw([(sheet(), WORDS)], None, seconds=1)
    assert drawn.by.startswith("matplotlib")
    assert "not done after 1 s" in drawn.why


BLANK = """
import numpy as np
class Plotter:
    def __init__(self, off_screen, window_size): self.size = window_size
    camera = type("Camera", (), {})()
    def disable_anti_aliasing(self): pass
    add_mesh = lambda *a, **k: None
    close = disable_anti_aliasing
    def screenshot(self, **k): return np.full((SIZE, 4), ALPHA, dtype=np.uint8)
PolyData = lambda *a, **k: None
"""


@pytest.mark.parametrize(
    ("size", "alpha", "reason"),
    [
        ("*self.size[::-1]", "0", "blank picture"),
        ("*self.size[::-1]", "255", "blank picture"),
        ("300, 600", "9", "picture of 200x100 instead of"),
    ],
)
def test_a_blank_picture_or_one_of_another_size_is_drawn_again(stub, size, alpha, reason):
    stub(BLANK.replace("SIZE", size).replace("ALPHA", alpha))
    [drawn] = draw([(sheet(), WORDS)], None)
    assert reason in drawn.why
    assert not flaw(drawn.image, drawn.width, drawn.height)


def stored(folder):
    return Store(folder).all(picture_cache.KIND, picture_cache.SUBJECT)


def test_what_the_cache_holds_is_not_drawn_again(tmp_path, monkeypatch, no_pyvista):
    requests = [(sheet(), WORDS), (sheet(), replace(WORDS, mirror=("y",))), (sheet(), WORDS)]
    first = draw(requests, tmp_path)
    assert len(stored(tmp_path)) == 2
    monkeypatch.setattr(pictures, "compose", None)
    monkeypatch.setattr(pictures, "_by_pyvista", None)
    for old, new in zip(first, draw(requests, tmp_path), strict=True):
        assert all(np.array_equal(a, b) for a, b in zip(old.outline, new.outline, strict=True))
        assert replace(old, outline=()) == replace(new, outline=())


@pytest.mark.parametrize("damage", [b"", b"PK\x03\x04", None])
def test_a_damaged_picture_is_drawn_again(tmp_path, damage, no_pyvista):
    [first] = draw([(sheet(), WORDS)], tmp_path)
    [(key, whole)] = stored(tmp_path).items()
    flipped = whole[:400] + bytes([whole[400] ^ 255]) + whole[401:]
    torn = {key: flipped if damage is None else damage}
    Store(tmp_path).store(picture_cache.KIND, picture_cache.SUBJECT, torn)
    [again] = draw([(sheet(), WORDS)], tmp_path)
    assert again.image == first.image
    assert stored(tmp_path) == {key: whole}


def test_anything_that_changes_the_look_changes_the_key():
    field = sheet()
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


def test_the_key_covers_every_module_that_draws():
    folder = Path(picture_cache.__file__).parent
    reached, found = set(), {"pictures", "render"}
    while todo := found - reached:
        reached |= todo
        for name in todo:
            for node in ast.walk(ast.parse((folder / f"{name}.py").read_text("utf-8"))):
                if isinstance(node, ast.ImportFrom) and node.module == "reports":
                    found |= {alias.name for alias in node.names}
                elif isinstance(node, ast.ImportFrom) and node.module.startswith("reports."):
                    found.add(node.module.removeprefix("reports."))
    assert set(picture_cache.CODE) == reached


def test_pyvista_is_tried_again_once_the_machine_changed(tmp_path, no_pyvista, monkeypatch):
    [first] = draw([(sheet(), WORDS)], tmp_path)
    assert first.why
    monkeypatch.setattr(pictures, "_by_pyvista", lambda *_: ([first.image], ""))
    assert draw([(sheet(), WORDS)], tmp_path)[0].why == first.why  # not tried in vain every time
    monkeypatch.setattr(picture_cache, "_opengl", lambda: "libEGL.so.1 is there now")
    assert draw([(sheet(), WORDS)], tmp_path)[0].by.startswith("pyvista")
