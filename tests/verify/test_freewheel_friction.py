"""A freewheel's friction: its states and inputs, and that every fault turns a row red."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from analytic.freewheel import criterion
from analytic.freewheel.geometry import Cam
from fem.contact import interface
from fem.wedge import pulled as model
from fem.wedge import sliding
from fem.wedge.slip_limit import Limit
from verify.cases.freewheel.friction import reference as fem
from verify.cases.freewheel.friction.case import FRICTION, FreewheelFriction
from verify.cases.freewheel.pulled_sector import one_pulled
from verify.cases.freewheel.star import Star
from verify.cases.freewheel.sweep import Sweep
from verify.core.results import Status
from verify.jobs.level import Job, judge_case, solve_level

LEVELS = (3, 4, 5)
COARSE = replace(FRICTION, levels=LEVELS)
STEEP = math.radians(5)  # a clamping angle that friction of 0.08 does not bear

ONE = one_pulled(FreewheelFriction())

pytestmark = pytest.mark.xdist_group("freewheel-friction")


def names(rows):
    return {row.quantity for row in rows}


def solve_anew():
    model.wedged.cache_clear()
    q = FreewheelFriction()
    return judge_case(Job(COARSE, q), [solve_level(COARSE, q, level, None) for level in LEVELS])


@pytest.fixture
def coarse(monkeypatch):
    """The finest of the coarse levels stands for the finest."""
    monkeypatch.setattr(fem, "LEVELS", LEVELS)


@cache
def red_without_fault():
    return frozenset(names(r for r in solve_anew().rows if r.status is Status.FAIL))


@pytest.fixture
def broken(monkeypatch):
    def break_(owner, name, fault):
        monkeypatch.setattr(owner, name, fault(getattr(owner, name)))

    yield break_
    model.wedged.cache_clear()


@pytest.fixture(scope="module")
def start():
    return model.at_torque(ONE, 4)


def driven(start, mu=0.08):
    there = model.sector(ONE.q, start, 4, mu, driven=True)
    return there, there.rest(start.drags)


# States of the clutch.
def test_a_clutch_whose_friction_is_too_low_slips_and_does_not_fail(start):
    limit = Limit(ONE, start, start.drags)
    assert limit.slipping(0.9 * limit.tan).tolist() == [1.0, 1.0]
    assert limit.slipping(2.0 * limit.tan).max() < 0.5


def test_friction_and_the_sweep_over_the_torque_read_the_same_forces(start):
    q = FreewheelFriction()
    rest, _ = fem.under_load(ONE, start, 4)
    sweep, T, borne = Sweep(q, 4), rest.torque * q.L, model.Borne.by(rest)
    shares = [sweep.share(T, where) for where in ("", " race")]
    assert pytest.approx(np.mean(shares), rel=1e-4) == borne.tangent
    assert pytest.approx(sweep.at("N", T), rel=1e-4) == borne.N.mean() * q.L
    assert borne.tangent == pytest.approx(math.tan(rest.place.psi / 2), rel=2e-6)


def test_a_pull_within_the_cone_leaves_torque_and_normal_force(start):
    q = FreewheelFriction()
    there = model.sector(ONE.q, start, 4, 0.2, driven=False)
    rest = there.rest(start.drags)
    before, after = model.Borne.by(rest), model.Borne.by(model.pulled(ONE, there, rest))
    assert pytest.approx(before.N, rel=1e-4) == after.N
    assert after.F_t == pytest.approx(before.F_t, rel=1e-4)
    pull = q.F_ax * rest.torque / (q.z * q.T)
    assert after.F_z == pytest.approx([pull, -pull], rel=1e-9)


def test_a_pull_beyond_the_cone_finds_no_rest(start):
    q = FreewheelFriction()
    there = model.sector(ONE.q, start, 4, q.mu, driven=False)
    rest = there.rest(start.drags)
    force = {"ring.rim": 1.05 * FRICTION.analytic(q)["F_lim"] / (q.z * q.L)}
    with pytest.raises(ArithmeticError):
        there.at(rest.drags, after=rest.solution, axial_forces=force)


def test_a_ring_held_about_the_axis_lets_rollers_out_where_one_driven_on_keeps_them(start):
    there, rest = driven(start)
    path = {"ring.rim": 20e-6}
    held = there.at(rest.drags, after=rest.solution, axial_displacements={"ring.rim": 3e-6})
    held = there.at(rest.drags, after=held.solution, axial_displacements=path)
    assert held.torque < 0.95 * rest.torque
    out, _ = held.motion
    assert out < -5e-6
    kept = model.creeping(there, rest, axial_displacements={"ring.rim": 2e-6})
    assert kept.torque == pytest.approx(rest.torque, rel=3e-3)
    assert kept.drags[1] > rest.drags[1]


def test_slip_of_a_held_ring_costs_approach_as_coulombs_law_has_it(start):
    q = FreewheelFriction()
    there, rest = driven(start)
    first = there.at(rest.drags, after=rest.solution, axial_displacements={"ring.rim": 5e-6})
    second = there.at(rest.drags, after=first.solution, axial_displacements={"ring.rim": 8e-6})
    lost = sum(getattr(first.place, d) - getattr(second.place, d) for d in ("d_i", "d_o"))
    tan = math.tan(rest.start.psi / 2)
    assert lost / 3e-6 == pytest.approx(tan / math.sqrt((q.mu / tan) ** 2 - 1), rel=0.02)


def test_the_torque_that_is_left_falls_to_nothing_over_the_axial_slip():
    slip, torque = FreewheelFriction().slipped()
    assert (slip[-1], torque[-1]) == (0.0, 1.0)
    assert FRICTION.analytic(FreewheelFriction())["u_out"] == pytest.approx(slip[0])


def test_no_limit_is_found_in_a_bracket_on_one_side_of_it():
    value, _ = Limit._bisected(lambda _: True, 0.9, 1.1, 2)
    assert math.isnan(value)


# Inputs.
def test_a_torque_that_lets_rollers_out_is_said_to_and_not_solved():
    q = FreewheelFriction(X=14e-3 * math.cos(2 * STEEP) - 2.5e-3)
    v = FRICTION.analytic(q)
    assert "F_lim" not in v
    assert "the torque alone lets the rollers out" in " ".join(FRICTION.warnings(q, v))
    assert "check it without --fem" in FRICTION.too_large(q)
    assert FRICTION.equations(q, v)
    assert FRICTION.sketch(q)
    assert not FRICTION.too_large(FreewheelFriction())


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({"F_ax": 1.1e3}, "yellow: the clutch slips along its axis; it bears F_ax = 100"),
        ({"F_ax": 2.5e3}, "red: the clutch slips"),
        ({"F_ax": 16e3, "mu": 1}, "one end lifts off"),
    ],
)
def test_inputs_that_slip_or_tilt_are_warned_of(change, word):
    q = FreewheelFriction(**change)
    assert word in " ".join(FRICTION.warnings(q, FRICTION.analytic(q)))
    assert not FRICTION.warnings(FreewheelFriction(), FRICTION.analytic(FreewheelFriction()))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"F_ax": -1.0}, "greater than or equal to 0"),
        ({"mu": 0.0}, "greater than or equal to 0.01"),
        ({"X": 11.6e-3}, "no wedge"),
    ],
)
def test_what_is_no_loaded_clutch_is_refused(change, words):
    with pytest.raises(ValueError, match=words):
        FreewheelFriction(**change)


def test_more_torque_than_hertz_knows_is_refused_in_a_line():
    with pytest.raises(ValueError, match="wider than half the rollers"):
        FRICTION.analytic(FreewheelFriction(T=1e6))


# Judging.
def test_no_row_is_red_on_the_case_s_inputs(judged, red):
    assert not red(judged(FRICTION))


FORCE, AXIAL = "tangential force of a roller (Eq. 3, corrected)", "axial force of a roller, F_ax/z"
ALONE, BOTH = "required friction, torque alone (Eqs. 1, 2)", "required friction (Eqs. 8, 9)"
LIMIT = "limit of the axial load (Eq. 9)"
ONSET = "torque alone: friction at which all slips (Eq. 1)"
AXIAL_ONSET = "friction below which the axial load finds no rest (Eqs. 8-10)"
ON_RING = "required friction on the ring, at its own angle (Eqs. 8, 9)"
ANGLES = "wedge angles: held below tan α = μ, let out above"
CREEP = "creep of the ring that slips along the axis, F_t/F_a"
PRINTED = "required friction, Eq. 8 with the F_ax of Eq. 9 (as printed)"
TANGENTS = "tan α, Eq. 8 as printed"


def changed(**factors):
    """The same formula with some arguments multiplied."""
    return lambda right: lambda **k: right(**{key: factors.get(key, 1) * v for key, v in k.items()})


def scaled(factor):
    return lambda right: lambda *a, **k: factor * right(*a, **k)


READINGS = [
    pytest.param(criterion, "required_friction", changed(alpha=2), BOTH, id="alpha is the wedge's"),
    pytest.param(criterion, "required_friction", changed(alpha=2), ALONE, id="the same in Eq. 1"),
    pytest.param(criterion, "required_friction", changed(alpha=2), ONSET, id="the same at slip"),
    pytest.param(criterion, "required_friction", changed(alpha=2), ANGLES, id="in the sweep"),
    pytest.param(criterion, "required_friction", changed(F_ax=8), BOTH, id="F_ax of each roller"),
    pytest.param(criterion, "required_friction", changed(F_ax=8), ON_RING,
                 id="F_ax of each roller, at the contact"),
    pytest.param(criterion, "required_friction", changed(F_ax=1 / 8), AXIAL_ONSET,
                 id="an eighth of F_ax"),
    pytest.param(criterion, "required_friction", changed(R=11.39565 / 16.5), BOTH,
                 id="the star's lever X"),
    pytest.param(criterion, "required_friction", lambda _: lambda *, alpha, T, F_ax, R: (
        np.sin(alpha) * np.hypot(1, F_ax * R / T)), ALONE, id="sin for tan"),
    pytest.param(criterion, "required_friction", lambda _: lambda *, alpha, T, F_ax, R: (
        np.tan(alpha) * (1 + F_ax * R / T)), BOTH, id="friction adds up without right angles"),
    pytest.param(criterion, "required_friction", lambda _: lambda *, alpha, T, F_ax, R: (
        np.tan(alpha)), TANGENTS, id="Eq. 8 is tan alpha"),
    pytest.param(criterion, "required_friction_of_contact", changed(F_a=1 / 8), PRINTED,
                 id="F_ax/z where it prints F_ax"),
    pytest.param(criterion, "largest_axial_load", changed(R=11.39565 / 16.5), LIMIT,
                 id="the star's lever X in the limit"),
    pytest.param(criterion, "largest_axial_load", scaled(1 / 8), LIMIT, id="limit of one roller"),
    pytest.param(criterion, "largest_axial_load", lambda _: lambda *, alpha, T, R, mu: (
        T / R * (mu / np.tan(alpha) - 1)), LIMIT, id="no root in the limit"),
    pytest.param(criterion, "largest_axial_load", scaled(1.03), CREEP, id="limit 3 % too large"),
    pytest.param(criterion, "self_releasing", lambda _: lambda *, alpha, mu: np.tan(2 * alpha) > mu,
                 ANGLES, id="half the wedge's limit"),
    pytest.param(Cam, "torque_on_race", lambda _: lambda self, *, F_t: self.count * self.flat * F_t,
                 FORCE, id="T = z X F_t, Eq. 3 as printed"),
    pytest.param(Cam, "torque_on_race", lambda _: lambda self, *, F_t: self.race * F_t, FORCE,
                 id="T of one roller"),
    pytest.param(Star, "under", lambda right: lambda q, T: right(
        q, T / 2), ALONE, id="angle of half the torque"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), READINGS)
def test_another_reading_or_a_wrong_formula_turns_a_row_red(
    owner, name, fault, row, broken, judged, red
):
    right = judged(FRICTION)
    broken(owner, name, fault)
    assert row in names(red(judged(FRICTION))) - names(red(right))


def rough(factor):
    def fault(right):
        return lambda **k: right(**k | {"friction": factor * k["friction"]})

    return fault


def without_z(right):
    return lambda state: replace(right(state), F_z=0 * right(state).F_z)


FEM_FAULTS = [
    pytest.param(interface, "Complementarity", rough(1.01), ONSET, id="friction 1 % too large"),
    pytest.param(model.Borne, "by", without_z, BOTH, id="the pull along z is not read"),
    pytest.param(sliding, "pulled", lambda right: lambda one, there, rest: right(
        replace(one, F_ax=one.q.z * one.F_ax), there, rest), AXIAL,
        id="the whole load on one pitch"),
    pytest.param(sliding, "creeping", lambda _: lambda there, state, **along: (
        there.at(state.drags, after=state.solution, **along)), CREEP, id="the ring is held"),
]  # fmt: skip


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(("owner", "name", "fault", "row"), FEM_FAULTS)
def test_wrong_finite_elements_turn_a_row_red(owner, name, fault, row, coarse, broken, red):
    before = red_without_fault()
    broken(owner, name, fault)
    assert row in names(red(solve_anew())) - before
