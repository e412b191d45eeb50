"""Error budgets: known parts are found again, add up, are kept, and broken reruns are told."""

import json
import math
import re
from dataclasses import replace

import numpy as np
import pytest

from tests.verify import budget_made as made
from tests.verify.sweep_made import Dying, Here
from verify.cases import registry
from verify.cases.budgets import STATEMENTS
from verify.core import source_code
from verify.core.inputs import InputError, quantity
from verify.core.results import CaseResult, Kind, Row, Status
from verify.jobs import records
from verify.jobs.engine import GoneError
from verify.judging.budget_statement import Argument, Cause, Constant, Rerun, Statement, as_given
from verify.studies import deep
from verify.studies.budget import balance, generic, measuring
from verify.studies.budget import store as kept
from verify.studies.budget.changes import changed
from verify.studies.budget.console import of_case
from verify.studies.budget.found import budgets
from verify.studies.budget.plan import AS_IT_IS, Plan, Step, first, inputs_of, rows, together
from verify.studies.budget.solve import solved

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


def test_each_part_is_what_goes_when_its_cause_goes(measured_here):
    row = rows_of(measured_here()[0])["stiffness"]
    # by the made-up formula at the nominal inputs, whose joint part goes with either cause
    assert contributions(row) == pytest.approx({
        "discretisation": made.MESH * (1 / 16 - 1 / 64), "iteration": 0.0,
        "contact law": made.SLACK, "finite geometry": made.WIDE + made.TOGETHER,
        "plane assumption": made.PLANE, "small displacement": made.FAR + made.TOGETHER,
    }, rel=1e-5, abs=1e-9)  # fmt: skip


def test_parts_and_remainder_add_up_to_the_difference(measured_here):
    row = rows_of(measured_here()[0])["stiffness"]
    parts = contributions(row)
    assert sum(parts.values()) + row.balance.remainder == pytest.approx(row.balance.total, abs=1e-8)
    # what is left: the formula's own error, the finer mesh's, and less the joint part, taken twice
    left = made.SELF + made.MESH / 64 - made.TOGETHER
    assert row.balance.remainder == pytest.approx(left, abs=1e-7)


def test_two_large_causes_are_removed_together_as_well(measured_here):
    row = rows_of(measured_here()[0])["stiffness"]
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


def test_a_broken_rerun_is_told_and_the_others_stay(measured_here, capsys):
    broken = Rerun(cause=Cause.PLANE, what="broken", fem=made.fem_broken)
    plan, good = measured_here(Statement(reruns=(made.NARROW, broken), finer=8))
    row = rows_of(plan)["stiffness"]
    assert not good
    assert "not solved: made-up-leaf level 1, plane assumption: broken" in capsys.readouterr().out
    (part,) = [p for p in row.balance.parts if p.name == "plane assumption: broken"]
    assert (part.contribution, part.note) == (None, "ValueError: no mesh fits")
    assert contributions(row)["finite geometry"] == pytest.approx(
        made.WIDE + made.TOGETHER, rel=1e-5
    )


def test_a_record_stays_where_processes_die(measured_here, tmp_path, capsys):
    measured_here()
    before = kept.RECORDS.stored(made.CASE.id)
    for file in (tmp_path / "cache").glob("store.sqlite*"):
        file.unlink()
    assert not measuring.BUDGET.measure_missing([made.CASE], Dying(), again=True)
    assert re.search(r"not stored: \d+ reruns have no answer", capsys.readouterr().out)
    assert kept.RECORDS.stored(made.CASE.id) == before


def test_a_store_that_takes_nothing_is_found_before_the_work(measured_here, tmp_path):
    (tmp_path / "cache").write_text("", "utf-8")
    with pytest.raises(OSError, match=r"cache: is a file, expected a folder"):
        measured_here()


@pytest.mark.parametrize("error", [MemoryError, OSError])
def test_a_fault_of_the_machine_ends_the_run_and_stores_no_record(
    measured_here, monkeypatch, error
):
    def fem(*_):
        raise error("no room")

    monkeypatch.setattr(made, "CASE", replace(made.CASE, reference=fem))
    monkeypatch.setattr(registry, "CASES", (made.CASE,))
    with pytest.raises(GoneError, match=rf"reruns cannot be solved here: {error.__name__}: no "):
        measured_here()
    assert kept.RECORDS.stored(made.CASE.id) is None


def test_a_finer_mesh_that_fails_leaves_the_three_finest(measured_here, monkeypatch):
    def until_four(q, level):
        if level > 4:
            raise ArithmeticError("too fine")
        return made.fem(q, level)

    plan = made.plan(case=replace(made.CASE, reference=until_four))
    steps = {step: solved(plan, step, None) for step in first(plan)}
    part = budgets(plan, steps)[0].balance.parts[0]
    assert part.name == (
        "discretisation: Richardson from the three finest meshes (no finer one: too fine)"
    )
    assert part.contribution == pytest.approx(made.MESH / 16, rel=0.05)  # to the third order in m


def test_an_identity_is_explained_by_its_mesh(measured_here):
    told = of_case(measured_here()[0], RESULT)
    (same,) = [row for row in told.rows if row.quantity == "the same"]
    assert same.within is True
    assert same.total == pytest.approx(-1e-5 / 16, rel=1e-4)


def test_a_tolerance_of_numpy_s_is_a_number_of_records(measured_here):
    row = Row(case=made.CASE.id, quantity="the same", symbol="s", unit="1", kind=Kind.IDENTITY,
              status=Status.PASS, scale=np.float64(7.0), u_num=np.float64(1e-3))  # fmt: skip
    told = of_case(measured_here()[0], replace(RESULT, rows=(row,)))
    (same,) = [row for row in told.rows if row.quantity == "the same"]
    assert json.loads(json.dumps([same.U, same.within])) == [pytest.approx(2e-3 / 7), True]


