"""The engineer's sprag clutch: words that follow from numbers, rows that faults turn red."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from analytic.contact import slices
from analytic.ring import smeared
from analytic.sprag import closure, compliance, geometry, parts, printed, start
from analytic.sprag.clutch import Clutch
from analytic.sprag.course import rolled
from analytic.sprag.motion import Motion, Speeds
from analytic.sprag.rest import at_rest
from analytic.sprag.table import tabulated
from analytic.sprag.tolerance import first_contact
from tests.conftest import solved
from tests.verify.template_text import whole
from verify.answers.template import template
from verify.app.cli import run
from verify.cases.sprag.clutch import limits, model
from verify.cases.sprag.clutch.case import CLUTCH, SpragClutch
from verify.cases.sprag.clutch.drawn_fem import drawn
from verify.cases.sprag.clutch.dynamic import DYNAMIC
from verify.cases.sprag.clutch.dynamic_messages import least_time
from verify.cases.sprag.clutch.limits import as_torque_grows
from verify.cases.sprag.clutch.model import built, spring_force, under
from verify.cases.sprag.clutch.paper_fem import BEST, PRINTED, designed
from verify.cases.sprag.clutch.paper_statements import rectangle
from verify.cases.sprag.clutch.recommendations import verdict
from verify.cases.sprag.clutch.run_fem import run_fem
from verify.cases.sprag.inputs import ASSUMED, IDENTIFIED, EngagementInputs
from verify.cases.sprag.statements import FITTED
from verify.core.case import Context
from verify.core.inputs import InputError, build
from verify.core.results import Status
from verify.papers.ledger import papers, published

pytestmark = pytest.mark.xdist_group("sprag-clutch")
CACHED = (
    model.built, model.under, model.rigid, model.literal, model.grip, model.spring_force,
    limits.as_torque_grows,
)  # fmt: skip
analytic = CLUTCH.analytic


def own(**changes):
    return SpragClutch(**changes)


def said(**changes):
    q = own(**changes)
    with np.errstate(over="raise", divide="raise", invalid="raise"):
        return CLUTCH.findings(q, {})


def forget():
    for function in CACHED:
        function.cache_clear()


@pytest.fixture
def faulty(monkeypatch, judged, without_fault, red):
    """Break one function of the formulas; what of the case's rows turns red."""
    without_fault(CLUTCH)  # the other side stays right

    def broken(module, name, wrapper):
        right = getattr(module, name)
        monkeypatch.setattr(module, name, lambda *a, **k: wrapper(right, *a, **k))
        forget()
        return {row.quantity for row in red(judged(CLUTCH, drawn=False))}

    yield broken
    monkeypatch.undo()
    forget()


FORCE, ASKED = "normal force under torque", "friction that torque asks for, tan ν"
TURN, YIELDS = "turn of the sprags under torque", "sum of the five deflections"
LARGEST = "largest pressure under half of N by slices, inner race"
MIDDLE = "pressure at mid-length under half of N by slices, inner race"


# What is said first.
@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({}, "holds: torque asks for tan ν = 0.05541 of friction, μ_s is 0.12 (μ_s/tan ν = 2.17)"),
        ({"mu_s": 0.05, "mu_c": 0.04}, "slips: tan ν_0 = 0.05503 exceeds μ_s = 0.05: the sprags "
         "do not wedge"),
        ({"mu_s": 0.0552, "mu_c": 0.05}, "slips: tan ν = 0.05541 under torque exceeds"),
        ({"T": 115.0}, "rolls over: the sprags reach the end of their profile, α_max = 28.65°, at "
         "111.5 N m"),
        ({"T": 500.0, "alpha_max": 3.0}, "no state: no state bears T = 500 N m"),
        ({"T": 100.0}, "overloaded: friction holds, but the inner contacts bear"),
        ({"T": 100.0, "p_lim": None}, "holds"),
    ],
)  # fmt: skip
def test_the_verdict_comes_first(changes, words):
    assert said(**changes)[0].startswith(words)


def test_limits_come_in_their_order_and_what_is_not_met_is_left_out():
    keys = [limit.key for limit in as_torque_grows(own())]
    assert keys == ["pressure_inner", "end", "pressure_outer", "wide"]
    assert "slip" not in keys  # the spiral keeps its wedge angle
    assert as_torque_grows(own(nu_0=math.radians(6.75)))[0].key == "slip"


