"""A freewheel under torque: states, sweep, inputs, and that every fault turns a row red."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from analytic.freewheel import compliance, printed, series
from analytic.freewheel.cam import Cam
from analytic.freewheel.clutch import Clutch, Material, hertz_line
from analytic.freewheel.rolling import torsion
from analytic.freewheel.state import State as Formula
from fem.plane.material import Elastic
from fem.wedge import flat_start, rest
from fem.wedge.flat import Sector, State
from tests.conftest import solved
from verify.app.cli import run
from verify.cases.freewheel import star
from verify.cases.freewheel import sweep as freewheel_sweep
from verify.cases.freewheel.bounds import of_star
from verify.cases.freewheel.fem import overlapping
from verify.cases.freewheel.sweep import Sweep, rigid_force
from verify.cases.freewheel.torque.case import TORQUE, FreewheelTorque
from verify.core.case import Context
from verify.core.results import Status
from verify.form import quantity
from verify.jobs.level import Job, judge_case, solve_level

LEVELS = (3, 4, 5)
FEW = (0.05, 0.3, 0.7, 1.06)  # of the overlap, enough of the states to see what is wrong
COARSE = replace(TORQUE, levels=LEVELS)
Q = FreewheelTorque()

pytestmark = pytest.mark.xdist_group("freewheel-torque")


def names(rows):
    return {row.quantity for row in rows}


def forget():
    freewheel_sweep.starts.cache_clear()
    quantity.forget()


def under_torque(q):
    return of_star(q, q.state)


def under_force(q):
    return of_star(q, q.loaded_by("N_0").state)


def solve_anew():
    forget()
    return judge_case(Job(COARSE, Q), [solve_level(COARSE, Q, level, None) for level in LEVELS])


@pytest.fixture
def broken(monkeypatch):
    """Replace an attribute by what `fault` makes of it."""

    def break_(owner, name, fault):
        right = owner.__dict__[name]
        monkeypatch.setattr(owner, name, fault(right))
        forget()

    yield break_
    monkeypatch.undo()
    forget()


@pytest.fixture
def few(monkeypatch):
    """A sweep of few states."""
    monkeypatch.setattr(freewheel_sweep, "SHARES", FEW)


@cache
def red_without_fault():
    return frozenset(names(r for r in solve_anew().rows if r.status is Status.FAIL))


def off_x(alpha):
    """Distance of flats [m] that makes the angle `alpha` [deg] with the reference's R and r."""
    return (Q.R - Q.r) * math.cos(2 * math.radians(alpha)) - Q.r


def at_rest(q=Q, d=(8e-6, 17e-6), widths=(95e-6, 103e-6), cells=3):
    place = overlapping(q, *d)
    return Sector(place, widths, cells, mu=2 * math.tan(place.psi / 2)).rest()


@pytest.fixture(scope="module")
def state():
    return at_rest()


# The roller's place.
def test_a_place_overlaps_by_the_approaches_it_is_made_of():
    place = overlapping(Q, 8e-6, 17e-6)
    assert (place.d_i, place.d_o) == pytest.approx((8e-6, 17e-6), rel=1e-9)
    assert place.psi == pytest.approx(2 * float(Q.cam.alpha(d_i=8e-6, d_o=17e-6)), rel=1e-12)
    x, y = Q.cam.centre(d_i=8e-6, d_o=17e-6)
    assert (place.x, place.y) == pytest.approx((float(x), float(y)), rel=1e-12)


def test_a_place_without_overlap_stands_at_the_rigid_angle():
    assert overlapping(Q, 0.0, 0.0).psi == pytest.approx(2 * float(Q.cam.alpha0), rel=1e-12)


# A state.
def test_a_state_s_roller_neither_creeps_nor_turns(state):
    most = rest.STILL * (state.place.d_i + state.place.d_o)
    assert max(map(abs, state.motion)) <= most
    assert max(map(abs, state.drags)) > 100 * most


