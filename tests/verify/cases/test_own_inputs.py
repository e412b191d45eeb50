"""Parts of a user: judged without a failure, and drawn with any proportions."""

from dataclasses import replace

import numpy as np
import pytest

from tests.verify.cases.own import own, state
from tests.verify.cases.test_left_to_formulas import NANOMETRE
from tests.verify.cases.test_warned import RIM
from verify.cases.registry import find
from verify.core.case import Context
from verify.core.results import Status

SOAK = pytest.mark.soak
OWN = [
    ("polyhedral-pressure", {"delta_1": "0.4 mm"}),
    ("polyhedral-ring", {"rho": "34 mm", "e": "0.5 mm"}),
    pytest.param("polyhedral-ring", {"delta_1": "20 mm", "e": "5 mm"}, marks=SOAK),
    pytest.param("polyhedral-locking", {"z": 12, "e": "5 mm", "d": "8 mm"}, marks=SOAK),
    pytest.param("polyhedral-clutch", {"M_t": "110 N m"}, marks=SOAK),
    ("sprag-clutch", {"n": "1000 rad/s", "T": "15 N m"}),
    ("spring-stages", {"n": 5, "b": "0.3 mm", "r": "0.5 mm"}),
    pytest.param("spring-width", {"n": 4, "h": "3 mm", "head": "hinged"}, marks=SOAK),
    ("contact-press-fit", NANOMETRE),
    ("contact-roller-flat", {"F": "3000 N", "R_2": "-40 mm"}),
    pytest.param("contact-roller-tilted", RIM, marks=SOAK),
    ("rotor-clutch", {"n_s": 7, "T": "40 N m", "missing": 5, "nu": "0.1 rad"}),
    ("rotor-shaft", {"d_i": "0 mm", "L": "400 mm", "nu": 0.25}),
]  # fmt: skip


@pytest.mark.parametrize(("case_id", "changes"), OWN)
def test_a_part_of_a_user_has_no_failure(case_id, changes, judged, red):
    case = find(case_id)
    if case_id.startswith(("contact-", "polyhedral-locking")):
        case = replace(case, levels=case.levels[:3])
    result = judged(case, own(case, **changes), drawn=False)
    assert not red(result)
    assert not result.errors
    assert any(row.status is Status.PASS for row in result.rows)
    assert not any(row.status is Status.CALIBRATED for row in result.rows)  # fits to the papers


TEN_TIMES = {
    "R_id": "72.1 mm", "R_i": "111.1 mm", "R_e": "194.4 mm", "R_ed": "262.3 mm", "r_i": "40.2 mm",
    "l": "90 mm", "b": "40 mm", "T": "25 kN m", "Q": "340.7 kN", "z_m": "0.1 mm",
}  # fmt: skip
ODD = [
    ("spring-buckling", {"n": 200}),
    ("spring-map", {"alpha": "90 deg", "x_r": "4 mm", "y_r": "0 mm"}),
    ("contact-roller", {"R_2": "-12 mm"}),
    ("sprag-clutch", TEN_TIMES),
    ("rotor-clutch", {}),
    ("rotor-system", {}),
]


@pytest.mark.parametrize(("case_id", "changes"), ODD)
def test_figures_of_odd_parts_are_drawn_by_formulas_alone(case_id, changes):
    case = find(case_id)
    q, values, _ = state(case, **changes)
    with np.errstate(over="raise", divide="raise", invalid="raise"):
        figures = case.figures(Context(case.id, q, values, (), is_paper=False))
    for curve in (c for figure in figures for c in getattr(figure, "curves", ())):
        assert np.isfinite(curve.x).all()
        assert not np.isinf(curve.y).any()


@pytest.mark.parametrize("nu", [0.0, 0.2, 0.295])
def test_a_wide_spring_is_drawn_for_any_poisson_s_ratio(nu):
    case = find("spring-width")
    drawn = case.sketch(own(case, nu=nu)).shapes
    for one, other in zip(drawn, case.sketch(case.inputs()).shapes, strict=True):
        assert one.label == other.label
        assert np.array_equal(one.points, other.points)
