"""All reruns for the budgets of a case: unchanged, finer, and with single causes removed."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import Any

from verify.core.case import Case
from verify.judging.budget_statement import Cause, Rerun, Statement, Without
from verify.judging.claims import FemClaim
from verify.studies.budget.generic import LOOSER, TIGHTER, contact, tolerances, without
from verify.studies.sweep.pairs import Pair

AS_IT_IS, FINER = "as it is", "a finer mesh"
TIGHT, LOOSE = "tolerances / 100", "tolerances x 100"
AND = " and "


@dataclass(frozen=True)
class Plan:
    """A case, its statements on the budget, and its rows with a budget."""

    case: Case
    statement: Statement
    rows: tuple[Pair, ...]

    @cached_property
    def reruns(self) -> Mapping[str, Rerun]:
        """Reruns that remove one cause each (name of the cause: rerun)."""
        own = self.statement.reruns
        causes = {*(rerun.cause for rerun in own), *(one.cause for one in self.statement.without)}
        levels = next((rerun.levels for rerun in own), ())  # the same levels as the other reruns
        generic = () if Cause.CONTACT in causes else contact(self.case, levels)
        return {rerun.name: rerun for rerun in (*generic, *own)}

    @property
    def without(self) -> tuple[Without, ...]:
        """Causes that do not exist in the case, as stated by the case or in general."""
        own = {one.cause: one for one in self.statement.without}
        stated = {rerun.cause for rerun in self.reruns.values()}
        every = {one.cause: one for one in without(self.case)} | own
        return tuple(every[cause] for cause in Cause if cause in every and cause not in stated)

    def before(self, rerun: Rerun) -> tuple[str, ...]:
        """Causes removed in the run with which `rerun` is compared; AS_IT_IS if none.

        Raises StopIteration if no rerun has the name in `rerun.after`.
        """
        if not rerun.after:
            return (AS_IT_IS,)
        return (next(name for name, one in self.reruns.items() if one.what == rerun.after),)

    def levels(self, rerun: Rerun) -> tuple[int, ...]:
        """Levels (mesh numbers) on which a rerun is solved, from coarse to fine."""
        return rerun.levels or self.case.levels[:2]


@dataclass(frozen=True)
class Step:
    """One solution on the mesh `level` with `causes` removed, which are names of reruns."""

    case: str
    causes: tuple[str, ...]
    level: int

    @property
    def title(self) -> str:
        """Name of the rerun in progress lines and reasons."""
        return f"{self.case} level {self.level}, {AND.join(self.causes)}"


def rows(case: Case) -> tuple[Pair, ...]:
    """Rows that compare a value of the formulas with a value of finite elements."""
    return tuple(
        Pair(
            name=claim.name, symbol=claim.symbol, unit=claim.unit, kind=claim.kind,
            analytic=claim.analytic, fem=claim.fem, scale=claim.scale, by=claim.by, claim=claim,
        )
        for claim in case.checks if isinstance(claim, FemClaim) and hasattr(claim, "analytic")
    )  # fmt: skip


def first(plan: Plan) -> tuple[Step, ...]:
    """Reruns of the first round: unchanged, finer mesh, tighter tolerances, one cause removed."""
    case = plan.case
    found = [Step(case.id, (AS_IT_IS,), level) for level in case.levels]
    if plan.statement.finer:
        found.append(Step(case.id, (FINER,), plan.statement.finer))
    if tolerances(case, TIGHTER):
        found.append(Step(case.id, (TIGHT,), case.levels[0]))
    for name, rerun in plan.reruns.items():
        for level in plan.levels(rerun):
            found += [Step(case.id, (name,), level), Step(case.id, plan.before(rerun), level)]
    return tuple(dict.fromkeys(found))


def together(plan: Plan, large: Sequence[Sequence[str]]) -> tuple[Step, ...]:
    """Reruns that remove two causes together, for each pair of causes that are large for a row.

    They are solved on the finest mesh that both causes use. On this mesh, the unchanged run and the
    reruns that remove one cause are included.
    """
    pairs = dict.fromkeys(pair for names in large for pair in combinations(names, 2))
    found = [step for pair in pairs if (step := joint(plan, pair)) is not None]
    beside = [
        Step(plan.case.id, causes, step.level)
        for step in found for causes in ((AS_IT_IS,), *((name,) for name in step.causes))
    ]  # fmt: skip
    return tuple(dict.fromkeys((*found, *beside)))


def joint(plan: Plan, pair: tuple[str, str]) -> Step | None:
    """Rerun with both causes of a pair removed; None if they cannot be removed together.

    They cannot be removed together if both reruns have separate finite elements, or if one of the
    causes can only be removed after another cause.
    """
    both = [plan.reruns[name] for name in pair]
    if all(rerun.fem is not None for rerun in both) or any(rerun.after for rerun in both):
        return None
    level = min(plan.levels(rerun)[-1] for rerun in both)
    return Step(plan.case.id, pair, level)


def inputs_of(plan: Plan, step: Step) -> Any:
    """Inputs of a rerun; the changes for several causes are applied in order.

    Raises ValueError if the changed inputs are invalid.
    """
    found = plan.case.inputs()
    for name in step.causes:
        if name in plan.reruns:
            found = plan.reruns[name].inputs(found)
            found = type(found).model_validate(found.model_dump())  # by the rules of the inputs
    return found


def tolerance_factor(step: Step) -> float:
    """Factor of the solver tolerances in a rerun; 1 by default."""
    return {TIGHT: TIGHTER, LOOSE: LOOSER}.get(step.causes[0], 1.0)