def test_contact_forces_of_a_roller_are_equal_and_opposite(state):
    inner, outer = (np.array(touch.force) for touch in state.solution.touches)
    assert np.abs(inner + outer).max() < 1e-9 * np.abs(inner).max()


def test_the_moments_of_both_contacts_about_the_axis_are_the_torque(state):
    N, F_t = state.on_flat
    _, on_race = state.on_race
    star = Q.z * (N * state.place.x - F_t * Q.X)
    race = Q.z * Q.R * on_race
    assert star == pytest.approx(state.torque, rel=1e-3)
    assert race == pytest.approx(state.torque, rel=1e-3)


def test_the_contact_pulls_the_roller_out_as_far_as_friction_pulls_it_in(state):
    N, F_t = state.on_flat
    assert F_t / N == pytest.approx(math.tan(state.place.psi / 2), rel=2e-3)


def test_star_and_ring_turned_alike_turn_the_state_and_nothing_else(state):
    angle = 1e-4
    both = state.drags[0] + angle * Q.X, state.drags[1] + angle * Q.R
    start = state.start
    sector = Sector(start, (95e-6, 103e-6), 3, mu=2 * math.tan(start.psi / 2))
    turned = sector.at(both)
    assert turned.torque == pytest.approx(state.torque, rel=1e-4)
    for now, before in zip(turned.solution.touches, state.solution.touches, strict=True):
        assert now.force == pytest.approx(before.force, rel=1e-4)
    assert turned.tilt == pytest.approx(state.tilt + angle, rel=1e-9)
    assert turned.place.psi == pytest.approx(state.place.psi, rel=1e-4)


def test_a_roller_that_is_not_steered_bears_its_forces_beside_its_contacts(state):
    sector = Sector(state.start, (95e-6, 103e-6), 3, mu=2 * math.tan(state.start.psi / 2))
    left = sector.at((0.0, 0.0))
    off = [
        abs(s.on_race[1] * Q.z * Q.R / s.torque - 1) for s in (state, left)
    ]  # no row is as sharp as this
    assert off[1] > 2 * off[0]


# The sweep.
@pytest.fixture(scope="module")
def sweep():
    return Sweep(Q, 3)


def synthetic(way):
    """A sweep of nine states whose quantities follow `way(N)`, without finite elements."""
    made = object.__new__(Sweep)
    made.q = Q
    made.at_states = way(np.geomspace(20.0, 4000.0, 9))
    return made


def along_powers(N):
    """Approaches c N^0.95, at which T dphi = z N (dd_i + dd_o) of rolling and nothing else."""
    d_i, d_o = 3e-9 * N**0.95, 7e-9 * N**0.95
    tan = np.tan(
        np.array([float(Q.cam.alpha(d_i=a, d_o=b)) for a, b in zip(d_i, d_o, strict=True)])
    )
    U = Q.z * N * (d_i + d_o) * 0.95 / 1.95
    return {"T": Q.z * Q.R * N * tan, "N": N, "d_i": d_i, "d_o": d_o, "U": U}


def test_splines_hit_the_states(sweep):
    for name, values in sweep.at_states.items():
        for T, value in zip(sweep.at_states["T"], values, strict=True):
            inside = min(T, sweep.at_states["T"][-1])
            assert sweep.at(name, inside) == pytest.approx(value, rel=1e-12)


def test_a_sweep_says_nothing_beyond_its_states(sweep):
    T, psi = sweep.at_states["T"], sweep.psi
    for value in (0.99 * T[0], 1.01 * T[-1]):
        with pytest.raises(ArithmeticError, match="lies beyond the states"):
            sweep.at("N", value)
    with pytest.raises(ArithmeticError, match="lies beyond the states"):
        sweep.force_at_angle(1.01 * psi[-1])


def test_the_sweep_reaches_the_normal_force_of_a_rigid_clutch_and_the_torque(sweep):
    states = sweep.at_states
    assert states["N"][0] < 0.02 * rigid_force(Q) < rigid_force(Q) < states["N"][-1]
    assert states["T"][-1] > Q.T
    assert all(np.all(np.diff(states[name]) > 0) for name in ("T", "N", "d_i", "d_o", "U"))


