"""Outcomes of mutants: rows, refusals, tests, survivors; stored, continued, and scored."""

import importlib
import sys
from dataclasses import replace
from functools import partial
from textwrap import dedent

import pytest

from verify.audit.mutation import baseline as known
from verify.audit.mutation import score, trial, workload
from verify.audit.mutation.campaign import Campaign
from verify.audit.mutation.groups import Group, functions_of
from verify.audit.mutation.outcomes import KIND, By, Outcome, Outcomes
from verify.audit.mutation.sample import sample
from verify.audit.mutation.sandbox import Task
from verify.audit.mutation.sites import mutants, source
from verify.audit.mutation.subject_operators import FORMULAS
from verify.audit.mutation.trial import Bench
from verify.audit.mutation.workload import Load
from verify.core.case import Case, FemResult
from verify.core.inputs import Inputs, quantity
from verify.core.results import Caught, MutantGroup, Survivor
from verify.core.store import Store
from verify.jobs import records
from verify.judging.checks import Fact

LIMIT = 4.0  # s for a judgement, of a child that imports what it needs: endless mutants take all
FORMULA = """
    FAR = 2.0


    def width(a, b):
        if b < 0:
            raise ValueError("needs a width of at least 0")
        return a + b * 1e-9


    def length(a):
        return width(a, a - FAR)


    def count(a):
        while a > 0:
            a = a - 1
        return a
"""


class Bar(Inputs):
    a: float = quantity("3 m", "m", "a", "length")


