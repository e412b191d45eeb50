"""What becomes of mutants: rows, refusals, tests, survivors; kept, gone on with, and scored."""

import importlib
from dataclasses import replace
from functools import partial
from textwrap import dedent

import pytest

from tests.verify.mutation.forked import answer
from verify.audit.mutation import baseline as known
from verify.audit.mutation import score, suite, trial, workload
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
    def width(a, b):
        if b < 0:
            raise ValueError("needs a width of at least 0")
        return a + b * 1e-9


    def length(a):
        return width(a, a - 2.0)


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
    monkeypatch.setattr(workload, "ROOT", tmp_path)  # whose errors are the project's own
    source.cache_clear()
    yield importlib.import_module("measuring_tape")
    monkeypatch.delitem(__import__("sys").modules, "measuring_tape")
    source.cache_clear()


@pytest.fixture
def group(module) -> Group:
    """Mutants of a module whose case has one row: the length is 3 within a tenth."""
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

    def task(changed):
        return Task(changed.mutant.id, partial(trial.tried, changed, [bench]), LIMIT)

    return Group("formulas", found, found, task, lambda _changed: ())


@pytest.fixture
def brief(group) -> Group:
    """Without mutants of the loop that do not end, each of which takes all of LIMIT."""
    ends = [m for m in group.chosen if m.mutant.function != "count" or m.mutant.after == "a <= 0"]
    return replace(group, chosen=ends)


def made(folder) -> Outcomes:
    return Outcomes(Store(folder), "the code")


def by(group: Group, outcomes: Outcomes) -> dict[tuple[str, str], Outcome]:
    return {(m.mutant.before, m.mutant.after): outcomes.found[m.mutant.id] for m in group.chosen}


def test_each_mutant_meets_what_notices_it(group, brief, tmp_path):
    outcomes = made(tmp_path)
    endless = next(one for one in group.chosen if one.mutant.after == "a + 1")
    some = replace(brief, chosen=[*brief.chosen, endless])
    Campaign(some, outcomes, 2).run()
    found = by(some, outcomes)
    assert found["a + b * 1e-09", "a - b * 1e-09"].by is By.NOTHING  # the tolerance is too wide
    red = found["b * 1e-09", "b / 1e-09"]
    assert (red.by, red.what) == (By.ROWS, "ring-tape/length")
    refused = found["2.0", "4.0"]
    assert refused.by is By.REFUSED
    assert "needs a width of at least 0" in refused.what
    assert found["a - 1", "a + 1"].by is By.TIME
    assert found["a > 0", "a <= 0"].by is By.NOTHING
    done = score.scored(some, outcomes.found, 1.0)
    assert [one[2:] for one in done["survivors"] if one[2] == "a > 0"] == [["a > 0", "a <= 0"]]


def test_tests_come_next_and_only_for_what_no_row_noticed(brief, tmp_path, monkeypatch):
    asked = []

    def tests(changed):
        asked.append((changed.mutant.before, changed.mutant.after))
        return ("a test",)

    monkeypatch.setattr(trial, "tested", lambda *_: [By.TESTS.value, "a test"])
    outcomes = made(tmp_path)
    Campaign(replace(brief, tests=tests), outcomes, 2).run()
    assert ("a + b * 1e-09", "a - b * 1e-09") in asked
    assert ("b * 1e-09", "b / 1e-09") not in asked
    assert not [one for one in outcomes.found.values() if one.by is By.NOTHING]
    assert by(brief, outcomes)["a > 0", "a <= 0"].what == "a test"


def test_what_takes_long_is_asked_last_and_only_where_no_test_fails(brief, tmp_path, monkeypatch):
    def tested(changed, _tests):
        noticed = changed.mutant.before == "a > 0"
        return [By.TESTS.value, "a test"] if noticed else [By.NOTHING.value, ""]

    def last(changed):
        return Task(changed.mutant.id, lambda: [By.ROWS.value, "a slow row"], LIMIT)

    monkeypatch.setattr(trial, "tested", tested)
    outcomes = made(tmp_path)
    Campaign(replace(brief, tests=lambda _: ("a test",), last=last), outcomes, 2).run()
    found = by(brief, outcomes)
    assert found["a > 0", "a <= 0"].what == "a test"
    assert found["a + b * 1e-09", "a - b * 1e-09"].what == "a slow row"
    assert found["b * 1e-09", "b / 1e-09"].what != "a slow row"


@pytest.mark.parametrize(
    ("path", "runs"), [("tests/verify/test_durations.py", True), ("tests/none", False)]
)
def test_the_project_s_own_tests_run_or_the_run_ends(path, runs):
    """Without xdist, as mutants need it: hooks of a plugin that is missing end a run of pytest."""
    found = answer(partial(suite.traced, path), 60.0)
    assert bool(found.value) == runs
    assert ("pytest ends with" in found.failure) != runs


