"""A wedged sprag: yields of elastic bodies, the work of the torque, and independent intervals."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.sprag import closure, course, elastic, parts, printed
from verify.cases.sprag.wedge import model
from verify.cases.sprag.wedge.case import WEDGE, WedgedSprag
from verify.cases.sprag.wedge.figures import parts_of
from verify.cases.sprag.wedge.model import rigid_force
from verify.cases.sprag.wedge.sketch import outline

Q = WedgedSprag()


def test_elastic_yields_are_those_of_rings_under_single_loads_and_of_the_column():
    yields = dict(parts_of(Q, np.array([rigid_force(Q)])))
    assert sum(float(p[0]) for p in yields.values()) == pytest.approx(Q.at_share(1.0).H, rel=1e-12)
    P = rigid_force(Q) / Q.l
    a_i, a_e = (float(a) for a in Q.bodies.half_widths(np.array(rigid_force(Q))))
    for name, r_i, r_o, loaded, a in (
        ("inner", Q.R_id, Q.R_i, "rim", a_i), ("outer", Q.R_e, Q.R_ed, "bore", a_e),
    ):  # fmt: skip
        ring = elastic.LoadedRace(r_i=r_i, r_o=r_o, E=Q.E, nu=Q.nu, assumption="plane strain",
                                  loaded=loaded, n=Q.z, P=P, a=a)  # fmt: skip
        both = float(yields[f"{name} mean"][0] + yields[f"{name} dent"][0])
        assert both == pytest.approx(abs(ring.displacement(ring.r, 0.0)), rel=2e-4)


def test_the_work_of_the_torque_is_that_of_the_yields_but_not_for_the_printed_closure():
    clutch, N, h = Q.clutch, rigid_force(Q), 1e-4
    low, high = (closure.wedged(clutch, N * (1 + s)) for s in (-h, h))
    turn = course.rolled(clutch, N * (1 + h)) - course.rolled(clutch, N * (1 - h))
    work = Q.z * N * (high.yields.H - low.yields.H)
    assert float(closure.wedged(clutch, N).T * turn / work) == pytest.approx(1.0, abs=1e-3)
    before, after = (printed.wedged(clutch, N * (1 + s)).alpha_b for s in (-h, h))
    assert 0.85 < float((after - before) / (high.alpha_b - low.alpha_b)) < 0.92


def test_intervals_are_derived_apart_from_the_formula_that_they_judge(broken):
    N = rigid_force(Q)
    before = model.bounds(Q.part, N).plane()
    assert model.bounds(Q.part, N).plane_yields() == pytest.approx(
        float(Q.bodies.plane.compliance.yields(N).H), rel=2e-3
    )
    broken(parts.Parts, "plane", lambda right: lambda self: replace(right(self), sprag=1e-9))
    assert model.bounds(Q.part, N).plane() == pytest.approx(before, rel=1e-9)


def test_a_sprag_rolls_over_where_its_flank_comes_to_the_race():
    v = WEDGE.analytic(Q)
    for share, verdict in ((0.99, "holds"), (1.01, "rolls over")):
        q = WedgedSprag(T=share * v["T_roll"])
        own = WEDGE.analytic(q)
        assert WEDGE.findings(q, own)[0].startswith(
            "rolls over: a contact reaches the sprag's flank"
            if verdict == "rolls over"
            else "holds with friction above"
        )
    assert WEDGE.summary(q, own)["verdict"] == "rolls over"


def test_the_drawn_sprag_touches_both_races():
    body = outline(Q, turned=0.0, alpha_b=0.0, OC_e=float(Q.sprag.OC_e))
    r = np.hypot(*body.T)
    assert r.min() == pytest.approx(Q.R_i, rel=1e-9)
    assert r.max() == pytest.approx(Q.R_e, rel=1e-9)
