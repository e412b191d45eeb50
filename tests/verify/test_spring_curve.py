"""Case spring-curve: faults of model and judging turn rows red; readings; what is read off."""

from dataclasses import replace

import numpy as np
import pytest

from fem.beam import touching, touching_law, two_lines
from meshes.spring import centre_line
from verify.cases.spring.curve import claims, reference
from verify.cases.spring.curve import fem as curve_fem
from verify.cases.spring.curve.case import CURVE, CurveSpring
from verify.cases.spring.curve.figures import points
from verify.cases.spring.stages.readings import eq10
from verify.core.case import Context, FemResult
from verify.core.inputs import InputError, build
from verify.core.results import Status

pytestmark = pytest.mark.xdist_group("spring-curve")
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
    back = kept[:, [13, 9, 5]]
    arrays["there and back"] = np.hstack([kept, back])
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
AT_A, FORCE_A, BEYOND = (
    f"{what}, closed form for slender leaves"
    for what in ("displacement where tips touch", "force where tips touch", "stiffness beyond")
)


def test_no_row_is_red_without_a_fault(own):
    """All but the stage BE, which lies beyond the stroke."""
    names = (DEPTH, SAME, HALVED, BACK, NEAREST, K1, K2, CROSSING, ALONG)
    assert [name for name in names if is_red(name, context(own))] == []
    fitted = {judge(name, context(own)).status for name in (NEAREST, K1, K2, CROSSING, ALONG)}
    assert fitted == {Status.CALIBRATED}


@pytest.mark.parametrize(
    ("changed", "row"),
    [
        pytest.param({"line": Q.path | {"radius": Q.r + Q.b / 2}}, K1, id="arcs of r + b/2"),
        pytest.param({"tail": "arc"}, ALONG, id="a tail held at its arc"),
    ],
)
def test_another_reading_of_the_spring_turns_a_row_red(changed, row):
    assert is_red(row, context(pressed(**changed)))


@pytest.mark.parametrize("factor", [1.0, 1.0957**2, 1 / 0.91**2])
def test_a_width_factor_dropped_or_taken_twice_turns_k_1_red(own, factor):
    """All forces go with it."""
    wrong = replace(own, F=own.F * factor / Q.width_factor, press=own.press * factor / 1.0957)
    assert is_red(K1, context(wrong))


def stiffness_at_rest():
    return reference.solve(Q, reference.READINGS).values["k1"] / CURVE.analytic(Q)["k1"] - 1


def test_a_head_that_may_turn_is_softer_at_rest(monkeypatch):
    monkeypatch.setattr(reference, "_read", lambda _: {})
    assert abs(stiffness_at_rest()) < 1e-6
    monkeypatch.setattr(curve_fem, "SUPPORTS", curve_fem.SUPPORTS | {"guided": "y"})
    assert stiffness_at_rest() < -5e-4


@pytest.fixture
def slender(monkeypatch):
    """The three limit rows, as the least share says: what is wrong there is wrong at all."""

    def rows():
        q, share = Q, reference.THIN[-1]
        found = np.array(reference.thin_fem(q, share, 2))
        form = claims._thin(q, share)
        off = found / np.array([form["U_A"], form["F_A"], form["k2"]])
        exact = np.array([
            [claims._thin(q, s)[key] for key in ("U_A", "F_A", "k2")] for s in reference.THIN
        ])  # fmt: skip
        curved = off * (1 - 0.1 * np.array(reference.THIN)[:, None])
        thin = np.array([exact * curved * (1 + 1e-6), exact * curved])
        fem = [FemResult(h=1.0, values={}, arrays={"thin": thin})]
        seen = Context("spring-curve", q, {}, fem, is_paper=True)
        return {name for name in (AT_A, FORCE_A, BEYOND) if is_red(name, seen)}

    return rows


def test_slender_leaves_meet_the_closed_form(slender):
    assert slender() == set()


def without_tail_tip(init):
    def wrong(self, points, elements, **more):
        init(self, points, elements[:-2], **more)  # of the tail's tip, at 2 cells

    return wrong


SLENDER_FAULTS = [
    pytest.param(touching.SelfContact, "__init__",
                 lambda f: lambda s, *a, **k: f(s, *a, **k | {"thickness": k["thickness"] / 2}),
                 AT_A, id="half the thickness in contact"),
    pytest.param(touching.SelfContact, "__init__", without_tail_tip, BEYOND, id="one tip only"),
    pytest.param(curve_fem.Spring, "EA", lambda f: property(lambda s: f.fget(s) / (1 - s.nu**2)),
                 FORCE_A, id="a wide strip's stiffness"),
    pytest.param(centre_line, "accordion",
                 lambda f: lambda **k: f(**k | {"radius": 1.02 * k["radius"]}), AT_A,
                 id="arcs 2 % too large"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), SLENDER_FAULTS)
