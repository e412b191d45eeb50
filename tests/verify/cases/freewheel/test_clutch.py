"""The freewheel of a user: statements follow from numbers, and limits are at the stated values."""

from dataclasses import replace

import numpy as np
import pytest

from tests.verify.cases.rows import context, failed
from verify.cases.freewheel.clutch import reference
from verify.cases.freewheel.clutch.case import CLUTCH, FreewheelClutch
from verify.cases.freewheel.clutch.classes import light
from verify.cases.freewheel.clutch.figures import lights

CUP = {"kind": "outer cam", "R": 10e-3, "r": 2e-3, "X": 13.8832168e-3, "R_a": 17.5e-3, "r_b": 0.0}
TIGHT = {"X": 11.499e-3, "F_ax": 0.0}


def values(**changes):
    return dict(FreewheelClutch(**changes).values)


def findings(**changes):
    q = FreewheelClutch(**changes)
    with np.errstate(over="raise", divide="raise", invalid="raise"):
        return CLUTCH.findings(q, dict(q.values))


@pytest.mark.parametrize(
    ("changes", "verdict"),
    [
        ({}, "green: μ/μ_req = 1.109: by Coulomb's law the clutch holds"),
        ({"mu": 0.065}, "yellow: μ/μ_req = 0.9013: by Coulomb's law the clutch slips"),
        ({"F_ax": 3000.0}, "red: μ/μ_req = 0.552: by Coulomb's law the clutch slips"),
        ({"T": -3.0}, "free: the torque turns against the locking direction"),
        ({"T": 0.0}, "red: without torque the rollers are not pressed: no friction resists F_ax"),
        ({"T": 0.0, "F_ax": 0.0}, "green: no load"),
        ({"mu": 0.06}, "red: tan α_0 = 0.06116 exceeds μ = 0.06: the clutch releases itself"),
        ({"T": 1e6}, "red: no equilibrium at T = 1000 kN m: the contacts are as wide as the"),
        (CUP | {"T": 40.0}, "red: no equilibrium at T = 40 N m: the rollers pop through"),
        ({"mu": 1.0, "T": 4000.0}, "red: the rollers are beyond the ends of the cam flats "
         "(T_c = 2717 N m); friction alone would hold"),
        ({"T": 140.0, "mu": 0.5}, "overloaded: μ/μ_req = 6.019: friction holds"),
        ({"e_lim": 0.005}, "overloaded: μ/μ_req"),
    ],
)  # fmt: skip
def test_the_verdict_comes_first(changes, verdict):
    q = FreewheelClutch(**changes)
    assert findings(**changes)[0].startswith(verdict)
    assert light(q, dict(q.values)) == verdict.partition(":")[0]


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({}, "are not included): first the contacts slip (110.5 N m, 4.25 times T)"),
        ({"e_lim": 0.01}, "first the tilting couple shifts the contact forces by (e/L)_lim"),
        (CUP, "first the inner contacts reach p_lim (29.21 N m"),
        ({"T": 130.0, "F_ax": 0.0}, "already beyond a limit of the torque: the inner contacts"),
        ({"F_ax": 1100.0}, "friction transmits F_ax = 1100 N at torques from 29.35 to 102.7 N m"),
        (CUP | {"T": 40.0}, "R_a is the outer radius of the housing of a drawn cup"),
        (
            {"T": 1e9},
            "no R_a, X or L near the given values is sufficient for this torque",
        ),
        (TIGHT, "random sample of 20,000 clutches with ±5 µm on X"),
        (CUP | {"T": 30.0, "X_tol": 5e-5}, "pop through"),
    ],
)
def test_limits_and_advice_are_stated(changes, words):
    assert words in "; ".join(findings(**changes))


def test_the_map_is_green_where_the_class_is():
    changes = {"mu": 0.5, "T": 140.0}
    figure = lights(FreewheelClutch(**changes))
    for k in (60, 170):
        T, tops = float(figure.x[k]), [np.nan_to_num(zone.top[k]) for zone in figure.zones]
        for kN in (0.05 * figure.y_top, 0.6 * figure.y_top):
            zone = figure.zones[next(n for n, top in enumerate(tops) if top >= kN)]
            there = FreewheelClutch(**changes | {"T": T, "F_ax": kN * 1e3})
            assert light(there, dict(there.values)) in zone.name.replace("friction holds, ", "")
    assert any(
        c.name.startswith("the diagram ends: the rollers pop through")
        for c in lights(FreewheelClutch(**CUP)).curves
    )


def test_friction_that_is_not_needed_or_not_enough_fails_a_fact():
    """mu_req of F_ax on each roller would hold the whole load, 1 % below it too."""
    right = context(CLUTCH)
    assert list(right.fem[-1].arrays["around"]) == [0.0, 1.0]
    for around, name in (([1.0, 1.0], "friction 1 % below"), ([0.0, 0.0], "friction 1 % above")):
        wrong = replace(right.fem[-1], arrays={"around": np.array(around)})
        (row,) = failed(CLUTCH, "friction 1 %", replace(right, fem=[wrong]))
        assert row.startswith(name)
    one, whole_load = (values(F_ax=F)["mu_req"] for F in (600.0, 8 * 600.0))
    assert 0.99 * whole_load > reference.AROUND[1] * one
