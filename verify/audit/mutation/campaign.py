"""Check of a group's mutants by judging, tests and solving; outcomes are stored immediately."""

from collections import deque
from dataclasses import dataclass, field
from functools import partial

from verify.audit.mutation import trial
from verify.audit.mutation.groups import Group
from verify.audit.mutation.outcomes import By, Outcome, Outcomes
from verify.audit.mutation.sandbox import LATE, Answer, Task, forks, perform
from verify.core.progress import Show
from verify.jobs.dispatch import Dispatch, queue

TESTS = 200.0  # s for the tests of one mutant, which took AT_MOST unchanged
JUDGED, TESTED, SOLVED = range(3)  # stages of a mutant


@dataclass
class Campaign:
    """Check of the mutants of one group; `stages` is the present stage of undetected mutants."""

    group: Group
    outcomes: Outcomes
    jobs: int
    show: Show = lambda _state: None
    waiting: deque[Task] = field(default_factory=deque)
    spent: dict[str, float] = field(default_factory=dict)
    stages: dict[str, int] = field(default_factory=dict)

    def run(self) -> None:
        """Check every selected mutant that has no outcome yet."""
        self.mutants = {one.mutant.id: one for one in self.group.chosen}
        missing = [key for key in self.mutants if key not in self.outcomes.found]
        self.waiting += [self.group.trial(self.mutants[key]) for key in missing]
        total = len(self.mutants)
        Dispatch(
            f"mutants of {self.group.name}", total, total - len(missing), self.show,
            title=lambda task: str(task.key),
        ).run(forks(self.jobs), perform, queue(self.waiting), self._receive)  # fmt: skip

    def _receive(self, task: Task, answer: Answer) -> int:
        key = str(task.key)
        self.spent[key] = self.spent.get(key, 0.0) + answer.seconds
        if (outcome := self._outcome(key, answer)) is None:
            return 0
        self.outcomes.add(outcome)
        return 1

    def _outcome(self, key: str, answer: Answer) -> Outcome | None:
        """Outcome of a mutant; None if further checks remain."""
        if answer.failure:
            by = By.TIME if answer.failure == LATE else By.CRASHED
            what = answer.failure
        else:
            by, what = By(answer.value[0]), str(answer.value[1])
        if by is By.NOTHING and (task := self._next(key)):
            self.waiting.appendleft(task)
            return None
        if by is By.TIME and self.stages.get(key) == TESTED:
            by, what = By.TESTS, "the tests do not end"
        return Outcome(key, by, what, round(self.spent[key], 1))

    def _next(self, key: str) -> Task | None:
        """Next check of a mutant: the tests, then the cases that take a long time to solve."""
        changed = self.mutants[key]
        while (stage := self.stages.get(key, JUDGED)) < SOLVED:
            self.stages[key] = stage + 1
            if stage + 1 == SOLVED:
                return self.group.last(changed)
            if tests := self.group.tests(changed):
                return Task(key, partial(trial.tested, changed, tests), TESTS)
        return None