def test_a_wrong_model_misses_the_closed_form(owner, name, fault, row, monkeypatch, slender):
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert row in slender()


def test_a_soft_contact_that_does_not_settle_enters(own, monkeypatch):
    monkeypatch.setattr(touching_law.Law, "settle", lambda *_: False)
    places = np.array([6, 12, 14, 17]) * mm
    soft = curve_fem.fem_compress(reference.spring_of(Q), places, per_arc=CELLS, times=0.1)
    assert is_red(DEPTH, context(own, **{"curve 8 depth": soft.depth}))


def test_lines_on_the_wrong_side_turn_both_slopes_red(own, monkeypatch):
    right = two_lines.touching
    monkeypatch.setattr(two_lines, "touching", lambda *a: (right(*a)[0] - 6 * mm, *right(*a)[1:]))
    assert is_red(K2, context(own))
    monkeypatch.setattr(two_lines, "touching", lambda *a: (right(*a)[0] + 2 * mm, *right(*a)[1:]))
    assert is_red(CROSSING, context(own)) or is_red(K1, context(own))


def test_friction_s_loss_belongs_to_the_balance(own):
    """It is 1e-4 of the work once loops meet, and less than the row sees before."""
    lost = 1e-4 * own.stored * (16 * mm < own.U)
    balanced = replace(own, work=own.stored + lost, dissipated=lost)
    assert not is_red(BALANCE, context(balanced))
    assert is_red(BALANCE, context(replace(balanced, dissipated=0 * lost)))


def stiffer_beyond(curve, by, begin=13 * mm):
    """The curve with its slope past `begin` larger."""
    return replace(curve, F=curve.F + by * 750 * np.maximum(curve.U - begin, 0))


def test_slopes_of_other_contacts_and_meshes_must_agree(own):
    kept = np.array([own.U, stiffer_beyond(own, 0.004).F, own.press.sum(axis=1)])
    assert is_red(SAME, context(own, **{"contact 0.1": kept}))
    other = stiffer_beyond(own, 0.005).arrays("curve 4")
    assert is_red(HALVED, context(own, **other))


def test_forces_must_be_retraced(own):
    kept = np.array([own.U, own.F, own.press.sum(axis=1)])
    back = kept[:, [13, 9, 5]] * np.array([[1], [1 + 2e-5], [1]])
    assert is_red(BACK, context(own, **{"there and back": np.hstack([kept, back])}))


def further(curve, share, force):
    """Arrays of the curve with one more state, at a share of its stroke and of its last force."""
    return {
        "curve 8 U": np.append(curve.U, share * Q.stroke),
        "curve 8 F": np.append(curve.F, force * curve.F[-1]),
        "curve 8 press": np.vstack([curve.press, curve.press[-1]]),
    }


def test_a_curve_that_ends_by_its_force_or_its_last_displacement_has_a_third_stage(own):
    assert not is_red(TENFOLD, context(own, **further(own, 1.03, 2.01)))
    soft = judge(TENFOLD, context(own, **further(own, 1 + reference.BEYOND[-1], 1.3)))
    assert soft.status is Status.FAIL
    assert soft.reason.startswith("not held")


def test_a_curve_that_ends_for_want_of_an_equilibrium_has_no_third_stage(own):
    for curve in ({}, further(own, 1.03, 1.99)):
        found = judge(TENFOLD, context(own, **curve))
        assert found.status is Status.FAIL
        assert found.reason.startswith("not converged: no result, no equilibrium was found beyond")


def test_a_state_that_is_not_found_ends_a_curve_beyond_its_stroke_and_no_other(monkeypatch):
    """Up to the stroke the error goes on to the case."""
    from fem.beam.large import LargeFrame

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


def test_a_reading_that_is_nearer_to_k_1_is_told(own):
    k1 = claims.lines(context(own)).k1
    kept = np.array([own.U, own.F * eq10().k1 / k1, own.press.sum(axis=1)])
    seen = context(own, **{"reading arc, guided, r": kept})
    assert is_red(NEAREST, seen)
    assert "arc, guided, r, f = 1:" in judge(NEAREST, seen).reason


def test_forces_5_percent_off_are_red_along_the_way(own):
    assert is_red(ALONG, context(replace(own, F=1.05 * own.F)))
    assert is_red(CROSSING, context(replace(own, U=1.06 * own.U)))


