"""Error budgets: known parts are found again, add up, and are stale after a change of code."""

import functools
import math
import re
import sys
import types
from dataclasses import replace

import pytest

from tests.verify import budget_made as made
from tests.verify.sweep_made import Dying, Here
from verify.cases import registry
from verify.core import source_code
from verify.jobs import records
from verify.judging.budget_statement import Argument, Constant, Corrected
from verify.studies.budget import balance, generic, measuring
from verify.studies.budget import store as kept
from verify.studies.budget.changes import changed
from verify.studies.budget.console import of_case

ORIGINAL = made.Solver


@pytest.fixture
def measured_here(tmp_path, monkeypatch):
    """Measures the made-up case by its statement, and gives its plan and its rows."""
    monkeypatch.setattr(records, "FOLDER", tmp_path / "measured")
    monkeypatch.setattr(registry, "CASES", (made.CASE,))
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path / "cache"))

    def measure(*reruns, again=False, finer=8):
        statement = replace(made.STATEMENT, finer=finer, **({"reruns": reruns} if reruns else {}))
        monkeypatch.setattr("verify.cases.budgets.STATEMENTS", {made.CASE.id: statement})
        measuring.plan_of.cache_clear()
        assert measuring.BUDGET.measure_missing([made.CASE], Here(1), again=again)
        plan = measuring.plan_of(made.CASE.id)
        return plan, {one.pair.name: one for one in kept.measured(plan).rows}

    yield measure
    measuring.plan_of.cache_clear()


def contributions(row):
    return {
        part.name.partition(": ")[0]: part.contribution
        for part in row.balance.parts if part.counts
    }  # fmt: skip


def test_each_part_is_what_goes_with_its_cause_and_all_add_up_to_the_difference(measured_here):
    row = measured_here()[1]["stiffness"]
    parts = contributions(row)
    # by the made-up formula at the nominal inputs, whose joint part goes with either cause
    assert parts == pytest.approx({
        "discretisation": made.MESH * (1 / 16 - 1 / 64), "iteration": 0.0,
        "contact law": made.SLACK, "finite geometry": made.WIDE + made.TOGETHER,
        "plane assumption": made.PLANE, "small displacement": made.FAR + made.TOGETHER,
    }, rel=1e-5, abs=1e-9)  # fmt: skip
    assert sum(parts.values()) + row.balance.remainder == pytest.approx(row.balance.total, abs=1e-8)
    # remainder: the errors of formula and finer mesh, less the joint part, taken twice
    left = made.SELF + made.MESH / 64 - made.TOGETHER
    assert row.balance.remainder == pytest.approx(left, abs=1e-7)
    (joint,) = [one for one in row.joints if len({n.partition(":")[0] for n in one.names}) == 2
                and all(n.startswith(("finite", "small")) for n in one.names)]  # fmt: skip
    # both gone: the joint part goes once, not twice
    assert joint.value == pytest.approx(-made.TOGETHER, abs=1e-8)


def test_a_shared_cause_is_no_part_and_one_after_another_is_read_without_both(measured_here):
    counted = measured_here(made.STRAIN)[1]["stiffness"].balance.remainder
    row = measured_here(replace(made.STRAIN, shared=True))[1]["stiffness"]
    assert row.balance.remainder - counted == pytest.approx(made.PLANE, abs=1e-8)
    assert "plane assumption" not in contributions(row)
    both = replace(made.NARROW, fem=made.fem_near, after="near")
    row = measured_here(made.NEAR, both)[1]["stiffness"]
    assert contributions(row)["finite geometry"] == pytest.approx(made.WIDE, rel=1e-5)
    assert row.joints == ()
    left = made.SELF + made.MESH / 64 + made.SLACK + made.PLANE
    assert row.balance.remainder == pytest.approx(left, abs=1e-6)


def test_measuring_goes_on_where_it_was_and_a_record_stays_where_processes_die(
    measured_here, tmp_path, capsys
):
    measured_here()
    made.calls.clear()
    measured_here(again=True)  # every solution is in the cache
    assert made.calls == []
    measured_here()
    assert "measured already" in capsys.readouterr().out
    before = kept.RECORDS.stored(made.CASE.id)
    for file in (tmp_path / "cache").glob("store.sqlite*"):
        file.unlink()
    assert not measuring.BUDGET.measure_missing([made.CASE], Dying(), again=True)
    assert re.search(r"not stored: \d+ reruns were not completed", capsys.readouterr().out)
    assert kept.RECORDS.stored(made.CASE.id) == before


