"""A drawn-cup clutch under torque: states, the sweep over the summit, inputs, and faults."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from analytic.bounds.freewheel.cup import Course
from analytic.bounds.freewheel.cup_bracket import expected_approach
from analytic.freewheel import compliance, printed, series
from analytic.freewheel.cam import Cam
from analytic.freewheel.clutch import Clutch, Material, hertz_line
from analytic.freewheel.state import State as Formula
from analytic.freewheel.state import at_normal_force, loaded
from fem.wedge.flat import Sector, State
from fem.wedge.flat_course import FlatCourse
from verify.app.cli import run
from verify.cases.freewheel.bounds import parts
from verify.cases.freewheel.cup import inputs
from verify.cases.freewheel.cup import sweep as freewheel_cup_sweep
from verify.cases.freewheel.cup.case import CUP, FreewheelCup
from verify.cases.freewheel.cup.sweep import ONWARD, SHARES, CupSweep, through
from verify.cases.freewheel.fem import overlapping
from verify.core.case import Context
from verify.core.results import Status
from verify.form import quantity
from verify.jobs.level import Job, judge_case, solve_level

LEVELS = (3, 4, 5)
COARSE = replace(CUP, levels=LEVELS)
Q = FreewheelCup()

pytestmark = pytest.mark.xdist_group("freewheel-cup")


def names(rows):
    return {row.quantity for row in rows}


def forget():
    freewheel_cup_sweep.starts.cache_clear()
    quantity.forget()


def under_torque(q):
    return q.within(q.state)


def solve_anew():
    forget()
    return judge_case(Job(COARSE, Q), [solve_level(COARSE, Q, level, None) for level in LEVELS])


@pytest.fixture
def broken(monkeypatch):
    """Replace an attribute by what `fault` makes of it."""

    def break_(owner, name, fault):
        monkeypatch.setattr(owner, name, fault(owner.__dict__[name]))
        forget()

    yield break_
    monkeypatch.undo()
    forget()


@pytest.fixture
def few(monkeypatch):
    """A sweep of few states."""
    monkeypatch.setattr(freewheel_cup_sweep, "SHARES", (0.05, 0.25, 0.65, 1.04))
    monkeypatch.setattr(freewheel_cup_sweep, "ONWARD", (0.6, 0.69, 0.77))


@cache
def red_without_fault():
    return frozenset(names(r for r in solve_anew().rows if r.status is Status.FAIL))


@pytest.fixture(scope="module")
def state():
    place = overlapping(Q, 10e-6, 17e-6)
    return Sector(place, (83e-6, 91e-6), 4, mu=2 * math.tan(place.psi / 2)).rest()


@pytest.fixture(scope="module")
def sweep():
    return CupSweep(Q, 4)


# The roller's place and state.
def test_a_place_overlaps_by_the_approaches_it_is_made_of():
    place = overlapping(Q, 10e-6, 17e-6)
    assert (place.d_i, place.d_o) == pytest.approx((10e-6, 17e-6), rel=1e-9)
    assert place.psi == pytest.approx(2 * float(Q.cam.alpha(d_i=10e-6, d_o=17e-6)), rel=1e-12)
    x, y = Q.cam.centre(d_i=10e-6, d_o=17e-6)
    assert (place.x, place.y) == pytest.approx((float(x), float(y)), rel=1e-12)


def test_a_place_goes_towards_the_flat_s_middle_as_contacts_overlap_more():
    angles = [overlapping(Q, d, d).psi for d in (0, 1e-5, 3e-5, 0.499999 * through(Q))]
    assert angles == sorted(angles, reverse=True)
    assert angles[-1] < 1e-3 * angles[0] or angles[-1] < 3e-4


def test_a_state_s_roller_neither_creeps_nor_turns(state):
    assert max(map(abs, state.motion)) < 1e-5 * 27e-6


def test_the_moments_of_both_contacts_about_the_axis_are_the_torque(state):
    (N, F_t), (_, F_race) = state.on_flat, state.on_race
    assert min(N, F_t, F_race) > 0
    assert Q.z * Q.R_s * F_race == pytest.approx(state.torque, rel=3e-4)
    assert Q.z * (N * state.place.x - F_t * Q.X_o) == pytest.approx(state.torque, rel=6e-4)
    cup = state.solution.plane.mean_reaction("cup.rim")["r"]
    assert -Q.z * cup == pytest.approx(state.torque, rel=1e-3)


def test_contact_forces_of_a_roller_are_equal_and_opposite(state):
    forces = np.array([touch.force for touch in state.solution.touches])
    assert np.abs(forces.sum(axis=0)).max() < 1e-9 * np.abs(forces).max()


def test_surfaces_drawn_out_of_the_wedge_push_the_roller_out():
    place = overlapping(Q, 10e-6, 17e-6)
    sector = Sector(place, (83e-6, 91e-6), 3, mu=2 * math.tan(place.psi / 2))
    still, drawn = sector.at((0.0, 0.0)), sector.at((5e-7, 5e-7))
    assert drawn.motion[0] > still.motion[0] + 3e-7


# The sweep.
@pytest.mark.slow("the sweep over the torque that the tests of this file read")
def test_the_torque_falls_beyond_its_summit_and_the_normal_force_grows(sweep):
    T, N = sweep.at_states["T"], sweep.at_states["N"]
    top = int(np.argmax(T))
    assert 0 < top < T.size - 1
    assert np.all(np.diff(N) > 0)
    assert np.all(np.diff(T)[:top] > 0)
    assert T[-1] < 0.99 * sweep.summit[1]
    assert np.all(np.diff(sweep.psi) < 0)


def test_the_sweep_reads_its_states_back(sweep):
    T, N = sweep.at_states["T"], sweep.at_states["N"]
    for k in range(1, 6):
        assert sweep.at("N", T[k]) == pytest.approx(N[k], rel=1e-9)
        assert sweep.at("T", T[k]) == pytest.approx(T[k], rel=1e-9)
    assert sweep.at("T", N[-1], "N") == pytest.approx(T[-1], rel=1e-12)


def test_a_sweep_says_nothing_beyond_its_summit_or_below_its_states(sweep):
    for T in (1.01 * sweep.summit[1], 0.5 * sweep.at_states["T"][0]):
        with pytest.raises(ArithmeticError, match="beyond the states"):
            sweep.at("N", T)


def synthetic():
    """The formulas' states where a sweep has its own."""
    sweep, whole = object.__new__(CupSweep), Q.clutch
    v = CUP.analytic(Q)
    under, most = v["d_i"] + v["d_o"], through(Q)
    wanted = [share * under for share in SHARES] + [d * most for d in ONWARD if d > 0.4]
    many = at_normal_force(whole, 1.5 * v["N_max"] * np.linspace(0, 1, 20001)[1:] ** 2)
    N = np.interp(wanted, many.d_i + many.d_o, many.N)
    states = at_normal_force(whole, N)
    P = np.linspace(0, 1, 20001)[:, None] ** 2 * N
    d = compliance.compliance(whole).approaches(P / Q.L)
    U = Q.z * np.trapezoid(P, d.d_i + d.d_o, axis=0)
    sweep.q = Q
    sweep.at_states = {"T": states.T, "N": N, "d_i": states.d_i, "d_o": states.d_o, "U": U}
    sweep.psi = states.psi
    return sweep


