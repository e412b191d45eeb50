"""Budgets whose causes are removed one after the other leave nothing that has no name."""

from itertools import pairwise

import pytest

from analytic.polyhedral.expansion import many_corners_factor
from verify.cases.polyhedral import budget as polyhedral_budget
from verify.cases.polyhedral.ring.case import RING
from verify.cases.registry import find
from verify.cases.rotor import budget as rotor_budget
from verify.cases.sprag import budget as sprag_budget
from verify.judging.budget_statement import Cause
from verify.studies.budget.measuring import plan_of, with_rows
from verify.studies.budget.store import measured

LEFT = {  # at most, of the row: what is told of it
    ("polyhedral-ring", "K of the paper"): 1e-4,
    ("rotor-step", "beam as drawn, mode 1 backward"): 1.5e-3,
    ("sprag-optimum", "pressure at mid-length of the crown at hand at rest, by slices"): 5e-3,
    ("sprag-optimum", "largest pressure of the crown at hand at rest, by slices"): 4e-3,
}


@pytest.mark.parametrize(("case", "row"), list(LEFT))
def test_what_a_chain_leaves_is_small(case, row):
    found = measured(plan_of(case))
    if found is None:
        pytest.skip("not measured for this code")
    (known,) = [one.balance for one in found.rows if one.pair.name == row]
    assert abs(known.remainder) < LEFT[case, row] < abs(known.total) / 2


def test_a_chain_removes_what_went_before_as_well():
    q = find("rotor-step").inputs()
    low, both = rotor_budget.low_step(q), rotor_budget.low_and_slender(q)
    assert (both.d_2, both.L) == (low.d_2, rotor_budget.SLENDER * q.L)
    q = find("sprag-optimum").inputs()
    assert sprag_budget.long_uncrowned(q).l == sprag_budget.long_half_crowned(q).l == 4 * q.l
    assert polyhedral_budget.sharp(RING.inputs()).rho == RING.inputs().rho / 10


def test_every_link_of_a_chain_names_the_one_before():
    names = [rerun.what for rerun in plan_of("polyhedral-ring").reruns.values()]
    chain = [rerun for rerun in plan_of("polyhedral-ring").reruns.values() if not rerun.shared]
    assert [one.after for one in chain] == ["", *(one.what for one in chain[:-1])]
    assert all(a != b for a, b in pairwise(names))


def test_without_corners_k_is_that_of_a_round_bore():
    q = RING.inputs()
    K = polyhedral_budget.fem_round(q, 2).values["K_mid"]
    many = float(many_corners_factor(d_i=q.d_i, d_e=q.d_e))
    assert pytest.approx(many, rel=1e-5) == K
    assert polyhedral_budget.fem_thin_round(q, 2).values["K_mid"] - 1 < (K - 1) / 50


def test_every_case_says_what_its_contact_s_law_is():
    for case in with_rows():
        plan = plan_of(case.id)
        said = [*plan.reruns.values(), *plan.without]
        assert any(one.cause is Cause.CONTACT for one in said), case.id
