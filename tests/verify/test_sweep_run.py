"""What a sweep solves and what it finds solved, batch by batch."""

import sqlite3
from contextlib import contextmanager
from dataclasses import replace

import pytest

from tests.verify.sweep_made import CASE, Dying, Here, chosen
from verify.cases import registry
from verify.jobs.engine import GoneError
from verify.studies.sweep import point, run
from verify.studies.sweep.plan import grid
from verify.studies.sweep.run import solve


@pytest.fixture
def called(monkeypatch):
    """How often formulas and levels of the made-up case were asked for."""
    counts = {"formulas": 0, "fe": 0}

    def counted(name, function):
        def inner(*args):
            counts[name] += 1
            return function(*args)

        return inner

    known = replace(
        CASE, analytic=counted("formulas", CASE.analytic), reference=counted("fe", CASE.reference)
    )
    monkeypatch.setattr(registry, "CASES", (known,))
    point._known.cache_clear()
    monkeypatch.setattr(run, "code_of", lambda _case, _part: ("formulas", "fe"))
    monkeypatch.setattr(point, "code_of", lambda _case, _part: ("formulas", "fe"))
    yield counts
    point._known.cache_clear()


def planned(*vary):
    return grid(CASE, "plate", CASE.inputs(), chosen(), vary)


def test_what_is_solved_is_not_solved_again_and_a_finer_grid_takes_it_up(tmp_path, called):
    first = solve(planned("a=2mm:6mm:3"), Here(), folder=tmp_path)
    assert (first.timing.points, first.timing.known, called["fe"]) == (3, 0, 9)
    again = solve(planned("a=2mm:6mm:3"), Here(), folder=tmp_path)
    assert (again.timing.points, again.timing.known) == (0, 3)
    assert again.solutions == first.solutions
    finer = solve(planned("a=2mm:6mm:5"), Here(), folder=tmp_path)
    assert (finer.timing.points, finer.timing.known, called["fe"]) == (2, 3, 15)
    assert finer.solutions[::2] == first.solutions


@pytest.mark.parametrize(
    ("code", "solved"),
    [
        (("other", "fe"), {"formulas": 4, "fe": 6}),
        (("formulas", "other"), {"formulas": 2, "fe": 12}),
        (("other", "other"), {"formulas": 4, "fe": 12}),
    ],
)
def test_only_the_side_whose_code_has_changed_is_solved_anew(
    tmp_path, called, monkeypatch, code, solved
):
    first = solve(planned("a=2mm,4mm"), Here(), folder=tmp_path)
    for module in (run, point):
        monkeypatch.setattr(module, "code_of", lambda _case, _part: code)
    second = solve(planned("a=2mm,4mm"), Here(), folder=tmp_path)
    assert called == solved
    assert [one.fe for one in second.solutions] == [one.fe for one in first.solutions]
    assert [one.formulas for one in second.solutions] == [one.formulas for one in first.solutions]


def test_a_point_that_fails_keeps_its_reason_until_it_is_asked_for_again(tmp_path, called):
    plan = planned("n=3,9,10")
    first = solve(plan, Here(), folder=tmp_path)
    assert [one.problem_fe for one in first.solutions] == [
        "", "level 1: ValueError: 9 holes do not fit", "level 1: ValueError: 10 holes do not fit",
    ]  # fmt: skip
    assert called["fe"] == 5
    assert solve(plan, Here(), folder=tmp_path).timing.points == 0
    again = solve(plan, Here(), folder=tmp_path, again=True)
    assert (again.timing.points, called["fe"]) == (2, 7)
    assert [one.problem_fe for one in again.solutions] == [
        one.problem_fe for one in first.solutions
    ]


def test_a_point_whose_process_died_has_its_reason_and_is_solved_by_the_next_run(tmp_path, called):
    lost = solve(planned("a=2mm:6mm:3"), Dying(), folder=tmp_path)
    assert {one.problem_fe for one in lost.solutions} == {"the process died (signal 9)"}
    again = solve(planned("a=2mm:6mm:3"), Here(), folder=tmp_path)
    assert (again.timing.points, again.timing.known) == (3, 0)
    assert not any(one.problem_fe or one.lost for one in again.solutions)


@pytest.mark.parametrize("error", [MemoryError, OSError])
def test_a_point_on_which_the_machine_failed_is_solved_by_the_next_run(
    tmp_path, called, monkeypatch, error
):
    case = registry.CASES[0]

    def fails(*_):
        raise error("no room")

    broken = replace(case, reference=fails)
    monkeypatch.setattr(registry, "CASES", (broken,))
    point._known.cache_clear()
    plan = replace(planned("a=2mm:6mm:3"), case=broken)
    lost = solve(plan, Here(), folder=tmp_path)
    assert {one.problem_fe for one in lost.solutions} == {f"level 1: {error.__name__}: no room"}
    monkeypatch.setattr(registry, "CASES", (case,))
    point._known.cache_clear()
    again = solve(planned("a=2mm:6mm:3"), Here(), folder=tmp_path)
    assert (again.timing.points, again.timing.known) == (3, 0)


