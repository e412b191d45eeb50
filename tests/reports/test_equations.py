"""Equations are drawn once, and nothing on disk changes how they look."""

import re

import pytest
import ziamath

from reports.equations import Glyphs

TEX = r"\frac{a}{b}\ \mathrm{mm}"


@pytest.fixture
def no_drawing(monkeypatch):
    def stop() -> None:
        monkeypatch.setattr(ziamath, "Latex", lambda *_, **__: pytest.fail("drawn again"))

    return stop


def test_what_was_drawn_is_not_drawn_again(tmp_path, no_drawing):
    first = Glyphs(tmp_path)
    shown = first.maths(TEX)
    symbols = first.symbols()
    no_drawing()
    second = Glyphs(tmp_path)
    assert second.maths(TEX) == shown
    assert second.symbols() == symbols
    assert not list(tmp_path.glob(".part-*"))


@pytest.mark.parametrize("torn", [b"", b'{"15 x": ', b"[1, 2]", b'{"15 x": 3}', b"\xff\xfe"])
def test_a_torn_file_is_drawn_anew(tmp_path, torn):
    whole = Glyphs(tmp_path)
    shown = whole.maths(TEX)
    whole.symbols()
    (kept,) = tmp_path.iterdir()
    kept.write_bytes(torn)
    assert Glyphs(tmp_path).maths(TEX) == shown


def test_every_glyph_that_is_used_is_there_and_each_once():
    glyphs = Glyphs()
    page = "".join(map(str, (glyphs.maths(TEX), glyphs.maths(r"a + \quad b"), glyphs.symbols())))
    defined = re.findall(r'<symbol id="([^"]+)"', page)
    assert len(set(defined)) == len(defined)
    assert set(re.findall(r'href="#([^"]+)"', page)) <= set(defined)


def test_a_place_that_cannot_be_written_costs_no_equation(tmp_path):
    (tmp_path / "file").write_text("")
    glyphs = Glyphs(tmp_path / "file")
    assert "<use" in glyphs.maths(TEX)
    glyphs.symbols()