def test_splines_over_so_few_states_miss_little_of_the_formulas_course():
    sweep = synthetic()
    v = CUP.analytic(Q)
    assert sweep.at("N", Q.T) == pytest.approx(v["N"], rel=2e-5)
    assert sweep.place(Q.T).psi / 2 == pytest.approx(v["alpha"], rel=2e-5)
    assert sweep.summit[1] == pytest.approx(v["T_max"], rel=2e-5)


def test_energy_and_rolling_agree_about_rollers_that_roll():
    sweep, T = synthetic(), np.array([0.3, 0.7, 1.0]) * Q.T
    phi = loaded(Q.clutch, T).phi
    assert sweep.torsion_by_rolling(T) == pytest.approx(phi, rel=4e-4)
    assert sweep.torsion_by_energy(T) == pytest.approx(phi, rel=4e-4)


# What is expected.
def test_the_course_follows_the_formulas():
    v, course = CUP.analytic(Q), Course(parts(Q), under_torque(Q).approaches, (1.0, 1.0, 1.0))
    own = course.at(Q.T)
    for key in ("N", "alpha", "s", "phi"):
        assert own[key] == pytest.approx(v[key], rel=1e-6)
    assert course.summit == pytest.approx(v["T_max"], rel=1e-6)


def test_a_cup_lies_between_rings_and_the_formula_does():
    P = CUP.analytic(Q)["N"] / Q.L
    low, _, high = expected_approach(parts(Q), P)
    assert low < CUP.analytic(Q)["d_o"] < high < 1.06 * low


