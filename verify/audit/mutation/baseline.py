"""Statuses, times and called functions of unchanged code, stored for the check of mutants."""

import json
import time
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from typing import Any

from verify.audit.mutation.digest import digest
from verify.audit.mutation.sandbox import Answer, Task, forks, perform
from verify.audit.mutation.tracing import called
from verify.audit.mutation.workload import Load, States
from verify.core.case import Case
from verify.core.inputs import InputError
from verify.core.progress import Show
from verify.core.store import Store
from verify.jobs import cache
from verify.jobs.dispatch import Dispatch, queue

TRACER = "verify/audit/mutation/tracing.py"
KIND = "mutant note"  # of entries: their subject is the kind of note
JUDGING = 300.0  # s for a case to be judged with every call noted
SOLVING = 400.0  # s for a case's coarsest level
TESTING = 900.0  # s for a file of tests


@dataclass(frozen=True)
class Noted:
    """Record of unchanged code: time [s], called functions, and statuses of rows."""

    seconds: float
    functions: tuple[str, ...]
    states: States


@dataclass(frozen=True)
class Notes:
    """Records of unchanged code; those missing in the store are determined when requested."""

    store: Store
    jobs: int
    show: Show

    def cases(self, loads: Sequence[Load]) -> dict[str, Noted]:
        """Records of judging (id of the case: record)."""
        code = digest("analytic", "verify")
        work = {f"{load.case.id} {code}": partial(_judge, load) for load in loads}
        found = self._noted("cases", "judging", work, JUDGING)
        return {name.partition(" ")[0]: Noted(*one) for name, one in found.items()}

    def elements(self, cases: Sequence[Case]) -> dict[str, Noted]:
        """Records of solving the coarsest level of the cases (id of the case: record)."""
        tracer = digest(TRACER)
        work = {
            f"{case.id} {cache.key(case, case.inputs(), case.levels[0])} {tracer}": partial(
                _solve, case
            )
            for case in cases
        }
        found = self._noted("elements", "solving", work, SOLVING, needed=False)
        return {name.partition(" ")[0]: Noted(*one) for name, one in found.items()}

    def tests(self, kind: str, files: Sequence[str]) -> dict[str, tuple[float, Sequence[str]]]:
        """Time [s] and called functions of every test in `files` (id of the test: record)."""
        from verify.audit.mutation import suite  # pytest, which a user's environment may not have

        tested = suite.TESTED[kind]
        work = {
            f"{path} {digest(TRACER, *tested, path)}": partial(suite.traced, path) for path in files
        }
        found = self._noted(f"tests-{kind}", "testing", work, TESTING)
        return {test: tuple(one) for tests in found.values() for test, one in tests.items()}

    def _noted(
        self, kind: str, doing: str, work: Mapping[str, Callable[[], Any]], limit: float,
        *, needed: bool = True,
    ) -> dict[str, Any]:  # fmt: skip
        """Records of one kind from the store; missing records are determined now.

        Raises InputError if a record that is `needed` cannot be determined.
        """
        stored = self.store.load(KIND, list(work))
        known = {}
        for name, content in stored.items():
            with suppress(ValueError):  # damaged: noted again
                known[name] = json.loads(content)
        missing = [name for name in work if name not in known]
        waiting = deque(Task(name, work[name], limit) for name in missing)

        def receive(task: Task, answer: Answer) -> int:
            name = str(task.key)
            if not answer.failure:
                known[name] = answer.value
                self.store.store(KIND, kind, {name: json.dumps(answer.value).encode()})
            elif needed:
                raise InputError(f"{doing} {name.partition(' ')[0]} failed: {answer.failure}")
            else:
                dispatch.unstored += 1
            return 1

        dispatch = Dispatch(
            f"records of {doing} unchanged code", len(work), len(known), self.show,
            title=lambda task: str(task.key).partition(" ")[0],
        )  # fmt: skip
        dispatch.run(forks(self.jobs), perform, queue(waiting), receive)
        return {name: known[name] for name in work if name in known}


def _judge(load: Load) -> list[Any]:
    start = time.process_time()
    judged, functions = called(load.judged)
    if judged.errors:
        raise judged.errors[0]
    return [time.process_time() - start, functions, judged.states]


def _solve(case: Case) -> list[Any]:
    start = time.process_time()
    _, functions = called(lambda: case.reference(case.inputs(), case.levels[0]))
    return [time.process_time() - start, functions, {}]