def test_the_angle_of_a_state_has_the_state_s_force(sweep):
    for psi, N in zip(sweep.psi[1:-1], sweep.at_states["N"][1:-1], strict=True):
        assert sweep.force_at_angle(psi) == pytest.approx(N, rel=1e-9)


def test_torsion_by_rolling_is_the_dense_integral_of_the_splines():
    sweep = synthetic(along_powers)
    N = np.concatenate([[0.0], np.geomspace(1e-6, 1.0, 20001)]) * sweep.at_states["N"][-1]
    d = np.where(N > 0, N, 0.0) ** 0.95
    dense = torsion(Q.cam, d_i=3e-9 * d, d_o=7e-9 * d)[-1]
    T = sweep.at_states["T"][[-1]]
    assert sweep.torsion_by_rolling(T)[0] == pytest.approx(dense, rel=2e-5)


def test_torsion_by_energy_is_force_times_way_of_rollers_that_roll():
    sweep = synthetic(along_powers)
    T = sweep.at_states["T"][[3, 6, -1]]
    assert sweep.torsion_by_energy(T) == pytest.approx(sweep.torsion_by_rolling(T), rel=2e-5)


def test_energy_s_torsion_is_that_of_a_torque_that_grows_by_a_power():
    def power(T):
        return {"T": T, "U": 0.3 * T**1.9}

    sweep = synthetic(power)
    T = np.array([30.0, 500.0, 4000.0])
    assert sweep.torsion_by_energy(T) == pytest.approx(0.3 * 1.9 / 0.9 * T**0.9, rel=1e-9)


# What is expected.
KNOWN = [
    pytest.param({}, id="the case's own"),
    pytest.param({"z": 12, "T": 35.0}, id="twelve rollers"),
    pytest.param({"R_a": 26e-3, "r_b": 6e-3, "T": 20.0}, id="a thick ring, a small bore"),
    pytest.param({"X": off_x(5.0), "T": 40.0}, id="a wide angle"),
]


@pytest.mark.parametrize("change", KNOWN)
def test_intervals_lie_about_the_formulas_and_are_no_wider_than_what_they_are_for(change):
    q = FreewheelTorque(**change)
    torque, force = under_torque(q), under_force(q)
    for interval in (torque.angle(), torque.slope(), torque.travel(), force.approach("d_o")):
        assert interval[0] <= 1e-5
        assert interval[1] >= -3e-3  # the winding of the star is missing in formulas
    assert torque.angle()[1] - torque.angle()[0] < 4e-3
    low, high = force.approach("d_i")
    assert -0.05 < low < 0 < high < 0.02


# A sweep of another clutch takes seconds: one in every run.
SWEPT = [
    KNOWN[1],
    *(pytest.param(*known.values, id=known.id, marks=pytest.mark.soak) for known in KNOWN[2:]),
]


@pytest.mark.parametrize("change", SWEPT)
def test_intervals_hold_what_finite_elements_say_of_other_clutches(change):
    q = FreewheelTorque(**change)
    sweep, v = Sweep(q, 5), TORQUE.analytic(q)
    T, N = q.T, rigid_force(q)
    place, torque, force = sweep.place(T), under_torque(q), under_force(q)
    told = [
        (v["alpha"], place.psi / 2, torque.angle()),
        (v["N"], sweep.at("N", T), torque.force()),
        (v["phi"], sweep.torsion_by_energy(np.array([T]))[0], torque.torsion()),
        (v["d_i_rigid"], sweep.at("d_i", N, "N"), force.approach("d_i")),
        (v["d_o_rigid"], sweep.at("d_o", N, "N"), force.approach("d_o")),
        (v["a_i_rigid"], sweep.at("a_i", N, "N"), force.contact()),
        (v["torque_rigid"], sweep.at("T", N, "N"), force.slope(tilted=True)),
        (
            v["N_angle"],
            sweep.force_at_angle(freewheel_sweep.given_angle(q)),
            force.force_at_angle(),
        ),
    ]
    for formula, fem, (low, high) in told:
        assert low < formula / fem - 1 < high


