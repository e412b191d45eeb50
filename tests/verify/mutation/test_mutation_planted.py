"""Faults of three depths, each caught and named by a row that is about it."""

from functools import partial

import pytest

from tests.conftest import solved
from tests.verify.mutation.forked import answer
from verify.audit.mutation import trial
from verify.audit.mutation.baseline import Noted
from verify.audit.mutation.outcomes import By
from verify.audit.mutation.sites import mutants, source
from verify.audit.mutation.subject_operators import FINITE_ELEMENTS, FORMULAS
from verify.audit.mutation.trial import Bench
from verify.audit.mutation.workload import Load
from verify.cases.ring.lame.case import LAME


@pytest.fixture(scope="module")
def bench() -> Bench:
    inputs = LAME.inputs()
    load = Load(LAME, inputs, tuple(one.result for one in solved(LAME, inputs))).with_values()
    judged = load.judged()
    assert not judged.errors
    return Bench(load, Noted(1.0, (), judged.states))


def planted(module, operators, function, before, becomes):
    of = source(module)
    return next(
        one for one in mutants(of, operators)
        if one.mutant.function == function
        and (one.mutant.before, one.mutant.after) == (before, becomes)
    )  # fmt: skip


def verdict(work):
    found = answer(work, 120.0)
    assert not found.failure
    return found.value


def test_a_formula_with_the_other_radius_is_named_by_the_rows_it_feeds(bench):
    fault = planted("analytic.ring.lame", FORMULAS, "_constants", "r_o ** 2", "r_o")
    load = Load(LAME, bench.load.inputs, bench.load.levels)  # the formulas' values made anew
    by, what = verdict(partial(trial.tried, fault, [Bench(load, bench.before)]))
    assert by == By.ROWS
    assert what.startswith("ring-lame/")
    assert "stress" in what


def test_a_weak_form_with_a_sign_mistaken_is_named_by_what_it_strains(bench):
    fault = planted(
        "fem.plane.cells", FINITE_ELEMENTS, "Cells._stiffness",
        "lam * M[:, :, i, :, j] + mu * M[:, :, j, :, i]",
        "lam * M[:, :, i, :, j] - mu * M[:, :, j, :, i]",
    )  # fmt: skip
    by, what = verdict(partial(trial.solved, fault, [(bench, LAME.levels[:1])]))
    assert by == By.ROWS
    assert what.startswith("ring-lame/")
    assert "displacement" in what or "stress" in what


def test_code_that_stays_as_it_is_turns_no_row_red(bench):
    assert verdict(lambda: trial.told(bench.judged(), bench)) is None
    fault = planted("fem.plane.cells", FINITE_ELEMENTS, "Cells.strain_energy", "2", "3")
    unused = Bench(bench.load, bench.before)
    assert verdict(partial(trial.tried, fault, [unused])) == [By.NOTHING, ""]  # it calls none of it
