"""The sprag clutch of a user at rest: statements follow from numbers, limits are as stated."""

import json
import math

import numpy as np
import pytest

from verify.cases.sprag.clutch import model
from verify.cases.sprag.clutch.case import CLUTCH, SpragClutch
from verify.cases.sprag.clutch.limits import as_torque_grows
from verify.cases.sprag.clutch.recommendations import verdict

PAPER = SpragClutch()


def findings(**changes):
    with np.errstate(over="raise", divide="raise", invalid="raise"):
        return CLUTCH.findings(SpragClutch(**changes), {})


def number(line, before):
    """The number that follows these words."""
    return float(line.partition(before)[2].split()[0].strip("°;,"))


def limit(key, **changes):
    return next(x.at for x in as_torque_grows(SpragClutch(**changes)) if x.key == key)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({}, "holds: required friction coefficient tan ν = 0.05541, available μ_s = 0.12 (margin "
         "μ_s/tan ν = 2.17)"),
        ({"mu_s": 0.05, "mu_c": 0.04}, "slips: tan ν_0 = 0.05503 exceeds μ_s = 0.05: the sprags "
         "do not wedge"),
        ({"mu_s": 0.0552, "mu_c": 0.05}, "slips: tan ν = 0.05541 under torque exceeds"),
        ({"T": 115.0}, "rolls over: the sprags reach the end of their profile, α_max = 28.65°, at "
         "111.5 N m"),
        ({"T": 500.0, "alpha_max": 3.0}, "no state: no equilibrium exists at T = 500 N m"),
        ({"T": 100.0}, "overloaded: friction is sufficient, but the inner contacts have"),
        ({"R_p": 2e8}, "overloaded: friction is sufficient, but the inner race has"),
        ({"T": 100.0, "p_lim": None}, "holds"),
    ],
)  # fmt: skip
def test_the_verdict_comes_first(changes, words):
    assert findings(**changes)[0].startswith(words)
    assert CLUTCH.summary(SpragClutch(**changes), {})["verdict"] == words.partition(":")[0]


def test_limits_come_in_their_order_and_at_each_the_clutch_is_at_it():
    keys = [x.key for x in as_torque_grows(PAPER)]
    assert keys == ["pressure_inner", "end", "pressure_outer", "wide"]  # the angle hardly opens
    assert as_torque_grows(SpragClutch(nu_0=math.radians(6.75)))[0].key == "slip"
    record = json.loads(json.dumps(CLUTCH.summary(PAPER, {})))
    assert record["margin"] == pytest.approx(0.12 / 0.05541, rel=1e-3)
    assert [x["passed"] for x in record["limits"]] == [False] * 4
    for side in ("inner", "outer"):
        v = CLUTCH.analytic(SpragClutch(T=limit(f"pressure_{side}")))
        assert v[f"p_{side[0]}"] == pytest.approx(4500e6, rel=1e-6)
        q = SpragClutch(T=limit(f"yield_{side}", R_p=8e8))
        assert q.tresca[side == "outer"] == pytest.approx(8e8, rel=1e-3)
    end = limit("end")
    assert SpragClutch(T=end).turned == pytest.approx(0.5, rel=1e-9)
    for share, state in ((1.001, "rolls over"), (0.999, "holds")):
        assert verdict(SpragClutch(T=share * end, p_lim=None)) == state
    for share, state in ((1.001, "holds"), (0.999, "slips")):
        mu = share * CLUTCH.analytic(PAPER)["mu_req"]
        assert verdict(SpragClutch(mu_s=mu, mu_c=0.04)) == state


def test_what_is_advised_holds():
    for changes in ({"mu_s": 0.05, "mu_c": 0.04}, {"nu_0": math.radians(7.5), "T": 40.0}):
        first, second, *rest = findings(**changes)
        assert second.endswith("assume that the clutch holds")
        assert not any(
            " increases" in x or "exceeded" in x or "each sprag carries" in x for x in rest
        )
        angle, friction = number(first, "ν_0 below "), number(first, "μ_s above ")
        for advised in ({"nu_0": math.radians(angle)}, {"mu_s": friction}):
            assert verdict(SpragClutch(**changes | advised | {"p_lim": None})) == "holds"
    first, _, third, *_ = findings(T=115.0, p_lim=None)
    least = math.radians(number(first, "α_max of at least "))
    assert verdict(SpragClutch(T=115.0, p_lim=None, alpha_max=least)) == "holds"
    assert third.startswith("limits below T: the sprags reach the end of their profile")
    times = number(findings(T=100.0)[0], "use about ")
    assert 1 < times < 2
    assert verdict(SpragClutch(T=100.0, l=9e-3 * times)) == "holds"


def test_elastic_bodies_turn_the_clutch_as_finite_elements_of_the_wedge_do():
    v = CLUTCH.analytic(PAPER)
    assert math.degrees(v["alpha_elastic"]) == pytest.approx(5.72, abs=0.03)  # of sprag-wedge's
    (words,) = (x for x in findings() if x.startswith("with the deflections of elastic bodies"))
    assert (
        "softer than with elastic bodies and its period of oscillation is about 1.13 times as long"
        in words
    )
    fast = SpragClutch(n=2000.0)  # grows the outer race, not the clutch's spring
    assert fast.theta / fast.theta_elastic == pytest.approx(
        PAPER.theta / PAPER.theta_elastic, rel=1e-3
    )


def test_a_crown_drops_less_at_the_middle_of_its_end_slices():
    t = (1 - 1 / 41 - 0.3) / 0.7
    A = 3407 * (1 - 0.3**2) * 2 / (math.pi * 9e-3 * 206e9)
    drop = -A * math.log(1 - (1 - math.exp(-1e-5 / A)) * t**2)
    assert CLUTCH.analytic(PAPER)["z_end"] == pytest.approx(drop)
    for z_m, stated in ((1e-5, True), (2e-6, False), (0.0, False)):
        assert any("end slices: z_m" in x for x in findings(z_m=z_m)) == stated


def test_springs_whose_state_is_not_found_have_no_force(broken):
    def fails(_):
        def equilibrium(*_args, **_more):
            raise ArithmeticError("no normal force with an equilibrium state")

        return equilibrium

    broken(model, "spring_equilibrium", fails)
    v = CLUTCH.analytic(SpragClutch())
    assert "N_0" not in v
    warned = CLUTCH.warnings(SpragClutch(), v)
    assert "no equilibrium under the springs alone was found: N_0 is unknown" in warned


def test_stiffness_is_the_slope_of_the_torque_over_the_turn():
    low, high = (CLUTCH.analytic(SpragClutch(T=T)) for T in (24.9, 25.1))
    slope = 0.2 / (high["theta"] - low["theta"])
    assert CLUTCH.analytic(PAPER)["stiffness"] == pytest.approx(slope, rel=1e-4)
