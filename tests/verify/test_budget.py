"""Error budgets: known parts are found again, add up and are stale for other code."""

import math
import re
from dataclasses import replace

import pytest

from tests.verify import budget_made as made
from tests.verify.sweep_made import Dying, Here
from verify.cases import registry
from verify.core import source_code
from verify.core.results import CaseResult
from verify.jobs import records
from verify.judging.budget_statement import Argument, Constant, Statement
from verify.studies.budget import balance, generic, measuring
from verify.studies.budget import store as kept
from verify.studies.budget.balance import Balance, Part
from verify.studies.budget.changes import changed
from verify.studies.budget.console import of_case
from verify.studies.budget.found import RowBudget
from verify.studies.budget.messages import in_words
from verify.studies.budget.plan import first, inputs_of

ORIGINAL = made.Solver
RESULT = CaseResult(
    id=made.CASE.id, title="", paper="", place="", lead="", inputs=(), equations=(),
    assumptions=(), readings=(), rows=(),
)  # fmt: skip


@pytest.fixture
def measured_here(tmp_path, monkeypatch):
    """Measures the made-up case as its statement says it, and gives its plan."""
    monkeypatch.setattr(records, "FOLDER", tmp_path / "measured")
    monkeypatch.setattr(registry, "CASES", (made.CASE,))
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path / "cache"))

    def measure(says=made.SAYS, *, again=False):
        monkeypatch.setattr("verify.cases.budgets.STATEMENTS", {made.CASE.id: says})
        measuring.plan_of.cache_clear()
        good = measuring.BUDGET.measure_missing([made.CASE], Here(1), again=again)
        return measuring.plan_of(made.CASE.id), good

    yield measure
    measuring.plan_of.cache_clear()


def rows_of(plan):
    found = kept.measured(plan)
    assert found is not None
    return {one.pair.name: one for one in found.rows}


def contributions(row):
    return {
        part.name.partition(": ")[0]: part.contribution
        for part in row.balance.parts if part.counts
    }  # fmt: skip


def test_each_part_is_what_goes_with_its_cause_and_all_add_up_to_the_difference(measured_here):
    row = rows_of(measured_here()[0])["stiffness"]
    parts = contributions(row)
    # by the made-up formula at the nominal inputs, whose joint part goes with either cause
    assert parts == pytest.approx({
        "discretisation": made.MESH * (1 / 16 - 1 / 64), "iteration": 0.0,
        "contact law": made.SLACK, "finite geometry": made.WIDE + made.TOGETHER,
        "plane assumption": made.PLANE, "small displacement": made.FAR + made.TOGETHER,
    }, rel=1e-5, abs=1e-9)  # fmt: skip
    assert sum(parts.values()) + row.balance.remainder == pytest.approx(row.balance.total, abs=1e-8)
    # what is left: the formula's own error, the finer mesh's, and less the joint part, taken twice
    left = made.SELF + made.MESH / 64 - made.TOGETHER
    assert row.balance.remainder == pytest.approx(left, abs=1e-7)
    (joint,) = [one for one in row.joints if len({n.partition(":")[0] for n in one.names}) == 2
                and all(n.startswith(("finite", "small")) for n in one.names)]  # fmt: skip
    # both gone: the joint part goes once, not twice
    assert joint.value == pytest.approx(-made.TOGETHER, abs=1e-8)


def test_what_both_sides_assume_is_no_part_of_the_difference(measured_here):
    alone = measured_here(Statement(reruns=(made.STRAIN,), finer=8))[0]
    counted = rows_of(alone)["stiffness"].balance.remainder
    says = Statement(reruns=(replace(made.STRAIN, shared=True),), finer=8)
    row = rows_of(measured_here(says)[0])["stiffness"]
    assert row.balance.remainder - counted == pytest.approx(made.PLANE, abs=1e-8)
    assert "plane assumption" not in contributions(row)


def test_a_cause_after_another_is_read_without_both(measured_here):
    both = replace(made.NARROW, fem=made.fem_near, after="near")
    row = rows_of(measured_here(Statement(reruns=(made.NEAR, both), finer=8))[0])["stiffness"]
    found = contributions(row)
    assert found["finite geometry"] == pytest.approx(made.WIDE, rel=1e-5)
    assert row.joints == ()
    assert row.balance.remainder == pytest.approx(
        made.SELF + made.MESH / 64 + made.SLACK + made.PLANE, abs=1e-6
    )


def test_a_record_stays_where_processes_die(measured_here, tmp_path, capsys):
    measured_here()
    before = kept.RECORDS.stored(made.CASE.id)
    for file in (tmp_path / "cache").glob("store.sqlite*"):
        file.unlink()
    assert not measuring.BUDGET.measure_missing([made.CASE], Dying(), again=True)
    assert re.search(r"not stored: \d+ reruns have no answer", capsys.readouterr().out)
    assert kept.RECORDS.stored(made.CASE.id) == before


@pytest.mark.parametrize("source", ["whole_source_of"])
def test_a_record_of_other_code_does_not_count(measured_here, monkeypatch, source):
    plan, _ = measured_here()
    monkeypatch.setattr(source_code, source, lambda _code: "other")
    kept._hash.cache_clear()
    told = of_case(plan, RESULT)
    kept._hash.cache_clear()
    assert told.missing == (
        "not measured for this code: freewheel deep budget:made-up-leaf does it"
    )
    assert told.rows == ()


