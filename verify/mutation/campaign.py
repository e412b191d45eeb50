"""Tries a group's mutants: judged anew first, then the tests; every outcome is kept at once."""

import time
from collections import deque
from dataclasses import dataclass, field
from functools import partial

from verify.mutation import trial
from verify.mutation.forked import LATE, Answer, Task, answers
from verify.mutation.groups import Group
from verify.mutation.outcomes import By, Outcome, Store
from verify.progress import Show, State

TESTS = 200.0  # s for the tests of one mutant, which took AT_MOST unchanged
EXPECTED = 4.0  # s for a mutant before anything is known


@dataclass
class Campaign:
    """One group under way; `tests` are still to run for those that no row noticed."""

    group: Group
    store: Store
    jobs: int
    show: Show = lambda _state: None
    waiting: deque[Task] = field(default_factory=deque)
    spent: dict[str, float] = field(default_factory=dict)
    tested: set[str] = field(default_factory=set)

    def run(self) -> None:
        """Try every chosen mutant that has no outcome yet."""
        self.mutants = {one.mutant.id: one for one in self.group.chosen}
        missing = [key for key in self.mutants if key not in self.store.found]
        self.waiting += [self.group.trial(self.mutants[key]) for key in missing]
        self.start, self.total, self.done = time.monotonic(), len(missing), 0
        self._tell("")
        for answer in answers(self.waiting, self.jobs):
            key = str(answer.key)
            self.spent[key] = self.spent.get(key, 0.0) + answer.seconds
            if (outcome := self._outcome(key, answer)) is not None:
                self.store.add(outcome)
                self.done += 1
            self._tell(key)

    def _outcome(self, key: str, answer: Answer) -> Outcome | None:
        """The mutant's fate; None where tests are still to come."""
        if answer.failure:
            by = By.TIME if answer.failure == LATE else By.CRASHED
            what = answer.failure
        else:
            by, what = By(answer.value[0]), str(answer.value[1])
        is_first = key not in self.tested
        if by is By.NOTHING and is_first and (tests := self.group.tests(self.mutants[key])):
            self.tested.add(key)
            work = partial(trial.tested, self.mutants[key], tests)
            self.waiting.appendleft(Task(key, work, TESTS))
            return None
        if not is_first and by is By.TIME:
            by, what = By.TESTS, "tests that do not end"
        return Outcome(key, by, what, round(self.spent[key], 1))

    def _tell(self, key: str) -> None:
        elapsed = time.monotonic() - self.start
        each = elapsed / self.done if self.done > 5 else EXPECTED / self.jobs
        left = each * (self.total - self.done)
        self.show(State(self.done, self.total, (key,), left, what=f"mutants of {self.group.name}"))