def test_intervals_hold_the_formulas_themselves():
    e = under_torque(Q)
    found = [e.under_torque(k) for k in ("N", "alpha", "s")] + [
        e.slope(), e.approach("d_i"), e.approach("d_o"),
        Q.within(Q.loaded_by("N_0").state).torque(), Q.within(Q.at_summit).summit(),
    ]  # fmt: skip
    assert all(low < 0 < high for low, high in found)


def test_more_compliance_costs_more_torque_the_nearer_the_summit_is():
    far = under_torque(Q.at(T=5.0)).under_torque("N")
    near = under_torque(Q.at(T=26.0)).under_torque("N")
    assert near[1] - near[0] > 3 * (far[1] - far[0])


# Inputs.
@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"T": 27.0}, "MPa exceeds the 4000 MPa"),
        ({"R_a": 17e-3, "T": 5.0}, "bends: rings that enclose it"),
        ({"X_o": 12e-3 * math.cos(math.radians(12)) + 2e-3}, "do not grip"),
    ],
)
def test_inputs_near_an_end_of_the_range_are_warned_of(change, words):
    q = FreewheelCup(**change)
    assert any(words in told for told in CUP.warnings(q, CUP.analytic(q)))
    assert not CUP.warnings(Q, CUP.analytic(Q))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"T": 29.0}, "of the largest torque 30.04 N m"),
        ({"T": 0.1}, "of the largest torque 30.04 N m"),
        ({"X_o": 12e-3 * math.cos(math.radians(18)) + 2e-3, "T": 90.0}, "r wide at the largest"),
    ],
)
def test_what_finite_elements_cannot_do_is_said_beforehand(change, words):
    reason = CUP.too_large(FreewheelCup(**change))
    assert words in reason
    assert "check it without --fem" in reason
    assert not CUP.too_large(Q)


