"""What makes a stored point the one that is asked for, and a solution what a worker hands back."""

from dataclasses import replace

import pytest

from tests.verify import sweep_made
from tests.verify.sweep_made import CASE, Plate
from verify.cases import registry
from verify.core import source_code
from verify.core.case import FemResult, Portion
from verify.core.store import Store
from verify.jobs.executor import Lost
from verify.studies.sweep import point, run
from verify.studies.sweep.pairs import whole
from verify.studies.sweep.point import OtherCodeError, Solution, Task, code_of, solve_point
from verify.studies.sweep.store import Points, joined, lacking

PART = Portion(name="part", fem=sweep_made.fem, levels=(1, 2, 4), keys=("k",))
SOLVED = Solution({"k": 1.0}, (1.0, 0.5, 0.25), {"k": (1.0, 2.0, 3.0)}, {"k": 0.1}, seconds=2.0)


@pytest.fixture
def known(monkeypatch):
    monkeypatch.setattr(registry, "CASES", (*registry.CASES, CASE))
    point._known.cache_clear()
    yield
    point._known.cache_clear()


def store(folder, part=PART, code=("formulas", "fe"), versions="numpy 2"):
    return Points(Store(folder), "one", part, code, versions)


def task(**changed):
    part = whole(CASE)
    of = Task(0, CASE.id, part.name, Plate(), True, True, code_of(CASE, part))
    return replace(of, **changed)


@pytest.mark.parametrize(
    "part",
    [replace(PART, name="other"), replace(PART, levels=(1, 2)), replace(PART, levels=(2, 4, 8))],
)
def test_a_point_of_another_portion_or_other_levels_is_another(tmp_path, part):
    assert store(tmp_path, part).key(Plate()) != store(tmp_path).key(Plate())
    assert store(tmp_path).key(Plate(c=2e-3)) != store(tmp_path).key(Plate())


@pytest.mark.parametrize(
    ("code", "versions", "formulas", "fe"),
    [
        (("formulas", "fe"), "numpy 2", True, True),
        (("other", "fe"), "numpy 2", False, True),
        (("formulas", "other"), "numpy 2", True, False),
        (("formulas", "fe"), "numpy 3", False, False),
    ],
)
def test_each_side_is_read_while_the_code_and_the_libraries_stand(
    tmp_path, code, versions, formulas, fe
):
    store(tmp_path).keep({"key": SOLVED})
    found = store(tmp_path, code=code, versions=versions).load(["key"])
    got = found.get("key", Solution({}, (), {}, {}))
    assert (bool(got.formulas), bool(got.fe), bool(got.h), bool(got.u_it)) == (formulas, fe, fe, fe)
    assert lacking(got) == (not formulas, not fe)


def test_a_side_that_is_new_takes_the_place_of_the_old_one():
    formulas = Solution({"k": 5.0}, (), {}, {})
    assert joined(SOLVED, formulas) == replace(SOLVED, formulas={"k": 5.0})
    fe = replace(SOLVED, formulas={}, fe={"k": (7.0, 8.0, 9.0)}, seconds=3.0)
    assert joined(SOLVED, fe) == replace(fe, formulas=SOLVED.formulas)


def test_a_task_of_other_code_is_not_solved(known):
    with pytest.raises(OtherCodeError):
        solve_point(task(code=("theirs", "theirs")))


def test_a_solution_has_its_time_and_the_largest_uncertainty_of_its_levels(known, monkeypatch):
    def fem(q, level):
        return FemResult(h=1 / level, values={"k": 1.0}, u_it={"k": 1.0 / level})

    case = replace(CASE, reference=fem)
    monkeypatch.setattr(registry, "CASES", (*registry.CASES[:-1], case))
    got = solve_point(task(code=code_of(case, whole(case))))
    assert got.u_it == {"k": 1.0}
    assert got.seconds > 0


@pytest.mark.parametrize(("formulas", "fe"), [(True, True), (True, False), (False, True)])
def test_a_task_that_killed_its_process_has_failed_on_the_sides_that_it_was_asked_for(formulas, fe):
    got = run._lost(task(formulas=formulas, fe=fe), Lost("the process died (signal 9)"))
    assert (bool(got.problem_formulas), bool(got.problem_fe)) == (formulas, fe)


@pytest.mark.parametrize(
    ("module", "formulas", "fe"),
    [("analytic.polyhedral.bore_pressure", True, False), ("fem.plane.solve", True, True)],
)
def test_the_code_of_a_side_is_that_of_all_its_modules(monkeypatch, module, formulas, fe):
    case = registry.find("polyhedral-ring", registry.CASES)
    before, true = code_of(case, whole(case)), source_code._read

    def changed(name, *, whole=False):
        digest, imported = true(name, whole=whole)
        return digest + "x" * (name == module), imported

    monkeypatch.setattr(source_code, "_read", changed)
    forget()
    after = code_of(case, whole(case))
    monkeypatch.undo()
    forget()
    assert (after[0] != before[0], after[1] != before[1]) == (formulas, fe)


def forget():
    for one in (source_code.source_of, source_code.whole_source_of):
        one.cache_clear()