def test_eq_10_is_printed_as_two_lines():
    U = np.array([1, 11.9, 12.0, 17]) * mm
    assert eq10().force(U) == pytest.approx(
        [0.613 + 0.0055, 0.613 * 11.9 + 0.0055, 0.749 * 12 - 1.62, 0.749 * 17 - 1.62], rel=1e-12
    )


def test_deviations_are_over_eq_10(own):
    U = np.arange(1.0, 18.0) * mm
    exact = replace(own, U=U, F=eq10().force(U))
    assert claims.deviations(context(exact), 8)[1] == pytest.approx(np.zeros(17), abs=1e-14)
    assert claims.deviations(context(replace(exact, F=1.02 * exact.F)), 8)[1] == pytest.approx(
        np.full(17, 0.02)
    )


def test_points_are_named_by_what_presses(own):
    press = np.zeros((17, 9))
    press[12:, [0, -1]] = 1.0
    assert points(context(replace(own, press=press))) == {"O": -1, "A": 12, "E": 16}
    press[15:, :6] = 1.0
    assert points(context(replace(own, press=press))) == {"O": -1, "A": 12, "B": 15, "E": 16}
    assert points(context(replace(own, press=0 * press))) == {"O": -1, "E": 16}


def test_what_is_not_reached_is_told_in_words(own):
    """At one's own inputs nothing turns red by that, and no row tells of nan."""
    short = replace(own, press=0 * own.press)
    mine = CurveSpring(mu=0.1)
    seen = context(short, inputs=mine)
    whole = context(short, inputs=mine, **further(short, 1 + reference.BEYOND[-1], 1.3))
    rows = [judge(name, seen) for name in (DEPTH, SAME, HALVED, BALANCE, BACK, TENFOLD)]
    assert {row.status for row in rows} == {Status.SHOWN}
    assert not any("nan" in row.reason for row in rows)
    assert "no leaves touch for long enough" in judge(TENFOLD, whole).reason
    (table,) = CURVE.tables(seen)
    assert [row[0] for row in table.rows] == ["E", "A, linear"]
    assert CURVE.figures(seen)


def test_a_curve_that_breaks_off_shows_nothing(own):
    seen = context(own)
    assert not CURVE.figures(replace(seen, fem=seen.fem[:2]))
    assert not CURVE.tables(replace(seen, fem=seen.fem[:2]))


def test_rows_about_the_paper_are_the_paper_s_alone():
    assert CurveSpring().is_paper
    assert not CurveSpring(mu=0.1).is_paper
    alone = {check.name for check in CURVE.checks if check.paper_only}
    assert alone >= {NEAREST, K1, K2, CROSSING, ALONG, AT_A, FORCE_A, BEYOND}


PAPER = {"n": 10, "b": "0.1 mm", "h": "56 mm", "r": "0.45 mm", "L1": "11.6 mm",
         "alpha": "80 deg", "E": "206 GPa", "nu": 0.3, "width_factor": 1.09, "mu": 0.15,
         "stroke": "17 mm"}  # fmt: skip


@pytest.mark.parametrize(
    ("raw", "message"),
    [
        ({"stroke": "20 mm"}, "over 5% to 72% of the free length L_0 = 2"),
        ({"stroke": "1 mm"}, "got stroke = 1 mm"),
        ({"width_factor": 1.2}, "by 1/(1 - ν²) = 1.0989 at most, got width_factor = 1.2"),
        ({"width_factor": 0.9}, "inputs.width_factor = 0.9: must be at least 1"),
        ({"mu": -0.1}, "inputs.mu = -0.1: must be at least 0"),
        ({"mu": 0.6}, "inputs.mu = 0.6: must be at most 0.5"),
        ({"head": "loose"}, "inputs.head: needs one of free, hinged, guided, got 'loose'"),
        ({"tail": "end"}, "inputs.tail: needs one of arc, mid-leaf, got 'end'"),
        ({"arcs": "R"}, "inputs.arcs: needs one of r, r + b/2, got 'R'"),
    ],
)
def test_wrong_input_is_named_in_one_line(raw, message):
    with pytest.raises(InputError) as error:
        build(CurveSpring, PAPER | raw, "my.toml")
    assert message in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("head", ["free", "hinged"])
def test_only_a_guided_head_is_followed(head):
    assert f"head = {head}: the whole curve" in CURVE.too_large(CurveSpring(head=head))
    assert CURVE.too_large(CurveSpring()) == ""
