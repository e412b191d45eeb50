"""Springs of a user's own by formulas: limits of the strip, sizes, and what is left to a tip."""

import pytest

from tests.verify.cases.own import own
from verify.cases.spring.buckling.case import BUCKLING
from verify.cases.spring.stages.case import STAGES, StageSpring
from verify.cases.spring.width.case import WIDTH


def test_a_wide_strip_is_warned_of_unless_its_width_factor_is_known():
    for factor, warned in ((None, True), (1.09, False)):
        q = StageSpring(width_factor=factor)
        said = STAGES.warnings(q, STAGES.analytic(q))
        assert any("a strip 560 times as wide as thick" in line for line in said) is warned


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


def test_the_displacement_of_buckling_scales_with_the_size_alone():
    v = BUCKLING.analytic(own(BUCKLING))
    small = own(BUCKLING, b="0.001 mm", h="0.56 mm", r="0.0045 mm", L1="0.116 mm")
    for key in ("U_cr", "column_U"):
        assert BUCKLING.analytic(small)[key] == pytest.approx(0.01 * v[key], rel=1e-8)


def test_a_force_leaves_room_until_a_tip_touches_and_presses_less_beyond():
    values = STAGES.analytic(own(STAGES, F="5 N"))
    assert values["U_w"] == pytest.approx(5 / values["k1"], rel=1e-12)
    assert values["margin"] == pytest.approx(values["U_A"] - values["U_w"])
    beyond = STAGES.analytic(own(STAGES, F="10 N"))
    assert beyond["margin"] < 0
    after = beyond["U_A"] + (10 - beyond["F_A"]) / beyond["k2"]
    assert beyond["U_w"] == pytest.approx(after, rel=1e-12)
