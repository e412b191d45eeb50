"""Equations are drawn once, and nothing on disk changes how they look."""

import re

import pytest
import ziamath

from reports.equations import Glyphs
from verify.core.store import Store

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


def test_a_store_that_cannot_be_read_costs_no_equation(tmp_path):
    whole = Glyphs(tmp_path)
    shown = whole.maths(TEX)
    whole.symbols()
    Store(tmp_path).path.write_bytes(b"no database")
    again = Glyphs(tmp_path)
    assert again.maths(TEX) == shown
    assert again.symbols() == whole.symbols()


def test_every_glyph_that_is_used_is_there_and_each_once():
    glyphs = Glyphs()
    page = "".join(map(str, (glyphs.maths(TEX), glyphs.maths(r"a + \quad b"), glyphs.symbols())))
    defined = re.findall(r'<g id="([^"]+)"', page)
    assert len(set(defined)) == len(defined) == 4
    assert set(re.findall(r'href="#([^"]+)"', page)) == set(defined)
    assert "<symbol" not in page


def test_glyphs_stand_where_they_were_drawn():
    """Corners of ziamath's boxes and of the glyphs put in their place, of one size and of two."""
    tex = r"A^2 + \frac{a}{b}\ \mathrm{mm}"
    drawn = ziamath.Latex(tex, size=15, color="currentColor").svg()
    boxes = dict(re.findall(r'<symbol id="([^"]+)" viewBox="([^"]+)">', drawn))  # of one equation
    glyphs = Glyphs()
    page = str(glyphs.maths(tex)) + glyphs.symbols()
    scales = dict(re.findall(r'<g id="([^"]+)" transform="scale\(([^)]+)\)"', page))
    uses = re.findall(r'<use href="#([^"]+)"(?: x="([^"]+)")?(?: y="([^"]+)")?/>', page)
    drawn_use = re.compile(r'<use href="#(\S+)" x="(\S+)" y="(\S+)" width="(\S+)" height="(\S+)"')
    wanted = [use for use in drawn_use.findall(drawn) if use[0] in boxes]
    assert len(uses) == len(wanted) == 7
    assert len(set(scales.values())) == 2
    for (name, *at), (symbol, *box) in zip(uses, wanted, strict=True):
        left, top, wide, high = map(float, boxes[symbol].split())
        x, y, k = *(float(v or 0) for v in at), float(scales[name])
        shown = x + k * left, y + k * top, k * wide, k * high
        assert shown == pytest.approx([float(v) for v in box], abs=0.02)
