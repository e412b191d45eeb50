"""Equations of a page: drawn at their places, each glyph once, as source where nothing draws."""

import re
import sys

import pytest

from reports import equations
from reports.equations import SYMBOLS, Equations
from reports.mathematics import tree


def page(*texs):
    drawn = Equations()
    return drawn.placed("".join(f"<p>{drawn.maths(tex)}</p>" for tex in texs) + SYMBOLS)


def test_every_glyph_that_is_used_is_there_and_each_once():
    drawn = page(r"\frac{a}{b}\ \mathrm{m}", "a + m", r"\frac{a}{b}\ \mathrm{m}")
    defined = re.findall(r'<g id="([^"]+)"', drawn)
    assert len(set(defined)) == len(defined) == 5  # an italic and an upright m
    assert set(re.findall(r'href="#([^"]+)"', drawn)) == set(defined)
    assert drawn.count(' role="img"') == 3
    assert drawn.count("<path d=") == 5 + 2  # and the rules of two fractions
    assert "equation 0" not in drawn


def test_letters_stand_on_the_line_of_the_text():
    """A fraction reaches below the base line by its denominator; a letter without tail does not."""
    below = [
        float(d) for d in re.findall(r"vertical-align:-?([\d.]+)px", page("a", r"\frac{a}{b}"))
    ]
    assert below[0] == pytest.approx(0.2, abs=0.15)  # the bowl of an a
    assert 8 < below[1] < 12
    places = re.findall(r'<use href="#\S+" x="\S+" y="([\d.]+)"', page(r"a + \frac{a}{b}"))
    base, _, above, under = map(float, places)
    assert above < base < under


def test_what_the_text_may_hold_does_not_end_the_drawing():
    assert 'aria-label="a &lt; &#34;b&#34;"' in page('a < "b"')


@pytest.mark.parametrize("missing", ["typst", "rule"])
def test_the_source_stands_where_nothing_draws(missing, monkeypatch):
    if missing == "typst":
        monkeypatch.setitem(sys.modules, "typst", None)
    else:
        monkeypatch.setattr(equations, "tree", lambda tex: {"<b": tree(tex)}[tex])
    drawn = page("a", "<b")
    assert "<code>a</code>" in drawn
    assert ("<code>&lt;b</code>" in drawn) is (missing == "typst")
    assert drawn.count("<svg") == (missing == "rule")
