"""Measure the budgets of cases: every step solved where it is said, each kept as it is there."""

import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cache as memoised

from verify.core.case import Case
from verify.core.environment import require_gmsh
from verify.core.inputs import InputError
from verify.core.progress import Show, State
from verify.core.suggestions import nearest
from verify.jobs import cache
from verify.jobs.engine import Engine, GoneError
from verify.jobs.executor import Drive, Lost, Where
from verify.judging.budget_statement import Statement
from verify.studies.budget import store as kept
from verify.studies.budget.corrected import budgets
from verify.studies.budget.found import RowBudget, Solutions
from verify.studies.budget.plan import LOOSE, TIGHT, Plan, Step, first, rows, together
from verify.studies.budget.solve import Solution, solved

NAME = "budget"


@memoised
def plan_of(case_id: str) -> Plan:
    """What the budgets of a case need; ValueError for an unknown one."""
    from verify.cases.budgets import STATEMENTS
    from verify.cases.registry import CASES, find  # a spawned process knows no cases yet

    case = find(case_id, CASES)
    return Plan(case, STATEMENTS.get(case_id, Statement()), rows(case))


def chosen(names: Sequence[str], cases: Sequence[Case]) -> list[Case]:
    """The cases with rows that "budget", all, and "budget:CASE" name; InputError."""
    found = [case for case in cases if rows(case)]
    if NAME in names:
        return found
    known = {case.id: case for case in found}
    wanted = [name.partition(":")[2] for name in dict.fromkeys(names)]
    for name in wanted:
        if name not in known:
            asked = f"{NAME}:{name}".rstrip(":")
            raise InputError(f"{asked}: no such measurement, there are {nearest(name, known)}")
    return [known[name] for name in wanted]


def measure(
    cases: Sequence[Case],
    where: Where,
    *,
    again: bool = False,
    show: Show = lambda _state: None,
) -> bool:
    """Measure what is not kept for the present code; False where a rerun failed.

    A run goes on where one was interrupted. OSError where a file cannot be written.
    """
    todo = []
    for case in cases:
        if not again and kept.measured(plan_of(case.id)) is not None:
            print(f"{NAME}:{case.id}: measured already, --again measures it anew")
        else:
            todo.append(plan_of(case.id))
    if not todo:
        return True
    if not where.scheduler:
        require_gmsh()
    run = _Run(show, {})
    try:
        with where.entered() as engine:
            return run.work(engine, todo)
    except KeyboardInterrupt:
        raise KeyboardInterrupt(f"interrupted; {run}") from None
    except GoneError as error:
        raise GoneError(f"{error}; {run}") from error


@dataclass
class _Run:
    show: Show
    solutions: dict[Step, Solution]
    total: int = 0
    seconds: float = 0.0
    start: float = field(default_factory=time.monotonic)

    def work(self, engine: Engine, plans: Sequence[Plan]) -> bool:
        """All plans, each kept as soon as its steps are there."""
        waiting = {plan.case.id: set(first(plan)) for plan in plans}
        steps = [step for plan in plans for step in first(plan)]
        rounds = {plan.case.id: 0 for plan in plans}
        good = True
        while steps:
            following: list[Step] = []
            for done in self._solve(engine, steps):
                left = waiting[done.case]
                left.discard(done)
                if left:
                    continue
                plan = plan_of(done.case)
                more = self._more(plan) if rounds[done.case] < 2 else set()
                rounds[done.case] += 1
                if more:
                    waiting[done.case] = more
                    following += more
                else:
                    good &= self._finish(plan)
            steps = following
        return good

    def _more(self, plan: Plan) -> set[Step]:
        """What the solutions so far ask for: looser tolerances, and pairs of large causes."""
        mine = self.of(plan)
        level = plan.case.levels[0]
        tight = mine.get(Step(plan.case.id, (TIGHT,), level))
        wanted = [Step(plan.case.id, (LOOSE,), level)] if tight and tight.problem else []
        known = budgets(plan, mine)
        large = [[n for n in one.balance.large if n in plan.reruns] for one in known]
        wanted += together(plan, large)
        return {step for step in wanted if step not in mine}

    def _finish(self, plan: Plan) -> bool:
        mine = self.of(plan)
        found = budgets(plan, mine)
        spent = sum(one.seconds for one in mine.values())
        kept.keep(plan, found, spent)
        bad = {step.title: one.problem for step, one in mine.items() if one.problem}
        print(f"{NAME}:{plan.case.id}: {said(found)}, {len(mine)} solutions of {spent:.0f} s")
        for title, problem in bad.items():
            print(f"{NAME}:{plan.case.id}: not solved: {title}: {problem}")
        return not any(LOOSE in title or TIGHT not in title for title in bad)

    def of(self, plan: Plan) -> Solutions:
        """The solutions of one case."""
        return {step: one for step, one in self.solutions.items() if step.case == plan.case.id}

    def _solve(self, engine: Engine, steps: Sequence[Step]) -> Iterable[Step]:
        self.total += len(steps)
        drive = Drive(engine, solve_step)
        for event in drive.answers(iter(steps)):
            if event is not None:
                step, answer = event
                if isinstance(answer, Lost):
                    answer = Solution({}, {}, {}, 0.0, 0.0, answer.reason)
                self.solutions[step] = answer
                self.seconds += answer.seconds
                yield step
            self.show(self._state(drive))

    def _state(self, drive: Drive) -> State:
        done = len(self.solutions)
        pace = (time.monotonic() - self.start) / done if done else 0.0
        running = tuple(step.title for step, _ in drive.running.values())
        return State(done, self.total, running, pace * (self.total - done), what="reruns")

    def __str__(self) -> str:
        return f"{len(self.solutions)} of {self.total} reruns are kept: the same command goes on"


def solve_step(step: Step) -> Solution:
    """The solution of a step with the usual cache, in any process."""
    return solved(plan_of(step.case), step, cache.default_folder())


def said(found: Sequence[RowBudget]) -> str:
    """How many rows have a budget, and the largest remainder."""
    if not found:
        return "no row"
    worst = max(found, key=lambda one: abs(one.balance.remainder))
    return (
        f"{len(found)} rows, largest remainder {worst.balance.remainder:+.2g} of "
        f"{worst.balance.total:+.2g} ({worst.pair.name})"
    )
