"""Faults of a formula, of a weak form and of what both sides share, each named by its rows."""

import ast
from collections.abc import Iterator
from functools import partial

import pytest

from tests.conftest import solved
from tests.verify.mutation.forked import answer
from verify.audit.mutation import resolve, trial
from verify.audit.mutation.baseline import Noted
from verify.audit.mutation.outcomes import By
from verify.audit.mutation.sites import Changed, mutants, source
from verify.audit.mutation.trial import Bench
from verify.audit.mutation.workload import Load
from verify.cases.registry import CASES, find


def bench_of(name: str, seconds: float) -> Bench:
    case = find(name, CASES)
    inputs = case.inputs()
    load = Load(case, inputs, tuple(one.result for one in solved(case, inputs)))
    judged = load.judged()
    assert not judged.errors
    return Bench(load, Noted(seconds, (), judged.states))


@pytest.fixture(scope="module")
def ring() -> Bench:
    return bench_of("ring-lame", 1.0)


@pytest.fixture(scope="module")
def engaged() -> Bench:
    return bench_of("sprag-engagement", 4.0)


def planted(module: str, function: str, before: str, after: str) -> Changed:
    """One expression of a function in the place of another."""

    def put(node: ast.AST, _around: object) -> Iterator[ast.AST]:
        if isinstance(node, ast.expr) and ast.unparse(node) == before:
            yield ast.parse(after, mode="eval").body

    found = mutants(source(module), {"planted": put})
    return next(one for one in found if one.mutant.function == function)


def verdict(work) -> list[str]:
    found = answer(work, 200.0)
    assert not found.failure
    return found.value


def test_a_modulus_with_a_wrong_factor_is_named_by_what_it_strains(ring):
    term = "self.E / ({} * (1 + self.nu))"
    fault = planted(
        "fem.plane.material", "Elastic.lame_constants", term.format("2"), term.format("2.1")
    )
    by, what = verdict(partial(trial.solved, fault, [(ring, ring.load.case.levels[:1])]))
    assert by == By.ROWS
    assert "displacement" in what or "stress" in what


@pytest.mark.soak  # solves an engagement
@pytest.mark.parametrize(
    ("fault", "by"),
    [
        (("analytic.sprag.compliance", "Compliance.yields", "N * self.race_i",
          "1.1 * N * self.race_i"), By.NOTHING),
        (("analytic.sprag.events", "System._driven", "n_s * motion.m_g * OC_g ** 2",
          "n_s * motion.m_g * OC_g ** 2 / 2"), By.ROWS),
    ],
    ids=["of both sides", "of the levels alone"],
)  # fmt: skip
def test_a_fault_of_what_levels_are_made_with_is_judged_on_levels_solved_with_it(
    fault, by, engaged
):
    """What changes both sides alike is not credited to rows; half an inertia of one side is."""
    fault = planted(*fault)
    stored, quick, slow = resolve.split(fault.mutant.module, [engaged])
    found, what = verdict(partial(trial.tried, fault, stored, [*quick, *slow]))
    assert found == by
    assert what.startswith("sprag-engagement/" if by == By.ROWS else "")


def test_a_mutant_is_judged_on_stored_levels_or_on_levels_solved_with_it(engaged):
    """On those of a case that takes long it is not judged at all."""
    quick = bench_of("rotor-clutch", 1.0)
    both = [engaged, quick]
    assert resolve.split("analytic.polyhedral.wedging", [engaged]) == ([engaged], [], [])
    assert resolve.split("analytic.contact.palmgren", both) == ([], [quick], [engaged])
    assert resolve.split("analytic.sprag.events", both) == ([quick], [], [engaged])
    case = find("spring-width", CASES)
    assert "analytic.spring.frame" in resolve.formulas_in(case)
    bench = Bench(Load(case, case.inputs(), ()), Noted(1.0, (), {}))
    assert resolve.split("analytic.spring.frame", [bench]) == ([], [], [])
