"""Springs by formulas and by shells: limits of the strip, widths, and what is left to a tip."""

import pytest

from tests.verify.cases.own import own
from tests.verify.cases.rows import context
from verify.cases.spring.stages.case import STAGES
from verify.cases.spring.width import claims
from verify.cases.spring.width.case import WIDTH, WideSpring
from verify.cases.spring.width.reference import fem_spring
from verify.judging.judge import fit_limit


@pytest.mark.parametrize(
    "change",
    [
        {"alpha": "90 deg", "nu": 0.45},
        {"b": "0.44 mm", "h": "0.1 mm"},
        {"h": "10000 mm", "head": "hinged"},
        {"E": "0.01 GPa", "nu": 0.0},
    ],
)
def test_a_spring_is_between_plane_stress_and_plane_strain(change):
    q = own(WIDTH, **change)
    v = WIDTH.analytic(q)
    assert 1 - 1e-12 <= v["f"] <= q.widest * (1 + 1e-12)
    assert v["k_narrow"] * (1 - 1e-12) <= v["k"] <= v["k_wide"] * (1 + 1e-3)


def test_a_force_leaves_room_until_a_tip_touches_and_presses_less_beyond():
    values = STAGES.analytic(own(STAGES, F="5 N"))
    assert values["U_w"] == pytest.approx(5 / values["k1"], rel=1e-12)
    assert values["margin"] == pytest.approx(values["U_A"] - values["U_w"])
    beyond = STAGES.analytic(own(STAGES, F="10 N"))
    assert beyond["margin"] < 0
    after = beyond["U_A"] + (10 - beyond["F_A"]) / beyond["k2"]
    assert beyond["U_w"] == pytest.approx(after, rel=1e-12)


def test_a_uniform_force_on_a_free_head_is_a_little_softer_than_a_straight_edge():
    """The force bends the edge; of a short spring the most."""
    q = WideSpring(n=4)
    straight = fem_spring(q, q.h, 2, "arc", "free")
    force = fem_spring(q, q.h, 2, "arc", "free", uniform=True)
    assert force < straight
    assert force == pytest.approx(straight, rel=2e-4)


def test_what_a_wide_spring_lacks_of_plane_strain_is_as_wide_as_its_leaves():
    fit = fit_limit(*claims.wide(context(WIDTH)))
    assert abs(fit.q - 1) < fit.U_q < 0.1
    assert abs(fit.d0) < 1e-4
