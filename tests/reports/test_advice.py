"""What to use in place of a formula, and what a verdict says beside one case."""

from dataclasses import replace

import pytest

from reports.advice import advised, of_case
from verify.core.verdicts import Form, Verdict
from verify.verdicts.record import kept

ONE = replace(
    next(v for v in kept() if v.verdict is Verdict.WRONG), id="p/Eq. 1, printed", name="Eq. 1",
    paper="p", form=Form.PRINTED, instead="",
)  # fmt: skip
RIGHT = replace(ONE, id="p/Eq. 1, corrected", form=Form.CORRECTED, verdict=Verdict.ACCURATE,
                within=0.02)  # fmt: skip


@pytest.mark.parametrize(
    ("corrected", "words"),
    [
        ({}, "the corrected form, accurate within 2 %"),
        ({"verdict": Verdict.PART}, "the corrected form, accurate within 2 % in part of the range"),
        ({"verdict": Verdict.DEFINITION}, "the corrected form"),
        (
            {"verdict": Verdict.CONSERVATIVE, "instead": "x"},
            "the corrected form, conservative; or x",
        ),
        ({"verdict": Verdict.UNSAFE, "instead": "x"}, "x"),
        ({"verdict": Verdict.UNVERIFIABLE}, ""),
    ],
)
def test_a_printed_form_is_advised_by_its_corrected_form(corrected, words):
    printed, _ = advised([ONE, replace(RIGHT, **corrected)])
    assert printed.instead == words


def test_other_advice_stands_and_other_forms_have_none():
    own = replace(ONE, instead="a table")
    usable = replace(ONE, verdict=Verdict.ACCURATE)
    other = replace(RIGHT, paper="q")
    assert [v.instead for v in advised([own, RIGHT])] == ["a table", ""]
    assert advised([usable, RIGHT])[0].instead == advised([ONE, other])[0].instead == ""


def test_a_case_has_the_largest_error_of_its_own_rows(report):
    case = next(c for c in report.cases if c.id == "polyhedral-ring")
    others = next(c for c in report.cases if c.id == "ring-lame")
    first, second, *_ = [r for r in case.rows if r.tolerance and r.scale and r.difference]
    foreign = next(r for r in others.rows if r.tolerance and r.scale)
    verdict = replace(
        RIGHT, error=9.0, U=0.1, is_of_part=True, rows=(first.id, foreign.id),
        model_rows=(second.id,), words="+900 % ± 10 % at the case's own inputs",
    )  # fmt: skip
    (found,) = of_case([verdict], case.id, case.rows)
    assert found.error == first.difference / first.scale
    assert first.tolerance / first.scale == found.U
    assert found.is_of_part
    assert found.words == "+900 % ± 10 % at the inputs of another case"
    (model,) = of_case([replace(verdict, rows=(foreign.id,))], case.id, case.rows)
    assert (model.error, model.is_of_part) == (second.difference / second.scale, False)
    assert of_case([replace(verdict, rows=(), model_rows=())], case.id, case.rows) == []
    (none,) = of_case([replace(verdict, error=None)], case.id, case.rows)
    assert none.error is None
