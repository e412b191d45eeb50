"""The rig's load paths: inputs, states, and that every fault turns a row red."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from analytic.freewheel import course, criterion, load_path
from fem.wedge.held import Held
from fem.wedge.pulled import Borne
from verify.cases.freewheel.paths import reference as fem
from verify.cases.freewheel.paths.case import PATHS, LoadPaths
from verify.cases.freewheel.pulled_sector import one_pulled
from verify.core.results import Status
from verify.jobs.cache import default_folder
from verify.jobs.level import Job, judge_case, solve_level

FIRST, SECOND, THIRD = (
    "axial load at slip, torque first (load case 1)",
    "axial amplitude at slip, steady torque (load case 2)",
    "axial amplitude at slip, both in phase (load case 3)",
)
IN_PHASE = "required friction, load case 3, at 0.3 of the amplitudes (Eqs. 8, 9)"
EXTREMES = "required friction at the extremes of load case 2, at its own angle (Eqs. 8, 9)"
WALKS = "a large alternating load makes the ring walk: ratcheting below slip"

pytestmark = pytest.mark.xdist_group("freewheel-paths")


def names(rows):
    return {row.quantity for row in rows}


@pytest.fixture
def broken(monkeypatch):
    def break_(owner, name, fault):
        monkeypatch.setattr(owner, name, fault(getattr(owner, name)))

    yield break_
    monkeypatch.undo()


# Paths and their courses.
def test_all_three_paths_slip_at_the_load_that_eq_9_gives():
    q = LoadPaths()
    v = PATHS.analytic(q)
    steady = q.rise + v["F_lim"] / q.F_ax * (q.duration - q.rise)
    assert v["slip_1"] == pytest.approx(steady, abs=3e-4)
    for case in (2, 3):
        along = q.courses[case]
        at = np.searchsorted(along.t, along.slips_at)
        assert abs(along.mu_req[at]) > q.mu > abs(along.mu_req[at - 1])


def test_an_alternating_load_slips_no_sooner_than_a_steady_one_of_the_same_growth():
    v = PATHS.analytic(LoadPaths())
    assert v["slip_2"] >= v["slip_1"]


def test_a_path_that_ends_below_the_limit_holds_and_is_green():
    q = LoadPaths(F_ax=900.0)
    v = PATHS.analytic(q)
    assert not any(key.startswith("slip") for key in v)
    assert all(
        "holds to the end" in words and "green" in words for words in PATHS.findings(q, v)[1:4]
    )


def test_about_a_mean_torque_the_trough_asks_for_most():
    q = LoadPaths(T=10.0, T_m=16.0, F_ax=300.0)
    last = q.courses[3]
    assert q.T_critical == pytest.approx(last.T[np.nanargmax(last.mu_req)], rel=1e-3)
    assert not PATHS.too_large(q)


def test_inertia_is_a_thousandth_of_the_loads_at_30_hz_and_warned_of_near_the_eigenfrequency():
    q = LoadPaths()
    assert PATHS.analytic(q)["sway"] < 1e-3
    assert not [w for w in PATHS.warnings(q, PATHS.analytic(q)) if "inertia" in w]
    fast = LoadPaths(f=500.0)
    assert "inertia adds some" in " ".join(PATHS.warnings(fast, PATHS.analytic(fast)))


# Inputs.
@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"rise": 0.6}, "rise < duration, got rise = 0.6 s, duration = 0.5 s"),
        ({"f": 1e4}, "at most 1000 cycles, got f duration = 5000"),
        ({"F_ax": 0.0}, "greater than"),
        ({"T_m": -1.0}, "greater than or equal"),
        ({"T": 1e6}, "wider than half the rollers"),
    ],
)
def test_what_is_no_path_is_refused(change, words):
    with pytest.raises(ValueError, match=words):
        PATHS.analytic(LoadPaths(**change))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"T_m": 10.0}, "axial load while its torque is next to zero"),
        ({"T_m": 26.0}, "axial load while its torque is next to zero"),
        ({"mu": 0.05}, "tan α = 0.0674 is not below μ = 0.05"),
        ({"F_ax": 1e5}, "asks for friction of"),
        ({"T": 250.0, "mu": 0.5}, "displacements are not small"),
    ],
)
def test_paths_that_finite_elements_cannot_follow_are_told(change, words):
    q = LoadPaths(**change)
    assert words in PATHS.too_large(q)
    assert PATHS.equations(q, PATHS.analytic(q))


# States.
def test_friction_of_the_way_there_leaves_the_roller_s_balance_alone():
    q = LoadPaths()
    one = one_pulled(q)
    held = Held.at(one, fem.at_torque(one, 3), 3, q.mu)
    there = held.to(-0.8, held.to(0.8, held.rest))
    b, on_mesh = Borne.by(there), Borne.on_mesh(there)
    assert b.F_z.sum() == pytest.approx(0.0, abs=1e-8 * b.N[0])
    assert np.hypot(on_mesh.F_t, on_mesh.F_z).max() < q.mu * on_mesh.N.min() * (1 + 1e-9)
    assert b.tangent == pytest.approx(math.tan(held.rest.place.psi / 2), rel=2e-5)


# Judging.
def test_no_row_is_red_on_the_case_s_inputs(judged, red):
    assert not red(judged(PATHS))


def test_the_classes_are_adopted_and_no_row_calls_them_verified(judged):
    rows = [row for row in judged(PATHS).rows if row.quantity.startswith("class ")]
    assert [row.status for row in rows] == [Status.NOTE, Status.NOTE]
    assert all("rule adopted" in row.reason for row in rows)


READINGS = [
    pytest.param(criterion, "largest_axial_load", lambda f: lambda **k: 8 * f(**k), FIRST,
                 id="F_ax of one roller"),
    pytest.param(criterion, "largest_axial_load", lambda f: lambda **k: f(
        **k | {"R": 11.39565e-3}), SECOND, id="the flat's distance for the lever"),
    pytest.param(criterion, "largest_axial_load", lambda f: lambda **k: f(
        **k | {"alpha": 2 * k["alpha"] / 2 + 0.0012}), THIRD, id="alpha 0.07 degrees larger"),
    pytest.param(criterion, "required_friction_of_ratio", lambda f: lambda **k: f(
        **k | {"ratio": 8 * np.asarray(k["ratio"])}), IN_PHASE, id="mu_req by F_ax of each roller"),
    pytest.param(criterion, "required_friction_of_ratio", lambda _: lambda *, alpha, ratio, R:
        np.tan(alpha) * (1 + np.abs(ratio) * R), EXTREMES, id="forces added without angles"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), READINGS)
def test_another_reading_or_a_wrong_formula_turns_a_row_red(
    owner, name, fault, row, broken, judged, without_fault, red
):
    without_fault(PATHS)
    broken(owner, name, fault)
    assert row in names(red(judged(PATHS, drawn=False)))


WRONG_PATHS = [
    pytest.param(load_path.BothAlternating, "ratio", lambda f: lambda self, t: 0.9 * f(self, t),
                 (3,), id="a ratio of 0.9"),
    pytest.param(load_path.AxialRamp, "axial_load", lambda f: lambda self, t: f(self, t) / 2,
                 (1,), id="a ramp to half the load"),
    pytest.param(load_path.AlternatingAxial, "axial_load", lambda f: lambda self, t: f(
        replace(self, frequency=2 * self.frequency), t), (2,), id="doubled frequency, load case 2"),
    pytest.param(load_path.BothAlternating, "_turn", lambda f: lambda self, t: 2 * f(self, t),
                 (3,), id="doubled frequency, load case 3"),
    pytest.param(load_path, "_growth", lambda f: lambda *args: f(*args) ** 2, (1, 2, 3),
                 id="growth with the square of time"),
    pytest.param(course.Course, "slips_at", lambda f: property(
        lambda self: f.fget(self) + 0.003), (1, 2, 3), id="named three milliseconds late"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "cases"), WRONG_PATHS)
def test_a_wrong_path_turns_its_time_of_slip_red(
    owner, name, fault, cases, broken, judged, without_fault, red
):
    without_fault(PATHS)
    broken(owner, name, fault)
    wrong = names(red(judged(PATHS, drawn=False)))
    assert {f"time of slip, load case {case}" for case in cases} <= wrong


@pytest.mark.parametrize("share", [0.3, 0.5, 0.7, 0.9, 1.0])
def test_between_two_torques_the_angle_is_next_to_a_line(share):
    q = LoadPaths()
    v, tan = PATHS.analytic(q), math.tan(q.under(share * q.T).alpha)
    line = q.rig.tangent(tuple(fem.MU_REQ), tuple(v[key] for key in fem.MU_REQ.values()))
    assert line(share * q.T) == pytest.approx(tan, rel=2e-3)


@cache
def solved():
    return [solve_level(PATHS, LoadPaths(), level, default_folder()) for level in PATHS.levels]


def changed(level, fault):
    result = level.result
    return replace(level, result=replace(result, arrays={**result.arrays, **fault(result.arrays)}))


@pytest.mark.parametrize(
    ("row", "fault"),
    [
        (EXTREMES, lambda a: {"growing": a["growing"] * [1, 1.003, 1.003, 1, 1, 1, 1, 1, 1]}),
        (WALKS, lambda a: {"cycles": a["cycles"][::-1]} if "cycles" in a else {}),
        (SECOND, lambda a: {"slips": a["slips"] * [[0.98], [1]]} if "slips" in a else {}),
        ("torque is kept up to the limit",
         lambda a: {"ramp": a["ramp"] * [1, 1, 1, 1, 1, 1, 0.99, 1, 1]}),
    ],
)  # fmt: skip
def test_finite_elements_that_say_otherwise_turn_a_row_red(row, fault, red):
    q = LoadPaths()
    levels = [changed(level, fault) for level in solved()]
    assert row in names(red(judge_case(Job(PATHS, q), levels)))


@pytest.mark.parametrize("off", [-1e-13, 1e-13])
def test_round_off_of_the_frequency_moves_no_time_of_a_course(off):
    """Cycles of the defaults are whole: one time more would move every time of slip."""
    q = LoadPaths()
    own = q.courses
    for case, along in q.model_copy(update={"f": q.f * (1 + off)}).courses.items():
        assert np.array_equal(along.t, own[case].t)
