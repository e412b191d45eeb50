"""A sprag clutch's engagement: its states and inputs, and that every fault turns a row red."""

import time
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from analytic.sprag import closure, course, printed, race_spring, start, table, work_balance
from analytic.sprag.history import Phase
from analytic.sprag.race_spring import RaceSpring
from verify.cases.sprag.engagement import comparisons, formulas, model, reference
from verify.cases.sprag.engagement.case import ENGAGEMENT, SpragEngagement
from verify.core.results import Status
from verify.form import quantity
from verify.jobs.cache import default_folder
from verify.jobs.level import Job, judge_case, solve_level

pytestmark = pytest.mark.xdist_group("sprag-engagement")
PAPER = SpragEngagement()


def names(rows):
    return {row.quantity for row in rows}


def own(**changes):
    return SpragEngagement.model_validate(PAPER.model_dump() | changes)


def forget():
    for kept in (model.wedge, race_spring._table, formulas.swing):
        kept.cache_clear()
    quantity.forget()


@pytest.fixture
def broken(monkeypatch):
    def break_(owner, name, fault):
        monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
        forget()

    forget()
    yield break_
    monkeypatch.undo()
    forget()


@cache
def finest():
    """What the finest level keeps of LSODA and of other clutches, from the cache."""
    return solve_level(ENGAGEMENT, PAPER, reference.LEVELS[-1], default_folder()).result


@pytest.fixture
def steps_alone(monkeypatch):
    """Solve the steps anew beside the right LSODA, which takes longest."""
    right = finest()
    kept = {key: v for key, v in right.values.items() if key.startswith("LSODA")}
    for name, arrays in (
        ("compared_fem", ("LSODA t", "LSODA N", "LSODA beside", "rolling")),
        ("designs_fem", ("crowns", "centroids", "balanced")),
    ):
        monkeypatch.setattr(
            reference, name, lambda *_, keys=arrays: {key: right.arrays[key] for key in keys}
        )
    monkeypatch.setattr(
        reference, "order_fem", lambda _q: {"order": right.arrays["order"]}["order"]
    )
    monkeypatch.setattr(reference, "partners_fem", lambda _q: kept)
    monkeypatch.setattr(reference, "pressed_fem", lambda _q: {})

    def solve():
        levels = [solve_level(ENGAGEMENT, PAPER, level, None) for level in ENGAGEMENT.levels]
        return judge_case(Job(ENGAGEMENT, PAPER, drawn=False), levels)

    return solve


def engaged(q, dt=1e-5, **how):
    return reference.engaged_fem(q, model.wedge(q), dt, **how)


# States of the clutch.
def test_the_same_engagement_twice_has_the_same_bits():
    one, two = engaged(PAPER), engaged(PAPER)
    assert np.array_equal(one.states, two.states)
    assert np.array_equal(one.told, two.told)


def test_an_engagement_of_60_ms_takes_less_than_a_tenth_of_a_second():
    engaged(PAPER)
    taken = []
    for _ in range(3):
        before = time.process_time()
        engaged(PAPER)
        taken.append(time.process_time() - before)
    assert min(taken) < 0.1


def test_no_contact_slides_with_the_paper_s_springs():
    assert (engaged(PAPER).phases == Phase.STICK).all()


@pytest.mark.parametrize(
    ("change", "verdict", "said"),
    [
        ({}, "locks", "locks: N swings to 62"),
        ({"mu_s": 0.05, "mu_c": 0.05}, "slips", "slips: friction is less"),
        ({"T": 120.0}, "over the end", "rolls over"),
    ],
)
def test_words_of_the_formulas_agree_with_what_the_steps_do(change, verdict, said):
    q = own(**change)
    assert engaged(q).verdict == verdict
    assert ENGAGEMENT.findings(q, ENGAGEMENT.analytic(q))[0].startswith(said)
    assert bool(ENGAGEMENT.too_large(q)) == (verdict != "locks")
    assert bool(ENGAGEMENT.warnings(q, ENGAGEMENT.analytic(q))) == (verdict != "locks")


def test_sprags_that_slide_at_the_start_are_warned_of_and_not_compared():
    q = own(K_r=4e-4)
    assert "slide at the start" in ENGAGEMENT.warnings(q, ENGAGEMENT.analytic(q))[0]
    assert "slide at the start" in ENGAGEMENT.too_large(q)
    assert (engaged(q).phases[:20, 0] == Phase.SLIP).any()


def test_too_many_steps_are_refused_before_they_run():
    assert "steps" in ENGAGEMENT.too_large(own(dt=1e-7, t_end=0.06))


def test_a_band_too_narrow_for_the_step_is_one_red_line_not_a_traceback():
    q = own(D_V=1e-3, K_r=4e-4, T=40.0)
    solved = solve_level(ENGAGEMENT, q, 1, None)
    assert "band of sticking is too narrow" in solved.failure
    assert "\n" not in solved.failure


