"""Verdicts from rows, errata and declarations; evidence that does not stand gives none."""

from types import SimpleNamespace

import numpy as np
import pytest

from verify.core.results import Kind, Status
from verify.core.verdicts import DesignRange, Form, Safe, Side, Verdict
from verify.verdicts import evidence, found
from verify.verdicts.declared import Formula

ID = "ring-lame/x"


def formula(**changes):
    given = {"equation": 6, "what": "x", "safe": Safe.ABOVE, "safe_reason": "a margin"}
    return Formula(**given | {"part": (ID,)} | changes)


def verdict(declared, *rows):
    return found._verdict("huang2018", "Huang 2018", declared, {row.id: row for row in rows})


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"status": Status.FAIL}, "ring-lame/x is FAIL"),
        ({"status": Status.SKIP}, "ring-lame/x is SKIP"),
        ({"status": Status.CALIBRATED}, "ring-lame/x is CALIBRATED"),
        ({"status": Status.SHOWN}, "ring-lame/x is SHOWN"),  # no meshes that converge beside it
        ({"kind": Kind.FACT}, "compares no formula with a reference"),
        ({"tolerance": None}, "no error with an uncertainty"),
    ],
)
def test_evidence_that_does_not_stand_gives_no_verdict(row, changes, says):
    got = verdict(formula(), row("x", 0.001, **changes))
    assert got.verdict is Verdict.NONE
    assert says in got.words


def test_a_row_that_was_not_run_gives_no_verdict():
    assert verdict(formula()).verdict is Verdict.NONE


def test_without_evidence_nothing_can_be_declared():
    with pytest.raises(ValueError, match="give one of defines, missing, or evidence"):
        formula(part=())


def test_a_measured_error_counts_where_its_meshes_converge(row):
    shown = row("x", -0.2, status=Status.SHOWN)
    beside = row("x: convergence", 0.0, kind=Kind.FACT)
    got = verdict(formula(), shown, beside)
    assert got.verdict is Verdict.UNSAFE
    assert got.words.startswith(
        "unsafe: up to 20 % below; −20 % at the case's own inputs, the only ones compared; a higher"
    )


def test_an_identity_alone_is_exact_and_beside_the_part_a_second_statement(row):
    same = row("same", 1e-6, kind=Kind.IDENTITY, detects=1e-4)
    assert verdict(formula(part=(), model=("ring-lame/same",)), same).verdict is Verdict.EXACT
    got = verdict(formula(model=("ring-lame/same",)), same, row("x", 0.3))
    assert got.verdict is Verdict.CONSERVATIVE
    assert got.model == "solves its own idealisation to rounding"


def test_an_identity_that_is_not_sharp_is_not_exact(row):
    blunt = row("same", 1e-6, kind=Kind.IDENTITY, detects=0.02)
    got = verdict(formula(part=(), model=("ring-lame/same",)), blunt)
    assert got.verdict is Verdict.PART
    assert "same simplifications" in got.words


def test_a_misprint_is_wrong_where_its_error_leaves_the_bar(row):
    printed = formula(errata=("eq-9-centrifugal",))
    assert verdict(printed, row("x", 0.2, 0.01)).verdict is Verdict.WRONG
    hidden = verdict(printed, row("x", 0.002, 0.01))
    assert hidden.verdict is Verdict.NONE
    assert "has no error" in hidden.words


def test_a_misprint_without_a_row_needs_a_test_of_its_own():
    shown = formula(part=(), errata=("eq-9-centrifugal",), limited_by="no growth")
    assert verdict(shown).verdict is Verdict.WRONG
    untested = formula(part=(), errata=("fig-2-3-captions",), limited_by="x")
    assert verdict(untested).words == "erratum fig-2-3-captions is shown by no row and no test"


@pytest.mark.parametrize(
    ("changes", "kind"),
    [({"defines": "x"}, Verdict.DEFINITION), ({"missing": "x"}, Verdict.UNVERIFIABLE)],
)
def test_what_has_no_evidence_says_why(changes, kind):
    got = verdict(formula(part=(), **changes))
    assert (got.verdict, got.words) == (kind, "x")