@pytest.mark.parametrize("key", ["pressure_inner", "pressure_outer"])
def test_at_its_limit_of_pressure_a_contact_bears_p_lim(key):
    q = own()
    at = next(x.at for x in as_torque_grows(q) if x.key == key)
    v = analytic(own(T=at))
    assert v["p_i" if key.endswith("inner") else "p_o"] == pytest.approx(q.p_lim, rel=1e-6)


def test_at_the_end_of_the_profile_the_spiral_has_turned_by_alpha_max():
    at = next(x.at for x in as_torque_grows(own()) if x.key == "end")
    assert own(T=at).turned == pytest.approx(0.5, rel=1e-9)
    assert verdict(own(T=1.001 * at, p_lim=None)) == "rolls over"
    assert verdict(own(T=0.999 * at, p_lim=None)) == "holds"


def after(words, said):
    """The number behind the words."""
    return float(said.partition(words)[2].split()[0].strip("°;,"))


@pytest.mark.parametrize("changes", [{"mu_s": 0.05, "mu_c": 0.04}, {"mu_s": 0.0552, "mu_c": 0.04},
                                     {"nu_0": math.radians(7.5), "T": 40.0}], ids=str)  # fmt: skip
def test_a_clutch_that_slips_is_told_a_wedge_angle_and_a_friction_that_hold(changes):
    (first, second, *rest) = said(**changes)
    assert second.endswith("would have if it held")
    assert not any(" grows" in x or "passed" in x or "each sprag bears" in x for x in rest)
    less = changes | {"nu_0": math.radians(after("ν_0 below ", first)), "p_lim": None}
    more = changes | {"mu_s": after("μ_s above ", first), "p_lim": None}
    for q in (own(**less), own(**more)):
        assert verdict(q) == "holds"


def test_a_clutch_that_rolls_over_is_told_the_profile_that_it_needs():
    first, _, third, *_ = said(T=115.0, p_lim=None)
    least = math.radians(after("α_max of at least ", first))
    q = own(T=115.0, p_lim=None, alpha_max=least)
    assert verdict(q) == "holds"
    assert third.startswith("passed already: the sprags reach the end of their profile")


def test_an_overloaded_clutch_is_told_how_many_or_how_long_sprags_it_needs():
    times = after("take about ", said(T=100.0)[0])
    assert 1 < times < 2
    q = own(T=100.0, l=9e-3 * times)
    assert verdict(q) == "holds"


def test_without_the_engagement_holds_is_of_a_torque_that_rises_slowly():
    assert said()[0].endswith("one that comes at once nearly doubles the force (check --dynamic)")
    _, lines = DYNAMIC.overall(*ran())
    assert not any("check --dynamic" in x for x in lines)


def test_elastic_bodies_turn_the_papers_clutch_as_finite_elements_do():
    v = analytic(own())
    assert math.degrees(v["alpha_elastic"]) == pytest.approx(5.72, abs=0.03)  # of sprag-wedge's
    assert math.degrees(v["alpha"]) == pytest.approx(7.23, abs=0.01)
    (words,) = (x for x in said() if x.startswith("as elastic bodies"))
    assert "softer and its period of oscillation about 1.13 times as long" in words
    assert any("make the clutch stiffer" in x for x in said(z=3))
    fast = own(n=2000.0)  # grows the outer race, not the clutch's spring
    assert fast.theta / fast.theta_elastic == pytest.approx(
        own().theta / own().theta_elastic, rel=1e-3
    )