def test_a_formula_beyond_its_bounds_does_not_carry_them_along(broken):
    before = under_force(Q).approach("d_i")
    broken(compliance, "_star", softer(1.2))
    after = under_force(Q).approach("d_i")
    assert after[1] - after[0] == pytest.approx(before[1] - before[0], abs=0.01)
    assert after[1] < 0.04


# Inputs.
@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"X": off_x(6.0)}, "that oiled steel hardly exceeds: the clutch slips"),
        ({"T": 400.0}, "exceeds the 4000 MPa"),
    ],
)
def test_inputs_near_an_end_of_the_range_are_warned_of(change, words):
    q = FreewheelTorque(**change)
    assert words in " ".join(TORQUE.warnings(q, TORQUE.analytic(q)))
    assert not TORQUE.warnings(Q, TORQUE.analytic(Q))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"T": 500.0}, "wide under"),
        ({"R_a": 17e-3, "T": 10.0}, "more than 0.1 of its wall of 0.5 mm"),
        ({"z": 17, "T": 52.0}, "mm of the flats' corners"),
    ],
)
def test_what_finite_elements_cannot_do_is_said_beforehand(change, words):
    reason = TORQUE.too_large(FreewheelTorque(**change))
    assert words in reason
    assert "check it without --fem" in reason
    assert not TORQUE.too_large(Q)


BASE = {
    "R": "16.5 mm", "r": "2.5 mm", "X": "11.39565 mm", "R_a": "21 mm", "r_b": "7.5 mm", "z": 8,
    "L": "10 mm", "T": "26 N m", "E": "206 GPa", "nu": 0.3,
}  # fmt: skip


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"R": "-1 mm"}, "inputs.R"),
        ({"R": "16.5"}, "inputs.R"),
        ({"R": "16.5 N"}, "inputs.R"),
        ({"R": "22 mm"}, "the ring needs a wall"),
        ({"R": "16 mm"}, "no wedge"),
        ({"r": "0 mm"}, "inputs.r"),
        ({"r": "6 mm"}, "no wedge"),
        ({"X": "11.6 mm"}, "no wedge"),
        ({"X": "9.3 mm", "z": 3}, "is beyond friction"),
        ({"R_a": "16 mm"}, "the ring needs a wall"),
        ({"r_b": "12 mm"}, "the star needs a wall"),
        ({"z": 2}, "inputs.z"),
        ({"z": 8.5}, "inputs.z"),
        ({"z": 40}, "rollers"),
        ({"L": "0 mm"}, "inputs.L"),
        ({"T": "0 N m"}, "inputs.T"),
        ({"T": "26 N"}, "inputs.T"),
        ({"T": "1e6 N m"}, "wider than half the rollers"),
        ({"T": "4000 N m"}, "past the corners of their flats: 5.2"),
        ({"R_a": "16.6 mm"}, "past the corners of their flats"),
        ({"E": "-1 GPa"}, "inputs.E"),
        ({"nu": 0.5}, "inputs.nu"),
        ({"mu": 0.1}, "mu"),
    ],
)
def test_wrong_inputs_end_in_one_line(change, words, tmp_path, capsys):
    entries = BASE | change
    lines = [f"{k} = {v!r}".replace("'", '"') for k, v in entries.items()]
    path = tmp_path / "own.toml"
    path.write_text("\n".join(['case = "freewheel-torque"', "[inputs]", *lines]), "utf-8")
    assert run(["check", str(path)]) == 2
    told = capsys.readouterr()
    assert words in told.err
    assert len(told.err.strip().splitlines()) == 1
    assert not told.out


# Judging.
def test_no_row_is_red_on_the_case_s_inputs(judged, red):
    assert not red(judged(TORQUE))


