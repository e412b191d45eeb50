"""Wedge, engagement and friction of sprags: words agree with time steps, deflections with rings."""

import math

import numpy as np
import pytest

from analytic.sprag import elastic
from analytic.sprag.history import Phase
from verify.cases.sprag.engagement import model
from verify.cases.sprag.engagement import reference as steps
from verify.cases.sprag.engagement.case import ENGAGEMENT, SpragEngagement
from verify.cases.sprag.friction import formulas, reference
from verify.cases.sprag.friction.case import FRICTION, SpragFriction
from verify.cases.sprag.wedge.case import WEDGE, WedgedSprag
from verify.cases.sprag.wedge.figures import parts_of
from verify.cases.sprag.wedge.model import rigid_force
from verify.jobs.level import solve_level

PAPER, RUBBING = SpragEngagement(), SpragFriction()
LATE = {"mu_s": 0.056, "mu_c": 0.05, "K_r": 4e-4}  # its sprags are caught late


def other(q, **changes):
    return type(q).model_validate(q.model_dump() | changes)


def engaged(q, dt=1e-5, **how):
    return steps.engaged_fem(q, model.wedge(q), dt, **how)


@pytest.mark.parametrize(
    ("case", "changes", "verdict", "words"),
    [
        (ENGAGEMENT, {}, "locks", "locks: the largest normal force is 62"),
        (
            ENGAGEMENT,
            {"mu_s": 0.05, "mu_c": 0.05},
            "slips",
            "slips: the friction coefficient is below",
        ),
        (ENGAGEMENT, {"T": 120.0}, "over the end", "rolls over"),
        (FRICTION, {}, "locks", "locks: μ_s is 2.17 times"),
        (FRICTION, {"mu_s": 0.05, "mu_c": 0.05}, "slips", "slips permanently"),
        (FRICTION, LATE, "slips", "locks: μ_s is 1.01"),
        (FRICTION, {"T": 120.0}, "over the end", "rolls over"),
    ],
)
def test_the_words_of_the_formulas_are_what_the_steps_do(case, changes, verdict, words):
    q = other(case.inputs(), **changes)
    assert engaged(q).verdict == verdict
    assert case.findings(q, case.analytic(q))[0].startswith(words)
    assert bool(case.too_large(q)) == (verdict != "locks")
    assert case.equations(q, case.analytic(q))


def test_a_band_too_narrow_for_the_step_is_one_line_and_no_traceback():
    q = other(PAPER, D_V=1e-3, K_r=4e-4, T=40.0)
    failure = solve_level(ENGAGEMENT, q, 1, None).failure
    assert "band of sticking is too narrow" in failure
    assert "\n" not in failure


@pytest.mark.parametrize(
    ("speed", "mu", "outside"), [(100.0, 0.9 * math.tan(RUBBING.nu_0), False), (-100.0, 0.12, True)]
)
def test_driven_it_is_the_inner_contact_that_slides_and_overrunning_the_outer(speed, mu, outside):
    w = model.wedge(RUBBING)
    assert formulas.sliding(w, math.copysign(mu, speed)).outside == outside
    run = steps.engaged_fem(
        RUBBING, w, 1e-5, moves=reference.held(reference.rough(RUBBING, mu), C_rl=0.0, I_bi=1.0),
        course=reference.Torque.step(0.0), duration=reference.SLIDES,
        speeds=reference.Speeds(inner=speed),
    )  # fmt: skip
    late = run.phases[len(run.t) // 2 :]
    assert (late[:, int(outside)] == Phase.SLIP).mean() > 0.9
    assert (late[:, 1 - int(outside)] == Phase.STICK).mean() > 0.9


SPRAG = WedgedSprag()


def test_elastic_yields_are_those_of_rings_under_single_loads_and_of_the_column():
    yields = dict(parts_of(SPRAG, np.array([rigid_force(SPRAG)])))
    assert sum(float(p[0]) for p in yields.values()) == pytest.approx(
        SPRAG.at_share(1.0).H, rel=1e-12
    )
    P = rigid_force(SPRAG) / SPRAG.l
    a_i, a_e = (float(a) for a in SPRAG.bodies.half_widths(np.array(rigid_force(SPRAG))))
    for name, r_i, r_o, loaded, a in (
        ("inner", SPRAG.R_id, SPRAG.R_i, "rim", a_i), ("outer", SPRAG.R_e, SPRAG.R_ed, "bore", a_e),
    ):  # fmt: skip
        ring = elastic.LoadedRace(
            r_i=r_i, r_o=r_o, E=SPRAG.E, nu=SPRAG.nu, assumption="plane strain", loaded=loaded,
            n=SPRAG.z, P=P, a=a,
        )  # fmt: skip
        both = float(yields[f"{name} mean"][0] + yields[f"{name} indentation"][0])
        assert both == pytest.approx(abs(ring.displacement(ring.r, 0.0)), rel=2e-4)


def test_a_sprag_rolls_over_where_its_flank_comes_to_the_race():
    v = WEDGE.analytic(SPRAG)
    for share, verdict in ((0.99, "holds"), (1.01, "rolls over")):
        q = WedgedSprag(T=share * v["T_roll"])
        own = WEDGE.analytic(q)
        assert WEDGE.findings(q, own)[0].startswith(
            "rolls over: a contact reaches the sprag's flank"
            if verdict == "rolls over"
            else "holds if the friction coefficient exceeds"
        )
    assert WEDGE.summary(q, own)["verdict"] == "rolls over"
