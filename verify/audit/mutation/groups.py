"""The three groups of mutants: formulas, judging, finite elements."""

import sys
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

from verify.audit.mutation import resolve as resolving
from verify.audit.mutation import trial
from verify.audit.mutation.baseline import Noted, Notes
from verify.audit.mutation.sample import is_constant, reached, readers, sample
from verify.audit.mutation.sandbox import Task
from verify.audit.mutation.sites import Changed, source
from verify.audit.mutation.subject_operators import FINITE_ELEMENTS, FORMULAS, JUDGING
from verify.audit.mutation.trial import Bench
from verify.audit.mutation.workload import Load
from verify.core.case import Case
from verify.core.progress import Show, State
from verify.jobs import cache
from verify.jobs import timing as durations

# with a margin: one in twenty crashes, of finite elements one in six, and is counted separately
SIZES = {"formulas": 260, "judging": 64, "finite-elements": 54}
JUDGES = (
    "verify.judging.checks",
    "verify.judging.claims",
    "verify.judging.convergence",
    "verify.judging.judge",
)
LEAST = 30.0  # s that every mutant has
FACTOR = 10.0  # times the duration of the unchanged code: two processes may share a core
WHOLE = 3.0  # s: a case is solved completely if all its levels together take less
CASES_EACH = 3  # the quickest, one after the other until one notices a mutant of finite elements
LONGEST = 4.0  # s for a coarsest level that mutants are tried on


@dataclass(frozen=True)
class Group:
    """A group of mutants: all, the selected sample, and the functions that check a mutant.

    `trial` returns the first check of a mutant and `tests` the tests that follow. `last` returns
    the final check, for a mutant that no faster check has detected.
    """

    name: str
    all: Sequence[Changed]
    chosen: Sequence[Changed]
    trial: Callable[[Changed], Task]
    tests: Callable[[Changed], Sequence[str]]
    last: Callable[[Changed], Task | None] = lambda _changed: None


def formulas(loads: Sequence[Load], notes: Notes, seed: int, *, whole: bool) -> Group:
    """Mutants of analytic/ in functions that are called while cases are judged."""
    benches = _benches(loads, notes.cases(loads))
    tests = _suite(notes, "formulas")
    found = reached(_modules(benches, "analytic."), FORMULAS, benches)
    group = _group("formulas", found, seed, whole, _judging(benches), tests)
    return replace(group, last=_solving_last(benches))


def judging(loads: Sequence[Load], notes: Notes, seed: int, *, whole: bool) -> Group:
    """Mutants of the judging code; each case is judged with stored values of its formulas."""
    noted = notes.cases(loads)
    benches = _benches(_with_values(loads, notes.show), noted)
    tests = _suite(notes, "judging")
    found = reached(JUDGES, JUDGING, benches)
    return _group("judging", found, seed, whole, _judging(benches), tests)


def elements(loads: Sequence[Load], notes: Notes, seed: int, *, whole: bool) -> Group:
    """Mutants of fem/ and meshes/ in functions that the coarsest level of a case calls."""
    quick = _quick(loads)
    noted = notes.elements([load.case for load in quick])
    states = notes.cases(loads)
    of_levels = {
        case: Noted(one.seconds, one.functions, states[case].states) for case, one in noted.items()
    }
    _imported(of_levels)
    benches = _benches(_with_values(quick, notes.show), of_levels)
    tests = _suite(notes, "elements")
    found = reached(_modules(benches, ("fem.", "meshes.")), FINITE_ELEMENTS, benches)
    return _group("finite-elements", found, seed, whole, _solving_task(benches), tests)


MAKE = {"formulas": formulas, "judging": judging, "finite-elements": elements}


def _group(
    name: str, found: Sequence[Changed], seed: int, whole: bool,
    trial: Callable[[Changed], Task], tests: Callable[[Changed], Sequence[str]],
) -> Group:  # fmt: skip
    chosen = found if whole else sample(found, SIZES[name], seed)
    return Group(name, found, chosen, trial, tests)


def _with_values(loads: Sequence[Load], show: Show) -> list[Load]:
    """The cases with the values of their formulas, computed once for all mutants."""
    start, found = time.monotonic(), list[Load]()
    for n, load in enumerate(loads):
        left = (time.monotonic() - start) / max(n, 1) * (len(loads) - n)
        show(State(n, len(loads), (load.case.id,), left, what="cases with formulas computed"))
        found.append(load.with_values())
    return found


