"""The engineer's freewheel: what is stated follows from numbers, and limits lie where stated."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from tests.verify.cases.rows import context, failed
from tests.verify.template_text import whole
from verify.answers.template import template
from verify.app.cli import run
from verify.cases.freewheel.clutch import reference
from verify.cases.freewheel.clutch.case import CLUTCH, FreewheelClutch
from verify.cases.freewheel.clutch.classes import light
from verify.cases.freewheel.clutch.figures import lights

CUP = {"kind": "outer cam", "R": 10e-3, "r": 2e-3, "X": 13.8832168e-3, "R_a": 17.5e-3, "r_b": 0.0}
TIGHT = {"X": 11.499e-3, "F_ax": 0.0}
SHARP = {"X_tol": 0.0, "r_tol": 0.0, "R_tol": 0.0, "s_mu": 0.0}


def values(**changes):
    return dict(FreewheelClutch(**changes).values)


def findings(**changes):
    q = FreewheelClutch(**changes)
    with np.errstate(over="raise", divide="raise", invalid="raise"):
        return CLUTCH.findings(q, dict(q.values))


def number(line, before):
    """The number that follows these words."""
    return float(line.partition(before)[2].split()[0].strip(",;"))


@pytest.mark.parametrize(
    ("changes", "verdict"),
    [
        ({}, "green: μ/μ_req = 1.109: by Coulomb's law it holds"),
        ({"mu": 0.065}, "yellow: μ/μ_req = 0.9013: by Coulomb's law it slips"),
        ({"F_ax": 3000.0}, "red: μ/μ_req = 0.552: by Coulomb's law it slips"),
        ({"T": -3.0}, "free: the torque turns against the locking direction"),
        ({"T": 0.0}, "red: without torque nothing presses the rollers: F_ax = 600 N"),
        ({"T": 0.0, "F_ax": 0.0}, "green: at rest"),
        ({"mu": 0.06}, "red: tan α_0 = 0.06116 exceeds μ = 0.06: the clutch releases itself"),
        ({"T": 1e6}, "red: no equilibrium at T = 1000 kN m: contacts as wide as the rollers'"),
        (CUP | {"T": 40.0}, "red: no equilibrium at T = 40 N m: the rollers go through"),
        ({"mu": 1.0, "T": 4000.0}, "red: the rollers are past the flats' corners (T_c = 2717 N m); "
         "friction alone would hold"),
        ({"T": 140.0, "mu": 0.5}, "overloaded: μ/μ_req = 6.019: friction holds"),
        ({"p_lim": 2.06e9}, "overloaded: μ/μ_req"),
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
        ({}, "rollers' ends: first the contacts slip (110.5 N m, 4.25 T)"),
        ({"e_lim": 0.01}, "first the tilting couple moves the contact forces by (e/L)_lim"),
        (CUP, "first the inner contacts reach p_lim (29.21 N m"),
        ({"T": 140.0, "mu": 0.5}, "the inner contacts bear 42"),
        ({"e_lim": 0.005}, "the rollers tilt: e/L = 0.00"),
        ({"T": 200.0, "F_ax": 0.0}, "without axial load friction holds up to 113.3 N m"),
        ({"T": 130.0, "F_ax": 0.0}, "already beyond a limit of the torque: the inner contacts"),
        ({"F_ax": 1100.0}, "friction would bear F_ax = 1100 N from 29.35 to 102.7 N m"),
        (CUP | {"T": 40.0}, "R_a is that of the housing that stiffens a drawn cup"),
        ({"T": 1e9}, "no R_a, X or L near these bears the torque: the clutch is too small"),
        ({"mu": 0.065}, "are those it would have if it held"),
        (TIGHT, "of 20,000 clutches of like rollers with ±5 µm on X"),
        (CUP | {"T": 30.0, "X_tol": 5e-5}, "let the rollers through"),
        ({"X": 11.49999e-3} | SHARP, "(μ/μ_req by "),
    ],
)
def test_limits_and_advice_are_stated(changes, words):
    assert words in "; ".join(findings(**changes))


@pytest.mark.parametrize("changes", [{"mu": 0.065}, CUP | {"mu": 0.055, "T": 5.0}])
def test_flats_and_friction_that_are_advised_hold_and_less_does_not(changes):
    advice = "; ".join(findings(**changes))
    for goal, at in ((1.0, "1.0: X = "), (1.1, "1.1: X = ")):
        X = number(advice, at) * 1e-3
        for off, holds in ((2e-8, True), (-2e-8, False)):
            v = values(**changes | {"X": X + off})
            assert (v["safety"] >= goal and v["mu_0"] <= changes["mu"]) == holds
    mu = number(advice, "1.0: μ = ")
    assert values(**changes | {"mu": 1.001 * mu})["safety"] >= 1
    assert values(**changes | {"mu": 0.998 * mu})["safety"] < 1


def test_a_micrometre_changes_ratio_and_angle_as_stated():
    (line,) = (x for x in findings() if x.startswith("sensitivity of α_0"))
    for name in ("X", "r", "R"):
        part, q = line.partition(f"1 µm on {name} by ")[2], FreewheelClutch()
        low, high = (values(**{name: getattr(q, name) + s * 1e-8}) for s in (-1, 1))
        turned = math.degrees(high["alpha_0"] - low["alpha_0"]) * 50
        assert float(part.partition("°")[0]) == pytest.approx(turned, abs=5.1e-4)
        grown = 100 * (high["safety"] - low["safety"]) / (high["safety"] + low["safety"]) * 100
        assert number(part, "μ/μ_req by ") == pytest.approx(grown, rel=0.06)  # of two digits


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
        c.name.startswith("the map ends: the rollers go")
        for c in lights(FreewheelClutch(**CUP)).curves
    )


def test_check_answers_in_words_in_json_and_in_a_report_that_offers_no_finite_elements(
    tmp_path, capsys
):
    path = tmp_path / "clutch.toml"
    text = whole(template(CLUTCH))
    path.write_text(text)
    assert run(["check", str(path), "--json"]) == 3  # 2.7 % of the clutches within tolerance slip
    record = json.loads(capsys.readouterr().out)
    assert record["details"]["verdict"] == "green"
    assert "0.0268 of the clutches" in record["answer"]["reasons"][0]
    path.write_text(text.replace('# E_r = "310 GPa"', 'E_r = "310 GPa"', 1))
    run(["check", str(path), "--out", str(tmp_path / "out")])
    reason = "finite elements take one material for all"
    assert f"(check --fem is not possible: {reason}" in capsys.readouterr().out
    assert reason in (tmp_path / "out" / "report.html").read_text("utf-8")


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


def test_the_template_s_outer_cam_is_a_clutch(tmp_path, capsys):
    head, other = template(CLUTCH).split("\n# Or an outer cam")
    lines = [line.removeprefix("#   ") for line in other.splitlines()[1:]]
    names = {line.partition(" =")[0] for line in lines}
    stays = [x for x in head.splitlines() if x.removeprefix("# ").partition(" =")[0] not in names]
    path = tmp_path / "cup.toml"
    path.write_text("\n".join(stays + lines))
    assert run(["check", str(path)]) == 0
    assert "green: " in capsys.readouterr().out


def test_with_flats_nearer_by_what_is_to_spare_the_contacts_slip():
    spare = number("; ".join(findings(**CUP)), "with X smaller by ") * 1e-6
    for share, holds in ((0.98, True), (1.02, False)):
        v = values(**CUP | {"X": CUP["X"] - share * spare})
        assert (v["safety"] >= 1 and v["mu_0"] <= 0.08) == holds


def test_shares_of_the_classes_add_up_and_what_does_not_wedge_is_red():
    v = values(mu=0.06)
    assert sum(v[f"share_{c}"] for c in ("green", "yellow", "red")) == pytest.approx(1)
    assert v["share_red"] > 0.5  # tan α_0 = 0.0612
    tight = values(**TIGHT)
    assert tight["share_red"] == pytest.approx(tight["P_no_wedge"])
    assert tight["P_slip"] == 0
    assert "P_slip" not in values(**SHARP)


@pytest.mark.parametrize(
    ("changes", "passed"),
    [({}, set()), ({"T": 4000.0, "mu": 1.0}, {"pressure_inner", "pressure_outer", "corner",
                                              "pressure"})],
)  # fmt: skip
def test_programs_read_the_verdict_the_ratio_and_the_limits(changes, passed):
    q = FreewheelClutch(**changes)
    v = dict(q.values)
    record = json.loads(json.dumps(CLUTCH.summary(q, v)))
    assert (record["verdict"], record["ratio"]) == (light(q, v), v.get("safety"))
    assert {x["key"] for x in record["limits"] if x["passed"]} == passed