def test_the_smeared_load_on_both_races_is_carried_by_their_walls():
    """Through a half of each race: the pressure on the diameter is the mean hoop stress's."""
    q, v = own(), analytic(own())
    force = q.z * v["N"] / (2 * math.pi * q.R_i * q.l) * q.R_i
    assert -force / (q.R_i - q.R_id) == pytest.approx((v["s_i"] + v["s_id"]) / 2, rel=0.05)
    assert v["s_e"] > q.z * q.state.N_e / (2 * math.pi * q.l) / (q.R_ed - q.R_e) > 0
    # thin walls: the mean itself
    q = own(R_id=11e-3, R_ed=19.55e-3, T=1.0)
    v = analytic(q)
    assert v["s_e"] == pytest.approx(q.z * q.state.N_e / (2 * math.pi * q.l) / 0.11e-3, rel=0.01)


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_at_its_yield_strength_a_race_bears_it(race):
    key = f"yield_{race}"
    at = next(x.at for x in as_torque_grows(own(R_p=8e8)) if x.key == key)
    assert own(T=at).tresca[race == "outer"] == pytest.approx(8e8, rel=1e-3)
    q = own(R_p=2e8)
    assert said(R_p=2e8)[0].startswith("overloaded: friction holds, but the inner race bears")
    assert CLUTCH.summary(q, analytic(q))["verdict"] == "overloaded"


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"z": 3}, ["the inner race deflects 3.8", "the outer race deflects 5.6"]),
        ({"R_id": 10.9e-3, "R_ed": 19.65e-3, "T": 1.0}, ["the inner race", "the outer race"]),
        ({"n": 2094.0}, ["at n each sprag feels m_g ω² r = 120.6 N of centrifugal force"]),
        ({"n": 100.0}, []),
        ({}, []),
    ],
    ids=str,
)
def test_what_smears_badly_or_flies_outwards_is_warned_of(changes, words):
    q = own(**changes)
    warned = [x for x in CLUTCH.warnings(q, analytic(q)) if "deflects" in x or "at n" in x]
    assert len(warned) == len(words)
    assert all(w.startswith(x) for w, x in zip(warned, words, strict=True))


def test_a_crown_is_told_what_it_drops_at_the_end_slices():
    v = analytic(own())
    t = (1 - 1 / 41 - 0.3) / 0.7
    A = 3407 * (1 - 0.3**2) * 2 / (math.pi * 9e-3 * 206e9)
    assert v["z_end"] == pytest.approx(-A * math.log(1 - (1 - math.exp(-1e-5 / A)) * t**2))
    assert any("at the middle of its end slices: z_m = 10 µm is reached at" in x for x in said())
    assert not any("end slices" in x for x in said(z_m=2e-6))
    assert not any("end slices" in x for x in said(z_m=0.0))


def test_no_blades_and_no_yields_are_told_to_readers():
    q, v = ran(T=72.0)
    context = Context("sprag-clutch", q, v, [], False)
    told = [
        *CLUTCH.findings(q, v),
        *CLUTCH.assumptions,
        *(o.what for o in CLUTCH.outputs),
        *(c.name for c in CLUTCH.checks),
        *CLUTCH.warnings(q, v),
        *DYNAMIC.findings(q, v),
        *(o.what for o in DYNAMIC.outputs),
        *(f.title for f in CLUTCH.figures(context)),
    ]
    assert not any("blade" in x or "yields" in x or "yield " in x for x in told)


def test_the_printed_torque_has_every_number():
    (one,) = (e for e in CLUTCH.equations(own(), {}) if e.tex.startswith("N ="))
    assert "OA" not in one.numbers
    v = analytic(own())
    assert 12 * v["N"] * v["mu_req"] * v["OA"] == pytest.approx(25.0, rel=1e-9)


def test_friction_just_above_and_below_tan_nu_decides():
    v = analytic(own())
    for share, state in ((1.001, "holds"), (0.999, "slips")):
        q = own(mu_s=share * v["mu_req"], mu_c=0.04)
        assert verdict(q) == state


def test_stiffness_is_the_slope_of_the_torque_over_the_turn():
    q = own()
    T = np.array([24.9, 25.1])
    turn = rolled(built(q).clutch, closure.at_torque(built(q).clutch, T).N)
    assert analytic(q)["stiffness"] == pytest.approx(0.2 / (turn[1] - turn[0]), rel=1e-4)


def test_a_radius_off_turns_the_sprag_and_hardly_its_wedge_angle():
    v, q = analytic(own()), own()
    nu, turned = first_contact(q.sprag, dR_i=-10e-6)
    assert turned == pytest.approx(-10e-6 * v["dalpha_per_dR_i"], rel=0.01)
    assert nu - q.nu_0 == pytest.approx(-10e-6 * v["dnu_0_per_dR_i"], rel=0.01)
    assert math.degrees(turned) == pytest.approx(1.61, abs=0.01)
    assert math.degrees(nu - q.nu_0) < 0.005


def test_a_radius_off_is_what_yielding_by_as_much_is():
    """A rigid clutch whose inner race is smaller stands where one stands whose race yields."""
    q = own()
    d = 20e-6
    nu, turned = first_contact(q.sprag, dR_i=-d)
    one = compliance.Compliance(
        contact_i=lambda N: 0 * N, contact_e=lambda N: 0 * N, race_i=d / 1000.0, race_e=0.0,
        sprag=0.0,
    )  # fmt: skip
    now = closure.wedged(parts_clutch(q, one), 1000.0)
    assert float(now.nu) == pytest.approx(nu, rel=1e-12)
    assert float(now.alpha_b) == pytest.approx(turned, rel=1e-9)