BASE = {
    "R_s": "10 mm", "r": "2 mm", "X_o": "13.910554 mm", "R_a": "30 mm", "r_b": "4 mm", "z": 8,
    "L": "10 mm", "T": "18 N m", "E": "206 GPa", "nu": 0.3,
}  # fmt: skip


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"R_s": "-1 mm"}, "inputs.R_s"),
        ({"R_s": "10"}, "inputs.R_s"),
        ({"R_s": "14 mm"}, "flat cuts the shaft"),
        ({"R_s": "9 mm"}, "no wedge"),
        ({"r": "1.9 mm"}, "no wedge"),
        ({"r": "5 mm"}, "corner"),
        ({"X_o": "14.1 mm"}, "no wedge"),
        ({"X_o": "12.2 mm", "z": 4}, "is beyond friction"),
        ({"R_a": "15 mm"}, "the cup needs a wall"),
        ({"r_b": "10 mm"}, "the shaft needs a wall"),
        ({"r_b": "0 mm"}, "inputs.r_b"),
        ({"z": 2}, "inputs.z"),
        ({"z": 40}, "rollers"),
        ({"L": "0 mm"}, "inputs.L"),
        ({"T": "-18 N m"}, "inputs.T"),
        ({"T": "31 N m"}, "more than the largest torque, 30.041 N m"),
        ({"E": "0 GPa"}, "inputs.E"),
        ({"nu": 0.5}, "inputs.nu"),
        ({"R": "10 mm"}, "R"),
    ],
)
def test_wrong_inputs_end_in_one_line(change, words, tmp_path, capsys):
    lines = [f"{k} = {v!r}".replace("'", '"') for k, v in (BASE | change).items()]
    path = tmp_path / "own.toml"
    path.write_text("\n".join(['case = "freewheel-cup"', "[inputs]", *lines]), "utf-8")
    assert run(["check", str(path)]) == 2
    told = capsys.readouterr()
    assert words in told.err
    assert len(told.err.strip().splitlines()) == 1
    assert not told.out


# Judging.
def test_no_row_is_red_on_the_case_s_inputs(judged, red):
    assert not red(judged(CUP))


def test_every_row_finds_what_it_compares(judged):
    result = judged(CUP)
    assert len({row.id for row in result.rows}) == len(result.rows)
    v = CUP.analytic(Q)
    for output in CUP.outputs:
        assert math.isfinite(v[output.key])
    context = Context(CUP.id, Q, v, (), is_paper=True)
    told = [r.id for c in CUP.checks for r in
            (c.skipped(CUP.id, "") if c.needs_fem else c.rows(context))]  # fmt: skip
    assert set(told) <= {row.id for row in result.rows}
    assert CUP.equations(Q, v)
    assert CUP.sketch(Q)


ANGLE, FORCE = "clamping angle under torque (Eq. 5 for a cup)", (
    "normal force under torque (Eqs. 2, 3)")  # fmt: skip
SLOPE, WAY = "F_t/F_n, mean of both contacts (Eqs. 1, 2)", "way of the rollers (Eq. 6)"
TORSION = "torsion by exact rolling, against ∫dU/T (Eq. 7, corrected)"
PRINTED_7 = "torsion, Eq. 7 as printed, with R_s and X_o, against ∫dU/T"
NO_LOAD = "F_t/F_n becomes tan α_0 without load (Eq. 4 for a cup)"
AT_N = ", at N = T/(z R_s tan α_0)"
D_I, D_O = f"approach of roller and shaft{AT_N}", f"approach of roller and cup{AT_N}"
A_I, P_O = f"half-width on the shaft{AT_N}", f"peak pressure on the cup{AT_N}"
T_AT_N = f"torque z R_s F_t (Eq. 3 for a cup){AT_N}"
SUMMIT = "largest torque, before the rollers go through"
ON_RACE = "torque against z R_s F_t of the shaft (Eq. 3 for a cup)"
ROLLS = "∫dU/T against rolling"


def scaled(factor):
    return lambda right: lambda *a, **k: factor * np.asarray(right(*a, **k))


def softer(factor):
    def fault(right):
        def wrong(clutch):
            body = right(clutch)
            return replace(body, E=body.E / factor)

        return wrong

    return fault