def test_a_record_of_other_code_or_of_another_statement_does_not_count(measured_here, monkeypatch):
    plan, _ = measured_here()
    corrected = (Corrected("stiffness", "same"),)
    for statement in (
        replace(made.STATEMENT, finer=16),
        replace(made.STATEMENT, reruns=made.STATEMENT.reruns[:-1]),
        replace(made.STATEMENT, corrected=corrected),
    ):  # fmt: skip
        assert kept.measured(made.plan(statement)) is None
    monkeypatch.setattr(source_code, "whole_source_of", lambda _code: "other")
    kept._hash.cache_clear()
    shown = of_case(plan, made.RESULT)
    kept._hash.cache_clear()
    assert shown.missing == (
        "error budget not computed for the present code: run `freewheel deep budget:made-up-leaf`"
    )
    assert shown.rows == ()


@pytest.mark.parametrize("fails", [False, True])
def test_tolerances_are_tightened_and_loosened_where_that_fails(measured_here, monkeypatch, fails):
    monkeypatch.setattr(generic, "TOLERANCES", (f"{made.HERE}:SLACK",))
    monkeypatch.setattr(generic, "reached", lambda _case: frozenset({made.HERE}))

    def difficult(q, level):
        if fails and made.SLACK < 5e-5:
            raise ArithmeticError("rounding")
        return made.fem(q, level)

    monkeypatch.setattr(registry, "CASES", (replace(made.CASE, reference=difficult),))
    row = measured_here(made.NARROW, finer=0)[1]["stiffness"]
    (part,) = [p for p in row.balance.parts if p.name.startswith("iteration")]
    words, factor = ("x 100", 100.0) if fails else ("/ 100", 0.01)
    assert part.name == f"iteration: tolerances {words}"
    assert part.contribution == pytest.approx(made.SLACK * (1 - factor), abs=1e-8)


def slack():
    return made.SLACK


def look_inside(kept):
    """The state of a body during two changes, which then fails."""
    assert made.Solver(assumption="plane stress").excess == 0.0
    assert isinstance(made.Solver(assumption=""), ORIGINAL)  # a class stays one
    assert made.SLACK == kept() == 1e-3
    raise ZeroDivisionError


def test_changes_hold_for_a_while_whatever_happens_and_for_what_was_memoised(monkeypatch):
    monkeypatch.setattr(slack, "__module__", "verify.cases.made")
    kept = functools.lru_cache(slack)
    assert kept() == 1e-4
    changes = [Argument(f"{made.HERE}:Solver", {"assumption": "plane strain"}),
               Constant(f"{made.HERE}:SLACK", 10)]  # fmt: skip
    with pytest.raises(ZeroDivisionError), changed(changes):
        look_inside(kept)
    assert (made.Solver, made.SLACK) == (ORIGINAL, 1e-4)
    assert kept() == 1e-4


def test_a_change_holds_in_modules_imported_before_and_ends_in_modules_imported_during_it(
    monkeypatch,
):
    before, during = types.ModuleType("before"), types.ModuleType("during")
    before.Solver = made.Solver
    monkeypatch.setitem(sys.modules, "before", before)
    monkeypatch.setitem(sys.modules, "during", during)
    with changed([Argument(f"{made.HERE}:Solver", {"assumption": "plane strain"})]):
        during.Solver = made.Solver
        found = before.Solver(assumption="plane stress"), during.Solver(assumption="plane stress")
        assert [one.excess for one in found] == [0.0, 0.0]
    assert before.Solver is during.Solver is ORIGINAL


@pytest.mark.parametrize(("name", "error"), [("narrow", RuntimeError), ("nobody", LookupError)])
def test_a_change_that_changes_nothing_is_an_error(name, error):
    with pytest.raises(error), changed([Argument(f"{made.HERE}:{name}", {"x": 1})]):
        pass  # never called


def test_a_part_is_as_uncertain_as_its_meshes_differ_or_one_is_coarse():
    for pairs, finest, contribution, u in (
        ([(0.05, 0.02)], 0.041, 0.03, 0.009),
        ([(0.05, 0.02), (0.045, 0.02)], 0.0, 0.025, 0.005),
    ):
        part = balance.removed("x", pairs, finest=finest, shared=False)
        assert (part.contribution, part.u) == pytest.approx((contribution, u))
    none = balance.extrapolated("x", [math.nan, math.nan, 0.1], [1.0, 0.5, 0.25], math.nan)
    assert (none.contribution, none.u, none.note) == (
        None, None, "the row has no value on the coarser meshes"
    )  # fmt: skip
