"""Study of error budgets: all reruns of the cases are solved together, and each is stored."""

from collections import deque
from collections.abc import Sequence
from functools import cache as memoised

from verify.core.case import Case
from verify.core.environment import require_gmsh
from verify.core.progress import Show, shown
from verify.core.store import Store
from verify.jobs import cache
from verify.jobs.dispatch import Dispatch, queue
from verify.jobs.engine import GoneError
from verify.jobs.executor import Lost, Where
from verify.judging.budget_statement import Statement
from verify.studies.budget import store as kept
from verify.studies.budget.corrected import budgets
from verify.studies.budget.found import RowBudget, Solutions
from verify.studies.budget.plan import LOOSE, TIGHT, Plan, Step, first, rows, together
from verify.studies.budget.solve import Solution, solved
from verify.studies.study import Study

NAME = "budget"
MOST_ROUNDS = 2  # of further steps of a case


@memoised
def plan_of(case_id: str) -> Plan:
    """Plan of the runs that the budgets of a case require.

    Raises ValueError for an unknown case.
    """
    from verify.cases.budgets import STATEMENTS
    from verify.cases.registry import CASES, find  # a spawned process knows no cases yet

    case = find(case_id, CASES)
    return Plan(case, STATEMENTS.get(case_id, Statement()), rows(case))


def with_rows() -> list[Case]:
    """Cases that have rows with a budget."""
    from verify.cases.registry import CASES

    return [case for case in CASES if rows(case)]


def measure(cases: Sequence[Case], where: Where, _again: bool) -> bool:
    """Solve and store the reruns for the budgets of `cases`; False if a rerun failed.

    An interrupted run is continued by the same command. Raises OSError if records cannot be stored.
    """
    if not where.scheduler:
        require_gmsh()
    Store(cache.default_folder()).check()
    with shown(quiet=False) as show:
        run = _Run([plan_of(case.id) for case in cases], show)
        run.solve(where)
    return run.is_solved


class _Run:
    """Reruns of all plans. The budgets of a case are stored as soon as its reruns are solved."""

    def __init__(self, plans: Sequence[Plan], show: Show) -> None:
        self.solutions: dict[Step, Solution] = {}
        self.is_solved = True
        self.lost: list[Step] = []
        self.rounds = {plan.case.id: 0 for plan in plans}
        self.open = {plan.case.id: set(first(plan)) for plan in plans}
        self.waiting = deque(step for plan in plans for step in first(plan))
        self.dispatch = Dispatch(
            "reruns", len(self.waiting), show=show, title=lambda step: step.title
        )

    def solve(self, where: Where) -> None:
        """Solve all reruns, including those that the results of other reruns require."""
        self.dispatch.run(
            where.entered(), solve_step,
            queue(self.waiting), self._receive,
        )  # fmt: skip

    def _receive(self, step: Step, answer: Solution | Lost) -> int:
        if isinstance(answer, Lost):
            if answer.trace:  # errors of a rerun are stated in its solution
                raise GoneError(f"the workers cannot solve the reruns: {answer.reason}")
            self.lost.append(step)
            answer = Solution({}, {}, {}, 0.0, 0.0, answer.reason)
        self.dispatch.unstored += bool(answer.problem)
        self.solutions[step] = answer
        left = self.open[step.case]
        left.discard(step)
        if not left:
            self._continue(plan_of(step.case))
        return 1

    def _continue(self, plan: Plan) -> None:
        """Add further reruns of a case, at most twice, or store its budgets."""
        case = plan.case.id
        more = self._more(plan) if self.rounds[case] < MOST_ROUNDS else set()
        self.rounds[case] += 1
        if not more:
            self._finish(plan)
            return
        self.open[case] = more
        self.waiting += sorted(more, key=lambda step: step.title)
        self.dispatch.total += len(more)

    def _more(self, plan: Plan) -> set[Step]:
        """Further reruns that the results require.

        These are a rerun with looser tolerances, if the one with tighter tolerances failed, and
        reruns that remove pairs of large causes.
        """
        mine = self.of(plan)
        level = plan.case.levels[0]
        tight = mine.get(Step(plan.case.id, (TIGHT,), level))
        further = [Step(plan.case.id, (LOOSE,), level)] if tight and tight.problem else []
        known = budgets(plan, mine)
        large = [[n for n in one.balance.large if n in plan.reruns] for one in known]
        further += together(plan, large)
        return {step for step in further if step not in mine}

    def _finish(self, plan: Plan) -> None:
        mine = self.of(plan)
        found = budgets(plan, mine)
        spent = sum(one.seconds for one in mine.values())
        if lost := sum(step.case == plan.case.id for step in self.lost):
            print(f"{NAME}:{plan.case.id}: not stored: {lost} reruns were not completed")
        else:
            kept.keep(plan, found, spent)
        bad = {step.title: one.problem for step, one in mine.items() if one.problem}
        print(f"{NAME}:{plan.case.id}: {summary(found)}, {len(mine)} solutions of {spent:.0f} s")
        for title, problem in bad.items():
            print(f"{NAME}:{plan.case.id}: not solved: {title}: {problem}")
        self.is_solved &= not any(LOOSE in title or TIGHT not in title for title in bad)

    def of(self, plan: Plan) -> Solutions:
        """Solutions of the reruns of one case."""
        return {step: one for step, one in self.solutions.items() if step.case == plan.case.id}


def solve_step(step: Step) -> Solution:
    """Read the solution of a rerun from the default cache, or compute it; works in any process."""
    return solved(plan_of(step.case), step, cache.default_folder())


def summary(found: Sequence[RowBudget]) -> str:
    """Number of rows with a budget and the largest remainder, as text."""
    if not found:
        return "no row"
    worst = max(found, key=lambda one: abs(one.balance.remainder))
    return (
        f"{len(found)} rows, largest remainder {worst.balance.remainder:+.2g} of "
        f"{worst.balance.total:+.2g} ({worst.pair.name})"
    )


BUDGET = Study(
    name=NAME,
    cases=with_rows,
    is_measured=lambda case: kept.measured(plan_of(case.id)) is not None,
    measure=measure,
)
