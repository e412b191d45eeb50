"""One case that goes wrong is red; the others are judged as usual, and nothing is solved twice."""

import os
from concurrent.futures import Future
from contextlib import nullcontext
from dataclasses import replace

import pytest

from verify.core.case import Case, FemResult
from verify.core.inputs import Inputs, quantity
from verify.core.results import Status
from verify.jobs.engine import Engine, GoneError
from verify.jobs.executor import Here
from verify.jobs.level import Job
from verify.jobs.processes import WorkerDiedError
from verify.jobs.scheduler import run
from verify.judging.checks import Fact


class Beam(Inputs):
    L: float = quantity("1 m", "mm", "L", "length")


def made_up(inputs, level):
    return FemResult(h=1 / level, values={"v": inputs.L})


def boom(*_):
    raise KeyError("no such\n key")


def late(*_):
    yield from ()
    raise RuntimeError("in the middle")


def holds(name, margin=lambda _context: (1.0, 0.0), **more):
    return Fact(name=name, symbol="x", unit="1", margin=margin, **more)


CASE = Case(
    id="ring-made-up", title="", paper="", place="", lead="", inputs=Beam,
    analytic=lambda q: {"v": q.L}, reference=made_up, levels=(1, 2, 4), outputs=(),
    checks=(holds("with elements"), holds("formula alone", fem_needed=False)),
)  # fmt: skip
OTHER = replace(CASE, id="ring-other")


def rows_of(result):
    return {row.quantity: (row.status.value, row.reason) for row in result.rows}


def here(case, **more):
    """The case beside a healthy one, solved in this process."""
    bad, good = run([Job(case, Beam()), Job(OTHER, Beam())], **more)
    assert {row.status for row in good.rows} == {Status.PASS}
    assert good.errors == ()
    return bad


@pytest.mark.parametrize(
    ("part", "fault", "reason"),
    [
        ("sketch", boom, "KeyError: 'no such\\n key'"),
        ("tables", boom, "KeyError: 'no such\\n key'"),
        ("figures", late, "RuntimeError: in the middle"),
    ],
)
def test_a_part_that_raises_is_a_red_row_and_the_rest_is_judged(part, fault, reason):
    result = here(replace(CASE, **{part: fault}))
    rows = rows_of(result)
    assert rows.pop(part) == ("FAIL", reason)
    assert set(rows.values()) == {("PASS", "held")}
    assert not getattr(result, part)
    assert len(result.errors) == 1
    assert f"in {fault.__name__}\n" in result.errors[0]


def test_formulas_that_raise_turn_every_row_red_by_its_name():
    result = here(replace(CASE, analytic=boom, equations=lambda _q, values: values["v"]))
    reason = ("FAIL", "KeyError: 'no such\\n key'")
    assert rows_of(result) == dict.fromkeys(("with elements", "formula alone", "formulas"), reason)
    assert len(result.errors) == 1  # no second one about equations without values


def test_a_check_that_raises_turns_its_own_rows_red():
    bad = holds("with elements", boom)
    rows = rows_of(here(replace(CASE, checks=(bad, CASE.checks[1]))))
    assert rows["with elements"] == ("FAIL", "KeyError: 'no such\\n key'")
    assert rows["formula alone"] == ("PASS", "held")


def test_a_check_that_cannot_even_name_its_rows_turns_one_red():
    class Broken(Fact):
        rows = skipped = boom

    broken = Broken(name="beyond help", symbol="", unit="1", margin=boom)
    result = here(replace(CASE, checks=(broken,)))
    assert rows_of(result) == {"beyond help": ("FAIL", "KeyError: 'no such\\n key'")}
    assert len(result.errors) == 2