def parts_clutch(q, yielding):
    return Clutch(sprag=q.sprag, n_s=q.z, compliance=yielding)


def test_springs_press_as_two_other_ways_say():
    q = own()
    state, _ = start.spring_equilibrium(built(q).clutch, K_r=q.K_r, alpha_max=q.alpha_max)
    assert spring_force(q) == pytest.approx(float(state.N), rel=1e-9)
    motion = Motion(**{name: getattr(q, name) for name in Motion.__dataclass_fields__})
    found = tabulated(built(q).clutch, N_end=200.0)
    alpha = at_rest(found, motion, Speeds())[3]
    assert spring_force(q) == pytest.approx(float(found.at(alpha)["N"]), rel=1e-4)


def test_stiff_springs_have_a_force():
    assert spring_force(own(K_r=10.0)) > 1000
    warned = CLUTCH.warnings(own(K_r=10.0), analytic(own(K_r=10.0)))
    assert any("springs alone press" in words for words in warned)


def test_springs_whose_state_is_not_found_have_no_force(monkeypatch):
    def fails(*_, **__):
        raise ArithmeticError("no load for which there is a state")

    monkeypatch.setattr(model, "spring_equilibrium", fails)
    forget()
    try:
        v = analytic(own())
        assert "N_0" not in v
        warned = CLUTCH.warnings(own(), v)
    finally:
        forget()
    assert "no state that bears the springs alone was found: N_0 is not known" in warned


def test_summary_says_what_programs_ask():
    q = own()
    record = CLUTCH.summary(q, analytic(q))
    assert record["verdict"] == "holds"
    assert record["margin"] == pytest.approx(0.12 / 0.05541, rel=1e-3)
    assert [x["passed"] for x in record["limits"]] == [False] * 4


# Own parameters.
ODD = [
    {"z": 3}, {"z": 40, "b": 1.5e-3}, {"nu_0": math.radians(1)}, {"nu_0": math.radians(6)},
    {"nu_0": math.radians(7.5)}, {"R_id": 10.5e-3, "R_ed": 20.5e-3}, {"z_m": 0.0},
    {"z_m": 50e-6}, {"T": 500.0}, {"T": 0.01}, {"E": 3e9}, {"mu_s": 0.05, "mu_c": 0.04},
    {"n": 1000.0}, {"alpha_max": 0.02}, {"Q": None}, {"p_lim": None}, {"nu": 0.0}, {"slices": 6},
    {"R_id": 72.1e-3, "R_i": 111.1e-3, "R_e": 194.4e-3, "R_ed": 262.3e-3, "r_i": 40.2e-3,
     "l": 90e-3, "b": 40e-3, "T": 25e3, "Q": 340.7e3, "z_m": 1e-4},
    {"R_id": 0.721e-3, "R_i": 1.111e-3, "R_e": 1.944e-3, "R_ed": 2.623e-3, "r_i": 0.402e-3,
     "l": 0.9e-3, "b": 0.4e-3, "T": 0.025, "Q": 34.07, "z_m": 1e-6},
]  # fmt: skip


@pytest.mark.parametrize("changes", ODD, ids=str)
def test_odd_clutches_have_words_values_and_figures(changes):
    q = own(**changes)
    with np.errstate(over="raise", divide="raise", invalid="raise"):
        v = CLUTCH.analytic(q)
    assert all(map(math.isfinite, v.values()))
    for part in (CLUTCH.findings, CLUTCH.warnings, CLUTCH.summary, CLUTCH.equations):
        part(q, v)
    assert CLUTCH.sketch(q).shapes
    CLUTCH.figures(Context("sprag-clutch", q, v, [], False))


@pytest.mark.parametrize("changes", [{"z": 3}, {"z_m": 0.0}, {"nu_0": math.radians(6)},
                                     {"E": 3e9, "T": 0.5}, {"n": 1000.0}], ids=str)  # fmt: skip
def test_one_s_own_clutch_is_judged_by_the_drawn_one(changes, judged, red):
    q = own(**changes)
    assert not CLUTCH.too_large(q)
    result = judged(CLUTCH, q)
    assert not red(result)
    names = {row.quantity for row in result.rows}
    assert FORCE in names
    assert not any("25 N m" in name or "Table 1" in name for name in names)


