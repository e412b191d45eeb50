"""A case that raises an error fails; all others are judged as usual, and each is solved once."""

import os
from concurrent.futures import Future
from contextlib import nullcontext
from dataclasses import replace

import pytest

from verify.core.case import Case, FemResult
from verify.core.inputs import Inputs, quantity
from verify.core.results import Status
from verify.core.store import Store
from verify.jobs import cache
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


BOOM = ("FAIL", "KeyError: 'no such\\n key'")
HELD = ("PASS", "confirmed")


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


def beside(case, **more):
    """The case beside a healthy one."""
    bad, good = run([Job(case, Beam()), Job(OTHER, Beam())], **more)
    assert {row.status for row in good.rows} == {Status.PASS}
    assert good.errors == ()
    return bad


def test_a_part_that_raises_is_a_failed_row_and_the_rest_is_judged():
    for part, fault, row in (
        ("sketch", boom, BOOM),
        ("tables", boom, BOOM),
        ("figures", late, ("FAIL", "RuntimeError: in the middle")),
    ):
        result = beside(replace(CASE, **{part: fault}))
        assert rows_of(result) == {part: row, "with elements": HELD, "formula alone": HELD}
        assert not getattr(result, part)
        (error,) = result.errors
        assert f"in {fault.__name__}\n" in error


def test_formulas_and_checks_that_raise_fail_their_rows_by_their_names():
    result = beside(replace(CASE, analytic=boom, equations=lambda _q, values: values["v"]))
    assert rows_of(result) == dict.fromkeys(("with elements", "formula alone", "formulas"), BOOM)
    assert len(result.errors) == 1  # no second one about equations without values
    rows = rows_of(beside(replace(CASE, checks=(holds("with elements", boom), CASE.checks[1]))))
    assert rows == {"with elements": BOOM, "formula alone": HELD}

    class Broken(Fact):
        rows = skipped = boom

    broken = Broken(name="beyond help", symbol="", unit="1", margin=boom)  # it names no rows
    result = beside(replace(CASE, checks=(broken,)))
    assert rows_of(result) == {"beyond help": BOOM}
    assert len(result.errors) == 2


def test_finite_elements_that_raise_fail_the_rows_that_need_them():
    for error, reason, traced in (
        (ArithmeticError("residual 1e+00"), "not converged: level 4: residual 1e+00", 0),
        (Exception("gmsh says\n  no"), "level 4: Exception: gmsh says no", 1),
        (MemoryError(), "level 4: MemoryError", 1),
    ):

        def fem(inputs, level, error=error):
            if level == 4:
                raise error
            return made_up(inputs, level)

        result = beside(replace(CASE, reference=fem))
        assert rows_of(result) == {"with elements": ("FAIL", reason), "formula alone": HELD}
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


def test_a_level_whose_process_died_is_a_failed_row_of_its_case_alone():
    bad = beside(CASE, engine=nullcontext(Engine(Dying(), lambda: 2)))
    died = ("FAIL", "level 4: the process died (signal 9)")
    assert rows_of(bad) == {"with elements": died, "formula alone": HELD}
    gone = nullcontext(Engine(Dying(), lambda: 1, gone=lambda: "it is gone"))
    with pytest.raises(GoneError, match="it is gone"):
        run([Job(CASE, Beam())], engine=gone)


# The cache and the order of levels.


def test_what_is_stored_is_not_solved_again(tmp_path):
    solved = []

    def fem(inputs, level):
        solved.append(level)
        return made_up(inputs, level)

    # the cache identifies a function by its source: that of `fem` above
    case = replace(CASE, reference=fem)
    run([Job(replace(case, levels=(1, 4)), Beam())], cache_folder=tmp_path)
    assert solved == [4, 1]
    states = []
    for _ in range(2):  # the second time there is nothing to say
        run([Job(case, Beam())], cache_folder=tmp_path, show=states.append)
        assert solved == [4, 1, 2]
        assert {(s.done, s.total) for s in states} == {(2, 3), (3, 3)}


def test_a_disk_that_fills_is_mentioned_once_and_the_run_continues(tmp_path, monkeypatch):
    tried, message = [], []

    def full(*_):
        tried.append(1)
        raise OSError(28, os.strerror(28), "somewhere")

    monkeypatch.setattr(cache, "store", full)
    result = beside(CASE, cache_folder=tmp_path, warn=message.append)
    assert {row.status for row in result.rows} == {Status.PASS}
    (line,) = message
    assert "No space left on device" in line
    assert len(tried) == 1  # and nothing is tried again


# Cases are judged on the engine while others are solved


def test_stored_cases_are_judged_on_the_engine_where_there_are_many(tmp_path):
    jobs = [Job(replace(CASE, id=f"ring-{n}"), Beam()) for n in range(4)]
    first = run(jobs, cache_folder=tmp_path)
    for count, judged in ((3, 0), (4, 4)):
        done = []
        run(jobs[:count], cache_folder=tmp_path, judged=done.append)
        assert len(done) == judged
    done = []

    def cleared(result):
        done.append(result)
        Store(tmp_path).clear("level")

    # what the store has lost meanwhile is judged here
    results = run(jobs, cache_folder=tmp_path, judged=cleared)
    assert [one.rows for one in results] == [one.rows for one in first]
    assert len(done) == 1
