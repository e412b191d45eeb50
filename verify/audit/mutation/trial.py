"""Check of one mutant in a child process: cases that call the changed code are judged again."""

from collections.abc import Sequence
from dataclasses import dataclass

from verify.audit.mutation.baseline import Noted
from verify.audit.mutation.outcomes import By
from verify.audit.mutation.patching import patch
from verify.audit.mutation.sites import Changed, source
from verify.audit.mutation.workload import Judged, Load, reddened, refuses
from verify.core.case import FemResult
from verify.core.figures import Array
from verify.jobs.guard import named

Verdict = list[str]  # kind of detection, and a description


@dataclass(frozen=True)
class Bench:
    """A case that calls the code changed by a mutant, and its record for unchanged code."""

    load: Load
    before: Noted

    def judged(self) -> Judged:
        """Statuses of the case's rows, judged with the code now in this process."""
        return self.load.judged()


def tried(
    changed: Changed, benches: Sequence[Bench], moved: Sequence[Bench] = ()
) -> Verdict:  # fmt: skip
    """Replace code by the mutant and judge the cases one by one until a row fails.

    The levels of cases in `moved` also depend on the mutant; these cases are solved with it.
    """
    patch(source(changed.mutant.module), changed)
    for bench in benches:
        if verdict := detected(bench.judged(), bench):
            return verdict
    for bench in moved:
        if verdict := _solved(bench, bench.load.case.levels):
            return verdict
    return [By.NOTHING.value, ""]


def detected(judged: Judged, bench: Bench) -> Verdict | None:
    """How the case detected the mutant (kind, and row or error); None if it did not detect it.

    Failed rows have priority over errors that the project raises, and these over other errors.
    """
    case = bench.load.case.id
    if red := reddened(bench.before.states, judged.states):
        more = f" and {len(red) - 1} more" if len(red) > 1 else ""
        return [By.ROWS.value, f"{case}/{red[0]}{more}"]
    own = [error for error in judged.errors if refuses(error)]
    for by, errors in ((By.REFUSED, own), (By.CRASHED, judged.errors)):
        if errors:
            return [by.value, f"{case}: {named(errors[0])}"[:200]]
    return None


def solved(changed: Changed, work: Sequence[tuple[Bench, Sequence[int]]]) -> Verdict:
    """Replace code by a mutant of finite elements and solve cases until one detects it."""
    patch(source(changed.mutant.module), changed)
    for bench, levels in work:
        if verdict := _solved(bench, levels):
            return verdict
    return [By.NOTHING.value, ""]


def _solved(bench: Bench, levels: Sequence[int]) -> Verdict | None:
    """Solve the given levels of a case with the changed code and judge the case.

    Levels that are not solved again are shifted by the change of the first solved level, because an
    error of the model changes all levels by the same amount.
    """
    case, load = bench.load.case, bench.load
    solved_levels: dict[int, FemResult] = {}
    try:
        for level in levels:
            solved_levels[level] = case.reference(load.inputs, level)
    except Exception as error:
        by = By.REFUSED if refuses(error) else By.CRASHED
        return [by.value, f"{case.id}: {named(error)}"[:200]]
    first = case.levels.index(levels[0])
    shifts = Shift(load.levels[first], solved_levels[levels[0]])
    results = tuple(
        solved_levels[level] if level in solved_levels else shifts.of(stored)
        for level, stored in zip(case.levels, load.levels, strict=True)
    )
    judged = Load(case, load.inputs, results, load.values).judged()
    return detected(judged, bench)


@dataclass(frozen=True)
class Shift:
    """Changes of one level's results by a mutant; `of` adds them to a stored level.

    An array is changed only if its shape is the same in `before`, `after` and the stored level.
    """

    before: FemResult
    after: FemResult

    def of(self, stored: FemResult) -> FemResult:
        """The level `stored`, with the changes by the mutant added to its values and arrays."""
        values = {
            key: value + self.after.values[key] - self.before.values[key]
            if key in self.after.values and key in self.before.values else value
            for key, value in stored.values.items()
        }  # fmt: skip
        arrays = {key: self._moved(key, array) for key, array in stored.arrays.items()}
        return FemResult(h=stored.h, values=values, u_it=stored.u_it, arrays=arrays)

    def _moved(self, key: str, array: Array) -> Array:
        one, other = self.after.arrays.get(key), self.before.arrays.get(key)
        if one is None or other is None or not one.shape == other.shape == array.shape:
            return array
        return array + (one - other) if array.dtype.kind in "fc" else array


def tested(changed: Changed, tests: Sequence[str]) -> Verdict:
    """Replace code by the mutant and run the tests until one fails."""
    from verify.audit.mutation import suite  # pytest, which a user's environment may not have

    patch(source(changed.mutant.module), changed)
    failed = suite.first_failure(tests)
    return [By.TESTS.value, failed] if failed else [By.NOTHING.value, ""]
