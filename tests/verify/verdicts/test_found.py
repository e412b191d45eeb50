"""Verdicts from rows, errata and declarations; invalid evidence gives no verdict."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from verify.core.results import Kind, Status
from verify.core.verdicts import DesignRange, Form, Safe, Side, Verdict, VerdictRange
from verify.verdicts import evidence, found, words
from verify.verdicts.declared import Formula, declared, rows_of_corrected
from verify.verdicts.misprint import misprint

ID, RIGHT = "ring-lame/x", "ring-lame/right"
MISPRINT = {"errata": ("eq-9-centrifugal",)}
CAUTION = {"caution": "but it buckles", "caution_row": "ring-lame/c"}


def formula(**changes):
    given = {"equation": 6, "what": "x", "safe": Safe.ABOVE, "safe_reason": "a margin"}
    return Formula(**given | {"part": (ID,)} | changes)


def verdict(declared, *rows, corrected=()):
    known = {row.id: row for row in rows}
    return found._verdict("huang2018", "Huang 2018", declared, known, corrected)


def test_evidence_that_failed_or_was_not_run_gives_no_verdict(row):
    for changes, expected in (
        ({"status": Status.FAIL}, "ring-lame/x cannot be evidence: it has the status FAIL"),
        ({"status": Status.CALIBRATED}, "it has the status CALIBRATED"),
        ({"status": Status.NOTE}, "it has the status NOTE"),  # enough for a caution alone
        (
            {"status": Status.SHOWN},
            "ring-lame/x cannot be evidence: it has the status SHOWN",
        ),  # no meshes that converge beside it
        ({"kind": Kind.FACT}, "does not compare formula and reference"),
        ({"tolerance": None}, "the uncertainty of its error, was not computed"),
    ):
        got = verdict(formula(), row("x", 0.001, **changes))
        assert got.verdict is Verdict.NONE
        assert expected in got.words
        assert verdict(formula()).verdict is Verdict.NONE


def test_an_error_is_formula_less_reference_also_where_a_row_states_reference_less_formula(row):
    for kind, difference in ((Kind.APPROXIMATION, 0.03), (Kind.IDENTITY, -0.03)):
        got = verdict(formula(), row("x", 0.03, kind=kind, difference=difference, detects=0.05))
        assert got.error == pytest.approx(0.03)
        assert (got.above, got.below) == (pytest.approx(0.03), 0.0)


def test_what_is_no_declaration_is_refused():
    for changes, expected in (
        ({"part": ()}, "give one of defines, missing, or evidence"),
        ({"form": Form.CORRECTED} | MISPRINT, "only the printed form can have errata"),
        ({"caution": "but it buckles"}, "give caution and caution_row together"),
    ):
        with pytest.raises(ValueError, match=expected):
            formula(**changes)


def test_a_measured_error_counts_where_its_meshes_converge(row):
    shown = row("x", -0.2, status=Status.SHOWN)
    got = verdict(formula(), shown, row("x: convergence", 0.0, kind=Kind.FACT))
    assert got.verdict is Verdict.UNSAFE
    assert got.words.startswith(
        "unsafe: the values are up to 20 % below the reference. The error is −20 % at the default "
        "inputs, which are the only inputs compared. Values above the reference"
    )
    same = row("x", -0.2, status=Status.SHOWN, kind=Kind.IDENTITY)  # an identity is predicted
    got = verdict(formula(), same, row("x: convergence", 0.0, kind=Kind.FACT))
    assert got.verdict is Verdict.NONE


def test_an_identity_alone_is_exact_if_sharp_and_beside_the_part_a_second_statement(row):
    same = row("same", 1e-6, kind=Kind.IDENTITY, detects=1e-4)
    assert verdict(formula(part=(), model=("ring-lame/same",)), same).verdict is Verdict.EXACT
    got = verdict(formula(model=("ring-lame/same",)), same, row("x", 0.3))
    assert got.verdict is Verdict.CONSERVATIVE
    assert got.model == "solves its idealisation to rounding error"
    of_part = verdict(formula(part=("ring-lame/same",)), same)  # compared with the part itself
    assert of_part.verdict is Verdict.PART
    rows = same, row("x", 0.003)
    got = verdict(formula(part=(), model=("ring-lame/same", ID)), *rows)
    assert got.verdict is Verdict.PART
    blunt = row("same", 1e-6, kind=Kind.IDENTITY, detects=0.02)
    got = verdict(formula(part=(), model=("ring-lame/same",)), blunt)
    assert got.verdict is Verdict.PART
    assert "same simplifications" in got.words


def test_what_has_no_evidence_has_a_reason():
    for key, kind in (("defines", Verdict.DEFINITION), ("missing", Verdict.UNVERIFIABLE)):
        got = verdict(formula(part=(), **{key: "why"}))
        assert (got.verdict, got.words) == (kind, "why")


def test_a_caution_needs_a_passed_row_and_is_added_to_the_sentence(row):
    warned = formula(**CAUTION)
    stands = row("c", 0.0, kind=Kind.FACT)
    assert verdict(warned, row("x", 0.001), stands).words.endswith(". But it buckles")
    contradiction = row("c", 0.0, kind=Kind.FACT, status=Status.NOTE)
    assert verdict(warned, row("x", 0.001), contradiction).verdict is Verdict.PART
    failed = row("c", 0.0, kind=Kind.FACT, status=Status.FAIL)
    assert verdict(warned, row("x", 0.001), failed).words == (
        "ring-lame/c cannot be evidence: it has the status FAIL"
    )
    unknown = formula(part=(), missing="no data", **CAUTION)
    assert verdict(unknown, stands).words == "no data. But it buckles"
    assert verdict(unknown).verdict is Verdict.NONE


def test_readings_state_how_far_the_value_moves(row):
    read = formula(readings=("ring-lame/a", "ring-lame/b"))
    rows = (row("x", 0.001), row("a", 0.0, analytic=0.9), row("b", 0.0, analytic=1.1))
    assert verdict(read, *rows).readings == "x = 0.9 to 1.1 1 (±10 %)"


def test_accurate_is_what_a_study_spans_the_design_range_of_without_a_caution(row, monkeypatch):
    plan = SimpleNamespace(points=np.zeros((2, 1)), case=SimpleNamespace(id="ring-lame"))
    course = SimpleNamespace(error=np.array([0.001, 0.002]), U_error=np.zeros(2))
    side = Side(name="T", symbol="T", unit="N", low=1.0, high=9.0)
    monkeypatch.setattr(found, "ranges", lambda _: ())
    monkeypatch.setattr(evidence, "_studies", lambda _: [(plan, course)])
    rows = row("x", 0.001), row("c", 0.0, kind=Kind.FACT)
    for spanned, expected in ((True, Verdict.ACCURATE), (False, Verdict.PART)):
        one = DesignRange(case="ring-lame", words="T 1 to 9 N", source="", side=side,
                          spanned=spanned)  # fmt: skip
        monkeypatch.setattr(found, "design", lambda *_, one=one: (one,))
        assert verdict(formula(), *rows).verdict is expected
        assert verdict(formula(**CAUTION), *rows).verdict is Verdict.PART
    missing = "No study covers the complete design range T 1 to 9 N"
    got = verdict(formula(), *rows)
    assert missing in got.words
    # a case without a study has a separate sentence
    assert missing not in words.sentences(replace(got, own_only=("ring-lame",)))
    monkeypatch.setattr(found, "design", lambda *_: ())
    assert verdict(formula(), *rows).verdict is Verdict.PART  # no range is declared


def test_an_accurate_formula_states_its_unsafe_side(row):
    low, high = (verdict(formula(), row("x", error, 0.001)).words for error in (-0.004, 0.004))
    assert ". Some values are at most 0.5 % too low, which is the unsafe side" in low
    assert ". All errors are on the safe side" in high


def studied(monkeypatch, *errors, is_star=True, held=""):
    """A study of two inputs with these errors."""
    plan = SimpleNamespace(points=np.zeros((len(errors), 2)), case=SimpleNamespace(id="ring-lame"))
    course = SimpleNamespace(error=np.array(errors), U_error=np.zeros(len(errors)))
    sides = [Side(name=n, symbol=n, unit="N", low=1.0, high=9.0) for n in ("T", "z")]
    one = VerdictRange(case="ring-lame", limit=0.1, words="", over=f"T, z{held}",
                       studied=tuple(sides), box=tuple(sides), is_star=is_star, inside=1,
                       points=2)  # fmt: skip
    monkeypatch.setattr(found, "ranges", lambda _: (one,))
    monkeypatch.setattr(found, "design", lambda *_: ())
    monkeypatch.setattr(evidence, "_studies", lambda _: [(plan, course)])


def test_inputs_that_were_changed_one_at_a_time_give_no_largest_error(row, monkeypatch):
    """Two inputs at the ends of their ranges may err more than each of them alone."""
    x = row("x", 0.001)
    for is_star, most in ((True, "up to"), (False, "at most")):
        studied(monkeypatch, 0.001, -0.2, is_star=is_star)
        side = f". Other values are {most} 20 % too low, which is the unsafe side"
        assert side in verdict(formula(), x).words
        words = verdict(formula(safe=Safe.NEITHER), row("x", 0.2)).words
        assert (" (one input varied at a time)." in words) == is_star


def test_a_study_of_one_input_at_a_time_beside_a_grid_gives_no_largest_error(row, monkeypatch):
    studied(monkeypatch, 0.001, -0.2)
    (star,) = found.ranges(())
    grid = replace(star, is_star=False)
    for ranges, most in (((grid, star), "up to"), ((grid, grid), "at most")):
        monkeypatch.setattr(found, "ranges", lambda _, ranges=ranges: ranges)
        words = verdict(formula(), row("x", 0.001)).words
        assert f". Other values are {most} 20 % too low, which is the unsafe side" in words
        assert words.count("T 1 to 9 N, z 1 to 9 N in ring-lame") <= 1  # no range twice


def test_an_error_beyond_the_limits_at_the_default_inputs_comes_first(row, monkeypatch):
    studied(monkeypatch, 0.01, 0.2, -0.03)
    words = verdict(formula(), row("x", 0.24)).words
    assert words.startswith(
        "the error is +24 % at the default inputs. The error is within 10 % at 1 of the 2 points, "
        "for T"
    )
    assert " in ring-lame (points within this limit: 1 of 2). Other values are up to 3 %" in words


def test_the_count_of_points_comes_first_where_most_are_beyond_the_limits(row, monkeypatch):
    studied(monkeypatch, 0.001, -0.2)
    (star,) = found.ranges(())
    for points, starts in (
        (2, "accurate within 10 % for"),
        (3, "the error is within 10 % at 1 of the 3 points,"),
    ):
        few = replace(star, points=points)
        monkeypatch.setattr(found, "ranges", lambda _, few=few: (few,))
        assert verdict(formula(), row("x", 0.001)).words.startswith(starts)


def test_default_inputs_are_those_of_the_case_of_the_largest_error(row):
    rows = row("x", -0.2), row("y", -0.3, case="ring-rotation")
    assert "−30 % at the default inputs of ring-rotation" in verdict(
        formula(part=(ID, "ring-rotation/y")), *rows).words  # fmt: skip
    assert "−20 % at the default inputs, " in verdict(formula(), rows[0]).words


def test_a_conservative_formula_states_over_which_range(row, monkeypatch):
    studied(monkeypatch, 0.2, -0.01)
    words = verdict(formula(), row("x", 0.3)).words
    assert words.startswith(
        "conservative over T, z: the values are up to 30 % above and up to 1 % below the "
        "reference. The error is +"
    )


def test_values_that_a_study_holds_are_stated(row, monkeypatch):
    studied(monkeypatch, 0.001, -0.2, held=", at n = 8")
    words = verdict(formula(), row("x", 0.001)).words
    assert "T 1 to 9 N, z 1 to 9 N (one input varied at a time) at n = 8 in ring-lame" in words
    assert ", one input varied" not in verdict(formula(), row("x", -0.2)).words


def test_both_sides_are_stated_where_neither_is_safe(row, monkeypatch):
    studied(monkeypatch, 0.03, -0.08)
    words = verdict(formula(safe=Safe.NEITHER), row("x", 0.001)).words
    assert ". The values are up to 8 % below and up to 3 % above the reference" in words


def test_a_misprint_states_the_errors_of_its_study(row, monkeypatch):
    studied(monkeypatch, 0.27, -0.52)
    words = verdict(formula(**MISPRINT), row("x", -0.33)).words
    assert (
        "−33 % at the default inputs. Over all points, the values are up to 52 % below and up to "
        "27 % above the reference"
    ) in words


def test_an_unsafe_formula_states_its_error_at_the_default_inputs_on_the_unsafe_side(row):
    rows = row("x", -0.2), row("y", 0.5)
    got = verdict(formula(part=(ID, "ring-lame/y")), *rows)
    assert (got.verdict, got.worst_row) == (Verdict.UNSAFE, ID)
    assert ". The error is −20 % at the default inputs" in got.words


# Misprints


def test_a_misprint_is_wrong_where_its_error_leaves_the_bar(row):
    printed = formula(**MISPRINT)
    assert verdict(printed, row("x", 0.2, 0.01)).verdict is Verdict.WRONG
    hidden = verdict(printed, row("x", 0.002, 0.01))
    assert hidden.verdict is Verdict.NONE
    assert "reveal no error" in hidden.words


def test_a_misprint_counts_separately_from_the_error_of_the_formula(row):
    """An error of 22 % hides that the misprint moves the value by half a per cent alone."""

    def beside(error, right, U=0.001):
        return verdict(
            formula(**MISPRINT), row("x", error, U), row("right", right, U), corrected=(RIGHT,)
        )

    got = beside(-0.22, -0.2161)
    assert got.verdict is Verdict.WRONG
    assert got.misprint == pytest.approx(0.78 / 0.7839 - 1)
    assert got.words.startswith(
        "wrong as printed: the misprint alone changes the value by −0.5 %. The total error is −22"
    )
    same = beside(-0.22, -0.22)
    assert same.verdict is Verdict.NONE
    assert "the printed form reveal no error" in same.words
    assert beside(0.004, 0.001, U=0.01).verdict is Verdict.WRONG  # though it is within the bar


def test_the_largest_change_from_a_value_of_the_same_reference_counts(row):
    printed = [row("a", 0.1), row("b", -0.3)]
    assert misprint(printed, [row("right", 0.0)]) == pytest.approx(-0.3)
    for other in ({"fem": 1.1}, {"unit": "mm"}, {"case": "ring-loads"}, {"analytic": None}):
        assert misprint(printed, [row("right", 0.2, **other)]) is None, other


def test_rows_of_the_corrected_form_belong_to_printed_forms_with_errata():
    forms = declared()["belcin"].of(17)
    assert rows_of_corrected("belcin", forms[0]) == forms[1].rows
    assert rows_of_corrected("belcin", forms[1]) == ()


def test_a_misprint_without_a_row_states_what_is_wrong_and_needs_a_test():
    shown = verdict(formula(part=(), limited_by="no growth", **MISPRINT))
    assert (shown.verdict, shown.words) == (Verdict.WRONG, "wrong as printed: no growth")
    untested = formula(part=(), errata=("fig-2-3-captions",), limited_by="x")
    assert verdict(untested).words == (
        "erratum fig-2-3-captions is not demonstrated: declare a row or a test for it"
    )
