"""Solve the points of a plan: what is stored is read, the rest goes to an engine in batches."""

import time
from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from importlib.metadata import version
from pathlib import Path

from verify.core.case import Portion
from verify.core.environment import require_gmsh
from verify.core.inputs import InputError, Inputs
from verify.core.progress import Show, State
from verify.core.store import Store
from verify.jobs import cache
from verify.jobs.engine import Engine, GoneError
from verify.jobs.executor import Drive, Lost, Where
from verify.studies.sweep.axes import changed
from verify.studies.sweep.pairs import portion
from verify.studies.sweep.plan import Plan
from verify.studies.sweep.point import Solution, Task, code_of, solve_batch
from verify.studies.sweep.store import Points, joined, lacking

BATCH = 1.0  # s that a batch takes: what handing it over costs is a few ms, what a kill loses this
ANSWERED = 50  # batches a second that a scheduler and this process keep up with easily
MOST = 256  # points of a batch


@dataclass(frozen=True)
class Timing:
    """What solving has cost: `points` solved now in `wall` s, of which each process spent `busy`.

    `workers` processes were busy at the end; `known` points were there already.
    """

    points: int
    wall: float
    busy: float
    workers: int
    known: int

    @property
    def overhead(self) -> float:
        """Share of the processes' time that no point was solved in."""
        whole = self.wall * self.workers
        return 1 - self.busy / whole if whole else 0.0


@dataclass(frozen=True)
class Solved:
    """A solution for each point of a plan, in its order, or why there is none.

    `inputs` are those of each point, None where the inputs' rules refuse it.
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
    """Every point of the plan, solved where it is said, each kept as soon as it is there.

    `again` solves anew what failed before. OSError where points cannot be kept or gmsh not
    started, GoneError where the engine answers no more, KeyboardInterrupt: both say what is kept.
    """
    part = portion(plan.case, plan.chosen)
    store = Store(folder or cache.default_folder())
    stored = Points(store, plan.case.id, part, code_of(plan.case, part), versions(part))
    points = _Points(plan, part, stored, again=again)
    todo = points.missing()
    # points of the same inputs are one; refused ones have none
    timing = Timing(0, 0.0, 0.0, 0, len(points.inputs) - len(todo))
    if todo:
        if not where.scheduler:  # its workers say themselves what they lack
            require_gmsh()
        run = _Run(points, show, known=timing.known, total=len(todo))
        start = time.monotonic()
        try:
            with where.entered() as engine:
                run.work(engine, todo)
                workers = engine.workers()
        except KeyboardInterrupt:
            raise KeyboardInterrupt(f"interrupted; {run.kept()}") from None
        except GoneError as error:
            raise GoneError(f"{error}; {run.kept()}") from error
        timing = replace(
            timing, points=len(todo), wall=time.monotonic() - start, busy=run.busy,
            workers=min(workers, len(todo)),
        )  # fmt: skip
    inputs = tuple(points.inputs.get(key) for key in points.keys)
    return Solved(plan, part, inputs, points.solutions(), timing)


def versions(part: Portion) -> str:
    """The libraries that a result may depend on, with their versions."""
    return ", ".join(f"{name} {version(name)}" for name in cache.libraries_of(part.fem))


class _Points:
    """The points of a plan, each with its inputs or why it has none, and what is known of it.

    Points with the same inputs are one.
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
            # the case's own limit, asked for each time: a stored answer would outlive it
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
        """What is to be solved, numbered by the order of `names`."""
        code = code_of(self.plan.case, self.part)
        todo = []
        for n, (key, inputs) in enumerate(self.inputs.items()):
            formulas, fe = lacking(self.known.get(key))
            if formulas or fe:
                todo.append(Task(n, self.plan.case.id, self.part.name, inputs, formulas, fe, code))
        return todo

    def keep(self, tasks: Sequence[Task], answers: Sequence[Solution]) -> None:
        """Store what has been solved."""
        keys = self.names
        found = {
            keys[task.number]: joined(self.known.get(keys[task.number]), answer)
            for task, answer in zip(tasks, answers, strict=True)
        }
        self.stored.keep(found)
        self.known |= found

    def solutions(self) -> tuple[Solution, ...]:
        """One for each point of the plan."""
        return tuple(
            Solution({}, (), {}, {}, problem_fe=f"refused: {self.refused[n]}")
            if n in self.refused
            else self.known[key]
            for n, key in enumerate(self.keys)
        )


def _without_problems(one: Solution) -> Solution:
    return replace(one, problem_formulas="", problem_fe="")


@dataclass
class _Run:
    """One round of work: what was done, how long points take, and how many go together."""

    points: _Points
    show: Show
    known: int
    done: int = 0
    total: int = 0
    busy: float = 0.0
    pace: float = 0.0  # s a point of the last batch: the first ones import what they need
    workers: int = 1
    waiting: deque[Task] = field(default_factory=deque)

    def work(self, engine: Engine, todo: Sequence[Task]) -> None:
        """Solve all; GoneError where the engine's processes cannot, as with other code."""
        self.waiting.extend(todo)
        drive = Drive(engine, solve_batch, split=lambda batch: [(task,) for task in batch])
        for event in drive.answers(self._batches(engine)):
            if event is not None:
                self._keep(*event)
            self.show(self._state(drive))

    def kept(self) -> str:
        """What an interrupted round leaves, in words."""
        return (
            f"{self.done + self.known} of {self.total + self.known} points are kept: the same "
            "command goes on"
        )

    def _batches(self, engine: Engine) -> Iterator[tuple[Task, ...]]:
        while self.waiting:
            self.workers = engine.workers()
            size = self._size(self.workers)
            yield tuple(self.waiting.popleft() for _ in range(min(size, len(self.waiting))))

    def _size(self, workers: int) -> int:
        """Points that take about BATCH together; single ones until it is known, and at the end."""
        if not self.done:
            return 1
        fair = len(self.waiting) // (4 * workers)
        seconds = max(BATCH, workers / ANSWERED)
        return max(1, min(MOST, int(seconds / max(self.pace, 1e-6)), fair))

    def _keep(self, batch: tuple[Task, ...], answer: list[Solution] | Lost) -> None:
        if isinstance(answer, Lost):
            if answer.trace:  # what goes wrong in a point is told in its solution
                raise GoneError(f"the workers cannot solve points here: {answer.reason}")
            answer = [_lost(task, answer) for task in batch]
        self.points.keep(batch, answer)
        self.done += len(batch)
        busy = sum(one.seconds for one in answer)
        self.busy += busy
        self.pace = busy / len(batch)

    def _state(self, drive: Drive) -> State:
        left = (self.total - self.done) * self.pace / self.workers
        under_way = sum(len(batch) for batch, _ in drive.running.values())
        names = (f"{under_way} under way",) if under_way and self.done else ()
        return State(self.known + self.done, self.known + self.total, names, left, what="points")


def _lost(task: Task, lost: Lost) -> Solution:
    return Solution(
        {}, (), {}, {}, problem_formulas=lost.reason if task.formulas else "",
        problem_fe=lost.reason if task.fe else "",
    )  # fmt: skip