def test_every_row_finds_what_it_compares(judged):
    result = judged(TORQUE)
    assert len({row.id for row in result.rows}) == len(result.rows)
    v = TORQUE.analytic(Q)
    for output in TORQUE.outputs:
        assert math.isfinite(v[output.key])
    context = Context(TORQUE.id, Q, v, (), is_paper=True)
    told = [r.id for c in TORQUE.checks for r in
            (c.skipped(TORQUE.id, "") if c.needs_fem else c.rows(context))]  # fmt: skip
    assert set(told) <= {row.id for row in result.rows}
    assert TORQUE.equations(Q, v)
    assert TORQUE.sketch(Q)


ANGLE, FORCE = "clamping angle under torque (Eqs. 4, 5)", "normal force under torque (Eqs. 2, 3)"
WAY = "way of the rollers (Eq. 6)"
TORSION = "torsion by exact rolling, against ∫dU/T (Eq. 7, corrected)"
PRINTED_7, NO_LOAD = "torsion, Eq. 7 as printed, against ∫dU/T", (
    "statics: F_t/F_n becomes tan α_0 without load (Eqs. 1, 4)")  # fmt: skip
AT_N = ", at N = T/(z R tan α_0)"
D_I, D_O = f"approach of roller and star{AT_N}", f"approach of roller and ring{AT_N}"
A_I, P_O = f"half-width on the star{AT_N}", f"peak pressure on the ring{AT_N}"
T_AT_N = f"torque z R F_t (Eq. 3, corrected){AT_N}"
PRINTED_3 = f"torque z X F_t of the star, Eq. 3 as printed{AT_N}"
ON_RACE = "torque against z R F_t of the ring (Eq. 3, corrected)"
ON_STAR = "torque against z (F_n x − F_t X) of the star (Eq. 3, corrected)"
AT_ANGLE, ROLLS = "normal force at a given angle", "∫dU/T against rolling"


def scaled(factor):
    return lambda right: lambda *a, **k: factor * np.asarray(right(*a, **k))


def softer(factor):
    def fault(right):
        def wrong(clutch):
            body = right(clutch)
            return replace(body, E=body.E / factor)

        return wrong

    return fault


def assumed(what):
    """As another state of strain or, without one, without 1 - nu²."""
    return lambda right: lambda **k: right(**k | {"assumption": what})