@pytest.mark.parametrize("changes", [{"T": 500.0}, {"T": 200.0}, {"T": 0.01}, {"slices": 81}])
def test_what_the_other_side_cannot_do_is_refused(changes):
    assert CLUTCH.too_large(own(**changes)).endswith("check it without --fem")


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"R_i": "20 mm"}, "the sprags need room between the races"),
        ({"R_id": "12 mm"}, "the inner race needs a wall"),
        ({"b": "7 mm"}, "sprags stand side by side on the inner race"),
        ({"r_i": "0.5 mm", "nu_0": "11 deg"}, "no spiral has this wedge angle"),
        ({"mu_c": 0.2}, "friction falls with the speed"),
        ({"dt": "1e-8 s", "t_end": "1 s"}, "between 10 and 2,000,000 steps"),
        ({"t_ramp": "0.1 s"}, "the torque has risen before the end: t_ramp <= t_end, got"),
        ({"slices": 500}, "must be at most 161"),
        ({"nu_0": "20 deg"}, "must be at most 12 deg"),
    ],
)
def test_wrong_input_has_one_clear_line(changes, words):
    raw = {"z": 12, "mu_s": 0.12, "mu_c": 0.08, "gamma_b": "1 s/m", "nu": 0.3, "slices": 41} | {
        name: f"{value * 1e3!r} mm" for name, value in
        (("R_id", 7.21e-3), ("R_i", 11.11e-3), ("R_e", 19.44e-3), ("R_ed", 26.23e-3),
         ("r_i", 4.02e-3), ("l", 9e-3), ("b", 4e-3))
    } | {
        "nu_0": "3.15 deg", "T": "25 N m", "E": "206 GPa", "alpha_max": "0.5 rad",
        "m_g": "1.8e-3 kg", "I_g": "1.18e-8 kg m^2", "I_bi": "1.41e-3 kg m^2",
        "I_be": "1.41e-3 kg m^2", "K_r": "0.01 N m/rad", "C_rl": "0.1 N m s/rad",
        "k_out": "1e5 N m/rad", "dt": "1e-5 s", "t_end": "0.06 s",
    }  # fmt: skip
    build(EngagementInputs, raw, "my.toml")
    with pytest.raises(InputError) as error:
        build(EngagementInputs, raw | changes, "my.toml")
    assert words in str(error.value)
    assert "\n" not in str(error.value)


# In time.
def ran(**changes):
    q = own(**changes)
    v = analytic(q)
    with np.errstate(all="ignore"):
        found = DYNAMIC.run(q, v)
    return q, {**v, **found}


def test_an_engagement_locks_and_its_first_peak_is_1_86_times_the_static_force():
    q, v = ran()
    assert DYNAMIC.findings(q, v)[0].startswith("in time: the clutch locks; the normal force")
    assert v["peak_factor"] == pytest.approx(1.857, abs=1e-3)
    assert v["missing"] < 1e-6
    assert v["t_slip"] == 0
    assert v["p_i_max"] > v["p_o_max"] > 0


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"mu_s": 0.05, "mu_c": 0.04}, "a contact slides on"),
        ({"T": 115.0}, "the sprags roll over"),
        ({"T": 600.0, "alpha_max": 3.0}, "the contacts become too wide for the formulas"),
        ({"T": 0.01}, "the clutch locks"),
        ({"w_i": -100.0}, "the clutch locks"),
    ],
)
def test_the_motion_has_a_verdict_in_words(changes, words):
    q, v = ran(**changes)
    assert DYNAMIC.findings(q, v)[0].startswith(f"in time: {words}")
    assert all(map(math.isfinite, v.values()))
    assert len(DYNAMIC.figures(q, v)) == 5


def test_a_band_too_narrow_is_refused_in_a_line(tmp_path, capsys):
    text = whole(template(CLUTCH)).replace('T = "25 N m"', 'T = "40 N m"')
    text = text.replace('alpha_max = "0.5 rad"', 'alpha_max = "0.02 rad"')
    text = text.replace('# D_V = "0.05 m/s"', 'D_V = "0.001 m/s"')
    path = tmp_path / "my.toml"
    path.write_text(text)
    assert run(["check", str(path), "--dynamic"]) == 2
    (line,) = capsys.readouterr().err.strip().splitlines()
    assert "the band of sticking is too narrow" in line


