"""Friction of a sprag clutch: its states and inputs, and that every fault turns a row red."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from analytic.sprag import race_spring
from analytic.sprag.friction import coefficient
from analytic.sprag.history import Phase
from verify.cases.sprag.engagement import formulas as engagement_formulas
from verify.cases.sprag.engagement import model as engagement_model
from verify.cases.sprag.engagement import reference as engagement_steps
from verify.cases.sprag.engagement.model import wedge
from verify.cases.sprag.friction import formulas, reference
from verify.cases.sprag.friction.case import FRICTION, SpragFriction
from verify.form import quantity
from verify.jobs.cache import default_folder
from verify.jobs.level import Job, judge_case, solve_level

pytestmark = pytest.mark.xdist_group("sprag-friction")
PAPER = SpragFriction()


def names(rows):
    return {row.quantity for row in rows}


def own(**changes):
    return SpragFriction.model_validate(PAPER.model_dump() | changes)


def forget():
    for kept in (engagement_model.wedge, race_spring._table,
                 engagement_formulas.swing):  # fmt: skip
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
    """What the finest level keeps, from the cache."""
    return solve_level(FRICTION, PAPER, reference.LEVELS[-1], default_folder()).result


@pytest.fixture
def steps_alone(monkeypatch):
    """Solve the steps anew beside the right LSODA and maps, which take longest."""
    right = finest()
    kept = {key: v for key, v in right.values.items() if key.startswith("LSODA")}
    monkeypatch.setattr(reference, "partners_fem", lambda *_: kept)
    for name, keys in (
        ("guarded_fem", ("guard",)), ("swept_fem", ("sweep",)), ("map_fem", ("map",)),
        ("narrow_fem", ("narrow", "unguarded")), ("boundaries_fem", ("boundaries",)),
    ):  # fmt: skip
        monkeypatch.setattr(
            reference, name, lambda *_, keys=keys: {key: right.arrays[key] for key in keys}
        )

    def solve():
        levels = [solve_level(FRICTION, PAPER, level, None) for level in FRICTION.levels]
        return judge_case(Job(FRICTION, PAPER, drawn=False), levels)

    return solve


def engaged(q, dt=1e-5, **how):
    return reference.engaged_fem(q, wedge(q), dt, **how)


# States of the contacts.
def test_friction_joins_where_sliding_begins_and_falls_with_speed():
    mu = coefficient([0.0, 1e-9, 1e3], mu_c=PAPER.mu_c, mu_s=PAPER.mu_s, gamma_b=PAPER.gamma_b)
    assert mu == pytest.approx([PAPER.mu_s, PAPER.mu_s, PAPER.mu_c], abs=1e-9)


@pytest.mark.parametrize(
    ("change", "verdict", "said"),
    [
        ({}, "locks", "locks: μ_s is 2.17 times"),
        ({"mu_s": 0.05, "mu_c": 0.05}, "slips", "slips for ever"),
        ({"mu_s": 0.056, "mu_c": 0.05, "K_r": 4e-4}, "slips", "locks: μ_s is 1.01"),
    ],
)
def test_what_the_words_say_is_what_the_steps_do(change, verdict, said):
    q = own(**change)
    v = FRICTION.analytic(q)
    assert engaged(q).verdict == verdict
    assert FRICTION.findings(q, v)[0].startswith(said)
    assert bool(FRICTION.too_large(q)) == (verdict != "locks")


def test_sprags_caught_late_slide_on_where_fast_friction_is_below_the_wedge():
    q = own(mu_s=0.056, mu_c=0.05, K_r=4e-4)
    assert (
        "it locks only where it does not slip first"
        in FRICTION.warnings(q, FRICTION.analytic(q))[0]
    )
    assert engaged(q).verdict == "slips"
    assert engaged(own(mu_s=0.056, mu_c=0.05)).verdict == "locks"


def test_driven_it_is_the_inner_contact_that_slides_and_overrunning_the_outer():
    for speed, mu, outside in ((100.0, 0.9 * math.tan(PAPER.nu_0), False), (-100.0, 0.12, True)):
        found = formulas.sliding(wedge(PAPER), math.copysign(mu, speed))
        assert found.outside == outside
        p = reference.rough(PAPER, mu)
        run = engaged(
            PAPER, moves=reference.held(p, C_rl=0.0, I_bi=1.0), course=reference.Torque.step(0.0),
            duration=reference.SLIDES, speeds=reference.Speeds(inner=speed),
        )  # fmt: skip
        late = run.phases[len(run.t) // 2 :]
        assert (late[:, int(outside)] == Phase.SLIP).mean() > 0.9
        assert (late[:, 1 - int(outside)] == Phase.STICK).mean() > 0.9


def test_figures_have_no_gaps_that_an_axis_could_not_bear(judged):
    for figure in judged(FRICTION).figures:
        for curve in getattr(figure, "curves", ()):
            assert np.isfinite(curve.x).all(), figure.title
            assert np.isfinite(curve.y).all(), figure.title


def test_friction_too_small_for_either_contact_has_no_sliding_state():
    assert math.isnan(formulas.sliding(wedge(PAPER), 1e-3).N)


def test_sliding_force_grows_as_friction_nears_the_wedge():
    tan = math.tan(PAPER.nu_0)
    N = [formulas.sliding(wedge(PAPER), share * tan).N for share in (0.6, 0.8, 0.9)]
    assert N[1] / N[0] == pytest.approx(2.0, rel=0.03)
    assert N[2] / N[0] == pytest.approx(4.0, rel=0.06)


def test_the_guard_stops_what_unguarded_is_silently_wrong():
    q = formulas.weak(PAPER, 1.6)
    assert reference.refused_fem(q, 1e-5, 1e-3)
    assert not reference.refused_fem(q, 1e-5, 1e-2)
    right = engaged(q).N_max
    torques = [q.model_copy(update={"T": q.T * (1 + k * 1e-9)}) for k in range(16)]
    wrong = [engaged(p, D_V=1e-3, guard=False).N_max / right for p in torques]
    assert max(wrong) - min(wrong) > 0.1
    assert min(abs(share - 1) for share in wrong) > 0.01


def test_clutches_that_roll_over_are_told_and_not_compared():
    q = own(T=120.0)
    v = FRICTION.analytic(q)
    assert FRICTION.findings(q, v)[0].startswith("rolls over")
    assert FRICTION.warnings(q, v)
    assert "roll over" in FRICTION.too_large(q)
    assert FRICTION.equations(q, v)


# Judging.
def test_no_row_is_red_on_the_case_s_inputs(judged, red):
    assert not red(judged(FRICTION))


def test_the_right_steps_turn_no_row_red(steps_alone, red):
    assert not red(steps_alone())


LOCKS = "friction from which on it locks, T/(n_s OA N)"
TAN = "locks from μ = tan ν on, within 2%"
DRIVEN = "normal force of sprags that slide, driven, μ = 0.9 tan ν_0"
OVERRUN = "normal force where the race overruns"
AFTER = "the same under 1.6 T"
BEGINS = "time at which slip begins, μ between rest and peak: steps and LSODA"
ENDS = "time at which slip ends: steps and LSODA"
REFUSED = "D_V = 0.001 m/s is refused at 1.6 T with weak springs"
HANGS = "unguarded, the force hangs on the torque's ninth digit"
RIGHT = "what the guard lets pass is right to 0.1%"
WRONG = "what the guard refuses is wrong"
CHOSEN = "chosen bands: N_max within 0.1% of LSODA"

FORMULAS = [
    pytest.param(formulas, "asked_at", lambda right: lambda w, t: 1.01 * right(w, t), LOCKS,
                 id="asked 1 % too much"),
    pytest.param(formulas, "asked_at", lambda _: lambda w, t: math.tan(2 * PAPER.nu_0), LOCKS,
                 id="twice the wedge angle"),
    pytest.param(formulas, "sliding", lambda right: lambda w, mu: replace(
        right(w, mu), N=right(w, mu).N / 12), OVERRUN, id="springs of one sprag for all"),
    pytest.param(formulas, "sliding", lambda right: lambda w, mu: right(w, abs(mu)), OVERRUN,
                 id="overrunning as driven"),
    pytest.param(formulas, "sliding", lambda right: lambda w, mu: right(w, 1.01 * mu), DRIVEN,
                 id="friction 1 % too large"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), FORMULAS)
def test_a_wrong_formula_or_another_reading_turns_a_row_red(
    owner, name, fault, row, broken, judged, without_fault, red
):
    without_fault(FRICTION)
    broken(owner, name, fault)
    assert row in names(red(judged(FRICTION, drawn=False)))


def moving(change):
    return lambda right: lambda q: change(right(q))


def unguarded(right):
    def engaged_fem(q, w, dt, *moves, **how):
        if how.get("D_V", 0) is None:
            how |= {"D_V": 1e-3, "guard": False}
        return right(q, w, dt, *moves, **how)

    return engaged_fem


STEPS = [
    pytest.param(engagement_steps, "motion", moving(lambda m: replace(m, mu_s=m.mu_c)), AFTER,
                 id="T_bis of Coulomb's friction"),
    pytest.param(engagement_steps, "motion", moving(lambda m: replace(m, gamma_b=0.0)), AFTER,
                 id="friction that does not fall"),
    pytest.param(engagement_steps, "motion", moving(lambda m: replace(m, mu_s=1.02 * m.mu_s)),
                 OVERRUN, id="friction 2 % too large"),
    pytest.param(engagement_steps, "motion", moving(lambda m: replace(m, K_r=12 * m.K_r)), DRIVEN,
                 id="springs of all sprags on one"),
    pytest.param(engagement_steps, "motion", moving(lambda m: replace(
        m, alpha_max=m.alpha_max / 2)), DRIVEN, id="springs half as far wound"),
    pytest.param(reference, "between", moving(lambda mu: 1.002 * mu), BEGINS,
                 id="slip at 0.2 % more friction"),
    pytest.param(reference, "engaged_fem", unguarded, AFTER, id="no guard and a narrow band"),
    pytest.param(reference, "engaged_fem", unguarded, ENDS, id="slip without an end"),
]  # fmt: skip


@pytest.mark.soak  # integrated anew for every fault
@pytest.mark.parametrize(("owner", "name", "fault", "row"), STEPS)
def test_wrong_steps_turn_a_row_red(owner, name, fault, row, steps_alone, broken, red):
    broken(owner, name, fault)
    assert row in names(red(steps_alone()))


def set_to(row, column, value):
    def change(arrays, key):
        found = np.array(arrays[key])
        found[(row, column) if found.ndim == 2 else column] = value
        return found

    return change


@pytest.mark.parametrize(
    ("key", "change", "row"),
    [
        ("narrow", set_to(0, 0, 0.0), REFUSED), ("unguarded", set_to(0, slice(None), 9e3), HANGS),
        ("guard", set_to(3, 3, 0.0), RIGHT), ("guard", set_to(0, 3, 1.0), WRONG),
        ("sweep", set_to(1, 2, 6400.0), CHOSEN), ("boundaries", set_to(0, 1, 0.97), TAN),
    ],
)  # fmt: skip
def test_a_fact_that_does_not_hold_is_red(key, change, row, red):
    levels = [solve_level(FRICTION, PAPER, n, default_folder()) for n in FRICTION.levels]
    other = [
        replace(s, result=replace(s.result, arrays={**s.result.arrays, key: change(
            s.result.arrays, key)})) if key in s.result.arrays else s
        for s in levels
    ]  # fmt: skip
    assert row in names(red(judge_case(Job(FRICTION, PAPER, drawn=False), other)))
