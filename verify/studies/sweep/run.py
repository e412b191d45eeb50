"""Solve the points of a plan: stored results are read, all other points are solved in batches."""

import time
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, replace
from importlib.metadata import version
from pathlib import Path

from verify.core.case import Portion
from verify.core.environment import require_gmsh
from verify.core.inputs import InputError, Inputs
from verify.core.progress import Show
from verify.core.store import Store
from verify.jobs import cache
from verify.jobs.dispatch import Dispatch
from verify.jobs.engine import GoneError
from verify.jobs.executor import Lost, Where
from verify.studies.sweep.axes import changed
from verify.studies.sweep.pairs import portion
from verify.studies.sweep.plan import Plan
from verify.studies.sweep.point import Solution, Task, code_of, solve_batch
from verify.studies.sweep.store import Points, joined, lacking

BATCH = 1.0  # s per batch: overhead a few ms; an interruption loses one batch of each process
ANSWERED = 50  # batches a second that a scheduler and this process keep up with easily
MOST = 256  # points of a batch


@dataclass(frozen=True)
class Timing:
    """Time used to solve points.

    `points` were solved in `wall` s, in which the processes computed for `busy` s in total.
    `workers` is the number of processes at the end. `known` is the number of points with stored
    results.
    """

    points: int
    wall: float
    busy: float
    workers: int
    known: int

    @property
    def overhead(self) -> float:
        """Share of the available process time in which no point was being solved."""
        whole = self.wall * self.workers
        return 1 - self.busy / whole if whole else 0.0


@dataclass(frozen=True)
class Solved:
    """Solutions of all points of a plan, in the order of the plan.

    A solution states the reason if there are no values. `inputs` are the inputs of each point, None
    if the rules of the inputs reject them.
    """

    plan: Plan
    part: Portion
    inputs: tuple[Inputs | None, ...]
    solutions: tuple[Solution, ...]
    timing: Timing


def solve(
    plan: Plan,
    where: Where,
    *,
    folder: Path | None = None,
    again: bool = False,
    show: Show = lambda _state: None,
) -> Solved:
    """Solve every point of the plan on the given processes; each result is stored immediately.

    `again` repeats failed points. Raises OSError if results cannot be stored or gmsh cannot be
    started, GoneError if the processes do not respond any more, and KeyboardInterrupt. The
    messages of the last two state which results are stored.
    """
    part = portion(plan.case, plan.chosen)
    store = Store(folder or cache.default_folder())
    stored = Points(store, plan.case.id, part, code_of(plan.case, part), versions(part))
    points = _Points(plan, part, stored, again=again)
    todo = points.missing()
    # points of the same inputs are one; refused ones have none
    timing = Timing(0, 0.0, 0.0, 0, len(points.inputs) - len(todo))
    if todo:
        if not where.scheduler:  # the workers report missing packages themselves
            require_gmsh()
        run = _Batches(points, show, known=timing.known, todo=todo)
        start = time.monotonic()
        run.solve(where)
        timing = replace(
            timing, points=len(todo), wall=time.monotonic() - start, busy=run.busy,
            workers=min(run.workers, len(todo)),
        )  # fmt: skip
    inputs = tuple(points.inputs.get(key) for key in points.keys)
    return Solved(plan, part, inputs, points.solutions(), timing)


def versions(part: Portion) -> str:
    """Libraries on which a result may depend, with their versions, as text."""
    return ", ".join(f"{name} {version(name)}" for name in cache.libraries_of(part.fem))


