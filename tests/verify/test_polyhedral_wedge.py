"""The wedged roller: its signs and states, its inputs, and that every fault turns a row red."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from analytic.contact import partial_slip
from analytic.polyhedral import wedging
from fem.contact import active_sets, interface, wedged, wedged_states
from fem.contact.friction_lcp import FrictionLcp
from fem.contact.wedged import Geometry, Wedge
from verify.cases.polyhedral.wedge import reference as fem
from verify.cases.polyhedral.wedge.case import WEDGE, WedgedRoller
from verify.cases.polyhedral.wedge.limit import least_fem
from verify.cases.polyhedral.wedge.mesh import fem_mesh
from verify.core.results import Status
from verify.jobs.level import Job, judge_case, solve_level

LEVELS = (8, 10, 12)
COARSE = replace(WEDGE, levels=LEVELS)
OUT = math.radians(12)  # a wedge angle that friction of 0.08 does not bear

pytestmark = pytest.mark.xdist_group("polyhedral-wedge")


def names(rows):
    return {row.quantity for row in rows}


def solve_anew():
    q = WedgedRoller()
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

    return break_


def wedge(q, *, cells=6, mu=None, **more):
    geometry = Geometry(q.R, q.half, q.a)
    return Wedge(geometry, fem_mesh(geometry, cells), E=q.E, nu=q.nu, mu=mu or q.mu, **more)


# States of the roller.
@pytest.mark.parametrize(("alpha", "mu"), [(6, 0.08), (6, 0.5), (1.5, 0.02), (25, 0.3)])
def test_friction_on_a_free_roller_does_not_depend_on_how_much_there_could_be(alpha, mu):
    q = WedgedRoller(alpha=math.radians(alpha), mu=mu)
    free = wedge(q)
    state, _ = free.pressed(q.line_load)
    N, T = free.forces(state)
    assert q.line_load == pytest.approx(N, rel=1e-11)
    assert math.tan(q.half) == pytest.approx(T / N, rel=1e-8)


def test_the_roller_leaves_to_the_wide_end_where_friction_is_too_low():
    q = WedgedRoller()
    free = wedge(q)
    _, down = free.pressed(q.line_load)
    slippery = wedge(q, mu=0.5 * math.tan(q.half))
    gone = slippery.at(down)
    assert slippery.forces(gone)[0] < 1e-6 * q.line_load
    x, _ = gone.plane.displacement_at((0.0, 0.0))
    assert x < -0.5 * down / math.tan(q.half)


def test_a_push_into_the_wedge_takes_load_off_friction():
    q = WedgedRoller()
    free = wedge(q)
    state, _ = free.pressed(q.line_load, push=q.line_load * math.sin(q.half))
    N, T = free.forces(state)
    assert abs(T) < 1e-8 * N


def test_what_slides_into_the_wedge_is_held_back_by_the_cage():
    q = WedgedRoller()
    found = fem.held_back(q, wedge(q, caged=True))
    expected = 2 * q.N * (q.mu * math.cos(q.half) - math.sin(q.half))
    assert found["C"] == pytest.approx(expected, rel=1e-9)
    assert expected > 0


def test_no_limit_is_found_in_a_bracket_on_one_side_of_it():
    q = WedgedRoller()
    _, down = wedge(q).pressed(q.line_load)
    value, _ = least_fem(q, down, 1.01 * math.tan(q.half))
    assert math.isnan(value)


# Inputs.
def test_a_roller_that_is_squeezed_out_is_said_to_be_and_not_solved():
    q = WedgedRoller(alpha=OUT)
    v = WEDGE.analytic(q)
    assert "M_free" not in v
    assert "T" not in v
    assert v["C"] < 0
    assert "squeezed out of the wedge" in " ".join(WEDGE.warnings(q, v))
    assert "no equilibrium to compute; check it without --fem" in q.refusal()
    assert WEDGE.equations(q, v)
    assert not WedgedRoller().refusal()


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({"alpha": math.radians(9)}, "friction a tenth lower"),
        ({"N": 3e5}, "give p_lim"),
        ({"p_lim": 5e8}, "exceeds p_lim = 500 MPa"),
    ],
)
def test_inputs_near_an_end_of_the_range_are_warned_of(change, word):
    q = WedgedRoller(**change)
    assert word in " ".join(WEDGE.warnings(q, WEDGE.analytic(q)))
    assert not WEDGE.warnings(WedgedRoller(), {})


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"N": 1e8}, r"a/R of at most 0.15, got a/R = .* N = 1e\+08 N on b = 30 mm"),
        ({"D_i": 0.015}, "D_i > 2 d, got D_i = 15 mm, d = 10 mm"),
        ({"alpha": 1.0}, "less than or equal"),
        ({"mu": 0.7}, "less than or equal"),
    ],
)
def test_what_is_no_wedged_roller_is_refused(change, words):
    with pytest.raises(ValueError, match=words):
        WedgedRoller(**change)


# Judging.
def test_no_row_is_red_on_the_case_s_inputs(judged, red):
    assert not red(judged(WEDGE))


FREE, CAGED = "torque of free rollers (Eq. 3, corrected)", "torque of caged rollers (Eq. 3)"
FORCE, CAGE = "friction force of a free roller", "cage force (Eq. 1)"
LEAST = "least friction of a free roller (Eq. 2)"
READINGS = [
    pytest.param(wedging, "_wedge", lambda f: lambda alpha: 2 * f(alpha), FORCE,
                 id="alpha is the half angle"),
    pytest.param(wedging, "_wedge", lambda f: lambda alpha: 2 * f(alpha), CAGE,
                 id="alpha is the half angle, Eq. 1"),
    pytest.param(wedging, "_wedge", lambda f: lambda alpha: 2 * f(alpha),
                 "T/(μN) over wedge angles, to the limit and beyond",
                 id="alpha is the half angle, Eq. 2"),
    pytest.param(wedging, "_lever", lambda f: lambda z, D_i: 2 * f(z, D_i), FREE,
                 id="D_i is a radius"),
    pytest.param(wedging, "_lever", lambda f: lambda z, D_i: f(1, D_i), CAGED, id="one roller"),
    pytest.param(wedging, "tangential_force", lambda _: lambda *, N, alpha: N * np.sin(alpha / 2),
                 FORCE, id="sin for tan"),
    pytest.param(wedging, "tangential_force", lambda _: lambda *, N, alpha: 0.08 * N, FREE,
                 id="mu N for a free roller"),
    pytest.param(wedging, "cage_force", lambda f: lambda **k: f(**k) / 2, CAGE,
                 id="cage force of one contact"),
    pytest.param(wedging, "cage_force", lambda _: lambda *, N, alpha, mu: 2 * N * (
        mu * np.cos(alpha / 2) + np.sin(alpha / 2)), LEAST, id="normal forces pull in"),
    pytest.param(wedging, "cage_force", lambda _: lambda *, N, alpha, mu: 2 * N * (
        mu - np.sin(alpha / 2)), LEAST, id="cos of alpha/2 dropped"),
    pytest.param(wedging, "largest_torque", lambda f: lambda **k: f(**k) * 1.001,
                 "torque of free rollers, Eq. 3 as printed", id="Eq. 3 a thousandth larger"),
    pytest.param(wedging, "least_normal_force", lambda _: lambda *, M_t, mu, z, D_i: M_t / (
        z * D_i / 2 * math.tan(WedgedRoller().half)),
                 "normal force per torque, caged (Eq. 4)", id="a free roller's force in Eq. 4"),
    pytest.param(wedging, "normal_force", lambda f: lambda **k: f(**k) * 0.99999,
                 "normal force per torque, free (Eq. 5, corrected)", id="< in Eq. 5"),
    pytest.param(partial_slip, "stick_half_width", lambda _: lambda *, Q, P, mu, a: a * (
        1 - Q / (mu * P)), "stick half-width of a roller let go, T/(μN) = 0.4",
                 id="c/a = 1 - T/(mu N)"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), READINGS)
def test_another_reading_or_a_wrong_formula_turns_a_row_red(
    owner, name, fault, row, broken, judged, red
):
    right = judged(WEDGE)
    broken(owner, name, fault)
    assert row in names(red(judged(WEDGE))) - names(red(right))


def rough(factor):
    def fault(right):
        return lambda **k: right(**k | {"friction": factor * k["friction"]})

    return fault


FEM_FAULTS = [
    pytest.param(interface, "Complementarity", rough(1.001), CAGED, id="friction 0.1 % too large"),
    pytest.param(wedged.Wedge, "forces", lambda f: lambda self, state: tuple(
        2 * np.array(f(self, state))), CAGE, id="forces of both contacts"),
    pytest.param(wedged.Geometry, "normal", lambda _: property(
        lambda self: np.array([math.sin(2 * self.half), math.cos(2 * self.half)])), FORCE,
        id="the flat at the full angle"),
    pytest.param(wedged_states, "share_stuck", lambda f: lambda touch: f(touch) + 0.004,
                 "stick half-width of a roller let go, T/(μN) = 0.8", id="moments read wrongly"),
]  # fmt: skip


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(("owner", "name", "fault", "row"), FEM_FAULTS)
def test_wrong_finite_elements_turn_a_row_red(owner, name, fault, row, coarse, broken, red):
    before = red_without_fault()
    broken(owner, name, fault)
    assert row in names(red(solve_anew())) - before


def test_friction_that_drives_finds_no_equilibrium(broken):
    q = WedgedRoller()
    broken(active_sets, "SIGN", lambda right: -right)
    broken(FrictionLcp, "candidates", lambda _: lambda _self: iter(()))
    with pytest.raises(ArithmeticError):
        fem.held_back(q, wedge(q, caged=True))