def test_a_corrected_form_has_no_errata():
    with pytest.raises(ValueError, match="errata belong to the printed form"):
        formula(form=Form.CORRECTED, errata=("eq-9-centrifugal",))


def test_a_caution_needs_a_row_that_stands_and_joins_the_sentence(row):
    warned = formula(caution="but it buckles", caution_row="ring-lame/c")
    stands = row("c", 0.0, kind=Kind.FACT)
    assert verdict(warned, row("x", 0.001), stands).words.endswith("; but it buckles")
    contradiction = row("c", 0.0, kind=Kind.FACT, status=Status.NOTE)
    assert verdict(warned, row("x", 0.001), contradiction).verdict is Verdict.PART
    failed = row("c", 0.0, kind=Kind.FACT, status=Status.FAIL)
    assert verdict(warned, row("x", 0.001), failed).words == "ring-lame/c is FAIL"
    with pytest.raises(ValueError, match="give caution and caution_row together"):
        formula(caution="but it buckles")


def test_a_missing_datum_may_have_a_caution_too(row):
    warned = formula(part=(), missing="no data", caution="it slips", caution_row="ring-lame/c")
    assert verdict(warned, row("c", 0.0, kind=Kind.FACT)).words == "no data; it slips"
    assert verdict(warned).verdict is Verdict.NONE


def test_readings_state_how_far_the_value_moves(row):
    read = formula(readings=("ring-lame/a", "ring-lame/b"))
    rows = (row("x", 0.001), row("a", 0.0, analytic=0.9), row("b", 0.0, analytic=1.1))
    assert verdict(read, *rows).readings == "x 0.9 to 1.1 1 (±10 %)"


def test_a_design_range_that_no_study_spans_leaves_a_part(row, monkeypatch):
    plan = SimpleNamespace(points=np.zeros((2, 1)), case=SimpleNamespace(id="ring-lame"))
    course = SimpleNamespace(error=np.array([0.001, 0.002]), U_error=np.zeros(2))
    side = Side(name="T", symbol="T", unit="N", low=1.0, high=9.0)
    monkeypatch.setattr(found, "ranges", lambda _: ())
    monkeypatch.setattr(evidence, "_studies", lambda _: [(plan, course)])
    for spanned, expected in ((True, Verdict.ACCURATE), (False, Verdict.PART)):
        one = DesignRange(case="ring-lame", words="T 1 to 9 N", source="", side=side,
                          spanned=spanned)  # fmt: skip
        monkeypatch.setattr(found, "design", lambda *_, one=one: (one,))
        assert verdict(formula(), row("x", 0.001)).verdict is expected
    assert "not compared over all of T 1 to 9 N" in verdict(formula(), row("x", 0.001)).words
    monkeypatch.setattr(found, "design", lambda *_: ())
    assert verdict(formula(), row("x", 0.001)).verdict is Verdict.PART  # no range is declared


def test_a_caution_keeps_a_formula_from_being_accurate(row, monkeypatch):
    plan = SimpleNamespace(points=np.zeros((2, 1)), case=SimpleNamespace(id="ring-lame"))
    course = SimpleNamespace(error=np.array([0.001, 0.002]), U_error=np.zeros(2))
    side = Side(name="T", symbol="T", unit="N", low=1.0, high=9.0)
    one = DesignRange(case="ring-lame", words="", source="", side=side, spanned=True)
    monkeypatch.setattr(found, "ranges", lambda _: ())
    monkeypatch.setattr(found, "design", lambda *_: (one,))
    monkeypatch.setattr(evidence, "_studies", lambda _: [(plan, course)])
    assert verdict(formula(), row("x", 0.001)).verdict is Verdict.ACCURATE
    warned = formula(caution="but it buckles", caution_row="ring-lame/c")
    rows = row("x", 0.001), row("c", 0.0, kind=Kind.FACT)
    assert verdict(warned, *rows).verdict is Verdict.PART