class _Points:
    """Points of a plan: inputs of each point or the reason for refusal, and stored results.

    Points with equal inputs are solved once.
    """

    def __init__(self, plan: Plan, part: Portion, stored: Points, *, again: bool) -> None:
        self.plan, self.part, self.stored = plan, part, stored
        self.keys: list[str] = []
        self.refused: dict[int, str] = {}
        self.inputs: dict[str, Inputs] = {}
        for n, row in enumerate(plan.points):
            try:
                one = changed(plan.inputs, dict(zip(plan.names, row, strict=True)))
            except InputError as error:
                self.refused[n] = str(error)
                self.keys.append("")
                continue
            # the limit of the case, evaluated each time: a stored answer could be outdated
            if reason := plan.case.too_large(one):
                self.refused[n] = reason.partition("; check ")[0]
                self.keys.append("")
                continue
            self.keys.append(stored.key(one))
            self.inputs[self.keys[-1]] = one
        self.names = list(self.inputs)
        self.known = stored.load(list(self.inputs))
        if again:
            self.known = {k: _without_problems(one) for k, one in self.known.items()}

    def missing(self) -> list[Task]:
        """Tasks for the points without results, numbered by their position in `names`."""
        code = code_of(self.plan.case, self.part)
        todo = []
        for n, (key, inputs) in enumerate(self.inputs.items()):
            formulas, fe = lacking(self.known.get(key))
            if formulas or fe:
                todo.append(Task(n, self.plan.case.id, self.part.name, inputs, formulas, fe, code))
        return todo

    def keep(self, tasks: Sequence[Task], answers: Sequence[Solution]) -> None:
        """Store the results of solved points."""
        keys = self.names
        found = {
            keys[task.number]: joined(self.known.get(keys[task.number]), answer)
            for task, answer in zip(tasks, answers, strict=True)
        }
        self.stored.keep({key: one for key, one in found.items() if not one.lost})
        self.known |= found

    def solutions(self) -> tuple[Solution, ...]:
        """One solution for each point of the plan."""
        return tuple(
            Solution({}, (), {}, {}, problem_fe=f"refused: {self.refused[n]}")
            if n in self.refused
            else self.known[key]
            for n, key in enumerate(self.keys)
        )


def _without_problems(one: Solution) -> Solution:
    return replace(one, problem_formulas="", problem_fe="")


class _Batches:
    """Batches of points for the processes; the time per point determines the size of a batch."""

    def __init__(self, points: _Points, show: Show, *, known: int, todo: Sequence[Task]) -> None:
        self.points = points
        self.waiting = deque(todo)
        self.busy = self.pace = (
            0.0  # s; time of a point in the last batch: the first points include imports
        )
        self.workers = 1
        self.dispatch = Dispatch(
            "points", known + len(todo), known, show,
            title=lambda batch: f"{len(batch)} running",
            split=lambda batch: [(task,) for task in batch],
        )  # fmt: skip

    def solve(self, where: Where) -> None:
        """Solve all points.

        Raises GoneError if the processes cannot solve points, for example because they have other
        code.
        """
        self.dispatch.run(where.entered(), solve_batch, self._take, self._receive)

    def _take(self) -> tuple[Task, ...] | None:
        if not self.waiting:
            return None
        self.workers = self.dispatch.workers
        size = min(self._size(), len(self.waiting))
        return tuple(self.waiting.popleft() for _ in range(size))

    def _size(self) -> int:
        """Number of points of the next batch, which is solved in about BATCH s.

        The first batches contain one point. Batches become smaller towards the end.
        """
        if not self.busy:
            return 1
        fair = len(self.waiting) // (4 * self.workers)
        seconds = max(BATCH, self.workers / ANSWERED)
        return max(1, min(MOST, int(seconds / max(self.pace, 1e-6)), fair))

    def _receive(self, batch: tuple[Task, ...], answer: list[Solution] | Lost) -> int:
        if isinstance(answer, Lost):
            if answer.trace:  # an error in a point is stated in its solution
                raise GoneError(f"the workers cannot solve the points: {answer.reason}")
            answer = [_lost(task, answer) for task in batch]
        self.points.keep(batch, answer)
        self.dispatch.unstored += sum(one.lost for one in answer)
        seconds = sum(one.seconds for one in answer)
        self.busy += seconds
        self.pace = seconds / len(batch)
        return len(batch)


def _lost(task: Task, lost: Lost) -> Solution:
    return Solution(
        {}, (), {}, {}, problem_formulas=lost.reason if task.formulas else "",
        problem_fe=lost.reason if task.fe else "", lost=True,
    )  # fmt: skip