READINGS = [
    pytest.param(Cam, "alpha", scaled(2), ANGLE, id="psi for alpha"),
    pytest.param(Cam, "alpha", scaled(2), NO_LOAD, id="psi for alpha, without load"),
    pytest.param(inputs, "loaded", lambda right: lambda whole, T: right(whole, 1.1 * T), FORCE,
                 id="another torque"),
    pytest.param(Cam, "torque_on_race", lambda _: lambda self, *, F_t: (
        self.count * self.flat * F_t), T_AT_N, id="X_o for R_s"),
    pytest.param(Cam, "arc", scaled(0.5), WAY, id="way of alpha instead of 2 alpha"),
    pytest.param(Cam, "alpha", lambda right: lambda self, *, d_i, d_o: right(
        self, d_i=-np.asarray(d_i), d_o=-np.asarray(d_o)), ANGLE, id="load widens the angle"),
    pytest.param(Cam, "alpha", lambda right: lambda self, *, d_i, d_o: right(
        self, d_i=d_i, d_o=0 * np.asarray(d_o)), T_AT_N, id="the cup's approach left out"),
    pytest.param(Clutch, "half_widths", lambda right: lambda self, P: right(self, P)[::-1], A_I,
                 id="flat and shaft interchanged"),
    pytest.param(hertz_line, "relative_radius", lambda right: lambda *, R_1, R_2: right(
        R_1=R_1, R_2=-R_2), A_I, id="shaft taken for a bore"),
    pytest.param(Clutch, "pressures", lambda right: lambda self, P: tuple(
        np.pi / 4 * p for p in right(self, P)), P_O, id="mean pressure for its peak"),
    pytest.param(Material, "plane", lambda _: property(lambda self: (
        np.asarray(self.E, float), np.asarray(self.nu, float))), D_I, id="1 - nu² dropped"),
    pytest.param(compliance, "ROLLER", lambda _: -1.0, D_I, id="half a roller without its k"),
    pytest.param(compliance, "ROLLER", lambda _: -1.0, SUMMIT, id="the same, at the summit"),
    pytest.param(compliance, "_cup", softer(1.15), D_O, id="cup 15 % too soft"),
    pytest.param(series, "race_constant", scaled(0.9), D_I, id="shaft's constant 10 % too small"),
    pytest.param(Formula, "phi", lambda _: property(lambda self: self.s / Q.R_s), TORSION,
                 id="the shaft's part alone in Eq. 7"),
    pytest.param(Formula, "phi", lambda right: property(lambda self: 0.96 * (
        2 * self.s / Q.R_s)), TORSION, id="4 % less than Eq. 7"),
    pytest.param(printed, "torsion", lambda _: lambda cam, **d: 2 * cam.arc(**d) / cam.race,
                 PRINTED_7, id="Eq. 7 corrected where the printed one is told"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), READINGS)
def test_another_reading_or_a_wrong_formula_turns_a_row_red(
    owner, name, fault, row, broken, judged, without_fault, red
):
    without_fault(CUP)
    broken(owner, name, fault)
    assert row in names(red(judged(CUP, drawn=False)))


def test_sin_for_tan_is_within_what_is_expected_but_not_a_per_cent(judged, red, monkeypatch):
    before = CUP.analytic(Q)
    for factor, seen in ((1.002, False), (1.01, True)):
        wrong = before | {"mu_T": factor * before["mu_T"]}
        case = replace(CUP, analytic=lambda _q, wrong=wrong: wrong)
        assert (SLOPE in names(red(judged(case)))) is seen


def mirrored(right):
    return property(lambda self: (right.fget(self)[0], -right.fget(self)[1]))


FAULTS = [
    pytest.param(State, "torque", lambda right: property(
        lambda self: right.fget(self) * (Q.z - 1) / Q.z), ON_RACE, id="one roller too few"),
    pytest.param(State, "on_race", mirrored, ON_RACE, id="the friction's sign"),
    pytest.param(CupSweep, "torsion_by_energy", lambda _: lambda self, T: 0.95 * (
        FlatCourse.torsion_by_energy(self, T)), ROLLS, id="energy 5 % too little"),
]  # fmt: skip


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(("owner", "name", "fault", "row"), FAULTS)
def test_wrong_finite_elements_turn_a_row_red(owner, name, fault, row, broken, few, monkeypatch):
    assert row not in red_without_fault()
    if name not in owner.__dict__:
        monkeypatch.setattr(owner, name, None, raising=False)
    broken(owner, name, fault)
    assert row in names(r for r in solve_anew().rows if r.status is Status.FAIL)