def test_a_step_that_is_too_long_is_refused_in_a_line_with_one_that_will_do(tmp_path, capsys):
    path = tmp_path / "my.toml"
    path.write_text(whole(template(CLUTCH)).replace('dt = "1e-05 s"', 'dt = "0.001 s"'))
    assert run(["check", str(path), "--dynamic"]) == 2
    said = capsys.readouterr()
    (line,) = said.err.strip().splitlines()
    assert "dt=0.001 s is too long" in line
    assert line.endswith("take dt=9e-06 s")
    assert said.out == ""


def test_energies_that_miss_half_a_percent_are_told():
    q, v = ran(I_bi=1e-6, I_be=1e-6)
    assert 1e-3 < v["missing"] < 1e-2
    (careful,) = (x for x in DYNAMIC.findings(q, v) if x.startswith("careful"))
    q, v = ran(I_bi=1e-6, I_be=1e-6, dt=float(careful.split()[-2]))
    assert v["missing"] < 1e-4
    assert not any(x.startswith("careful") for x in DYNAMIC.findings(q, v))


@pytest.mark.parametrize(
    "changes",
    [{"t_end": 2e-3}, {"I_bi": 1.0, "I_be": 1.0}, {"C_rl": 100.0}, {"t_end": 2e-3, "w_i": -50.0},
     {"I_bi": 1.0, "k_out": 1e3, "C_rl": 10.0}, {"t_ramp": 0.06}, {"T": 0.1, "t_end": 1e-3}],
    ids=str,
)  # fmt: skip
def test_what_ends_before_its_peak_is_told_and_how_long_it_takes(changes):
    q, v = ran(**changes)
    assert not {"peak_factor", "p_i_max", "p_o_max", "t_max"} & set(v)
    verdict, lines = DYNAMIC.overall(q, v)
    assert verdict == "not followed"
    assert lines[0] == "holds at rest, the engagement is not followed to its peak"
    (said,) = (x for x in DYNAMIC.findings(q, v) if x.startswith("in time: not followed"))
    assert "take t_end of at least" in said
    assert DYNAMIC.figures(q, v)
    long = q.model_copy(update={"t_end": least_time(q)})
    assert run_fem(long).engagement.verdict == "locks"


@pytest.mark.parametrize(
    ("changes", "verdict", "words"),
    [
        ({}, "holds", "holds at rest and in the first peak"),
        ({"T": 72.0}, "rolls over", "holds at rest, rolls over in the first peak; longer"),
        ({"T": 115.0}, "rolls over", "rolls over at rest and in the first peak"),
        ({"T": 55.0}, "overloaded", "holds at rest, is overloaded in the first peak"),
        ({"mu_s": 0.05, "mu_c": 0.04}, "slips", "slips at rest, slides on as the torque comes"),
        ({"T": 72.0, "t_ramp": 0.05}, "holds", "holds at rest and in the first peak"),
    ],
)
def test_the_worse_of_rest_and_motion_comes_first(changes, verdict, words):
    q, v = ran(**changes)
    found, lines = DYNAMIC.overall(q, v)
    assert found == verdict
    assert lines[0].startswith(words)
    assert lines[1].startswith("at rest: ")


