"""Formulas that a case's levels are made with change both of its sides: it is solved with them."""

import ast
from collections.abc import Iterator
from functools import partial

import pytest

from tests.conftest import solved
from tests.verify.mutation.forked import answer
from verify.audit.mutation import resolve as anew
from verify.audit.mutation import trial
from verify.audit.mutation.baseline import Noted
from verify.audit.mutation.outcomes import By
from verify.audit.mutation.sites import Changed, mutants, source
from verify.audit.mutation.trial import Bench
from verify.audit.mutation.workload import Load
from verify.cases.registry import CASES, find


def bench_of(name: str) -> Bench:
    case = find(name, CASES)
    inputs = case.inputs()
    load = Load(case, inputs, tuple(one.result for one in solved(case, inputs)))
    return Bench(load, Noted(1.0, (), {}))


def planted(module: str, function: str, before: str, after: str) -> Changed:
    """One expression of a function in the place of another."""

    def put(node: ast.AST, _around: object) -> Iterator[ast.AST]:
        if isinstance(node, ast.expr) and ast.unparse(node) == before:
            yield ast.parse(after, mode="eval").body

    found = mutants(source(module), {"planted": put})
    return next(one for one in found if one.mutant.function == function)


INERTIA = (
    "analytic.sprag.events", "System._driven", "n_s * motion.m_g * OC_g ** 2",
    "n_s * motion.m_g * OC_g ** 2 / 2",
)  # fmt: skip
RACE = (
    "analytic.sprag.compliance",
    "Compliance.yields",
    "N * self.race_i",
    "1.1 * N * self.race_i",
)


@pytest.fixture(scope="module")
def engaged() -> Bench:
    found = bench_of("sprag-engagement")
    judged = found.load.judged()
    assert not judged.errors
    return Bench(found.load, Noted(4.0, (), judged.states))


def verdict(fault: Changed, bench: Bench) -> list[str]:
    stored, quick, slow = anew.split(fault.mutant.module, [bench])
    work = partial(trial.tried, fault, stored, [*quick, *slow])
    found = answer(work, 200.0)
    assert not found.failure
    return found.value


@pytest.mark.soak  # solves an engagement anew for as long as all other tests of the file
def test_a_race_that_gives_way_more_on_both_sides_is_not_credited_to_rows(engaged):
    assert verdict(planted(*RACE), engaged) == [By.NOTHING, ""]


def test_half_the_inertia_is_red_in_the_levels_that_alone_know_of_it(engaged):
    fault = planted(*INERTIA)
    by, what = verdict(fault, engaged)
    assert by == By.ROWS
    assert what.startswith("sprag-engagement/")


def test_a_mutant_is_judged_on_stored_levels_or_on_levels_solved_with_it(engaged):
    """On those of a case that takes long it is not judged at all."""
    quick = bench_of("rotor-clutch")
    both = [engaged, quick]
    assert anew.split("analytic.polyhedral.wedging", [engaged]) == ([engaged], [], [])
    assert anew.split("analytic.contact.palmgren", both) == ([], [quick], [engaged])
    assert anew.split("analytic.sprag.events", both) == ([quick], [], [engaged])
    case = find("spring-width", CASES)
    assert "analytic.spring.frame" in anew.formulas_in(case)
    bench = Bench(Load(case, case.inputs(), ()), Noted(1.0, (), {}))
    assert anew.split("analytic.spring.frame", [bench]) == ([], [], [])
    assert all(anew.formulas_in(find(name, CASES)) for name in anew.SOLVED)
