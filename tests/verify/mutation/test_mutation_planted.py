"""A fault of a weak form is named by its rows; only levels that depend on it are solved."""

import ast
from functools import partial

from tests.conftest import solved
from tests.verify.mutation.forked import answer
from verify.audit.mutation import resolve, trial
from verify.audit.mutation.baseline import Noted
from verify.audit.mutation.outcomes import By
from verify.audit.mutation.sites import mutants, source
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


def test_a_modulus_with_a_wrong_factor_is_named_by_what_it_strains():
    term = "self.E / ({} * (1 + self.nu))"

    def put(node, _around):
        if isinstance(node, ast.expr) and ast.unparse(node) == term.format("2"):
            yield ast.parse(term.format("2.1"), mode="eval").body

    (fault,) = (
        one for one in mutants(source("fem.plane.material"), {"planted": put})
        if one.mutant.function == "Elastic.lame_constants"
    )  # fmt: skip
    ring = bench_of("ring-lame", 1.0)
    found = answer(partial(trial.solved, fault, [(ring, ring.load.case.levels[:1])]), 200.0)
    assert not found.failure
    by, what = found.value
    assert by == By.ROWS
    assert "displacement" in what or "stress" in what


def test_a_mutant_is_judged_on_stored_levels_or_on_levels_solved_with_it():
    """On those of a case that takes long it is not judged at all."""
    engaged, quick = bench_of("sprag-engagement", 4.0), bench_of("rotor-clutch", 1.0)
    both = [engaged, quick]
    assert resolve.split("analytic.polyhedral.wedging", [engaged]) == ([engaged], [], [])
    assert resolve.split("analytic.contact.palmgren", both) == ([], [quick], [engaged])
    assert resolve.split("analytic.sprag.events", both) == ([quick], [], [engaged])
    case = find("spring-width", CASES)
    assert "analytic.spring.frame" in resolve.formulas_in(case)
    bench = Bench(Load(case, case.inputs(), ()), Noted(1.0, (), {}))
    assert resolve.split("analytic.spring.frame", [bench]) == ([], [], [])
