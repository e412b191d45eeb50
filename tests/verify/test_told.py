"""What the terminal is told: short, aligned, the reasons once and the warnings last."""

from dataclasses import replace

import pytest

from verify.answers.registry import answer as answer_of
from verify.app.check_console import Checked, print_check
from verify.app.commands import make_report
from verify.cases.registry import CASES
from verify.core.console import raised, verdict_lines
from verify.core.results import Status


@pytest.fixture
def ring(judged):
    return judged(CASES[0])


def printed(result, *, used_fem=True, answer=None):
    """`check` on a judged result of the first case."""
    case = CASES[0]
    answer = answer or answer_of(case, case.inputs(), case.analytic(case.inputs()))
    print_check(Checked(case=case, result=result, answer=answer, used_fem=used_fem))


def test_a_check_begins_with_the_answer_and_ends_with_the_rows(ring, capsys):
    printed(replace(ring, name="mine", warnings=("it yields",)))
    first, *_, total, apart, limit = capsys.readouterr().out.splitlines()
    assert first == "mine: holds"
    orders = sum(row.quantity.endswith(": convergence") for row in ring.rows)
    n = len(ring.rows) - orders
    assert total == f"{n} of {n} comparisons pass; {orders} of {orders} convergence rows pass"
    assert apart.startswith("largest difference of all comparisons: -0.0041 % of stress")
    assert limit == "detection limit of the judged rows: 0.0093 %"


def test_warnings_and_notes_stand_before_the_numbers(ring, capsys):
    notes = ("green: it holds", "and so on")
    printed(replace(ring, findings=notes, warnings=("it yields",)), used_fem=False)
    lines = capsys.readouterr().out.splitlines()
    at = lines.index("warning: it yields")
    assert lines[at + 1 : at + 4] == ["notes", "  green: it holds", "  and so on"]
    assert lines[at + 4].startswith("values by the formulas")


def test_convergence_is_told_only_where_it_failed(ring, capsys):
    printed(ring)
    assert "convergence;" not in capsys.readouterr().out
    bad = [replace(r, status=Status.FAIL, reason="grows") if r.quantity.endswith("convergence")
           else r for r in ring.rows[:2]]  # fmt: skip
    printed(replace(ring, rows=tuple(bad)))
    said = capsys.readouterr().out
    assert f"FAIL {bad[1].quantity}: grows" in said
    assert "1 of 1 comparisons pass; 0 of 1 convergence rows pass" in said


def test_differences_are_formula_less_fe_in_per_cent(ring, capsys):
    (row,) = (r for r in ring.rows if r.quantity == "bore hoop stress, plane stress")
    high = replace(row, analytic=row.fem + 0.5 * row.scale, status=Status.FAIL, reason="far")
    printed(replace(ring, rows=(high,)))
    assert "+50 %" in capsys.readouterr().out


def test_one_cause_is_told_once(ring, capsys):
    failed = tuple(replace(r, status=Status.FAIL, reason="ZeroDivisionError") for r in ring.rows)
    report = make_report([replace(ring, rows=failed)], CASES[:1], 0.0)
    print(*verdict_lines(report), sep="\n")
    said = capsys.readouterr().out
    assert said.count("ZeroDivisionError") == 1
    assert f"and {len(failed) - 1} more" in said


@pytest.mark.parametrize(
    ("written", "read"),
    [("1×10^-5", "1×10⁻⁵"), ("1.97×10^-4 kg m^2", "1.97×10⁻⁴ kg m²"), ("(a + b)^2", "(a + b)²"),
     ("x^n", "x^n"), ("plain", "plain")],
)  # fmt: skip
def test_powers_are_raised_in_the_terminal(written, read):
    assert raised(written) == read


def test_units_of_inputs_have_raised_powers(ring, capsys):
    inputs = (replace(ring.inputs[0], unit="kg m^2"), *ring.inputs[1:])
    printed(replace(ring, name="mine", inputs=inputs), used_fem=False)
    said = capsys.readouterr().out
    assert "kg m²" in said
    assert "^" not in said
