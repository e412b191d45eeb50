"""Marked-up text, numbers and equations in the form in which they are printed."""

import re
import sys
from dataclasses import replace
from math import inf

import pytest
from markupsafe import Markup

from reports import equations, formats, svg
from reports.equations import Equations
from reports.formats import concise, difference, fraction, tolerance, values
from reports.glyphs import SYMBOLS
from reports.mathematics import tree
from reports.richtext import digits, plain, runs
from reports.rows import HEADER, cells
from reports.signature import position
from verify.cases.registry import find
from verify.core.references import reference_name
from verify.core.results import Kind


def test_only_markup_has_tags_and_escaped_text_comes_back_as_it_was():
    assert runs("<b>x</b>") == ["<b>x</b>"]
    assert runs("") == []
    assert runs(Markup("a <var>u<sub>r</sub></var><br>x")) == [
        "a ", ["var", "u", ["sub", "r"]], ["br"], "x",
    ]  # fmt: skip
    assert digits("1.2e-08") == ["1.2", ["small", "×10", ["sup", "−8"]]]
    assert digits("−5e+07") == ["−5", ["small", "×10", ["sup", "7"]]]
    assert [digits(word) for word in ("12.5", "1e5 runs")] == [["12.5"], ["1e5 runs"]]
    text = '<script>alert("1")</script> & x < y'
    assert plain(formats.prose(text)) == text
    assert str(formats.prose("by analytic.ring.lame, 3.5 mm")) == (
        "by analytic.<wbr>ring.<wbr>lame, 3.5 mm"  # a narrow column breaks there
    )
    assert plain(formats.power(2.1e-8)) == "2.1×10⁻⁸"
    assert plain(formats.symbol("u_r(r_i)")) == "u_r(r_i)"
    assert formats.symbol("K_1*") == "<var>K<sub>1</sub>*</var>"  # the star is above the index
    assert ">1</tspan>" in svg.lowered("K_1*")


@pytest.mark.parametrize(
    ("value", "u", "expected"),
    [
        (0.58178958, 3.9e-7, "0.58178958(39)"), (210.6194, 2.1e-3, "210.6194(21)"),
        (-57.245, 4.4e-3, "−57.2450(44)"), (1234.5, 25.0, "1234(25)"),
        (1.0, 9.97e-6, "1.000000(10)"), (0.1, 1e-20, "0.100000000(1)"), (0.0, 2e-3, "0.0000(20)"),
    ],
)  # fmt: skip
def test_an_uncertainty_stands_in_brackets_in_units_of_the_last_digit(value, u, expected):
    assert concise(value, u)[0] == expected


def without_tags(markup):
    return re.sub("<[^>]*>", "", str(markup)).replace("−", "-").replace("\u202f", " ")


def test_a_row_of_negative_values_lies_in_its_interval_on_the_page(of_paper):
    """Formula and reference are negative, the formula being the smaller magnitude."""
    rows = of_paper(find("contact-roller-end")).rows
    row = next(r for r in rows if r.quantity.startswith("exponent of the pressure"))
    assert row.reference < row.analytic < 0
    assert without_tags(difference(row)) == "-0.063 %"
    low, high = (float(end.removesuffix(" %")) for end in without_tags(tolerance(row)).split(" to"))
    assert low < -0.063 < high
    assert -1 < position(row) < 1


def test_another_reference_than_finite_elements_is_named_beside_its_value(of_paper):
    for row in of_paper(find("rotor-clutch")).rows:
        name = reference_name(row)
        if row.kind is Kind.APPROXIMATION:
            expected = "" if name == "FE" or name.startswith("printed") else name
            assert values(row).by == expected, row.id
    row = next(
        r for r in of_paper(find("contact-roller-flat")).rows
        if r.grid is not None and r.by == "half-space" and r.analytic and r.interval
    )  # fmt: skip
    assert row.reference == row.partner.value == row.grid.levels[-1][1]
    assert values(row).by == "half-space"
    found = dict(zip(HEADER, cells(row), strict=True))
    assert (found["by"], found["fem"], found["reference"]) == ("half-space", None, row.reference)


def test_fractions_are_percents_and_balances_are_numbers(report):
    identity = next(row for row in report.rows if row.kind is Kind.IDENTITY)
    balance = replace(identity, kind=Kind.EXACT)
    for row, value, expected in (
        (identity, 0.0123, "1.2 %"), (identity, 1.23e-9, "1.2×10-7 %"), (identity, inf, "–"),
        (balance, 1.23e-9, "1.2×10-9"),
    ):  # fmt: skip
        assert without_tags(fraction(row, value)) == expected


def letters(word):
    return ["row", *(["letter", c] for c in word)]