READINGS = [
    pytest.param(Cam, "alpha", scaled(2), ANGLE, id="psi for alpha"),
    pytest.param(Cam, "alpha", scaled(2), NO_LOAD, id="psi for alpha, without load"),
    pytest.param(Cam, "distance", scaled(Q.R_a / Q.R), FORCE, id="R_a for R"),
    pytest.param(Cam, "distance", scaled(2), ANGLE, id="diameters for radii"),
    pytest.param(star, "loaded", lambda right: lambda whole, T: right(whole, Q.z * T), FORCE,
                 id="the torque of one roller"),
    pytest.param(Cam, "torque_on_race", lambda _: lambda self, *, F_t: (
        self.count * self.flat * F_t), T_AT_N, id="X for R"),
    pytest.param(Cam, "arc", scaled(0.5), WAY, id="way of the angle alpha instead of 2 alpha"),
    pytest.param(Cam, "arc", lambda right: lambda self, *, d_i, d_o: right(
        self, d_i=-np.asarray(d_i), d_o=d_o), WAY, id="sign of d_i in Eq. 6"),
    pytest.param(Cam, "alpha", lambda right: lambda self, *, d_i, d_o: right(
        self, d_i=-np.asarray(d_i), d_o=d_o), ANGLE, id="sign of d_i in Eq. 5"),
    pytest.param(Cam, "distance", lambda right: lambda self, *, d_i, d_o: right(
        self, d_i=d_i, d_o=-np.asarray(d_o)), ANGLE, id="sign of d_o in Eq. 5"),
    pytest.param(Material, "plane", lambda _: property(lambda self: (
        np.asarray(self.E, float), np.asarray(self.nu, float))), D_O, id="1 - nu² dropped"),
    pytest.param(hertz_line, "contact_modulus", assumed("plane stress"), A_I,
                 id="plane stress for plane strain, a"),
    pytest.param(hertz_line, "contact_modulus", assumed("plane stress"), P_O,
                 id="plane stress for plane strain, p"),
    pytest.param(compliance, "ROLLER", lambda _: -1.0, D_I, id="half a roller without its k, star"),
    pytest.param(compliance, "ROLLER", lambda _: -1.0, D_O, id="half a roller without its k, ring"),
    pytest.param(compliance, "ROLLER", lambda _: -1.0, AT_ANGLE, id="the same, at an angle"),
    pytest.param(compliance, "_star", softer(1.05), D_I, id="star 5 % too soft"),
    pytest.param(compliance, "_star", lambda right: lambda clutch: right(
        replace(clutch, star="half space")), D_I, id="a half space for the star"),
    pytest.param(series, "race_constant", scaled(0.98), D_O, id="ring's constant 2 % too small"),
    pytest.param(series, "star_constant", scaled(0.95), AT_ANGLE, id="star 5 % of its k too soft"),
    pytest.param(series, "star_constant", scaled(1.5), D_I, id="star half of its k too stiff"),
    pytest.param(Clutch, "half_widths", lambda right: lambda self, P: tuple(
        2 * a for a in right(self, P)), A_I, id="widths for half-widths"),
    pytest.param(Clutch, "pressures", lambda right: lambda self, P: tuple(
        np.pi / 4 * p for p in right(self, P)), P_O, id="mean pressure for its peak"),
    pytest.param(Formula, "phi", lambda _: property(lambda self: self.s / Q.R), TORSION,
                 id="the race's part alone in Eq. 7"),
    pytest.param(Formula, "phi", lambda _: property(lambda self: 1.01 * 2 * self.s / Q.R), TORSION,
                 id="1 % more than Eq. 7"),
    pytest.param(printed, "torsion", lambda _: lambda cam, **d: 2 * cam.arc(**d) / cam.race,
                 PRINTED_7, id="Eq. 7 corrected where the printed one is told"),
    pytest.param(printed, "torque_on_cam", lambda _: lambda cam, *, F_t: cam.torque_on_race(
        F_t=F_t), PRINTED_3, id="Eq. 3 corrected where the printed one is told"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), READINGS)
def test_another_reading_or_a_wrong_formula_turns_a_row_red(
    owner, name, fault, row, broken, judged, without_fault, red
):
    without_fault(TORQUE)
    broken(owner, name, fault)
    assert row in names(red(judged(TORQUE, drawn=False)))


def test_approaches_are_those_of_an_elastic_solution_without_contact():
    """In plane strain: finite elements of star, roller and ring apart, Hertz's pressures given."""
    apart = {"d_i_rigid": 7.7807e-6, "d_o_rigid": 16.7671e-6}
    for key, d in apart.items():
        assert TORQUE.analytic(Q)[key] == pytest.approx(d, rel=6e-3)
        assert solved(TORQUE, Q)[-1].result.values[key] == pytest.approx(d, rel=2e-3)


FEM_FAULTS = [
    pytest.param(State, "torque", lambda right: property(
        lambda self: right.fget(self) * (1 - 1 / Q.z)), ON_RACE, id="a roller too few"),
    pytest.param(Elastic, "lame_constants", lambda right: lambda self, _: right(
        self, "plane stress"), D_O, id="plane stress"),
    pytest.param(State, "on_race", lambda right: property(
        lambda self: right.fget(self)[::-1]), ON_RACE, id="normal and tangential force swapped"),
    pytest.param(State, "place", lambda _: property(lambda self: self.start), D_I,
                 id="the roller's own displacement is not read"),
]  # fmt: skip


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(("owner", "name", "fault", "row"), FEM_FAULTS)
def test_wrong_finite_elements_turn_a_row_red(owner, name, fault, row, few, broken, red):
    before = red_without_fault()
    broken(owner, name, fault)
    assert row in names(red(solve_anew())) - before


def test_rollers_with_less_friction_than_they_need_find_no_state(monkeypatch):
    monkeypatch.setattr(flat_start, "STICKS", 0.9)
    with pytest.raises(ArithmeticError):
        freewheel_sweep.starts.__wrapped__(Q)
