"""TeX as a tree: by hand for each kind of node, and for every formula of a report."""

import pytest

from reports.mathematics import tree


def letters(word):
    return ["row", *(["letter", c] for c in word)]


@pytest.mark.parametrize(
    ("tex", "expected"),
    [
        ("x", ["letter", "x"]),
        ("E'", ["scripts", ["letter", "E"], None, ["letter", "′"]]),
        (r"\frac{a}{b}", ["fraction", ["letter", "a"], ["letter", "b"]]),
        ("x_{rs}^2", ["scripts", ["letter", "x"], letters("rs"), ["words", "2"]]),
        (r"\sum_i^n", ["limits", ["sign", "∑"], ["letter", "i"], ["letter", "n"]]),
        (r"\int_0^l", ["scripts", ["sign", "∫"], ["words", "0"], ["letter", "l"]]),
        (r"\mathrm{mm}", ["upright", "mm"]),
        (r"\cos", ["function", "cos"]),
        (r"\dot{q}", ["accent", ["letter", "q"], "\u0307"]),
        (r"\sqrt{x}", ["root", ["letter", "x"], None]),
        (r"\sqrt[3]{x}", ["root", ["letter", "x"], ["words", "3"]]),
        (r"\left(x\right)", ["fenced", "(", ["letter", "x"], ")"]),
        (r"\left. x\right|", ["fenced", "", ["letter", "x"], "|"]),
        (r"\text{if it}", ["words", "if\u00a0it"]),
        (r"\,", ["space", 0.167]),
        (
            r"\begin{bmatrix} a & b \\ c & d\end{bmatrix}",
            ["fenced", "[", ["table", "center", [
                [["letter", "a"], ["letter", "b"]], [["letter", "c"], ["letter", "d"]]]], "]"],
        ),
        (
            r"a\begin{pmatrix} b\end{pmatrix}\begin{pmatrix} c\end{pmatrix}",
            ["row", ["letter", "a"],
             ["fenced", "(", ["table", "center", [[["letter", "b"]]]], ")"],
             ["fenced", "(", ["table", "center", [[["letter", "c"]]]], ")"]],
        ),
        (
            r"\begin{cases} a & b \end{cases}",
            ["fenced", "{", ["table", "left", [[["letter", "a"], ["letter", "b"]]]], ""],
        ),
    ],
)  # fmt: skip
def test_a_formula_becomes_the_tree_that_one_writes_by_hand(tex, expected):
    assert tree(tex) == expected


def test_what_no_rule_knows_is_said():
    with pytest.raises(ValueError, match="mathematics: no rule for menclose"):
        tree(r"\boxed{x}")


def formulas(report):
    for e in report.equations:
        yield e["tex"]
    for e in report.errata:
        yield from (e["printed_tex"], e["right_tex"])
    for case in report.cases:
        for e in case.equations:
            yield from (e.tex, e.numbers)


def test_every_formula_of_a_report_has_a_tree(report):
    found = [tree(tex) for tex in formulas(report) if tex]
    assert len(found) > 100