TREES = {
    "E'": ["scripts", ["letter", "E"], None, ["letter", "′"]],
    r"\frac{a}{b}": ["fraction", ["letter", "a"], ["letter", "b"]],
    "x_{rs}^2": ["scripts", ["letter", "x"], letters("rs"), ["words", "2"]],
    r"\sum_i^n": ["limits", ["sign", "∑"], ["letter", "i"], ["letter", "n"]],
    r"\int_0^l": ["scripts", ["sign", "∫"], ["words", "0"], ["letter", "l"]],
    r"\mathrm{mm}": ["upright", "mm"],
    r"\cos": ["function", "cos"],
    r"\dot{q}": ["accent", ["letter", "q"], "\u0307"],
    r"\sqrt{x}": ["root", ["letter", "x"], None],
    r"\sqrt[3]{x}": ["root", ["letter", "x"], ["words", "3"]],
    r"\left. x\right|": ["fenced", "", ["letter", "x"], "|"],
    r"\text{if it}": ["words", "if\u00a0it"],
    r"\,": ["space", 0.167],
    r"\begin{bmatrix} a & b \\ c & d\end{bmatrix}": ["fenced", "[", ["table", "center", [
        [["letter", "a"], ["letter", "b"]], [["letter", "c"], ["letter", "d"]]]], "]"],
    r"a\begin{pmatrix} b\end{pmatrix}\begin{pmatrix} c\end{pmatrix}": [
        "row", ["letter", "a"], ["fenced", "(", ["table", "center", [[["letter", "b"]]]], ")"],
        ["fenced", "(", ["table", "center", [[["letter", "c"]]]], ")"]],
    r"\begin{cases} a & b \end{cases}":
        ["fenced", "{", ["table", "left", [[["letter", "a"], ["letter", "b"]]]], ""],
}  # fmt: skip


def test_a_formula_becomes_the_tree_that_one_writes_by_hand():
    assert {tex: tree(tex) for tex in TREES} == TREES


def test_every_formula_of_a_report_has_a_tree_and_others_are_refused(report):
    texs = [e["tex"] for e in report.equations]
    texs += [e[key] for e in report.errata for key in ("printed_tex", "right_tex")]
    texs += [tex for c in report.cases for e in c.equations for tex in (e.tex, e.numbers)]
    assert len([tree(tex) for tex in texs if tex]) > 100
    with pytest.raises(ValueError, match="the TeX element menclose is not supported"):
        tree(r"\boxed{x}")


def page(*texs):
    drawn = Equations()
    return drawn.placed(["".join(f"<p>{drawn.maths(tex)}</p>" for tex in texs) + SYMBOLS])[0]


def test_letters_stand_on_the_line_of_the_text():
    """A fraction reaches below the base line by its denominator; a letter without tail does not."""
    below = re.findall(r"vertical-align:-?([\d.]+)px", page("a", r"\frac{a}{b}"))
    assert float(below[0]) == pytest.approx(0.2, abs=0.15)  # the bowl of an a
    assert 8 < float(below[1]) < 12


def test_only_an_equation_wider_than_a_phone_is_long():
    drawn = re.findall("<svg[^>]*>", page("a = b", "a" + " + b" * 60))
    assert [" data-long" in opening for opening in drawn] == [False, True]


def test_pieces_of_a_large_bracket_stand_one_above_the_other():
    """The bracket around four lines is as high as they are."""
    drawn = page(r"\begin{pmatrix} a \\ b \\ c \\ d \end{pmatrix}")
    high = float(re.search(r'viewBox="0 0 [\d.]+ ([\d.]+)"', drawn)[1])
    outlines = re.findall(r'<path id="\w+" transform="scale\(0.01 -0.01\)" d="([^"]*)"', drawn)
    starts = [[float(y) / 100 for y in re.findall(r"M-?\d+[ ]?(-?\d+)", d)] for d in outlines]
    assert max(max(ys) - min(ys) for ys in starts) > high / 3


def test_a_number_that_is_repeated_is_drawn_once():
    drawn = page("x = 3.1415", "y = 3.1415", "z = 2.7182")
    assert drawn.count("<g id=") == 1
    (body,) = re.findall(r'<g id="(\w+)">', drawn)
    assert drawn.count(f'<use href="#{body}"') == 2
    once = page("x = 3.1415")
    assert "<g id=" not in once
    assert once.count("<use ") == 2 + len("3.1415")


def test_the_source_of_an_equation_stands_where_nothing_draws(monkeypatch):
    with monkeypatch.context() as patch:
        patch.setattr(equations, "tree", lambda tex: {"<b": tree(tex)}[tex])  # no rule for an a
        drawn = page("a", "<b")
    assert drawn.count("<code>a</code>") == drawn.count("<svg") == 1
    monkeypatch.setitem(sys.modules, "typst", None)
    drawn = page("a", "<b")
    assert "<code>a</code>" in drawn
    assert "<code>&lt;b</code>" in drawn
    assert "<svg" not in drawn