def test_a_ramp_swings_less_than_a_step_and_an_overrunning_race_comes_to_rest_first():
    step, ramp, late = (
        ENGAGEMENT.analytic(own(**c)) for c in ({}, {"t_ramp": 0.02}, {"w_i": -100.0})
    )
    assert ramp["factor"] < 1.2 < step["factor"]
    assert late["t_max"] > step["t_max"] + 4e-3
    assert late["N_max"] == pytest.approx(step["N_max"], rel=1e-3)
    assert engaged(own(w_i=-100.0)).peak[0] == pytest.approx(late["t_max"], rel=0.05)


@pytest.mark.parametrize(
    "change",
    [
        {"z": 3, "T": 6.0}, {"z": 40, "b": 1.5e-3, "T": 60.0, "Q": None}, {"z_m": 0.0},
        {"nu_0": 0.0175, "T": 8.0, "Q": None}, {"R_id": 10e-3, "R_ed": 21e-3}, {"E": 3e9, "T": 1.0},
        {"K_1": 20.0, "z_m": 5e-5}, {"t_end": 3e-3}, {"C_rl": 0.0}, {"k_out": 500.0},
    ],
)  # fmt: skip
def test_odd_clutches_have_words_equations_and_a_sketch(change):
    q = own(**change)
    v = ENGAGEMENT.analytic(q)
    assert all(np.isfinite(list(v.values())))
    assert ENGAGEMENT.findings(q, v)
    assert ENGAGEMENT.equations(q, v)
    assert ENGAGEMENT.sketch(q)


# Judging.
def test_no_row_is_red_on_the_case_s_inputs(judged, red):
    assert not red(judged(ENGAGEMENT))


def test_what_hangs_on_identified_inputs_is_no_evidence(judged):
    found = {r.quantity for r in judged(ENGAGEMENT).rows if r.status is Status.CALIBRATED}
    assert len(found) == 4


def test_the_right_steps_turn_no_row_red(steps_alone, red):
    assert not red(steps_alone())


LSODA = "largest force: steps and LSODA"
RIGID = "largest force without yielding races (Liu): steps and LSODA"
FREE = "first peak without damping, T θ = ∫T dθ by rolling"
WORK = "work till that peak, T θ = n_s ∫(N dH_i + N_e dH_e)"
CONJUGATE = "∫T dθ by rolling, n_s ∫(N dH_i + N_e dH_e) within 0.01%"
REST = "force at rest after a slow rise"
SMALL = "frequency of small oscillations, √(k/I)"
SPRING = "largest force, two races on a spring"
ASKED = "friction that rolling asks for, tan ν"
ENERGY = "balance of energies without damping"
BOOKED = "balance of energies, damping and friction booked"
FIRST = "the first peak is the largest"
INNER = "inner contact's pressure above the outer's, at any force"


def scaled_columns(**factors):
    """The table with some of its columns multiplied."""

    def fault(right):
        def table(w, intervals):
            found = right(w, intervals)
            values, slopes = found.values.copy(), found.slopes.copy()
            for name, factor in factors.items():
                k = ("N", "OA", "OB", "OC_g", "b_i", "b_e", "h", "W").index(name)
                values[k] *= factor
                slopes[k] *= factor
            return replace(found, values=values, slopes=slopes)

        table.cache_clear = lambda: None
        return table

    return fault


def moving(**changes):
    """The motion with other constants."""
    return lambda right: (
        lambda q: replace(
            right(q), **{key: factor * getattr(right(q), key) for key, factor in changes.items()}
        )
    )


STEPS = [
    pytest.param(race_spring, "_table", scaled_columns(OA=0.5, OB=0.5), REST,
                 id="lever arms halved, as printed"),
    pytest.param(race_spring, "_table", scaled_columns(OA=0.5, OB=0.5), LSODA,
                 id="lever arms halved, against LSODA"),
    pytest.param(race_spring, "_table", scaled_columns(N=1.001), LSODA, id="force 0.1 % too large"),
    pytest.param(race_spring, "_table", scaled_columns(h=1.01), ENERGY, id="lever of N"),
    pytest.param(race_spring, "_table", scaled_columns(b_i=1.01), FREE, id="lever of T_i"),
    pytest.param(race_spring, "_table", scaled_columns(b_e=0.99), REST, id="lever of T_e"),
    pytest.param(reference, "motion", moving(C_rl=2.0), SPRING, id="damping twice"),
    pytest.param(reference, "motion", moving(k_out=1e-5), SPRING,
                 id="a constant torque holds no outer race"),
    pytest.param(reference, "motion", moving(I_bi=1.01), SMALL, id="inertia of the inner race"),
    pytest.param(reference, "motion", moving(I_g=12.0, m_g=12.0), SMALL,
                 id="the mass of all sprags for one"),
    pytest.param(reference, "torque", lambda _: lambda q: reference.Torque.step(
        q.T, t_ramp=5e-3), SPRING, id="the torque is no step"),
    pytest.param(reference, "wedge", lambda right: lambda q, rigid=False: right(q), RIGID,
                 id="rigid races forgotten"),
]  # fmt: skip


