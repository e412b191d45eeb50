"""Case spring-curve: readings, statements about its curve that can fail, and where a curve ends."""

from dataclasses import replace

import numpy as np
import pytest

from fem.beam.large import LargeFrame
from tests.verify.cases.own import own as given
from verify.cases.spring.curve import claims, reference
from verify.cases.spring.curve import fem as curve_fem
from verify.cases.spring.curve.case import CURVE, CurveSpring
from verify.cases.spring.stages.readings import eq10
from verify.core.case import Context, FemResult
from verify.core.results import Status

mm = 1e-3
Q = CurveSpring()
STATES, CELLS = 17, 2  # of the runs here: every millimetre of the stroke


def pressed(**changed):
    """The paper's spring, or one with something `changed`, up to the end of its stroke."""
    return curve_fem.fem_compress(
        reference.spring_of(Q, **changed), reference.grid(Q, STATES), per_arc=CELLS
    )  # fmt: skip


@pytest.fixture(scope="module")
def own():
    return pressed()


def context(curve, *, inputs=Q, **more):
    """What judges see if this curve is what both meshes and all contacts give."""
    kept = curve.forces
    arrays = curve.arrays("curve 4") | curve.arrays("curve 8")
    arrays |= {f"contact {times:g}": kept for times in reference.TIMES}
    arrays["there and back"] = np.hstack([kept, kept[:, [13, 9, 5]]])
    for name, _ in reference.readings(Q):
        off = 1.0 if name == "mid-leaf, guided, r" else 1.2
        arrays[f"reading {name}"] = kept * np.array([[1], [off], [off]]) / [[1], [1.0957], [1.0957]]
    arrays |= {"rest": curve.shapes[0]} | more
    none = FemResult(h=1.0, values={})
    fem = [FemResult(h=1.0, values={}, arrays=arrays), none, none]
    return Context("spring-curve", inputs, CURVE.analytic(inputs), fem, inputs == Q)


def judge(name, context):
    """The row called `name`."""
    (check,) = (c for c in CURVE.checks if c.name == name)
    (row,) = check.rows(context)
    return row


def is_red(name, context):
    return judge(name, context).status is Status.FAIL


DEPTH = "leaves do not enter each other"
SAME = "slopes do not depend on the contact's stiffness"
HALVED = "slopes stay under halving of the mesh"
BALANCE = "work is stored or lost in friction"
BACK = "the way back is the way there without friction"
TENFOLD = "stiffness rises tenfold once loops meet (stage BE)"
NEAREST = "the reading is the nearest by k_1 alone"
K1, K2 = "k_1 of the reading beside Eq. 10", "k_2 of the reading beside Eq. 10"
CROSSING = "where the lines cross, beside Eq. 10"
ALONG = "F(U) at 1 ... 17 mm beside Eq. 10"


def test_the_paper_s_reading_has_no_failure(own):
    """All but the stage BE, which lies beyond the stroke."""
    seen = context(own)
    assert not any(is_red(name, seen) for name in (DEPTH, SAME, HALVED, BACK))
    fitted = {judge(name, seen).status for name in (NEAREST, K1, K2, CROSSING, ALONG)}
    assert fitted == {Status.CALIBRATED}
    assert claims.deviations(seen, 8)[1] == pytest.approx(np.zeros(17), abs=0.05)


@pytest.mark.parametrize(
    ("changed", "row"),
    [
        pytest.param({"line": Q.path | {"radius": Q.r + Q.b / 2}}, K1, id="arcs of r + b/2"),
        pytest.param({"tail": "arc"}, ALONG, id="a tail held at its arc"),
    ],
)
def test_another_reading_of_the_spring_fails(changed, row):
    assert is_red(row, context(pressed(**changed)))


def forces_times(curve, factor):
    return replace(curve, F=curve.F * factor, press=curve.press * factor)


def stiffer_beyond(curve, by, begin=13 * mm):
    """The curve with its slope past `begin` larger."""
    return replace(curve, F=curve.F + by * 750 * np.maximum(curve.U - begin, 0))


def retraced(curve, factor):
    kept = np.array([curve.U, curve.F, curve.press.sum(axis=1)])
    back = kept[:, [13, 9, 5]] * np.array([[1], [factor], [1]])
    return {"there and back": np.hstack([kept, back])}


def other_contact(curve):
    stiff = stiffer_beyond(curve, 0.004)
    return {"contact 0.1": np.array([curve.U, stiff.F, curve.press.sum(axis=1)])}


def nearer_reading(curve):
    factor = eq10().k1 / claims.lines(context(curve)).k1
    kept = np.array([curve.U, curve.F * factor, curve.press.sum(axis=1)])
    return {"reading arc, guided, r": kept}


@pytest.mark.parametrize(
    ("row", "wrong"),
    [
        pytest.param(K1, lambda c: context(forces_times(c, 1.0957)), id="width factor twice"),
        pytest.param(K1, lambda c: context(forces_times(c, 1 / 1.0957)), id="no width factor"),
        pytest.param(ALONG, lambda c: context(replace(c, F=1.05 * c.F)), id="forces 5 % off"),
        pytest.param(CROSSING, lambda c: context(replace(c, U=1.06 * c.U)), id="lines 6 % off"),
        pytest.param(K2, lambda c: context(stiffer_beyond(c, 0.1)), id="second slope 10 % off"),
        pytest.param(SAME, lambda c: context(c, **other_contact(c)), id="contact"),
        pytest.param(HALVED, lambda c: context(c, **stiffer_beyond(c, 0.005).arrays("curve 4")),
                     id="mesh"),
        pytest.param(BACK, lambda c: context(c, **retraced(c, 1 + 2e-5)), id="not retraced"),
        pytest.param(NEAREST, lambda c: context(c, **nearer_reading(c)), id="another is nearer"),
        pytest.param(DEPTH, lambda c: context(c, **{"curve 8 depth": 1e-4 + 0 * c.depth}),
                     id="leaves enter"),
    ],
)  # fmt: skip
def test_a_statement_fails_where_the_curve_says_otherwise(row, wrong, own):
    assert is_red(row, wrong(own))


