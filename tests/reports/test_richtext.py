"""Marked-up text as runs and as one string."""

import pytest
from markupsafe import Markup

from reports import formats, svg
from reports.richtext import digits, plain, runs


def test_only_markup_has_tags():
    assert runs("<b>x</b>") == ["<b>x</b>"]
    assert runs(Markup("a<sub>b</sub>")) == ["a", ["sub", "b"]]
    assert runs("") == []


def test_tags_nest_and_breaks_hold_nothing():
    assert runs(Markup("<var>u<sub>r</sub></var><br>x")) == [
        ["var", "u", ["sub", "r"]], ["br"], "x",
    ]  # fmt: skip


def test_escaped_text_comes_back_as_it_was():
    text = '<script>alert("1")</script> & x < y'
    assert plain(formats.prose(text)) == text


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        ("1.2e-08", ["1.2", ["small", "×10", ["sup", "−8"]]]),
        ("−5e+07", ["−5", ["small", "×10", ["sup", "7"]]]),
        ("12.5", ["12.5"]),
        ("–", ["–"]),
        ("1e5 runs", ["1e5 runs"]),
    ],
)
def test_a_power_of_ten_is_raised(written, expected):
    assert digits(written) == expected


def test_powers_and_indices_survive_in_one_string():
    assert plain(formats.power(2.1e-8)) == "2.1×10⁻⁸"
    assert plain(formats.symbol("u_r(r_i)")) == "u_r(r_i)"


def test_the_star_of_a_symbol_is_not_part_of_its_index():
    assert formats.symbol("K_1*") == "<var>K<sub>1</sub>*</var>"
    assert ">1</tspan>" in svg.lowered("K_1*")