def test_refused_points_are_neither_solved_nor_known(tmp_path, called):
    plan = planned("n=0,3,4")
    timings = [solve(plan, Here(), folder=tmp_path).timing for _ in range(2)]
    assert [(one.points, one.known) for one in timings] == [(2, 0), (0, 2)]


def test_a_case_s_own_limit_counts_as_it_stands_and_is_not_kept(tmp_path, called, monkeypatch):
    plan = planned("n=3,4")
    limit = {"most": 3}

    def too_large(q):
        return "too many holes; check without them" if q.n > limit["most"] else ""

    plan = replace(plan, case=replace(plan.case, too_large=too_large))
    first = solve(plan, Here(), folder=tmp_path)
    assert [one.problem_fe for one in first.solutions] == ["", "refused: too many holes"]
    limit["most"] = 4
    second = solve(plan, Here(), folder=tmp_path)
    assert [one.problem_fe for one in second.solutions] == ["", ""]
    assert (second.timing.points, second.timing.known) == (1, 1)


def test_an_engine_that_never_comes_leaves_all_points_to_do(tmp_path, called):
    class Nowhere(Here):
        @contextmanager
        def entered(self):
            raise GoneError("nothing answers")
            yield

    with pytest.raises(GoneError, match="nothing answers; 0 of 2 points are stored"):
        solve(planned("a=2mm,4mm"), Nowhere(), folder=tmp_path)


def test_points_of_the_same_inputs_are_solved_once(tmp_path, called):
    plan = planned("a=2mm,4mm")
    twice = replace(plan, points=plan.points[[0, 1, 0, 1]])
    found = solve(twice, Here(), folder=tmp_path)
    assert (found.timing.points, called["formulas"]) == (2, 2)
    assert found.solutions[:2] == found.solutions[2:]


def test_workers_of_other_code_end_the_sweep_with_what_is_kept(tmp_path, called, monkeypatch):
    monkeypatch.setattr(point, "code_of", lambda _case, _part: ("older", "fe"))
    with pytest.raises(GoneError, match=r"cannot solve points here: .*code of made-up-plate is not "
                                        r"that of the sweep; 0 of 2 points are"):  # fmt: skip
        solve(planned("a=2mm,4mm"), Here(), folder=tmp_path)
    assert called["fe"] == 0


def test_what_is_no_database_is_told_and_left_as_it_is(tmp_path, called):
    file = tmp_path / "store.sqlite"
    file.write_bytes(b"no database" * 100)
    with pytest.raises(OSError, match=r"store\.sqlite: .* cannot be stored there"):
        solve(planned("a=2mm,4mm"), Here(), folder=tmp_path)
    assert file.read_bytes() == b"no database" * 100


def test_a_point_that_cannot_be_read_is_solved_anew(tmp_path, called):
    plan = planned("a=2mm,4mm")
    first = solve(plan, Here(), folder=tmp_path)
    with sqlite3.connect(tmp_path / "store.sqlite") as database:
        database.execute(
            "UPDATE entries SET content = '{' WHERE rowid = (SELECT MIN(rowid) FROM entries)"
        )
    second = solve(plan, Here(), folder=tmp_path)
    assert second.timing.points == 1
    assert [one.fe for one in second.solutions] == [one.fe for one in first.solutions]


@pytest.mark.parametrize(
    ("done", "waiting", "workers", "pace", "size"),
    [
        (0, 1000, 2, 0.0, 1),  # nothing is known yet
        (4, 1000, 2, 0.25, 4),  # a second
        (4, 1000, 2, 3.0, 1),
        (4, 1000, 2, 1e-5, 125),  # a fair share of what is left: no process waits long for another
        (4, 10**6, 2, 1e-5, 256),
        (4, 20, 2, 0.01, 2),
        (4, 10**6, 1000, 0.25, 80),  # 20 s: fifty batches a second are answered
    ],
)  # fmt: skip
def test_batches_take_a_second_or_what_many_workers_need(done, waiting, workers, pace, size):
    one = run._Batches(None, lambda _state: None, known=0, todo=range(waiting))
    one.busy, one.pace, one.workers = done * pace, pace, workers
    assert one._size() == size


def test_the_share_of_the_time_in_which_nothing_is_solved():
    assert run.Timing(points=10, wall=10.0, busy=18.0, workers=2, known=0).overhead == (
        pytest.approx(0.1)
    )
    assert run.Timing(points=0, wall=0.0, busy=0.0, workers=0, known=10).overhead == 0
