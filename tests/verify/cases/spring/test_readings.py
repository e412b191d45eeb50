"""Readings of the paper on accordion springs: another one fails against beams and shells."""

import numpy as np
import pytest

from analytic.spring import frame, stages
from analytic.spring.elastica import Elastica
from tests.verify.cases.readings import given
from tests.verify.cases.rows import rows
from verify.cases.spring.buckling import formulas as buckling
from verify.cases.spring.buckling.case import BUCKLING
from verify.cases.spring.stages import readings as of_stages
from verify.cases.spring.stages.case import STAGES, StageSpring
from verify.cases.spring.stages.readings import chosen, eq10, meeting, readings, uncertainties
from verify.cases.spring.width.case import WIDTH
from verify.core.case import Context
from verify.core.results import Status

GUIDED = "head guided, tail clamped at mid-leaf"
FREE = "the spring with a free head buckles, tail clamped at its arc"


def wide_strip(_):
    return lambda q, tail: Elastica(
        buckling.frame.pieces(**q.path, tail=tail), EI=q.E * q.h * q.b**3 / 12 / (1 - q.nu**2)
    )


READINGS = [
    pytest.param(BUCKLING, buckling, "elastica", wide_strip,
                 f"force at which {FREE}", id="a wide strip"),
    pytest.param(STAGES, stages, "response", lambda f: lambda A, held, tips: f(A, held, tips[:1]),
                 f"stiffness k_2, {GUIDED}", id="one tip for two"),
    pytest.param(STAGES, stages, "line", given(normal=lambda _: "leaf"),
                 f"force at point A, {GUIDED}", id="the unloaded leaf's normal"),
    pytest.param(STAGES, stages, "HELD", lambda held: held | {"hinged": []},
                 "stiffness k_1, head hinged, tail clamped at mid-leaf",
                 id="a hinge without side force"),
    pytest.param(WIDTH, frame, "stiffness", given(plane_strain=lambda _: False),
                 "stiffness of the shell in plane strain, tail clamped at mid-leaf, head guided",
                 id="1 - nu² dropped"),
]  # fmt: skip


@pytest.mark.parametrize(("case", "owner", "name", "reading", "row"), READINGS)
def test_another_reading_fails(case, owner, name, reading, row, fails):
    assert row in fails(case, owner, name, reading, row)


def test_one_of_sixteen_readings_meets_the_printed_stiffness():
    q = StageSpring(width_factor=None)
    assert len(readings(q)) == 16
    assert [str(x) for x in meeting(q)] == [str(chosen(q))]
    x = chosen(q)
    assert (x.tail, x.head, x.radius, x.strip) == ("mid-leaf", "free", "r + b/2", "E I/(1 − ν²)")
    assert abs(x.off) < 0.005
    context = Context("spring-stages", q, STAGES.analytic(q), [], is_paper=True)
    (table,) = STAGES.tables(context)
    assert [row[:4] for row in table.rows if row[-1] == "yes"] == [
        ("mid-leaf", "free", "r + b/2", "E I/(1 − ν²)")
    ]


def test_a_prediction_of_the_chosen_reading_is_calibrated_and_fails_beyond_its_figure(
    monkeypatch,
):
    name = "displacement at point A against Eq. 10, calibrated interpretation of the paper"
    assert [row.status for row in rows(STAGES, name)] == [Status.CALIBRATED]
    guided = [
        x for x in readings(StageSpring(width_factor=1.09))
        if x.head == "guided" and x.strip == "1.09 E I"
    ]  # fmt: skip
    monkeypatch.setattr(of_stages, "readings", lambda _: guided)
    assert [row.status for row in rows(STAGES, name)] == [Status.FAIL]


def test_the_lines_of_eq_10_cross_at_the_point_of_the_ledger():
    assert pytest.approx((11.952, 7.332), abs=5e-4) == (eq10().U * 1e3, eq10().F)
    u = uncertainties()
    rng = np.random.default_rng(1)
    digits = rng.uniform(-1, 1, (4, 100_000)) * np.array([[0.5], [5e-6], [0.5], [0.005]])
    k1, c1, k2, c2 = np.array([[613.0], [0.0055], [749.0], [-1.62]]) + digits
    U = (c1 - c2) / (k2 - k1)
    assert u["U"] == pytest.approx(U.std(), rel=0.01)
    assert u["F"] == pytest.approx((k1 * U + c1).std(), rel=0.01)