def test_friction_s_loss_belongs_to_the_balance(own):
    """It is 1e-4 of the work once loops meet, and less than the row sees before."""
    lost = 1e-4 * own.stored * (16 * mm < own.U)
    balanced = replace(own, work=own.stored + lost, dissipated=lost)
    assert not is_red(BALANCE, context(balanced))
    assert is_red(BALANCE, context(replace(balanced, dissipated=0 * lost)))


def test_slender_leaves_meet_the_closed_form():
    """Where tips touch, at what force, and how stiff the spring is beyond."""
    share = reference.THIN[-1]
    found = np.array(reference.thin_fem(Q, share, 2))
    form = claims._thin(Q, share)
    off = found / np.array([form["U_A"], form["F_A"], form["k2"]])
    exact = np.array([
        [claims._thin(Q, s)[key] for key in ("U_A", "F_A", "k2")] for s in reference.THIN
    ])  # fmt: skip
    curved = off * (1 - 0.1 * np.array(reference.THIN)[:, None])
    thin = np.array([exact * curved * (1 + 1e-6), exact * curved])
    for factor, red in ((1.0, False), (1.01, True)):
        fem = [FemResult(h=1.0, values={}, arrays={"thin": thin * factor})]
        seen = Context("spring-curve", Q, {}, fem, is_paper=True)
        for what in ("displacement where tips touch", "force where tips touch", "stiffness beyond"):
            assert is_red(f"{what}, closed form for slender leaves", seen) is red


def further(curve, share, force):
    """Arrays of the curve with one more state, at a share of its stroke and of its last force."""
    return {
        "curve 8 U": np.append(curve.U, share * Q.stroke),
        "curve 8 F": np.append(curve.F, force * curve.F[-1]),
        "curve 8 press": np.vstack([curve.press, curve.press[-1]]),
    }


def test_a_curve_has_a_third_stage_if_its_force_doubles(own):
    assert not is_red(TENFOLD, context(own, **further(own, 1.03, 2.01)))
    soft = judge(TENFOLD, context(own, **further(own, 1 + reference.BEYOND[-1], 1.3)))
    assert soft.status is Status.FAIL
    assert soft.reason.startswith("not held")
    for curve in ({}, further(own, 1.03, 1.99)):  # it ends for want of an equilibrium
        found = judge(TENFOLD, context(own, **curve))
        assert found.reason.startswith("not converged: no result, no equilibrium was found beyond")


def test_a_state_that_is_not_found_ends_a_curve_beyond_its_stroke_alone(monkeypatch):
    right = LargeFrame.displaced

    def fails(self, moved, factors, *, since=None):
        if since is not None and since.u[:, 0].max() > 1.9 * mm:
            raise ArithmeticError("no equilibrium found")
        return right(self, moved, factors, since=since)

    monkeypatch.setattr(LargeFrame, "displaced", fails)
    spring, U = reference.spring_of(Q), np.arange(1, 4) * mm
    assert len(curve_fem.fem_compress(spring, U[:2], per_arc=CELLS, beyond=U[2:]).U) == 2
    with pytest.raises(ArithmeticError, match="pressed to 3 mm: no equilibrium found"):
        curve_fem.fem_compress(spring, U, per_arc=CELLS)


def test_eq_10_is_two_lines_from_which_deviations_count(own):
    U = np.array([1, 11.9, 12.0, 17]) * mm
    assert eq10().force(U) == pytest.approx(
        [0.613 + 0.0055, 0.613 * 11.9 + 0.0055, 0.749 * 12 - 1.62, 0.749 * 17 - 1.62], rel=1e-12
    )
    U = np.arange(1.0, 18.0) * mm
    larger = replace(own, U=U, F=1.02 * eq10().force(U))
    assert claims.deviations(context(larger), 8)[1] == pytest.approx(np.full(17, 0.02))


def test_what_a_user_s_own_curve_does_not_reach_is_not_judged(own):
    short = replace(own, press=0 * own.press)
    mine = given(CURVE, mu=0.1)
    seen = context(short, inputs=mine)
    rows = [judge(name, seen) for name in (DEPTH, SAME, HALVED, BALANCE, BACK, TENFOLD)]
    assert {row.status for row in rows} == {Status.SHOWN}
    assert not any("nan" in row.reason for row in rows)
    whole = context(short, inputs=mine, **further(short, 1 + reference.BEYOND[-1], 1.3))
    assert "no leaves touch for long enough" in judge(TENFOLD, whole).reason
    (table,) = CURVE.tables(seen)
    assert [row[0] for row in table.rows] == ["E", "A, linear"]
    assert CURVE.figures(seen)
    cut = replace(seen, fem=seen.fem[:2])  # a curve that breaks off
    assert not CURVE.figures(cut)
    assert not CURVE.tables(cut)