@pytest.fixture
def module(tmp_path, monkeypatch):
    (tmp_path / "measuring_tape.py").write_text(dedent(FORMULA), "utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(workload, "ROOT", tmp_path)  # whose errors are errors of the project
    source.cache_clear()
    yield importlib.import_module("measuring_tape")
    monkeypatch.delitem(sys.modules, "measuring_tape")
    source.cache_clear()


@pytest.fixture
def group(module) -> Group:
    """Mutants of a module whose case has one row: the length is 3 within a tenth.

    Of those whose loop does not end, each of which takes all of LIMIT, there is one.
    """
    row = Fact(
        name="length", symbol="L", unit="1",
        margin=lambda c: (0.1 - abs(c.analytic["length"] - 3.0), 0.0), fem_needed=False,
    )  # fmt: skip
    case = Case(
        id="ring-tape", title="", paper="", place="", lead="", inputs=Bar,
        analytic=lambda q: {"length": module.length(q.a), "count": module.count(q.a)},
        reference=lambda *_: FemResult(h=1.0, values={}), levels=(), outputs=(), checks=(row,),
    )  # fmt: skip
    load = Load(case, Bar(), ())
    bench = Bench(load, known.Noted(0.1, (), load.judged().states))
    found = mutants(source("measuring_tape"), FORMULAS)
    some = [
        m for m in found if m.mutant.function != "count" or m.mutant.after in ("a <= 0", "a + 1")
    ]

    def task(changed):
        return Task(changed.mutant.id, partial(trial.tried, changed, [bench]), LIMIT)

    return Group("formulas", found, some, task, lambda _changed: ())


def made(folder) -> Outcomes:
    return Outcomes(Store(folder), "the code")


def by(group: Group, outcomes: Outcomes) -> dict[tuple[str, str], Outcome]:
    return {(m.mutant.before, m.mutant.after): outcomes.found[m.mutant.id] for m in group.chosen}


@pytest.mark.slow("pytest starts for each mutant")
def test_each_mutant_is_judged_by_what_detects_it(group, tmp_path):
    outcomes = made(tmp_path)
    Campaign(group, outcomes, 2).run()
    found = by(group, outcomes)
    assert found["a + b * 1e-09", "a - b * 1e-09"].by is By.NOTHING  # the tolerance is too wide
    red, refused = found["b * 1e-09", "b / 1e-09"], found["2.0", "4.0"]
    assert (red.by, red.what) == (By.ROWS, "ring-tape/length")
    assert refused.by is By.REFUSED
    assert "needs a width of at least 0" in refused.what
    assert found["a - 1", "a + 1"].by is By.TIME
    done = score.scored(group, outcomes.found, 1.0)
    assert [one[2:] for one in done["survivors"] if one[2] == "a > 0"] == [["a > 0", "a <= 0"]]


@pytest.fixture
def brief(group) -> Group:
    """Without the mutant that does not end."""
    return replace(group, chosen=[m for m in group.chosen if m.mutant.after != "a + 1"])


def test_tests_come_after_the_rows_and_what_takes_long_last(brief, tmp_path, monkeypatch):
    asked = []

    def tested(changed, _tests):
        asked.append(changed.mutant.before)
        noticed = changed.mutant.before == "a > 0"
        return [By.TESTS.value, "a test"] if noticed else [By.NOTHING.value, ""]

    def last(changed):
        return Task(changed.mutant.id, lambda: [By.ROWS.value, "a slow row"], LIMIT)

    monkeypatch.setattr(trial, "tested", tested)
    outcomes = made(tmp_path)
    Campaign(replace(brief, tests=lambda _: ("a test",), last=last), outcomes, 1).run()
    found = by(brief, outcomes)
    assert found["a > 0", "a <= 0"].what == "a test"
    assert found["a + b * 1e-09", "a - b * 1e-09"].what == "a slow row"
    assert found["b * 1e-09", "b / 1e-09"].what == "ring-tape/length"


def test_a_run_continues_where_it_was_stopped(brief, tmp_path):
    def stopped(state):
        if state.done == 3:
            raise KeyboardInterrupt

    of_all = len(brief.chosen)
    with pytest.raises(KeyboardInterrupt, match=f"3 of {of_all} mutants of formulas are stored"):
        Campaign(brief, made(tmp_path), 1, stopped).run()
    torn = {"the code x": b'{"id": "half a li', "the code y": b"[]"}
    Store(tmp_path).store(KIND, "the code", torn)
    again = made(tmp_path)
    assert len(again.found) == 3
    states = []
    Campaign(brief, again, 2, states.append).run()
    assert (states[0].done, states[0].total) == (3, of_all)
    assert len(made(tmp_path).found) == of_all
    assert Outcomes(Store(tmp_path), "other code").found == {}


def test_a_sample_tries_each_operator_and_each_place_once(module):
    found = mutants(source("measuring_tape"), FORMULAS)
    some, again = (sample(found, 6, 0) for _ in range(2))
    assert [one.mutant.id for one in some] == [one.mutant.id for one in again]
    assert {one.mutant.operator for one in some} == {one.mutant.operator for one in found}
    assert len({id(one.place.node) for one in some}) == 6
    assert any(one != some for one in (sample(found, 6, seed) for seed in (1, 2, 3)))


def test_a_constant_is_tested_by_the_functions_that_read_it(module):
    found = mutants(source("measuring_tape"), FORMULAS)
    assert {one.mutant.function: functions_of(one) for one in found} == {
        name: {f"measuring_tape:{read}"}
        for name, read in {
            "FAR": "length", "width": "width", "length": "length", "count": "count",
        }.items()
    }  # fmt: skip


def test_each_group_counts_for_the_code_that_it_was_measured_on(group, tmp_path, monkeypatch):
    monkeypatch.setattr(records, "FOLDER", tmp_path)
    outcomes = {m.mutant.id: Outcome(m.mutant.id, By.ROWS, "", 0.1) for m in group.chosen}
    found = score.scored(group, outcomes, 12.3)
    score.keep("formulas", found, "this code")
    score.keep("finite-elements", found, "other code")
    # nonsense in a file is no score and spoils no other
    score.keep("references", 7, "this code")
    score.keep("judging", {"all": 3, "operators": {}, "survivors": [7]}, "this code")
    for code, name in (("this code", "formulas"), ("other code", "finite-elements")):
        now = score.measured(lambda code=code: code)
        assert (now.missing, [g.name for g in now.groups]) == ("", [name])
        assert {"references", "judging"} <= set(now.stale)
    none = score.measured(lambda: "a third")
    assert none.missing.startswith("score of mutants not computed for the present code")
    assert not none.groups
    both = score.latest(lambda: "this code")  # the group of other code is displayed and named
    assert [g.name for g in both.groups] == ["formulas", "finite-elements"]
    assert set(both.stale) == {"references", "judging", "finite-elements"}


def of(tests: int, survived: int, reason: str = "as the root is squared") -> Caught:
    one = MutantGroup(name="formulas", all=900, tried=tests + survived, rows=0, tests=tests,
                      survived=survived, apart=1)  # fmt: skip
    left = Survivor(group="formulas", where="a.f", line=1, operator="sign", before="-a", after="a",
                    reason=reason)  # fmt: skip
    return Caught(groups=(one,), survivors=(left,) * survived)


def test_the_gate_requires_95_percent_and_a_reason_for_the_rest():
    assert score.complaints(of(95, 5)) == []
    (few,) = score.complaints(of(94, 6))
    assert few == "formulas: 94 of 100 mutants are detected, 95% required"
    (bare,) = score.complaints(of(99, 1, reason=""))
    assert bare == "formulas: 1 undetected mutants without a reason in argued.json"
    assert all(len(reason.split()) > 3 for reason in score.argued().values())