@pytest.mark.parametrize(
    "says", [replace(made.SAYS, finer=16), replace(made.SAYS, reruns=made.SAYS.reruns[:-1])]
)
def test_another_statement_makes_it_stale(measured_here, says):
    measured_here()
    assert kept.measured(made.plan(says)) is None


def test_measuring_goes_on_where_it_was(measured_here, capsys):
    measured_here()
    made.calls.clear()
    measured_here(again=True)  # every solution is in the cache
    assert made.calls == []
    measured_here()
    assert "measured already" in capsys.readouterr().out


@pytest.mark.parametrize("fails", ["nothing", "tight"])
def test_tolerances_are_tightened_and_loosened_where_that_fails(measured_here, monkeypatch, fails):
    monkeypatch.setattr(generic, "TOLERANCES", (f"{made.HERE}:SLACK",))
    monkeypatch.setattr(generic, "reached", lambda _case: frozenset({made.HERE}))

    def difficult(q, level):
        if (fails != "nothing" and made.SLACK < 5e-5) or (fails == "both" and made.SLACK > 5e-4):
            raise ArithmeticError("rounding")
        return made.fem(q, level)

    monkeypatch.setattr(registry, "CASES", (replace(made.CASE, reference=difficult),))
    says = Statement(reruns=(made.NARROW,))
    measured_here(says)
    row = rows_of(measuring.plan_of(made.CASE.id))["stiffness"]
    (part,) = [p for p in row.balance.parts if p.name.startswith("iteration")]
    name, factor = {
        "nothing": ("iteration: tolerances / 100", 0.01),
        "tight": ("iteration: tolerances x 100", 100.0),
        "both": ("iteration: neither tighter nor looser tolerances: rounding", 1.0),
    }[fails]
    assert part.name == name
    assert part.contribution == pytest.approx(made.SLACK * (1 - factor), abs=1e-8)


def look_inside():
    """What a body sees while two changes hold, which then fails."""
    assert made.Solver(assumption="plane stress").excess == 0.0
    assert isinstance(made.Solver(assumption=""), ORIGINAL)  # a class stays one
    assert made.SLACK == 1e-3
    raise ZeroDivisionError


def test_changes_hold_for_a_while_and_whatever_happens():
    changes = [Argument(f"{made.HERE}:Solver", {"assumption": "plane strain"}),
               Constant(f"{made.HERE}:SLACK", 10)]  # fmt: skip
    with pytest.raises(ZeroDivisionError), changed(changes):
        look_inside()
    assert (made.Solver, made.SLACK) == (ORIGINAL, 1e-4)


@pytest.mark.parametrize(
    ("change", "error"),
    [
        (Argument("tests.verify.budget_made:narrow", {"x": 1}), RuntimeError),  # never called
        (Argument("tests.verify.budget_made:nobody", {}), LookupError),
    ],
)
def test_a_change_that_changes_nothing_is_an_error(change, error):
    with pytest.raises(error), changed([change]):
        pass


def test_one_mesh_alone_is_as_uncertain_as_it_is_coarse():
    part = balance.removed("x", [(0.05, 0.02)], finest=0.041, shared=False)
    assert (part.contribution, part.u) == (pytest.approx(0.03), pytest.approx(0.009))


def test_two_meshes_say_how_uncertain_a_part_is():
    part = balance.removed("x", [(0.05, 0.02), (0.045, 0.02)], finest=0.0, shared=False)
    assert (part.contribution, part.u) == (pytest.approx(0.025), pytest.approx(0.005))


def test_a_value_on_the_finest_mesh_alone_has_no_discretisation():
    part = balance.extrapolated("x", [math.nan, math.nan, 0.1], [1.0, 0.5, 0.25], math.nan)
    assert (part.contribution, part.u, part.note) == (None, None, "values on the finest mesh alone")


@pytest.mark.slow("the rows of all cases")
def test_reruns_are_about_rows_and_levels_that_there_are():
    for case in registry.CASES:
        plan = measuring.plan_of(case.id)
        names = [pair.name for pair in plan.rows]
        for rerun in plan.says.reruns:
            assert any(rerun.about(name) for name in names), rerun.what
            plan.before(rerun)
        assert plan.says.headline in ("", *names)
        assert plan.says.finer == 0 or plan.says.finer > case.levels[-1]
        for step in first(plan):
            inputs_of(plan, step)


@pytest.mark.parametrize(
    ("case", "name", "words"),
    [
        ("ring-lame", "level 20 after 16", "the next finer mesh"),
        ("sprag-clutch", "level 321 after 161", "more and narrower strips"),
        ("sprag-engagement", "Richardson from the three finest meshes (no finer one: too long)",
         "Richardson from the three finest time steps (no finer one: too long)"),
    ],
)  # fmt: skip
def test_discretisation_has_the_words_of_the_case(case, name, words):
    part = Part(f"discretisation: {name}", 1.0, 0.0)
    row = RowBudget(measuring.plan_of("ring-lame").rows[0], Balance(1.0, (part,), 0.0, 0.0))
    (found,) = in_words(case, (row,))
    assert found.balance.parts[0].name == f"discretisation: {words}"
