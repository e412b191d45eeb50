"""Springs by formulas and by shells: limits of the strip, widths, remaining gap of a tip."""

import math

import numpy as np
import pytest

from tests.verify.cases.own import own
from tests.verify.cases.rows import context
from verify.cases.spring.accordion.case import AccordionSpring
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


def squared_levers(q, head, segments, tail):
    """(M/F)² along head, inner segments and tail [m³], by the trapezoidal rule."""
    a, alpha, turn = q.L1 / 2, q.alpha, np.linspace(0, 1, 4001)

    def along(length, lever):
        return length * np.trapezoid(np.square(lever), turn)

    quarter = math.pi / 2 * turn
    ends = [r * math.pi / 2 for r in (head, tail)]
    of_head = along(a, a * turn) + along(ends[0], a + head * np.sin(quarter))
    of_tail = along(ends[1], a + tail * np.cos(quarter))
    inner, T = 0.0, a + segments
    for i in range(2, q.n):
        s = 1 if i % 2 else -1
        sagitta = segments * (1 - np.cos(alpha * turn))
        top = T + 2 * s * sagitta[-1] + s * q.L2 * math.sin(alpha)
        leaf = T + s * (sagitta[-1] + q.L2 * math.sin(alpha) * turn)
        inner += along(q.L2, leaf)
        inner += along(segments * alpha, T + s * sagitta)
        inner += along(segments * alpha, top - s * sagitta)
        T = top
    return of_head, inner, of_tail


@pytest.mark.parametrize("change", [{}, {"b": 0.4e-3}, {"n": 5}, {"alpha": math.radians(65)}])
def test_the_inner_radius_in_one_part_alone_has_its_own_stiffness(change):
    q = AccordionSpring(**change)
    EI = q.E * q.h * q.b**3 / 12
    for k, radii in ((q.k1_inner_head, (q.r, q.R, q.R)), (q.k1_inner_segments, (q.R, q.r, q.R))):
        assert k == pytest.approx(EI / sum(squared_levers(q, *radii)), rel=1e-6)


def test_the_inner_radius_changes_the_energy_of_each_part():
    q = AccordionSpring()
    parts = zip(squared_levers(q, q.r, q.r, q.r), squared_levers(q, q.R, q.R, q.R), strict=True)
    errors = [printed / right - 1 for printed, right in parts]
    assert errors == pytest.approx([-0.034, -0.030, -0.109], abs=5e-4)