@pytest.mark.parametrize(
    ("error", "reason", "traced"),
    [
        (ArithmeticError("residual 1e+00"), "not converged: level 4: residual 1e+00", 0),
        (ZeroDivisionError("by zero"), "level 4: ZeroDivisionError: by zero", 1),
        (Exception("gmsh says\n  no"), "level 4: Exception: gmsh says no", 1),
        (MemoryError(), "level 4: MemoryError", 1),
    ],
    ids=lambda value: type(value).__name__,
)
def test_finite_elements_that_raise_turn_the_rows_that_need_them_red(error, reason, traced):
    def fem(inputs, level):
        if level == 4:
            raise error
        return made_up(inputs, level)

    result = here(replace(CASE, reference=fem))
    assert rows_of(result) == {
        "with elements": ("FAIL", reason), "formula alone": ("PASS", "held")
    }  # fmt: skip
    assert len(result.errors) == traced


def test_ctrl_c_is_no_fault_of_a_case():
    def stop(*_):
        raise KeyboardInterrupt

    for part in ("reference", "analytic", "tables"):
        with pytest.raises(KeyboardInterrupt):
            run([Job(replace(CASE, **{part: stop}), Beam())])


class Dying(Here):
    """In place of processes: the finest level's dies whenever it is tried."""

    def submit(self, function, /, task):
        if task.case is CASE and task.level == 4:
            future = Future()
            future.set_exception(WorkerDiedError("the process died (signal 9)"))
            return future
        return super().submit(function, task)


def test_a_level_whose_process_died_is_a_red_row_of_its_case_alone():
    engine = nullcontext(Engine(Dying(), lambda: 2))
    bad, good = run([Job(CASE, Beam()), Job(OTHER, Beam())], engine=engine)
    assert rows_of(bad)["with elements"] == ("FAIL", "level 4: the process died (signal 9)")
    assert rows_of(bad)["formula alone"] == ("PASS", "held")
    assert {row.status for row in good.rows} == {Status.PASS}


def test_an_engine_that_is_gone_ends_the_run_and_what_was_solved_is_stored(tmp_path):
    engine = nullcontext(Engine(Dying(), lambda: 1, gone=lambda: "it is gone"))
    with pytest.raises(GoneError, match="it is gone"):
        run([Job(CASE, Beam())], engine=engine, cache_folder=tmp_path)


# The cache and the order of levels.


def counting(case, solved):
    def fem(inputs, level):
        solved.append((case.id, level))
        return made_up(inputs, level)

    # the cache knows a function by its source: that of `fem` above
    return replace(case, reference=fem)


def test_what_is_stored_is_not_solved_again(tmp_path):
    solved = []
    case = counting(CASE, solved)
    run([Job(replace(case, levels=(1, 4)), Beam())], cache_folder=tmp_path)
    assert solved == [("ring-made-up", 4), ("ring-made-up", 1)]
    run([Job(case, Beam())], cache_folder=tmp_path)
    assert solved[2:] == [("ring-made-up", 2)]


def test_a_disk_that_fills_is_mentioned_once_and_the_run_goes_on(tmp_path, monkeypatch):
    from verify.jobs import cache

    tried = []

    def full(*_):
        tried.append(1)
        raise OSError(28, os.strerror(28), "somewhere")

    monkeypatch.setattr(cache, "store", full)
    said = []
    result = here(CASE, cache_folder=tmp_path, warn=said.append)
    assert {row.status for row in result.rows} == {Status.PASS}
    assert len(said) == 1
    assert "No space left on device" in said[0]
    assert len(tried) == 1  # and nothing is tried again


def test_the_state_counts_what_the_cache_held(tmp_path):
    run([Job(replace(CASE, levels=(1, 4)), Beam())], cache_folder=tmp_path)
    states = []
    run([Job(CASE, Beam())], cache_folder=tmp_path, show=states.append)
    assert {(s.done, s.total) for s in states} == {(2, 3), (3, 3)}  # before the last level, after
    states.clear()
    run([Job(CASE, Beam())], cache_folder=tmp_path, show=states.append)
    assert states == []  # nothing to say when all is there