@pytest.mark.soak  # integrated anew for every fault
@pytest.mark.parametrize(("owner", "name", "fault", "row"), STEPS)
def test_wrong_steps_turn_a_row_red(owner, name, fault, row, steps_alone, broken, red):
    broken(owner, name, fault)
    assert row in names(red(steps_alone()))


def stiffer(factor):
    return lambda right: lambda self: factor_spline(right(self), factor)


def factor_spline(spline, factor):
    spline.c *= factor
    return spline


def as_printed(_right):
    return printed.wedged


FORMULAS = [
    pytest.param(RaceSpring, "resistance", stiffer(1.005), REST, id="torque 0.5 % too large"),
    pytest.param(RaceSpring, "resistance", stiffer(1 / 12), FREE, id="torque of one sprag"),
    pytest.param(RaceSpring, "force", stiffer(1.003), SPRING, id="force 0.3 % too large"),
    pytest.param(race_spring, "rolled", lambda right: lambda c, N: 1.01 * right(c, N), SMALL,
                 id="turn 1 % too large"),
    pytest.param(race_spring, "wedged", as_printed, REST, id="closure as printed, at rest"),
    pytest.param(race_spring, "wedged", as_printed, SMALL, id="closure as printed, stiffness"),
    pytest.param(work_balance, "sprags_inertia", lambda _: lambda *_: -0.02 * PAPER.I_bi, SMALL,
                 id="inertia 2 % too small"),
    pytest.param(formulas, "undamped", lambda right: lambda w, T: right(w, 1.01 * T), FREE,
                 id="work of 1 % more torque"),
    pytest.param(model, "parts", lambda right: lambda q: replace(right(q), b=2 * q.b), REST,
                 id="sprags twice as wide"),
    pytest.param(comparisons, "parts", lambda right: lambda q: replace(right(q), sprag=replace(
        q.sprag, r_i=1.0)), INNER, id="a flat sprag"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), FORMULAS)
def test_a_wrong_formula_or_another_reading_turns_a_row_red(
    owner, name, fault, row, broken, judged, without_fault, red
):
    without_fault(ENGAGEMENT)
    broken(owner, name, fault)
    assert row in names(red(judged(ENGAGEMENT, drawn=False)))


def lever_of_the_race(clutch, N):
    """A state whose forces act at R_i."""
    now, sprag = closure_wedged(clutch, N), clutch.sprag
    return closure.closed(clutch, now.N, now.yields, OA_s=now.OA_s, OA=np.asarray(sprag.R_i))


closure_wedged = closure.wedged


def in_every_closure(broken, fault):
    """Put `fault` where formulas, steps and LSODA take the state of a sprag from."""
    for module in (closure, course, table, start, race_spring):
        broken(module, "wedged", lambda _: fault)


@pytest.mark.parametrize("fault", [printed.wedged, lever_of_the_race])
def test_a_closure_that_loses_work_is_red_though_all_sides_share_it(
    fault, steps_alone, broken, red
):
    in_every_closure(broken, fault)
    assert {WORK, CONJUGATE} <= names(red(steps_alone()))


def test_rolling_without_the_sprag_s_way_outwards_is_red(broken, judged, without_fault, red):
    def without(clutch, N):
        on_way = course._way(clutch, N)
        per_turn = on_way.OC_e * (np.cos(on_way.beta) / on_way.OA - 1 / on_way.OB)
        return course._integral(per_turn, on_way.alpha_b)

    without_fault(ENGAGEMENT)
    broken(race_spring, "rolled", lambda _: without)
    assert CONJUGATE in names(red(judged(ENGAGEMENT, drawn=False)))


@pytest.mark.parametrize(
    ("key", "value", "row"),
    [("later peak", 6300.0, FIRST), ("missing", 1e-3, BOOKED), ("missing undamped", 1e-3, ENERGY),
     ("asked", 0.0559, ASKED)],
)  # fmt: skip
def test_a_fact_that_does_not_hold_is_red(key, value, row, red):
    levels = [solve_level(ENGAGEMENT, PAPER, n, default_folder()) for n in ENGAGEMENT.levels]
    other = [
        replace(s, result=replace(s.result, values={**s.result.values, key: value})) for s in levels
    ]
    assert row in names(red(judge_case(Job(ENGAGEMENT, PAPER, drawn=False), other)))
