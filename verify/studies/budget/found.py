"""Budgets of the rows of a case, computed from its solutions."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations

from verify.judging.budget_statement import Cause, Rerun
from verify.studies.budget import balance as sums
from verify.studies.budget.balance import Balance, Joint, Part
from verify.studies.budget.compared import NONE, Values, values
from verify.studies.budget.plan import AS_IT_IS, FINER, LOOSE, TIGHT, Plan, Step, inputs_of, joint
from verify.studies.budget.solve import Solution
from verify.studies.sweep.pairs import Pair

Solutions = Mapping[Step, Solution]
RICHARDSON = "Richardson from the three finest meshes"
DIRECT = "no solver tolerance to change; u_it of the row is used"


@dataclass(frozen=True)
class RowBudget:
    """Budget of one row; `joints` contains the joint effects of pairs of large causes."""

    pair: Pair
    balance: Balance
    joints: tuple[Joint, ...] = ()


def budgets(plan: Plan, solutions: Solutions) -> tuple[RowBudget, ...]:
    """Budgets of all rows that have values of formula and finite elements on the finest mesh."""
    reader = _Reader(plan, solutions)
    found = []
    for pair in plan.rows:
        total = reader.at(pair, (AS_IT_IS,), plan.case.levels[-1])
        if math.isfinite(total):
            known = sums.balance(total, reader.parts(pair))
            found.append(RowBudget(pair, known, reader.joints(pair, known)))
    return tuple(found)


@dataclass(frozen=True)
class _Reader:
    plan: Plan
    solutions: Solutions

    def at(self, pair: Pair, causes: tuple[str, ...], level: int) -> float:
        """Error of the row with `causes` removed; NaN if this was not solved."""
        return self.values(pair, causes, level).error

    def values(self, pair: Pair, causes: tuple[str, ...], level: int) -> Values:
        """Compared values of the row with `causes` removed."""
        step = Step(self.plan.case.id, causes, level)
        found = self.solutions.get(step)
        return values(pair, inputs_of(self.plan, step), found) if found else NONE

    def why(self, causes: tuple[str, ...], level: int) -> str:
        """Reason why the value with `causes` removed does not exist."""
        found = self.solutions.get(Step(self.plan.case.id, causes, level))
        return (
            "the rerun was not solved"
            if found is None
            else found.problem or "the row has no value without this cause"
        )

    def parts(self, pair: Pair) -> list[Part]:
        found = [self.discretisation(pair), self.iteration(pair)]
        for name, rerun in self.plan.reruns.items():
            if rerun.about(pair.name):
                found.append(self.part(pair, name, rerun))
        found += [Part(f"{one.cause}: {one.why}", None, None, note=one.why)
                  for one in self.plan.without]  # fmt: skip
        order = {cause: n for n, cause in enumerate(Cause)}
        return sorted(found, key=lambda part: order[Cause(part.name.partition(": ")[0])])

    def part(self, pair: Pair, name: str, rerun: Rerun) -> Part:
        levels = self.plan.levels(rerun)
        before = self.plan.before(rerun)
        errors = [(self.at(pair, before, k), self.at(pair, (name,), k)) for k in levels]
        finest = self.at(pair, (AS_IT_IS,), self.plan.case.levels[-1])
        found = sums.removed(name, errors, finest=finest, shared=rerun.shared)
        if found.contribution is None:
            known = zip(levels, errors, strict=True)
            bad = next(k for k, pair_ in known if not all(map(math.isfinite, pair_)))
            return Part(name, None, None, rerun.shared, self.why((name,), bad))
        return found

    def discretisation(self, pair: Pair) -> Part:
        levels, finer = self.plan.case.levels, self.plan.statement.finer
        mine = [self.values(pair, (AS_IT_IS,), k) for k in levels]
        h = [self.solutions[Step(self.plan.case.id, (AS_IT_IS,), k)].h for k in levels]
        order = sums.observed(h, [v.fe for v in mine], pair.claim.formal, mine[-1].scale)
        beyond = self.solutions.get(Step(self.plan.case.id, (FINER,), finer))
        if beyond is None or beyond.problem:
            reason = f" (no finer one: {beyond.problem})" if beyond else ""
            name = f"{Cause.DISCRETISATION}: {RICHARDSON}{reason}"
            return sums.extrapolated(name, [v.error for v in mine], h, order)
        name = f"{Cause.DISCRETISATION}: level {finer} after {levels[-1]}"
        there = self.at(pair, (FINER,), finer)
        return sums.finer(name, mine[-1].error, there, (h[-1], beyond.h), order)

    def iteration(self, pair: Pair) -> Part:
        case = self.plan.case
        level = case.levels[0]
        start = self.at(pair, (AS_IT_IS,), level)
        for name in (TIGHT, LOOSE):
            change = start - self.at(pair, (name,), level)
            if math.isfinite(change):
                return Part(f"{Cause.ITERATION}: {name}", change, abs(change))
        tried = self.solutions.get(Step(case.id, (LOOSE,), level))
        note = f"neither tighter nor looser tolerances: {tried.problem}" if tried else DIRECT
        rest = self.values(pair, (AS_IT_IS,), case.levels[-1])
        u = rest.u_it / rest.scale if rest.scale else 0.0
        return Part(f"{Cause.ITERATION}: {note}", 0.0, u, note=note)

    def joints(self, pair: Pair, known: Balance) -> tuple[Joint, ...]:
        """Joint effects of all pairs of large causes."""
        reruns = self.plan.reruns
        names = [name for name in known.large if name in reruns and not reruns[name].after]
        return tuple(self._joint(pair, both) for both in combinations(names, 2))

    def _joint(self, pair: Pair, names: tuple[str, str]) -> Joint:
        step = joint(self.plan, names)
        if step is None:
            return Joint(names, None, "both have separate finite elements")
        there = self.at(pair, step.causes, step.level)
        nominal, a, b = (
            self.at(pair, causes, step.level) for causes in ((AS_IT_IS,), names[:1], names[1:])
        )
        value = (nominal - there) - (nominal - a) - (nominal - b)
        if not math.isfinite(value):
            return Joint(names, None, self.why(step.causes, step.level))
        return Joint(names, value)