def _benches(loads: Sequence[Load], noted: Mapping[str, Noted]) -> dict[str, list[Bench]]:
    """Cases that call each function, fastest case first."""
    found: dict[str, list[Bench]] = {}
    for bench in sorted(
        (Bench(load, noted[load.case.id]) for load in loads if load.case.id in noted),
        key=lambda bench: bench.before.seconds,
    ):
        for function in bench.before.functions:
            found.setdefault(function, []).append(bench)
    return found


def _modules(functions: Mapping[str, object], package: str | tuple[str, ...]) -> list[str]:
    modules = sorted({name.partition(":")[0] for name in functions})
    return [name for name in modules if name.startswith(package) and name in sys.modules]


def _of(changed: Changed, benches: Mapping[str, list[Bench]]) -> list[Bench]:
    """Cases that call the function of a mutant.

    For a constant, these are the cases that call any function of its module.
    """
    module, name = changed.mutant.module, changed.mutant.function
    if found := benches.get(f"{module}:{name}"):
        return found
    every = [one for key, many in benches.items() if key.startswith(f"{module}:") for one in many]
    unique = {bench.load.case.id: bench for bench in every}
    return sorted(unique.values(), key=lambda bench: bench.before.seconds)


def _judging(benches: Mapping[str, list[Bench]]) -> Callable[[Changed], Task]:
    def task(changed: Changed) -> Task:
        mine = _of(changed, benches)
        stored, quick, _ = resolving.split(changed.mutant.module, mine)
        return _task(changed, stored, quick)

    return task


def _solving_last(benches: Mapping[str, list[Bench]]) -> Callable[[Changed], Task | None]:
    def task(changed: Changed) -> Task | None:
        *_, slow = resolving.split(changed.mutant.module, _of(changed, benches))
        return _task(changed, [], slow) if slow else None

    return task


def _task(changed: Changed, stored: Sequence[Bench], moved: Sequence[Bench]) -> Task:
    known = sum(bench.before.seconds for bench in (*stored, *moved)) + resolving.seconds(moved)
    work = partial(trial.tried, changed, stored, moved)
    return Task(changed.mutant.id, work, LEAST + FACTOR * known)


def _solving_task(benches: Mapping[str, list[Bench]]) -> Callable[[Changed], Task]:
    """Check that solves the coarsest levels of the fastest cases with a mutant.

    Cases that take little time are solved on all levels.
    """
    known = durations.load(cache.default_folder())

    def levels(case: Case) -> Sequence[int]:
        seconds = [known.get((case.id, level), WHOLE) for level in case.levels]
        return case.levels if sum(seconds) <= WHOLE else case.levels[:1]

    def task(changed: Changed) -> Task:
        mine = _of(changed, benches)[:CASES_EACH]
        work = [(bench, levels(bench.load.case)) for bench in mine]
        limit = LEAST + FACTOR * sum(bench.before.seconds for bench in mine)
        return Task(changed.mutant.id, partial(trial.solved, changed, work), limit)

    return task


def _quick(loads: Sequence[Load]) -> list[Load]:
    """Cases whose coarsest level is solved in a short time, by stored solution times."""
    known = durations.load(cache.default_folder())
    return [
        load for load in loads
        if known.get((load.case.id, load.case.levels[0]), LONGEST) <= LONGEST
    ]  # fmt: skip


def _imported(noted: Mapping[str, Noted]) -> None:
    """Import the modules for solving once, which saves a second or two in each child process."""
    import importlib

    for function in sorted({f for one in noted.values() for f in one.functions}):
        importlib.import_module(function.partition(":")[0])


def _suite(notes: Notes, kind: str) -> Callable[[Changed], Sequence[str]]:
    """Function that gives the tests which reach the code of a mutant; none without pytest."""
    try:
        from verify.audit.mutation import suite
    except ImportError:
        return lambda _changed: ()
    traces = {
        test: (seconds, frozenset(called))
        for test, (seconds, called) in notes.tests(kind, suite.files(kind)).items()
    }
    return lambda changed: suite.covering(functions_of(changed), traces)


def functions_of(changed: Changed) -> set[str]:
    """Names of the function that a mutant changes, or of all that read the changed constant."""
    module, name = changed.mutant.module, changed.mutant.function
    found = readers(name, source(module)) if is_constant(name) else {name}
    return {f"{module}:{function}" for function in found}
