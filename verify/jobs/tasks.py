"""Tasks of an engine: solving a level, and judging a case after its levels are stored."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from verify.core import source_memory
from verify.core.case import Case
from verify.core.inputs import Inputs
from verify.core.results import CaseResult
from verify.jobs import cache
from verify.jobs.level import Job, Solved, judge_case, solve_level


@dataclass(frozen=True)
class Task:
    """Task to solve one level of the job with the number `job`.

    Another process finds the case by its name.
    """

    case: Case
    inputs: Inputs
    level: int
    folder: Path | None
    job: int = 0

    def __reduce__(self) -> tuple[Any, ...]:
        rest = self.inputs, self.level, self.folder, self.job
        return named, (Task, Case.finder, self.case.id, *rest)

    def __str__(self) -> str:
        return f"{self.case.id} level {self.level}"


@dataclass(frozen=True)
class Judging:
    """Task to judge the job with the number `job`, after its levels are solved.

    `levels` contains no results; these are read from the store in `folder`.
    """

    case: Case
    inputs: Inputs
    folder: Path
    job: int
    levels: tuple[tuple[int, Solved], ...]

    def __reduce__(self) -> tuple[Any, ...]:
        rest = self.inputs, self.folder, self.job, self.levels
        return named, (Judging, Case.finder, self.case.id, *rest)

    def __str__(self) -> str:
        return f"{self.case.id} rows"


def named(kind: Callable[..., Any], find: Callable[[str], Case], case_id: str, *rest: Any) -> Any:
    """Task for the case with this id; each process finds the case, as functions are not pickled."""
    return kind(find(case_id), *rest)


def load(case_ids: Sequence[str]) -> None:
    """Import cases with all modules that their references require."""
    for one in case_ids:
        Case.finder(one)


def do(task: Task | Judging) -> Solved | CaseResult | None:
    """Solve the level or judge the case of a task; works in any process."""
    if task.folder is not None:
        source_memory.use(task.folder)
    if isinstance(task, Judging):
        return _judge(task)
    return solve_level(task.case, task.inputs, task.level, task.folder)


def _judge(task: Judging) -> CaseResult | None:
    """The judged case; None if a level is missing in the store."""
    levels = []
    for level, solved in task.levels:
        found = cache.load(task.folder, task.case, task.inputs, level)
        if found is None and not solved.failure:
            return None
        levels.append(solved if solved.failure else replace(solved, result=found))
    return judge_case(Job(task.case, task.inputs), levels)
