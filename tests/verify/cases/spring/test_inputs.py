"""Springs of a user's own: what is computed, warned of, not compared and refused."""

import numpy as np
import pytest

from tests.verify.cases.own import assert_refused, own, state
from verify.cases.spring.buckling.case import BUCKLING
from verify.cases.spring.curve.case import CURVE
from verify.cases.spring.map.case import MAP
from verify.cases.spring.map.inputs import points
from verify.cases.spring.stages.case import STAGES, StageSpring
from verify.cases.spring.width.case import WIDTH
from verify.cases.spring.width.reference import LEVELS
from verify.core.case import Context
from verify.core.results import Status
from verify.judging.claims import rows_of

REFUSED = [
    (STAGES, {"width_factor": 1.2}, "at most, got width_factor = 1.2"),
    (STAGES, {"width_factor": 0.9}, "inputs.width_factor = 0.9: must be at least 1"),
    (STAGES, {"head": "loose"}, "inputs.head: needs one of free, hinged, guided, got 'loose'"),
    (STAGES, {"tail": 3}, "inputs.tail: needs one of arc, mid-leaf, got 3"),
    (CURVE, {"stroke": "20 mm"}, "over 5% to 72% of the free length L_0 = 2"),
    (CURVE, {"stroke": "1 mm"}, "got stroke = 1 mm"),
    (CURVE, {"mu": 0.6}, "inputs.mu = 0.6: must be at most 0.5"),
    (CURVE, {"arcs": "R"}, "inputs.arcs: needs one of r, r . b/2, got 'R'"),
    (MAP, {"x_r": "20 mm"}, "way must be at most 0.7 of the spring's length = 17.84 mm, got x_r"),
    (MAP, {"y_r": "5 mm"}, "needs y_r <= 0.2 x_r, got x_r = 8.3 mm, y_r = 5 mm"),
    (BUCKLING, {"F": "-1 N"}, "inputs.F = -1 N: must be greater than 0 N"),
]


@pytest.mark.parametrize(("case", "change", "message"), REFUSED)
def test_a_spring_that_cannot_be_is_refused_in_one_line(case, change, message):
    assert_refused(case, change, message)


FLAT = {"alpha": "20 deg", "L1": "5 mm"}
WARNED = [
    (BUCKLING, {"n": 9, "F": "0.5 N"}, ""),
    (BUCKLING, {"F": "2 N"}, "with a free head the spring buckles at 1.46 mm: the head needs a"),
    (STAGES, {"width_factor": 1.09}, "U_A is 55% of the free length"),
    (STAGES, {"F": "10 N", "tail": "mid-leaf"}, "F = 10 N is beyond A"),
    (STAGES, {"F": "9.5 N", "tail": "arc"}, "a tip touches"),
    (STAGES, {"R_p": "500 MPa"}, "at A exceeds R_p = 500 MPa: the loops yield before the tips"),
    (STAGES, FLAT, "° from parallel to the tip"),
    (WIDTH, {}, ""),
    (WIDTH, {"h": "0.2 mm"}, "a strip 2 times as wide as thick is no plate"),
    (WIDTH, {"h": "3 mm"}, "a strip 0.25 times as wide as a leaf is long: its arcs"),
    (WIDTH, {"r": "4 mm", "L1": "8.1 mm"}, "as long as leaves: a leaf's factor says little"),
]


@pytest.mark.parametrize(("case", "change", "words"), WARNED)
def test_the_state_of_a_spring_is_warned_of(case, change, words):
    *_, warned = state(case, **change)
    assert any(words in line for line in warned) if words else not warned


def test_a_wide_strip_is_warned_of_unless_its_width_factor_is_known():
    for factor, warned in ((None, True), (1.09, False)):
        q = StageSpring(width_factor=factor)
        said = STAGES.warnings(q, STAGES.analytic(q))
        assert any("a strip 560 times as wide as thick" in line for line in said) is warned


@pytest.mark.parametrize(
    ("case", "change", "words"),
    [
        (BUCKLING, {"n": 30}, "n = 30 segments are more than 24"),
        (BUCKLING, {"n": 4}, "too short to buckle sideways"),
        (WIDTH, {"n": 31}, "check it with n = 30"),
        (WIDTH, {"b": "0.001 mm"}, "11938 times as long as thick"),
        (CURVE, {"head": "free"}, "head = free: the whole curve"),
    ],
)
def test_a_spring_without_a_comparison_says_so(case, change, words):
    assert words in case.too_large(own(case, **change))
    assert not case.too_large(own(case))


@pytest.mark.parametrize(
    ("case", "change"),
    [
        (BUCKLING, {"n": 200}),
        (BUCKLING, {"alpha": "90 deg"}),
        (MAP, {"n": 200}),
        (MAP, {"alpha": "90 deg", "x_r": "4 mm", "y_r": "0 mm"}),
    ],
)
def test_values_of_odd_springs_are_finite(case, change):
    q, *_ = state(case, **change)
    if case is MAP:
        assert all(len(row) == 4 for row in points(q, deep=False)["slender"])


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


def test_a_force_says_what_is_left_until_a_tip_touches():
    values = STAGES.analytic(own(STAGES, F="5 N"))
    assert values["U_w"] == pytest.approx(5 / values["k1"], rel=1e-12)
    assert values["margin"] == pytest.approx(values["U_A"] - values["U_w"])
    beyond = STAGES.analytic(own(STAGES, F="10 N"))
    assert beyond["margin"] < 0
    after = beyond["U_A"] + (10 - beyond["F_A"]) / beyond["k2"]
    assert beyond["U_w"] == pytest.approx(after, rel=1e-12)


def test_a_spring_of_a_user_s_own_passes_and_is_not_compared_with_eq_10(judged):
    result = judged(STAGES, own(STAGES, n=5, b="0.3 mm", r="0.5 mm"), drawn=False)
    assert {row.status for row in result.rows} == {Status.PASS}


@pytest.mark.soak  # shells are solved for own inputs
def test_an_own_narrow_spring_passes_and_its_error_is_measured():
    q = own(WIDTH, n=4, h="3 mm", head="hinged", tail="arc")
    levels = [WIDTH.reference(q, level) for level in LEVELS]
    context = Context(WIDTH.id, q, WIDTH.analytic(q), levels, False)
    rows = [row for check in WIDTH.checks for row in rows_of(check, context)]
    assert {row.status for row in rows} == {Status.PASS, Status.SHOWN}
    assert any("one leaf" in row.quantity and "measured: leaf" in row.reason for row in rows)
    assert np.isfinite([row.fem for row in rows if row.fem is not None]).all()