def test_an_identity_that_nothing_explains_is_said_so(measured_here):
    plan, _ = measured_here()
    content = kept.RECORDS.stored(made.CASE.id).content
    content["rows"]["the same"]["remainder"] = 0.01
    kept.RECORDS.keep(made.CASE.id, kept._made_by(plan), content)
    (same,) = [row for row in of_case(plan, RESULT).rows if row.quantity == "the same"]
    assert same.within is False


@pytest.mark.parametrize("source", ["whole_source_of", "source_of", "group_hash"])
def test_what_other_code_measured_is_not_measured(measured_here, monkeypatch, source):
    plan, _ = measured_here()
    monkeypatch.setattr(source_code, source, lambda _code: "other")
    kept._hash.cache_clear()
    told = of_case(plan, RESULT)
    kept._hash.cache_clear()
    assert told.missing == (
        "not measured for this code: freewheel deep budget:made-up-leaf does it"
    )
    assert told.rows == ()


class Wider(made.CASE.inputs):
    w: float = quantity("3 mm", "mm", "w", "width", gt=0)


@pytest.mark.parametrize(
    "changed",
    [
        {"inputs": Wider},
        {"checks": (replace(made.CASE.checks[0], analytic="same"), *made.CASE.checks[1:])},
        {"levels": (1, 2, 3)},
    ],
)
def test_what_another_case_measured_is_not_measured(measured_here, changed):
    plan, _ = measured_here()
    case = replace(made.CASE, **changed)
    assert kept.measured(plan) is not None
    assert kept.measured(Plan(case, made.SAYS, rows(case))) is None


@pytest.mark.parametrize(
    "says",
    [
        replace(made.SAYS, finer=16),
        replace(made.SAYS, reruns=made.SAYS.reruns[:-1]),
        replace(made.SAYS, reruns=(replace(made.NARROW, inputs=as_given), *made.SAYS.reruns[1:])),
        replace(made.SAYS, reruns=(replace(made.NARROW, shared=True), *made.SAYS.reruns[1:])),
    ],
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


@pytest.mark.parametrize("fails", ["nothing", "tight", "both"])
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


def test_an_interrupted_measurement_says_how_much_is_kept(measured_here, monkeypatch):
    def stopped(_step):
        raise KeyboardInterrupt

    monkeypatch.setattr(measuring, "solve_step", stopped)
    with pytest.raises(KeyboardInterrupt, match=r"interrupted; 0 of 12 reruns are stored"):
        measured_here()


@pytest.mark.parametrize("name", ["budget:nothing", "budget:made-up"])
def test_an_unknown_case_is_one_line(name, measured_here):
    with pytest.raises(InputError, match=r"no such measurement, there are made-up-leaf"):
        deep.run_deep([name], jobs=1)


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
        (Argument("tests.verify.nowhere:nobody", {}), LookupError),
        (Constant("tests.verify.budget_made:HERE", 2.0), LookupError),  # a text
    ],
)
def test_a_change_that_changes_nothing_is_an_error(change, error):
    with pytest.raises(error), changed([change]):
        pass


def test_one_mesh_alone_is_as_uncertain_as_it_is_coarse():
    part = balance.removed("x", [(0.05, 0.02)], finest=0.041, shared=False)
    assert (part.contribution, part.u) == (pytest.approx(0.03), pytest.approx(0.009))


def test_a_value_on_the_finest_mesh_alone_has_no_discretisation():
    part = balance.extrapolated("x", [math.nan, math.nan, 0.1], [1.0, 0.5, 0.25], math.nan)
    assert (part.contribution, part.u, part.note) == (None, None, "values on the finest mesh alone")


def test_two_meshes_say_how_uncertain_a_part_is():
    part = balance.removed("x", [(0.05, 0.02), (0.045, 0.02)], finest=0.0, shared=False)
    assert (part.contribution, part.u) == (pytest.approx(0.025), pytest.approx(0.005))


@pytest.mark.parametrize("case", registry.CASES, ids=lambda case: case.id)
def test_what_a_case_says_fits_it(case):
    plan = measuring.plan_of(case.id)
    names = [pair.name for pair in plan.rows]
    for rerun in plan.says.reruns:
        assert any(rerun.about(name) for name in names), rerun.what
        plan.before(rerun)
    assert plan.says.headline in ("", *names)
    assert plan.says.finer == 0 or plan.says.finer > case.levels[-1]
    for step in first(plan):
        inputs_of(plan, step)


def test_every_name_of_a_row_is_that_of_one():
    """Cases share some reruns: each pattern fits a row of one of these."""
    used = {}
    for case in registry.CASES:
        plan = measuring.plan_of(case.id)
        for rerun in plan.says.reruns:
            for pattern in rerun.rows:
                fits = [replace(rerun, rows=(pattern,)).about(pair.name) for pair in plan.rows]
                used[pattern] = used.get(pattern, False) or any(fits)
    assert [pattern for pattern, fits in used.items() if not fits] == []


def test_statements_are_of_cases_that_there_are():
    assert set(STATEMENTS) == {case.id for case in registry.CASES}


def test_pairs_of_causes_come_once_with_what_they_are_compared_with():
    plan = made.plan()
    names = [made.NARROW.name, made.NEAR.name]
    found = together(plan, [names, names])
    id_ = made.CASE.id
    assert found == (
        Step(id_, tuple(names), 2), Step(id_, (AS_IT_IS,), 2), *(Step(id_, (n,), 2) for n in names)
    )  # fmt: skip
    both = Plan(made.CASE, replace(made.SAYS, reruns=(made.NEAR, replace(made.NEAR, what="b"))), ())
    assert together(both, [list(both.reruns)]) == ()
