"""What the drawn sprag judges: faults of the formulas turn its rows red, and those alone."""

import math
from dataclasses import replace

import numpy as np
import pytest

from analytic.sprag import parts
from analytic.sprag.clutch import Clutch
from tests.conftest import solved
from verify.cases.sprag.clutch import formulas, limits, model, paper_fem
from verify.cases.sprag.clutch.case import CLUTCH, SpragClutch
from verify.cases.sprag.clutch.drawn_fem import drawn
from verify.cases.sprag.clutch.paper_statements import corners, length
from verify.cases.sprag.optimum import reference as sprag_optimum_fem
from verify.cases.sprag.optimum.case import SpragOptimum
from verify.cases.sprag.statements import UNFITTED
from verify.jobs.level import Job, judge_case

pytestmark = pytest.mark.xdist_group("sprag-clutch")
PAPER = SpragClutch()
CACHED = (
    model.built, model.under, model.rigid, model.literal, model.grip, model.spring_force,
    limits.as_torque_grows,
)  # fmt: skip

TURN = "turn of the races, finite steps of rolling"
RIGID_FORCE = "normal force with rigid races (Liu)"
RIGID_SPRAGS = "turn of the sprags with rigid races (Liu)"
RIGID_TURN = "turn of the races, rigid (Liu), finite steps of rolling"
PRINTED = "turn of the sprags, Eqs. 9 and 10 as printed"
SLIPS = "torque at which the contacts slip at low friction"
GROWTH = "growth of the outer race at 20,000 r/min"
FAST = "turn of the sprags at 20,000 r/min"
FAST_TURN = "turn of the races at 20,000 r/min, by rolling"


def forget():
    for function in CACHED:
        function.cache_clear()


@pytest.fixture
def broken(monkeypatch, judged, without_fault, red):
    """Put a fault in place of a part of the formulas; the rows that turn red."""
    without_fault(CLUTCH)  # the other side stays right

    def break_(owner, name, fault):
        monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
        forget()
        return {row.quantity for row in red(judged(CLUTCH, drawn=False))}

    yield break_
    monkeypatch.undo()
    forget()


@pytest.mark.parametrize(
    ("key", "factor", "row"),
    [
        ("theta", 2.0, TURN), ("theta", 1.005, TURN), ("N_Liu", 1.05, RIGID_FORCE),
        ("N_Liu", 1.0005, RIGID_FORCE), ("alpha_Liu", 1.005, RIGID_SPRAGS),
        ("theta_Liu", 1.005, RIGID_TURN), ("alpha_printed", 1.005, PRINTED),
    ],
)  # fmt: skip
def test_a_wrong_value_turns_its_row_red(key, factor, row, broken):
    def fault(right):
        def wrong(q):
            return factor * right(q) if q.n == 0 else right(q)  # not of the variant at speed

        return wrong

    assert broken(getattr(SpragClutch, key), "formula", fault) == {row}


def test_rigid_races_that_yield_and_rolling_left_out_are_red(broken):
    rigid = broken(Clutch, "rigid_races", lambda _: lambda self: self)
    assert {RIGID_FORCE, RIGID_SPRAGS, RIGID_TURN} <= rigid


def test_without_rolling_the_turn_of_the_races_is_red(broken):
    found = broken(formulas, "rolled", lambda right: lambda c, N: 1.01 * right(c, N))
    assert {TURN, RIGID_TURN} <= found


def test_the_right_closure_in_the_printed_one_s_place_is_red(broken):
    found = broken(model.printed, "wedged", lambda _: lambda c, N: model.wedged(c, N))
    assert found == {PRINTED}


def test_without_the_growth_by_rotation_rows_at_speed_are_red(broken):
    still = property(lambda _self: np.zeros(()))
    assert {GROWTH, FAST} <= broken(parts.Parts, "d_ce", lambda _: still)


