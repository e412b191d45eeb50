"""Case spring-curve: readings, statements that can fail, and the end of the curve."""

from dataclasses import replace

import numpy as np
import pytest

from fem.beam.large import LargeFrame
from tests.verify.cases.own import own as given
from verify.cases.spring.curve import claims, reference
from verify.cases.spring.curve import fem as curve_fem
from verify.cases.spring.curve.case import CURVE, CurveSpring
from verify.core.case import Context, FemResult
from verify.core.results import Status

mm = 1e-3
Q = CurveSpring()
STATES, CELLS = 17, 2  # of the runs here: every millimetre of the stroke
TENFOLD = "stiffness after the loops touch (stage BE) is at least ten times k_2"
JUDGED = ("no interpenetration of leaves",
          "slopes k_1 and k_2 do not depend on the contact stiffness",
          "slopes k_1 and k_2 do not change if the cell size is halved",
          "work equals stored energy and friction losses",
          "loading and unloading coincide without friction", TENFOLD)  # fmt: skip
THIN = tuple(
    f"{what}, closed form for slender leaves"
    for what in (
        "displacement at which the first tip touches",
        "force at which the first tip touches",
        "stiffness after the first tip touches",
    )
)


@pytest.fixture(scope="module")
def own():
    """The paper's spring up to the end of its stroke."""
    grid = reference.grid(Q, STATES)
    return curve_fem.fem_compress(reference.spring_of(Q), grid, per_arc=CELLS)


def context(curve, *, inputs=Q, **more):
    """The input of judging if this curve is the result of both meshes and all contacts."""
    kept = curve.forces
    arrays = curve.arrays("curve 4") | curve.arrays("curve 8")
    arrays |= {f"contact {times:g}": kept for times in reference.TIMES}
    arrays["there and back"] = np.hstack([kept, kept[:, [13, 9, 5]]])
    arrays |= {"rest": curve.shapes[0]} | more
    none = FemResult(h=1.0, values={})
    fem = [FemResult(h=1.0, values={}, arrays=arrays), none, none]
    return Context("spring-curve", inputs, CURVE.analytic(inputs), fem, inputs == Q)


def judge(name, context):
    """The row called `name`."""
    (check,) = (c for c in CURVE.checks if c.name == name)
    (row,) = check.rows(context)
    return row


def test_slender_leaves_meet_the_closed_form():
    """Where tips touch, at what force, and how stiff the spring is beyond."""
    found = np.array(reference.thin_fem(Q, reference.THIN[-1], 2))
    exact = np.array([
        [claims._thin(Q, s)[key] for key in ("U_A", "F_A", "k2")] for s in reference.THIN
    ])  # fmt: skip
    curved = found / exact[-1] * (1 - 0.1 * np.array(reference.THIN)[:, None])
    thin = np.array([exact * curved * (1 + 1e-6), exact * curved])
    for factor, status in ((1.0, Status.PASS), (1.01, Status.FAIL)):
        fem = [FemResult(h=1.0, values={}, arrays={"thin": thin * factor})]
        seen = Context("spring-curve", Q, {}, fem, is_paper=True)
        assert {judge(name, seen).status for name in THIN} == {status}


def further(curve, share, force):
    """Arrays of the curve with one more state, at a share of its stroke and of its last force."""
    return {
        "curve 8 U": np.append(curve.U, share * Q.stroke),
        "curve 8 F": np.append(curve.F, force * curve.F[-1]),
        "curve 8 press": np.vstack([curve.press, curve.press[-1]]),
    }


def test_a_curve_has_a_third_stage_if_its_force_doubles(own):
    assert judge(TENFOLD, context(own, **further(own, 1.03, 2.01))).status is Status.PASS
    soft = judge(TENFOLD, context(own, **further(own, 1 + reference.BEYOND[-1], 1.3)))
    assert soft.status is Status.FAIL
    assert soft.reason.startswith("not confirmed")
    for curve in ({}, further(own, 1.03, 1.99)):  # it ends for want of an equilibrium
        found = judge(TENFOLD, context(own, **curve))
        assert found.reason.startswith("not converged: no result: no equilibrium was found beyond")


def test_a_state_that_is_not_found_ends_a_curve_beyond_its_stroke_alone(monkeypatch):
    right = LargeFrame.displaced

    def fails(self, moved, factors, *, since=None):
        if since is not None and since.u[:, 0].max() > 1.9 * mm:
            raise ArithmeticError("no equilibrium found")
        return right(self, moved, factors, since=since)

    monkeypatch.setattr(LargeFrame, "displaced", fails)
    spring, U = reference.spring_of(Q), np.arange(1, 4) * mm
    assert len(curve_fem.fem_compress(spring, U[:2], per_arc=CELLS, beyond=U[2:]).U) == 2
    with pytest.raises(ArithmeticError, match="at a displacement of 3 mm: no equilibrium found"):
        curve_fem.fem_compress(spring, U, per_arc=CELLS)


def test_what_a_user_s_curve_does_not_reach_is_not_judged(own):
    short = replace(own, press=0 * own.press)
    seen = context(short, inputs=given(CURVE, mu=0.1))
    rows = [judge(name, seen) for name in JUDGED]
    assert {row.status for row in rows} == {Status.SHOWN}
    assert not any("nan" in row.reason for row in rows)
    (table,) = CURVE.tables(seen)
    assert [row[0] for row in table.rows] == ["E", "A, linear"]
    assert CURVE.figures(seen)
    cut = replace(seen, fem=seen.fem[:2])  # a curve that breaks off
    assert not CURVE.figures(cut)
    assert not CURVE.tables(cut)
