"""Solved and stored points of a sweep: stored points are valid while their code is unchanged."""

import sqlite3
from dataclasses import replace

import pytest

from tests.verify.sweep_made import CASE, Dying, Here, Plate, chosen, fem
from verify.cases import registry
from verify.core.case import FemResult, Portion
from verify.core.store import Store
from verify.jobs.engine import GoneError
from verify.studies.sweep import point, run
from verify.studies.sweep.pairs import whole
from verify.studies.sweep.plan import grid
from verify.studies.sweep.point import Solution, Task, code_of, solve_point
from verify.studies.sweep.run import solve
from verify.studies.sweep.store import Points, lacking

PART = Portion(name="part", fem=fem, levels=(1, 2, 4), keys=("k",))
SOLVED = Solution({"k": 1.0}, (1.0, 0.5, 0.25), {"k": (1.0, 2.0, 3.0)}, {"k": 0.1}, seconds=2.0)


@pytest.fixture
def called(monkeypatch):
    """How often formulas and levels of the made-up case were evaluated."""
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
    for module in (run, point):
        monkeypatch.setattr(module, "code_of", lambda _case, _part: ("formulas", "fe"))
    yield counts
    point._known.cache_clear()


def planned(*vary):
    return grid(CASE, "plate", CASE.inputs(), chosen(), vary)


def test_what_is_solved_is_not_solved_again_and_a_finer_grid_takes_it_up(tmp_path, called):
    first = solve(planned("a=2mm:6mm:3"), Here(), folder=tmp_path)
    assert (first.timing.points, first.timing.known, called["fe"]) == (3, 0, 9)
    finer = solve(planned("a=2mm:6mm:5"), Here(), folder=tmp_path)
    assert (finer.timing.points, finer.timing.known, called["fe"]) == (2, 3, 15)
    assert finer.solutions[::2] == first.solutions
    plan = planned("a=2mm,4mm")
    twice = replace(plan, points=plan.points[[0, 1, 0, 1]])
    assert solve(twice, Here(), folder=tmp_path / "twice").timing.points == 2
    # a point that is torn in the store is solved again
    with sqlite3.connect(tmp_path / "store.sqlite") as database:
        database.execute(
            "UPDATE entries SET content = '{' WHERE rowid = (SELECT MIN(rowid) FROM entries)"
        )
    again = solve(planned("a=2mm:6mm:5"), Here(), folder=tmp_path)
    assert again.timing.points == 1
    assert [one.fe for one in again.solutions] == [one.fe for one in finer.solutions]


@pytest.mark.parametrize(
    ("code", "solved"),
    [
        (("other", "fe"), {"formulas": 4, "fe": 6}),
        (("formulas", "other"), {"formulas": 2, "fe": 12}),
    ],
)
def test_only_the_side_whose_code_has_changed_is_solved_again(
    tmp_path, called, monkeypatch, code, solved
):
    first = solve(planned("a=2mm,4mm"), Here(), folder=tmp_path)
    for module in (run, point):
        monkeypatch.setattr(module, "code_of", lambda _case, _part: code)
    second = solve(planned("a=2mm,4mm"), Here(), folder=tmp_path)
    assert called == solved
    got = [[(one.fe, one.formulas) for one in found.solutions] for found in (first, second)]
    assert got[0] == got[1]


def test_a_point_that_fails_has_its_reason_until_it_is_solved_again(tmp_path, called):
    plan = planned("n=0,3,9")
    first = solve(plan, Here(), folder=tmp_path)
    whys = ["", "level 1: ValueError: 9 holes do not fit"]
    assert [one.problem_fe for one in first.solutions[1:]] == whys
    assert (first.timing.points, called["fe"]) == (2, 4)  # none of the refused one
    assert solve(plan, Here(), folder=tmp_path).timing.points == 0
    again = solve(plan, Here(), folder=tmp_path, again=True)
    assert (again.timing.points, called["fe"]) == (1, 5)
    assert [one.problem_fe for one in again.solutions[1:]] == whys


def test_a_point_whose_process_died_has_its_reason_and_is_solved_by_the_next_run(tmp_path, called):
    lost = solve(planned("a=2mm:6mm:3"), Dying(), folder=tmp_path)
    assert {one.problem_fe for one in lost.solutions} == {"the process died (signal 9)"}
    again = solve(planned("a=2mm:6mm:3"), Here(), folder=tmp_path)
    assert (again.timing.points, again.timing.known) == (3, 0)
    assert not any(one.problem_fe or one.lost for one in again.solutions)


def test_a_limit_of_the_case_counts_unchanged_and_is_not_stored(tmp_path, called):
    plan, limit = planned("n=3,4"), {"most": 3}

    def too_large(q):
        return "too many holes; check without them" if q.n > limit["most"] else ""

    plan = replace(plan, case=replace(plan.case, too_large=too_large))
    first = solve(plan, Here(), folder=tmp_path)
    assert [one.problem_fe for one in first.solutions] == ["", "refused: too many holes"]
    limit["most"] = 4
    second = solve(plan, Here(), folder=tmp_path)
    assert [one.problem_fe for one in second.solutions] == ["", ""]
    assert (second.timing.points, second.timing.known) == (1, 1)


def test_workers_of_other_code_end_the_sweep(tmp_path, called, monkeypatch):
    monkeypatch.setattr(point, "code_of", lambda _case, _part: ("older", "fe"))
    with pytest.raises(
        GoneError,
        match=r"cannot solve the points: .*the code of made-up-plate in "
        r"this process differs from the code of the sweep; 0 ",
    ):
        solve(planned("a=2mm,4mm"), Here(), folder=tmp_path)
    assert called["fe"] == 0


# Points in the store


def store(folder, part=PART, code=("formulas", "fe"), versions="numpy 2"):
    return Points(Store(folder), "one", part, code, versions)


def test_a_point_in_the_store_is_that_of_its_inputs_portion_and_libraries(tmp_path):
    store(tmp_path).keep({"key": SOLVED})
    found = store(tmp_path, code=("other", "fe")).load(["key"])["key"]
    assert (found.formulas, found.fe, found.h, found.u_it) == (
        {}, SOLVED.fe, SOLVED.h, SOLVED.u_it)  # fmt: skip
    assert lacking(found) == (True, False)
    assert not store(tmp_path, versions="numpy 3").load(["key"])
    own = store(tmp_path).key(Plate())
    for part in (replace(PART, name="other"), replace(PART, levels=(2, 4, 8))):
        assert store(tmp_path, part).key(Plate()) != own
    assert store(tmp_path).key(Plate(c=2e-3)) != own


def test_a_point_has_the_largest_uncertainty_of_its_levels(monkeypatch):
    def reference(q, level):
        return FemResult(h=1 / level, values={"k": 1.0}, u_it={"k": 1.0 / level})

    case = replace(CASE, reference=reference)
    monkeypatch.setattr(registry, "CASES", (case,))
    point._known.cache_clear()
    part = whole(case)
    got = solve_point(Task(0, case.id, part.name, Plate(), True, True, code_of(case, part)))
    assert (got.u_it, got.seconds > 0) == ({"k": 1.0}, True)
    point._known.cache_clear()