def test_friction_s_limit_by_another_angle_is_red(broken):
    def by_sine(right):
        return lambda clutch, mu, **more: right(clutch, mu=mu / math.sqrt(1 + mu**2), **more)

    assert broken(model, "limits", by_sine) == {SLIPS}


def test_a_drawn_sprag_rolls_as_its_arcs_say_but_for_what_yields():
    """Arcs of the unloaded flank on the bore and of the spiral on the rim, to half a percent."""
    one, sprag = drawn(PAPER, 322), PAPER.sprag
    now, m = one.under(3388.0), float(np.asarray(sprag.m))
    spiral = float(sprag.rho_0) * math.hypot(1, m) / m * math.expm1(m * now.turned)
    swung = float(sprag.r_e) * now.alpha / PAPER.R_e
    leans = math.atan2(now.A[0], now.A[1]) - float(sprag.beta_0)
    turn = spiral / PAPER.R_i + swung - leans
    assert one.rolled(3388.0, 80) == pytest.approx(turn, rel=5e-3)


@pytest.mark.parametrize("changes", [{"n": 1000.0, "T": 15.0}, {"T": 15.0}, {"z_m": 0.0}])
def test_own_clutches_are_judged_by_the_drawn_one_without_the_variants(changes, judged, red):
    q = PAPER.model_copy(update=changes)
    found = judged(CLUTCH, q)
    assert not red(found)
    named = {row.quantity for row in found.rows}
    assert {TURN, RIGID_FORCE, PRINTED} <= named
    assert not {SLIPS, GROWTH, FAST} & named


# Calibration.
def test_a_failed_calibration_turns_its_own_rows_red_and_no_other(monkeypatch, red):
    monkeypatch.setattr(paper_fem, "peak_fem", lambda *_, **__: 1e9)
    without = paper_fem.calibrated_fem()
    *coarse, fine = solved(CLUTCH, PAPER)
    last = replace(fine, result=replace(fine.result, arrays={**fine.result.arrays, **without}))
    found = red(judge_case(Job(CLUTCH, PAPER), [*coarse, last]))
    assert {row.reason for row in found} == {UNFITTED}
    assert len(found) == 6


def test_a_wedge_angle_is_fitted_only_between_pressures_on_both_sides(monkeypatch):
    low, high = map(float, paper_fem.ANGLES)
    printed = paper_fem.PRINTED[25.0][1]

    def fitted(zero):
        """The angle found where the printed pressure is that of the angle `zero`."""
        monkeypatch.setattr(
            paper_fem, "peak_fem",
            lambda _crown, _T, *, nu_0: printed + 1e11 * (zero - nu_0),
        )  # fmt: skip
        return paper_fem.fitted_angle_fem()

    assert fitted(low - 1e-4) is None
    assert fitted(high + 1e-4) is None
    for zero in (low + 1e-4, high - 1e-4):
        assert fitted(zero) == pytest.approx(zero, abs=2e-5)


@pytest.mark.parametrize("error", [ArithmeticError, ValueError])
def test_an_engagement_that_is_not_solved_is_no_failed_calibration(error, monkeypatch):
    def fails(*_, **__):
        raise error("the engagement is not followed")

    monkeypatch.setattr(paper_fem, "peak_fem", fails)
    with pytest.raises(error, match="not followed"):
        paper_fem.calibrated_fem()
    with pytest.raises(error, match="not followed"):
        sprag_optimum_fem.calibrated_fem(SpragOptimum(), {})


def test_the_rounding_of_mass_and_inertia_leaves_8_to_11_mm():
    (w_short, short), (w_long, long) = corners(PAPER)
    assert [round(x * 1e3, 1) for x in (short, long, w_long, w_short)] == [7.8, 10.8, 2.6, 3.4]


@pytest.mark.parametrize(("l", "held"), [(9e-3, True), (7.5e-3, False), (11e-3, False)])
def test_a_length_that_no_digits_allow_is_red(l, held):  # noqa: E741
    class Own:
        inputs = PAPER.model_copy(update={"l": l})

    margin, U, _ = length(Own())
    assert (margin > U) is held