def test_the_verdict_of_both_reaches_the_reader_and_programs(tmp_path, capsys):
    path = tmp_path / "my.toml"
    path.write_text(whole(template(CLUTCH)).replace('T = "25 N m"', 'T = "72 N m"'))
    assert run(["check", str(path), "--dynamic"]) == 1
    assert "fails: holds at rest, rolls over" in capsys.readouterr().out.splitlines()[0]
    assert run(["check", str(path), "--dynamic", "--json"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert (found["answer"]["verdict"], found["details"]["verdict"]) == ("fails", "rolls over")


def test_ways_that_are_round_off_are_none_and_long_ones_are_in_millimetres():
    q, v = ran()
    assert v["slid_i"] == v["slid_o"] == 0.0
    q, v = ran(mu_s=0.05, mu_c=0.04)
    (slid,) = (x for x in DYNAMIC.findings(q, v) if x.startswith("contacts slide"))
    assert "the inner ones 127 mm and the outer ones 70" in slid


def test_a_table_that_ends_before_the_peak_is_made_longer():
    assert run_fem(own(w_i=300.0)).engagement.N_max > 4 * analytic(own())["N"]


def test_the_record_has_the_dynamic_part(tmp_path, capsys):
    path = tmp_path / "my.toml"
    path.write_text(whole(template(CLUTCH)))
    assert run(["check", str(path), "--dynamic", "--json"]) == 0
    record = json.loads(capsys.readouterr().out)
    assert "locks" in json.dumps(record["dynamic"])


# The paper.
def test_what_is_identified_is_counted_in_the_lead_and_neither_printed_nor_assumed():
    assert f"{len(IDENTIFIED)} inputs that it does not print" in CLUTCH.lead
    assert not set(IDENTIFIED) & set(ASSUMED)
    for name in IDENTIFIED:
        extra = EngagementInputs.model_fields[name].json_schema_extra
        assert not extra["claims"]


def test_the_papers_figures_are_those_of_the_ledger():
    for T, (flat, best) in PRINTED.items():
        for name, value in (("unmodified", flat), ("optimised", best)):
            assert published(f"huang2018:stress-{T:.0f}nm-{name}").value * 1e6 == value
        for value, key in zip(BEST[T], ("k1", "k2", "zm"), strict=True):
            scale = 1e-3 if key == "zm" else 1.0
            printed_value = published(f"huang2018:optimum-{T:.0f}nm-{key}").value
            assert value == pytest.approx(printed_value * scale, rel=1e-12)


def test_the_profile_load_is_the_static_load_at_25_newton_metres():
    q = own()
    assert pytest.approx(q.Q, rel=1e-3) == designed(None, 25.0).Q


def test_calibrated_rows_say_so_and_predictions_are_not_judged(judged):
    rows = {row.quantity: row for row in judged(CLUTCH).rows}
    for name, row in rows.items():
        if "fitted" in name or ("asks for" in name and "optimum" in name):
            assert row.status is Status.CALIBRATED
            assert FITTED in row.reason
        if "predicted" in name:
            assert row.status is Status.SHOWN
    assert sum(row.status is Status.SHOWN for row in rows.values()) == 2


def test_from_25_to_40_newton_metres_only_k_1_of_the_printed_optima_grows_freely():
    """Erratum sec-4-2-z-m-trend: z_m falls, K_2 meets its bound."""
    low, high = BEST[25.0], BEST[40.0]
    assert high[0] > low[0]
    assert high[1] == published("huang2018:k2-upper-bound").value
    assert high[2] < low[2]


def test_one_of_the_two_printed_reductions_is_wrong():
    """Erratum sec-4-2-2-percentage."""
    for T, holds in ((25.0, True), (40.0, False)):
        flat, best = PRINTED[T]
        entry = published(f"huang2018:stress-{T:.0f}nm-reduction")
        assert (abs(100 * (1 - best / flat) - entry.value) < 0.005) is holds


def test_the_optimum_at_25_newton_metres_asks_for_3_085_degrees(judged):
    (row,) = (r for r in judged(CLUTCH).rows if r.symbol == "ν_0")
    assert row.analytic == pytest.approx(3.085, abs=0.002)


def test_a_rectangle_with_table_1s_mass_and_inertia_is_9_mm_long_and_3_mm_wide():
    w, l = rectangle(own())  # noqa: E741
    assert w * 1e3 == pytest.approx(3.05, abs=0.01)  # sqrt(12 1.18e-8/1.8e-3 - 8.33²e-6)
    assert l * 1e3 == pytest.approx(9.04, abs=0.01)


def test_inputs_that_table_1_does_not_give_have_no_claim():
    """Erratum missing-inputs: no result follows from the paper alone."""
    without = {name for name, field in EngagementInputs.model_fields.items()
               if not field.json_schema_extra["claims"]}  # fmt: skip
    assert {"l", "b", "nu_0", "E", "nu", "mu_s", "mu_c", "gamma_b", "k_out", "Q", "alpha_max",
            "slices", "n", "density"} <= without  # fmt: skip


def test_three_equal_radii_are_no_spiral_s_whose_radius_grows():
    """Erratum table-1-radii: rho sqrt(1 + m²) grows with every degree of turn."""
    now = under(own())
    m = float(np.asarray(own().sprag.m))
    assert float(now.rho) * math.hypot(1, m) == pytest.approx(4.02e-3 * 1.01130, rel=1e-4)


def test_a_spring_s_stiffness_and_angle_enter_the_start_as_their_product_alone():
    """Erratum sec-2-3-spring-stiffness: the equilibrium at alpha = 0 gives K_r alpha_max."""
    soft = spring_force(own(K_r=0.001, alpha_max=1.0))
    hard = spring_force(own(K_r=0.002, alpha_max=0.5))
    assert soft == pytest.approx(hard, rel=0.01)


def test_the_torque_acts_on_the_inner_race():
    """Erratum eq-16-torque-symbol: with C_bi = T the sprags bear T on the inner race at rest."""
    e = run_fem(own(C_rl=3.0)).engagement
    M = 12 * e.T_i[-1] * float(e.table.at(e.alpha[-1])["OA"])
    assert pytest.approx(25.0, rel=0.01) == M


# Readings: the other one turns a row red.
def test_r_i_is_the_radius_of_curvature_not_the_polar_radius(faulty):
    right = geometry.LogSprag.__dict__["rho_0"]

    class Polar:
        def __get__(self, sprag, _owner=None):
            return np.asarray(sprag.r_i)

    try:
        geometry.LogSprag.rho_0 = Polar()
        assert {TURN} <= faulty(parts, "positive", lambda f, *a, **k: f(*a, **k))
    finally:
        geometry.LogSprag.rho_0 = right


def test_the_torque_is_that_of_the_whole_clutch(faulty):
    def of_one_sprag(right, clutch, T):
        return right(clutch, T * clutch.n_s)

    assert {FORCE, TURN, YIELDS} <= faulty(model, "at_torque", of_one_sprag)


def test_z_m_is_in_millimetres(faulty):
    def in_micrometres(right, q):
        return right(q.model_copy(update={"z_m": q.z_m / 1e3}))

    assert LARGEST in faulty(model, "gap", in_micrometres)


# Faults.
def changed(now, **more):
    return replace(now, **more)


def test_the_printed_closure_turns_a_row_red(faulty):
    def as_printed(_right, clutch, N):
        return printed.wedged(clutch, N)

    assert TURN in faulty(closure, "wedged", as_printed)


def test_sine_for_tangent_turns_force_and_friction_red(faulty):
    def with_sine(right, *args, **more):
        now = right(*args, **more)
        return changed(now, T=now.T * np.cos(now.nu))

    assert FORCE in faulty(closure, "wedged", with_sine)


def test_half_a_sprag_s_compression_is_missed(faulty):
    def without(right, *args, **more):
        return right(*args, **more) / 2

    assert {TURN, YIELDS} <= faulty(parts, "sprag_compression", without)


def test_races_without_poissons_term_are_missed(faulty):
    def without(right, *args, nu, **more):
        return right(*args, nu=0.0, **more)

    assert smeared.race_deflection is parts.race_deflection
    assert FORCE in faulty(parts, "race_deflection", without)  # in H both terms cancel


def test_pressures_with_a_modulus_of_plane_stress_are_missed(faulty):
    def plane_stress(right, *args, E_star, **more):
        return right(*args, E_star=E_star * (1 - 0.3**2), **more)

    assert {MIDDLE, LARGEST} <= faulty(slices, "press", plane_stress)


def test_a_fault_of_the_drawn_sprag_is_seen_as_well():
    q = own()
    one = drawn(q, 82)
    found, v = one.at_torque(q.T, 3400.0), analytic(q)
    assert pytest.approx(v["N"], rel=1e-4) == found.N
    lost = drawn(q.model_copy(update={"b": 2 * q.b}), 82).at_torque(q.T, 3400.0)
    assert abs(lost.alpha / v["alpha"] - 1) > 0.03


def test_without_its_equation_a_contradiction_of_the_ledger_fails(judged):
    fem = [level.result for level in solved(CLUTCH, own())]
    context = Context("sprag-clutch", own(), analytic(own()), fem, True)
    (check,) = (c for c in CLUTCH.checks if c.name.startswith("both printed pairs"))
    arrays = dict(context.fem[-1].arrays)
    arrays["N_max"] = np.array([1.0, 1.9])
    fem = [*context.fem[:-1], changed(context.fem[-1], arrays=arrays)]
    (row,) = check.rows(changed(context, fem=fem))
    assert row.status is Status.FAIL


def test_every_erratum_that_names_this_case_is_in_the_ledger():
    (paper,) = (p for p in papers() if p.key == "huang2018")
    named = {e.test.partition("/")[2] for e in paper.errata if e.test.startswith("sprag-clutch/")}
    assert named <= {check.name for check in CLUTCH.checks}


def test_slices_carry_what_the_crown_leaves_them():
    q = own()
    pressed = slices.press(built(q).gap, length=q.l, R=2.95e-3, E_star=113e9, load=100.0)
    assert not pressed.carries[0]
    assert pressed.carries[20]
