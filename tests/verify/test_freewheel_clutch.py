"""The engineer's freewheel: words that follow from numbers, limits where they are said to be."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from analytic.freewheel import criterion, remedies, state
from analytic.freewheel.scatter import DRAWS
from tests.conftest import solved
from tests.verify.template_text import whole
from verify.answers.template import template
from verify.app.cli import run
from verify.cases.freewheel.clutch import comparisons, reference
from verify.cases.freewheel.clutch.case import CLUTCH, FreewheelClutch
from verify.cases.freewheel.clutch.classes import light
from verify.cases.freewheel.clutch.figures import lights
from verify.cases.freewheel.clutch.recommendations import GOALS
from verify.cases.freewheel.star import Star
from verify.core import units
from verify.core.inputs import InputError, build
from verify.core.results import Status
from verify.jobs.level import Job, judge_case

CUP = {"kind": "outer cam", "R": 10e-3, "r": 2e-3, "X": 13.8832168e-3, "R_a": 17.5e-3, "r_b": 0.0}
SHARP = {"X_tol": 0.0, "r_tol": 0.0, "R_tol": 0.0, "s_mu": 0.0}

pytestmark = pytest.mark.xdist_group("freewheel-clutch")


def own(**changes):
    return FreewheelClutch(**changes)


def analytic(q):
    return dict(q.values)


def said(**changes):
    q = own(**changes)
    with np.errstate(over="raise", divide="raise", invalid="raise"):
        return CLUTCH.findings(q, analytic(q))


def required(q, *, T=None, F_ax=None):
    T, F_ax = T or q.T, q.F_ax if F_ax is None else F_ax
    alpha = state.loaded(q.clutch, T).alpha
    return float(criterion.required_friction(alpha=alpha, T=T, F_ax=F_ax, R=q.cam.race))


# What is said first.
@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({}, "green: μ/μ_req = 1.109: by Coulomb's law it holds"),
        ({"mu": 0.065}, "yellow: μ/μ_req = 0.9013: by Coulomb's law it slips"),
        ({"F_ax": 3000.0}, "red: μ/μ_req = 0.552: by Coulomb's law it slips"),
        ({"T": -3.0}, "free: the torque turns against the locking direction"),
        ({"T": 0.0}, "red: without torque nothing presses the rollers: F_ax = 600 N"),
        ({"T": 0.0, "F_ax": 0.0}, "green: at rest"),
        ({"mu": 0.06}, "red: tan α_0 = 0.06116 exceeds μ = 0.06: the clutch releases itself"),
        ({"T": 1e6}, "red: no equilibrium at T = 1000 kN m: contacts as wide as the rollers'"),
        (CUP, "green: μ/μ_req = 1.464"),
        (CUP | {"T": 40.0}, "red: no equilibrium at T = 40 N m: the rollers go through"),
        (CUP | {"mu": 0.06}, "red: tan α_0 = 0.06993 exceeds μ = 0.06"),
    ],
)
def test_the_verdict_comes_first(changes, words):
    assert said(**changes)[0].startswith(words)


def test_a_clutch_past_its_corners_is_red_though_friction_holds():
    wide = {"mu": 1.0, "T": 4000.0}
    v = analytic(own(**wide))
    assert v["safety"] > 1
    assert v["T_corner"] < 4000
    assert light(own(**wide), v) == "red"
    assert said(**wide)[0].startswith("red: the rollers are past the flats' corners (T_c = 2717 N")
    assert "friction alone would hold" in said(**wide)[0]


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"T": 140.0, "mu": 0.5}, "the inner contacts bear 42"),
        ({"p_lim": 2.06e9}, "the rollers' ends bear 20"),
        ({"e_lim": 0.005}, "the rollers tilt: e/L = 0.00"),
    ],
)
def test_pressure_or_tilt_beyond_its_limit_is_not_green(changes, words):
    q = own(**changes)
    v = analytic(q)
    assert v["safety"] > 1
    assert light(q, v) == "overloaded"
    assert said(**changes)[0].startswith("overloaded: μ/μ_req")
    assert words in said(**changes)[0]
    assert light(own(), analytic(own())) == "green"


def test_the_map_is_green_where_the_class_is():
    for changes in ({"mu": 0.5, "T": 140.0}, {"mu": 1.0, "T": 2600.0}, {"e_lim": 0.005}):
        q = own(**changes)
        figure = lights(q)
        for k in (60, 110, 170, 230):
            T, tops = float(figure.x[k]), [np.nan_to_num(zone.top[k]) for zone in figure.zones]
            for F_ax in (0.05, 0.3, 0.6, 0.9):
                kN = F_ax * figure.y_top
                zone = figure.zones[next(n for n, top in enumerate(tops) if top >= kN)]
                there = own(**changes | {"T": T, "F_ax": kN * 1e3})
                expected = light(there, analytic(there))
                assert expected in zone.name.replace("friction holds, ", "")


def test_a_cup_whose_loaded_angle_alone_would_hold_is_red():
    q = own(**CUP | {"mu": 0.06})
    v = analytic(q)
    assert v["safety"] > 1
    assert light(q, v) == "red"


def test_the_first_limit_of_each_load_is_named_with_its_margin():
    found = said()
    first = "stresses of rings and rollers' ends: first the contacts slip (110.5 N m, 4.25 T)"
    assert first in found[1]
    assert "as the axial load grows: first the contacts slip (1008 N, 1.68 F_ax)" in found[3]
    assert "first the inner contacts reach p_lim (29.21 N m" in said(**CUP)[1]
    tilting = said(e_lim=0.01)[3]
    assert "first the tilting couple moves the contact forces by (e/L)_lim" in tilting
    assert "as wide" not in said(mu=1.0)[1]


def test_limits_far_behind_the_first_are_not_told():
    assert "then" not in said()[3]  # 15.66 kN, where the contacts slip at 1008 N


# What to change.
@pytest.mark.parametrize("changes", [{"mu": 0.06}, {"mu": 0.065}, CUP | {"mu": 0.055, "T": 5.0}])
@pytest.mark.parametrize("goal", GOALS)
def test_the_flats_advised_hold_as_they_are_said_to(changes, goal):
    q = own(**changes)
    X = q.X + remedies.moved_to(q.duty, goal)
    v = analytic(own(**changes | {"X": X}))
    assert v["mu_0"] <= q.mu
    assert v["safety"] >= goal * (1 - 1e-12)
    less = analytic(own(**changes | {"X": X - 2e-9}))  # beyond the step of the search
    assert less["safety"] < goal or less["mu_0"] > q.mu
    assert any(f"X = {X * 1e3:.7g} mm" in f for f in said(**changes))


@pytest.mark.parametrize("changes", [{"mu": 0.065}, CUP | {"mu": 0.06}])
def test_the_friction_advised_is_just_enough(changes):
    q = own(**changes)
    for goal in GOALS:
        mu = remedies.friction_for(q.duty, goal)
        v = analytic(own(**changes | {"mu": mu * (1 + 1e-9)}))
        assert v["safety"] >= goal
        assert v["mu_0"] <= mu * (1 + 1e-9)
        assert any(f"μ = {mu:.4g}" in f for f in said(**changes))


@pytest.mark.parametrize("changes", [{}, CUP])
def test_flats_nearer_by_what_is_to_spare_just_hold(changes):
    q = own(**changes)
    spare = remedies.to_spare(q.duty)
    for off, holds in ((-1e-7, True), (1e-7, False)):
        v = analytic(own(**changes | {"X": q.X - spare - off}))
        assert (v["safety"] >= 1 and v["mu_0"] <= q.mu) == holds
    assert any(f"with X smaller by {spare * 1e6:.3g} µm" in f for f in said(**changes))


def test_a_micrometre_changes_the_ratio_as_it_is_said_to():
    q, h = own(), 1e-8
    for name, share in remedies.per_micrometre(q.duty).items():
        low, high = (analytic(own(**{name: getattr(q, name) + s * h}))["safety"] for s in (-1, 1))
        assert (high - low) / (high + low) * 1e-6 / h == pytest.approx(share, rel=1e-4)


def test_a_torque_that_no_state_bears_is_borne_by_what_is_advised():
    cup = CUP | {"T": 40.0}
    found = dict(remedies.bearing(own(**cup).duty))
    assert set(found) == {"R_a", "L", "X"}
    for name, value in found.items():
        worse = value + (1e-6 if name == "X" else -1e-5)
        assert "alpha" in analytic(own(**cup | {name: value * (1 + 1e-9 * (name != "X"))}))
        assert "alpha" not in analytic(own(**cup | {name: worse}))
        assert f"{name} = {value * 1e3:.5g}"[:10] in said(**cup)[1]
    assert "R_a is that of the housing that stiffens a drawn cup" in said(**cup)[1]


@pytest.mark.parametrize("exact", [{}, SHARP])
def test_a_wedge_of_a_hundredth_of_a_micrometre_is_spoken_of(exact):
    assert any(
        f.startswith("sensitivity of α_0") and "μ/μ_req" in f for f in said(X=11.49999e-3, **exact)
    )


def test_a_torque_far_beyond_is_not_met_with_rollers_of_kilometres():
    assert said(T=1e9)[1] == "no R_a, X or L near these bears the torque: the clutch is too small"


def test_the_template_s_outer_cam_is_a_clutch(tmp_path, capsys):
    text = template(CLUTCH)
    assert "with the housing that a drawn cup is pressed into" in text
    head, other = text.split("\n# Or an outer cam")
    lines = [line.removeprefix("#   ") for line in other.splitlines()[1:]]
    names = {line.partition(" =")[0] for line in lines}
    kept = [x for x in head.splitlines() if x.removeprefix("# ").partition(" =")[0] not in names]
    path = tmp_path / "cup.toml"
    path.write_text("\n".join(kept + lines))
    assert run(["check", str(path)]) == 0
    assert "green: " in capsys.readouterr().out


def test_the_map_of_an_outer_cam_says_where_it_ends():
    assert any(c.name.startswith("the map ends: the rollers go") for c in lights(own(**CUP)).curves)
    assert not any(c.name.startswith("the map ends") for c in lights(own()).curves)
    assert [zone.name for zone in lights(own()).zones if "yellow" in zone.name] == [
        "yellow: slips by Coulomb"
    ]


# How it is told.
def test_without_axial_load_friction_holds_up_to_a_torque():
    assert "without axial load friction holds up to 113.3 N m" in said(T=200.0, F_ax=0.0)
    assert "without axial load friction holds up to 113.3 N m" in said(T=0.0, F_ax=0.0)[0]


def test_limits_that_torque_alone_exceeds_are_not_those_of_the_axial_load():
    assert not any("(0 N" in f or "at 0 N" in f for f in said(T=140.0, mu=0.5))


def test_limits_passed_are_told_the_worst_first():
    passed = [f for f in said(T=4000.0, mu=1.0) if f.startswith("already")]
    assert ["ends of the cam flats" in f for f in passed] == [True, False, False]


def test_large_torques_and_pressures_are_told_in_larger_units():
    assert "17.72 kN m" in said(T=3e4)[0]
    beyond = own(T=4000.0, mu=1.0)
    assert CLUTCH.warnings(beyond, analytic(beyond))[0].startswith("15.3 GPa")


def test_limits_already_passed_are_told_and_not_said_to_come():
    found = said(T=130.0, F_ax=0.0)
    assert any(f.startswith("already beyond a limit of the torque: the inner") for f in found)
    assert not any("first the inner" in f for f in found)


def test_a_clutch_that_slips_is_told_where_it_would_hold():
    assert "friction would bear F_ax = 1100 N from 29.35 to 102.7 N m" in said(F_ax=1100.0)
    assert "friction would bear F_ax = 3000 N at no torque" in said(F_ax=3000.0)


@pytest.mark.parametrize("p_lim", [2.2e9, 4e9])  # linear line load, and lifted off at one end
def test_the_axial_load_at_which_the_ends_reach_p_lim_makes_that_pressure(p_lim):
    q = own(p_lim=p_lim)
    (F,) = (limit.at for limit in q.duty.of_axial_load if limit.key == "pressure")
    assert analytic(own(p_lim=p_lim, F_ax=F))["p_end"] == pytest.approx(p_lim, rel=1e-9)


def test_the_zones_of_the_figure_end_where_the_criterion_says():
    q = own()
    figure = lights(q)
    k = int(np.argmin(np.abs(figure.x - q.T)))
    for zone, share in zip(figure.zones[1:3], (1.0, 0.8), strict=True):
        at = required(q, T=float(figure.x[k]), F_ax=float(zone.top[k]) * 1e3)
        assert q.mu / at == pytest.approx(share, rel=1e-9)


# Tolerances.
def test_the_scatter_is_the_same_every_time_and_that_of_first_order():
    first, again = (own().scatter.drawn.alpha0 for _ in range(2))
    assert np.array_equal(first, again)
    assert np.std(again) == pytest.approx(analytic(own())["s_alpha_0"], rel=0.03)


def test_sensitivities_are_differences_of_the_angle():
    q, h = own(), 1e-9
    for slope in q.slopes:
        ends = [float(own(**{slope.name: getattr(q, slope.name) + s * h}).cam.alpha0)
                for s in (-1, 1)]  # fmt: skip
        assert (ends[1] - ends[0]) / (2 * h) == pytest.approx(slope.slope, rel=1e-5)
    assert sum(s.share for s in q.slopes) == pytest.approx(1)


def test_the_share_that_slips_is_that_of_friction_alone_where_only_it_scatters():
    """P(mu < mu_req) of a normal mu, by its distribution function."""
    q = own(**SHARP | {"s_mu": 0.008})
    z = (analytic(q)["mu_req"] - q.mu) / q.s_mu
    expected = 0.5 * math.erfc(-z / math.sqrt(2))
    sigma = math.sqrt(expected * (1 - expected) / DRAWS)
    assert analytic(q)["P_slip"] == pytest.approx(expected, abs=4 * sigma)


def test_shares_of_the_classes_add_up_and_red_ones_release_themselves_too():
    v = analytic(own(mu=0.06))
    assert sum(v[f"share_{c}"] for c in ("green", "yellow", "red")) == pytest.approx(1)
    assert v["share_red"] > 0.5  # tan α_0 = 0.0612
    cup = analytic(own(**CUP | {"mu": 0.06, "s_mu": 0.0}))
    assert cup["P_slip"] == 1


def test_clutches_without_a_wedge_are_told_apart_from_those_that_slip():
    tight = {"X": 11.499e-3, "F_ax": 0.0}
    v, found = analytic(own(**tight)), said(**tight)
    assert v["P_no_wedge"] > 0.3
    assert v["P_slip"] == 0
    assert v["share_red"] == pytest.approx(v["P_no_wedge"])
    (told,) = (f for f in found if f.startswith("of 20,000"))
    assert told.startswith("of 20,000 clutches of like rollers with ±5 µm on X")
    assert f"{100 * v['P_no_wedge']:.3g} % have no wedge, none slip" in told
    assert "of those that wedge have α_0" in told
    (warned,) = CLUTCH.warnings(own(**tight), v)
    assert warned.startswith("tolerances reach R - 2 r - X = 1 µm: X_tol + 2 r_tol + R_tol = 14 µm")
    assert not CLUTCH.warnings(own(), analytic(own()))
    cup = own(**CUP | {"X": 13.998e-3, "T": 0.1, "F_ax": 0.0})
    assert any("R + 2 r - X = 2 µm" in w for w in CLUTCH.warnings(cup, analytic(cup)))


def test_cups_through_which_rollers_go_are_told():
    through = CUP | {"T": 30.0, "X_tol": 5e-5}
    assert "let the rollers through" in next(f for f in said(**through) if "20,000" in f)


def test_uniform_parts_scatter_more_than_normal_ones_within_the_same_limits():
    normal, uniform = (analytic(own(spread=s))["s_alpha_0"] for s in ("normal", "uniform"))
    assert uniform / normal == pytest.approx(math.sqrt(3))


def test_the_tails_of_friction_stay_where_parts_are_uniform():
    """Parts then scatter more: no fewer clutches slip than of normal ones."""
    normal, uniform = (analytic(own(spread=s))["P_slip"] for s in ("normal", "uniform"))
    assert uniform > normal


def test_exact_parts_have_no_scatter():
    v = analytic(own(**SHARP))
    assert "P_slip" not in v
    assert not any("clutches" in found for found in said(**SHARP))


# Inputs.
@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"r": "17 mm"}, "roller too large: r must be below R, got r = 17 mm, R = 16.5 mm"),
        ({"X": "11.6 mm"}, "no wedge: the roller cannot touch flat and ring unless X + 2 r < R"),
        ({"X": "-3 mm"}, "X + r must be positive, got X = -3 mm"),
        (
            {"r_b": "12 mm"},
            "inner part needs r_b below its flats X, got r_b = 12 mm, limit = 11.39565 mm",
        ),
        ({"R_a": "16.5001 mm"}, "R_a - R = 0.1 µm, tolerance ±5 µm"),
        ({"r_b": "11.39 mm"}, "X - r_b = 5.65 µm, tolerance ±5 µm"),
        (
            {
                "kind": "outer cam",
                "R": "10 mm",
                "r": "2 mm",
                "X": "13.88322 mm",
                "R_a": "15.03 mm",
                "r_b": "0 mm",
                "X_tol": "10 µm",
            },
            "R_a - X/cos(π/z) = 2.911 µm, tolerance ±10.82 µm",
        ),
        (
            {"kind": "outer cam", "R": "10 mm", "r": "2 mm", "X": "13.88322 mm", "R_a": "15 mm"},
            "outer part needs R_a above its flats' corners, got R_a = 15 mm, limit = 15.02709 mm",
        ),
        ({"R_a": "16 mm"}, "outer part needs R_a above its bore"),
        ({"z": 30}, "half the distance of two rollers' centres, got r = 2.5 mm, half = 1.46"),
        ({"X": "8 mm"}, "roller beyond the corner of its flat"),
        ({"r_b": "0 mm"}, "a star is clamped on its bore"),
        ({"kind": "sprag"}, "needs one of inner cam, outer cam"),
        ({"kind": "outer cam"}, "flat cuts the shaft: X must be above R, got X = 11.39565 mm"),
        ({"X_tol": "0.3 mm"}, "X_tol must be below r/10, got X_tol = 300 µm, r = 2.5 mm"),
        ({"R_tol": "0.3 mm"}, "R_tol must be below r/10"),
        ({"s_mu": 0.05}, "s_mu must be below μ/2"),
        ({"e_lim": 0.6}, "must be less than 0.5"),
        ({"F_ax": "-1 N"}, "must be at least 0 N"),
    ],
)
def test_what_makes_no_clutch_is_refused_in_one_line(changes, words):
    raw = {"R": "16.5 mm", "r": "2.5 mm", "X": "11.39565 mm", "R_a": "21 mm", "r_b": "7.5 mm",
           "z": 8, "L": "10 mm", "T": "26 N m", "F_ax": "600 N", "mu": 0.08, "E": "206 GPa",
           "nu": 0.3, "X_tol": "5 µm", "R_tol": "5 µm"}  # fmt: skip
    with pytest.raises(InputError) as refused:
        build(FreewheelClutch, raw | changes, "my.toml")
    assert words in str(refused.value)
    assert "\n" not in str(refused.value)


def test_rules_of_a_star_are_told_in_millimetres():
    with pytest.raises(ValueError, match=r"got X = 11\.6 mm, r = 2\.5 mm, R = 16\.5 mm"):
        Star(X=11.6e-3)


def test_a_modulus_without_its_poisson_s_ratio_is_warned_of():
    for changes, warned in (({"E_r": 310e9}, True), ({"E_r": 310e9, "nu_r": 0.27}, False)):
        found = CLUTCH.warnings(own(**changes), analytic(own(**changes)))
        assert ("E_r is given without ν_r: ν = 0.3 is used for it" in found) == warned


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        (CUP, "inner cams only"),
        ({"T": -1.0}, "a torque that locks"),
        ({"E_r": 310e9}, "one material"),
        ({"T": 1e3}, "displacements are not small"),
        ({"T": 9e3}, "past the corners of their flats"),
        ({"X": 9e-3, "z": 3, "mu": 1.0}, "beyond friction"),
    ],
)
def test_what_elements_cannot_do_is_said_in_one_line(changes, words):
    assert words in CLUTCH.too_large(own(**changes))


def test_check_prints_the_verdict_before_the_numbers_and_puts_it_into_json(tmp_path, capsys):
    path = tmp_path / "clutch.toml"
    path.write_text(whole(template(CLUTCH)))
    assert run(["check", str(path)]) == 3  # 2.7 % of the clutches within tolerance slip
    assert "  green: μ/μ_req = 1.109" in capsys.readouterr().out
    assert run(["check", "--json", str(path)]) == 3
    told = json.loads(capsys.readouterr().out)
    assert told["findings"][0].startswith("green")
    assert (told["details"]["verdict"], told["name"]) == ("green", "my freewheel-clutch")
    assert told["details"]["limits"]
    assert "0.0268 of the clutches" in told["answer"]["reasons"][0]


@pytest.mark.parametrize(
    ("was", "now", "reason"),
    [
        ('T = "26 N m"', 'T = "-26 N m"', "finite elements need a torque that locks"),
        ('# E_r = "310 GPa"', 'E_r = "310 GPa"', "finite elements take one material for all"),
        ("", "", ""),
    ],
)
def test_finite_elements_are_not_offered_where_they_refuse(was, now, reason, tmp_path, capsys):
    path = tmp_path / "clutch.toml"
    path.write_text(whole(template(CLUTCH)).replace(was, now, 1))
    assert run(["check", str(path), "--out", str(tmp_path / "out")]) == 3
    said, page = capsys.readouterr().out, (tmp_path / "out" / "report.html").read_text()
    offers = "compares the values marked *" in said, "sets finite elements beside" in page
    assert offers == ((False, False) if reason else (True, True))
    assert (", Eq. 5 *" in said) == (not reason)
    assert f"(check --fem is not possible: {reason}" in said or not reason
    assert reason in page
    assert "without --fem" not in said


@pytest.mark.parametrize(
    ("changes", "verdict", "passed"),
    [
        ({}, "green", set()),
        ({"F_ax": 1100.0}, "yellow", {"slip"}),
        ({"T": 4000.0, "mu": 1.0}, "red",
         {"pressure_inner", "pressure_outer", "corner", "pressure"}),
        ({"T": 1e6}, "red", {"pressure_inner", "pressure_outer", "corner", "hertz"}),
        ({"T": -3.0}, "free", set()),
    ],
)  # fmt: skip
def test_programs_read_the_verdict_the_ratio_and_the_limits(changes, verdict, passed):
    q = own(**changes)
    v = analytic(q)
    told = json.loads(json.dumps(CLUTCH.summary(q, v)))
    assert told["verdict"] == verdict
    assert told["ratio"] == v.get("safety")
    assert {x["key"] for x in told["limits"] if x["passed"]} == passed
    if not changes:
        (slip, *_), unit = (x for x in told["limits"] if x["key"] == "slip"), "N m"
        assert (slip["of"], slip["unit"]) == ("T", unit)
        assert slip["at"] == pytest.approx(v["T_slip"])


def test_what_a_clutch_that_slips_would_carry_is_said_to_be_that():
    assert "if it held" in said(mu=0.065)[-1]
    assert "if it held" in said(T=4000.0, mu=1.0)[-1]
    assert not any("if it held" in f for f in [*said(), *said(T=1e6), *said(T=-1.0)])


def test_the_report_gives_the_values_once_and_says_of_what_percentiles_are(tmp_path, capsys):
    path = tmp_path / "clutch.toml"
    path.write_text(whole(template(CLUTCH)))
    assert run(["check", str(path), "--out", str(tmp_path / "out")]) == 3
    page = (tmp_path / "out" / "report.html").read_text()
    assert page.count("normal force of one contact") == 1
    assert "clamping angle without load below which 5 % of the clutches" in capsys.readouterr().out


def test_an_unknown_unit_of_torque_is_answered_with_those_that_are_known():
    with pytest.raises(ValueError, match="a torque takes N m, N mm, kN m, lbf in or lbf ft"):
        units.parse("5 Nmm", "N m")
    for text, torque in (("1 lbf in", 0.1129848), ("1 lbf ft", 1.355818), ("1 kN m", 1e3)):
        assert units.parse(text, "N m") == pytest.approx(torque, rel=1e-6)


# Elements.
def levels():
    return solved(CLUTCH, own())


def red(values=None):
    result = judge_case(Job(CLUTCH, own(), values=values), levels())
    return {row.quantity for row in result.rows if row.status is Status.FAIL}


def test_elements_agree():
    assert red() == set()


@pytest.mark.parametrize(
    ("key", "wrong", "row"),
    [
        ("alpha", lambda v: 1.005 * v["alpha"], "clamping angle"),
        ("alpha", lambda v: v["alpha_0"], "clamping angle"),
        ("N", lambda v: v["F_t"] / math.tan(v["alpha_0"]), "normal force"),
        ("phi", lambda v: v["phi_printed"], "torsion"),
        ("dalpha_dX", lambda v: v["dalpha_0_d_X"], "turn of the loaded angle"),
    ],
)
def test_a_wrong_formula_turns_its_row_red(key, wrong, row):
    v = dict(analytic(own()))
    found = red(values=v | {key: wrong(v)})
    assert any(name.startswith(row) for name in found)


def test_the_reading_of_radii_as_diameters_or_of_plane_stress_turns_rows_red():
    stress = analytic(own(E=206e9 * (1 - 0.3**2)))  # E' of plane stress is E
    assert any(name.startswith("clamping angle") for name in red(values=stress))
    assert any(name.startswith("normal force") for name in red(values=analytic(own(T=52.0))))


def test_the_reading_of_the_axial_load_as_one_roller_s_turns_the_fact_red():
    """mu_req of F_ax on each roller holds for F_ax on the whole clutch, 1 % below it too."""
    q = own()
    needed = required(q, F_ax=q.z * q.F_ax) / required(q)
    bears = levels()[-1].result.arrays["around"]
    assert list(bears) == [0.0, 1.0]
    assert 0.99 * needed > reference.AROUND[1]


def test_friction_that_is_not_needed_or_not_enough_turns_the_facts_red():
    finest = levels()[-1].result
    for around, fact in (([1.0, 1.0], "below"), ([0.0, 0.0], "above")):
        wrong = replace(finest, arrays=finest.arrays | {"around": np.array(around)})
        given = (*levels()[:-1], replace(levels()[-1], result=wrong))
        rows = judge_case(Job(CLUTCH, own()), given).rows
        failed = [row.quantity for row in rows if row.status is Status.FAIL]
        assert len(failed) == 1
        assert f"1 % {fact}" in failed[0]


def test_the_interval_of_the_turn_holds_the_formula_and_not_the_unloaded_one():
    low, high = comparisons.turn(own())
    assert low < 0 < high
    v = analytic(own())
    assert not low <= v["dalpha_0_d_X"] / v["dalpha_dX"] - 1 <= high