def test_a_run_goes_on_where_it_was_stopped(brief, tmp_path):
    seen = []

    def stopped(state):
        seen.append(state.done)
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
    some = sample(found, 6, 0)
    assert [one.mutant.id for one in some] == [one.mutant.id for one in sample(found, 6, 0)]
    assert {one.mutant.operator for one in some} == {one.mutant.operator for one in found}
    assert len({id(one.place.node) for one in some}) == 6
    others = [sample(found, 6, seed) for seed in (1, 2, 3)]
    assert any(one != some for one in others)


@pytest.fixture
def formulas(group, tmp_path, monkeypatch):
    """The score of a group, which is stored for this code."""
    monkeypatch.setattr(records, "FOLDER", tmp_path)
    outcomes = {
        key: Outcome(key, By.NOTHING if n % 2 else By.ROWS, "", 0.1)
        for n, key in enumerate(m.mutant.id for m in group.chosen)
    }
    found = score.scored(group, outcomes, 12.3)
    score.keep("formulas", found, "this code")
    return found


def test_the_score_counts_for_the_code_that_it_was_measured_on(formulas):
    now = score.measured(lambda: "this code")
    assert (now.missing, now.groups[0].name) == ("", "formulas")
    assert now.date == score.RECORDS.stored("formulas").date
    other = score.measured(lambda: "other code")
    assert other.missing == "not measured for this code: freewheel mutants does it"
    assert not other.groups


def test_each_group_counts_for_its_own_code(formulas):
    score.keep("judging", formulas, "other code")
    now = score.measured(lambda: "other code")
    assert [group.name for group in now.groups] == ["judging"]
    assert now.stale == ("references", "formulas", "finite-elements")
    score.keep("references", {"gate": {"held": True}}, "this code")
    now = score.measured(lambda: "this code")
    assert [group.name for group in now.groups] == ["formulas"]
    assert now.references == {"gate": {"held": True}}


@pytest.mark.parametrize(
    ("name", "nonsense"),
    [
        ("references", 7),
        ("judging", {"all": 3, "operators": {}, "survivors": [7]}),
    ],
)
def test_nonsense_is_no_score_and_spoils_no_other(formulas, name, nonsense):
    score.keep(name, nonsense, "this code")
    now = score.measured(lambda: "this code")
    assert [group.name for group in now.groups] == ["formulas"]
    assert name in now.stale


def of(tests: int, survived: int) -> Caught:
    one = MutantGroup(name="formulas", all=900, tried=tests + survived, rows=0, tests=tests,
                      survived=survived, apart=1)  # fmt: skip
    left = Survivor(group="formulas", where="a.f", line=1, operator="sign", before="-a", after="a",
                    reason="as the root is squared")  # fmt: skip
    return Caught(groups=(one,), survivors=(left,) * survived)


def test_the_gate_asks_for_95_percent_and_a_reason_for_the_rest():
    assert score.complaints(of(95, 5)) == []
    assert score.complaints(of(94, 6)) == [
        "formulas: 94 of 100 mutants are caught, 95% are asked"
    ]  # fmt: skip
    bare = of(99, 1)
    bare = replace(bare, survivors=(replace(bare.survivors[0], reason=""),))
    assert score.complaints(bare) == ["formulas: 1 survivors without a reason in argued.json"]


def test_every_argued_survivor_has_a_reason_in_words():
    assert all(len(reason.split()) > 3 for reason in score.argued().values())


TRACES = {
    "tests/a.py::direct": (3.0, frozenset({"m:f"})),
    "tests/a.py::shared": (0.5, frozenset()),
    "tests/a.py::long": (2.0, frozenset()),
    "tests/b.py::quick": (0.1, frozenset({"m:f", "m:g"})),
    "tests/c.py::other": (0.1, frozenset({"m:h"})),
}


def test_tests_of_a_function_come_before_those_that_share_its_file():
    assert suite.covering({"m:f"}, TRACES) == [
        "tests/b.py::quick", "tests/a.py::direct", "tests/a.py::shared",
    ]  # fmt: skip
    assert suite.covering({"m:g", "m:h"}, TRACES) == ["tests/b.py::quick", "tests/c.py::other"]
    assert suite.covering({"m:none"}, TRACES) == []


def test_a_constant_is_tested_by_the_functions_that_read_it(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(tmp_path)
    (tmp_path / "folding_rule.py").write_text(
        "LONG = 3.0\n\n\ndef width(a):\n    return a * LONG\n\n\ndef twice(a):\n"
        "    return width(a) * 2\n", "utf-8",
    )  # fmt: skip
    found = {
        one.mutant.function: functions_of(one) for one in mutants(source("folding_rule"), FORMULAS)
    }
    assert found == {
        "LONG": {"folding_rule:width"}, "width": {"folding_rule:width"},
        "twice": {"folding_rule:twice"},
    }  # fmt: skip
