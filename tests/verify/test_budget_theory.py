"""Contributions of real rows against predictions of theory."""

import pytest

from analytic.polyhedral.expansion import many_corners_factor
from analytic.spring import frame
from verify.cases.polyhedral import budget as polyhedral_budget
from verify.cases.polyhedral.ring.case import RING
from verify.cases.spring.inputs import strip_of
from verify.studies.budget.compared import values
from verify.studies.budget.measuring import plan_of
from verify.studies.budget.plan import AS_IT_IS, Step
from verify.studies.budget.solve import solved


def error(case, causes, level, row):
    """The error of a row with causes removed, by their words, from a solution made here."""
    plan = plan_of(case)
    names = tuple(name for name in plan.reruns if plan.reruns[name].what in causes)
    assert len(names) == len(causes)
    step = Step(case, names or (AS_IT_IS,), level)
    found = solved(plan, step, None)
    assert not found.problem
    pair = next(pair for pair in plan.rows if pair.name == row)
    return values(pair, plan.case.inputs(), found).error


def test_a_wide_strip_is_stiffer_by_one_over_one_minus_nu_squared():
    row = "stiffness, thin frame, plane stress"
    narrow = error("spring-continuum", (), 4, row)
    wide = error("spring-continuum", ("plane strain instead of plane stress",), 4, row)
    # k/k_FE with k_FE (1 - nu^2) in place of k_FE, but for shear, 1.7e-4 of it, that keeps its G
    assert narrow - wide == pytest.approx(0.3**2 * (1 + narrow), abs=2e-5)


def test_shear_and_stretching_of_the_strip_are_those_of_the_force_method():
    row, case = "stiffness by Eqs. 1-9 against curved beam elements", "spring-accordion"
    q = plan_of(case).case.inputs()
    k_1 = plan_of(case).case.analytic(q)["k1"]
    k = {theory: frame.stiffness(**q.paper_path, **strip_of(q), theory=theory)
         for theory in ("bending", "thin", "shear")}  # fmt: skip
    as_it_is = error(case, (), 8, row)
    shear = as_it_is - error(case, ("no shear of the strip",), 8, row)
    stretch = as_it_is - error(case, ("no stretching of the strip",), 8, row)
    assert shear == pytest.approx(k_1 / k["shear"] - k_1 / k["thin"], rel=1e-4)
    assert stretch == pytest.approx(k_1 / k["thin"] - k_1 / k["bending"], rel=1e-3)
    both = ("no shear of the strip", "no stretching of the strip")
    assert error(case, both, 8, row) == pytest.approx(0.0, abs=1e-7)  # nothing else is neglected


def test_loads_spread_over_a_race_explain_all_of_eq_6_as_the_fourier_ring_has_it():
    row, case = (
        "deflection by Eq. 6, compared with the displacement under a sprag",
        "ring-loads-outer",
    )
    plan = plan_of(case)
    v = plan.case.analytic(plan.case.inputs())
    as_it_is = error(case, (), 8, row)
    spread = error(case, ("in addition, the first harmonic is omitted: uniform pressure",), 8, row)
    assert as_it_is - spread == pytest.approx(v["smeared"] / v["load"] - 1, abs=1e-5)
    assert spread == pytest.approx(0.0, abs=1e-5)


def test_without_corners_k_is_that_of_a_round_bore():
    q = RING.inputs()
    K = polyhedral_budget.fem_round(q, 2).values["K_mid"]
    many = float(many_corners_factor(d_i=q.d_i, d_e=q.d_e))
    assert pytest.approx(many, rel=1e-5) == K
    assert polyhedral_budget.fem_thin_round(q, 2).values["K_mid"] - 1 < (K - 1) / 50
