"""The sprag clutch of a user over time: verdict compared with that at rest, run time."""

import numpy as np
import pytest

from verify.cases.sprag.clutch.case import CLUTCH, SpragClutch
from verify.cases.sprag.clutch.dynamic import DYNAMIC
from verify.cases.sprag.clutch.dynamic_messages import least_time
from verify.cases.sprag.clutch.run_fem import run_fem

SLIPPERY = {"mu_s": 0.05, "mu_c": 0.04}


def ran(**changes):
    q = SpragClutch(**changes)
    v = CLUTCH.analytic(q)
    with np.errstate(all="ignore"):
        return q, {**v, **DYNAMIC.run(q, v)}


def test_the_first_peak_of_an_engagement_is_1_86_times_the_static_force():
    q, v = ran()
    assert DYNAMIC.findings(q, v)[0].startswith("in time: the clutch locks; the normal force")
    assert v["peak_factor"] == pytest.approx(1.857, abs=1e-3)
    assert v["missing"] < 1e-6
    assert (v["t_slip"], v["slid_i"], v["slid_o"]) == (0, 0, 0)
    assert v["p_i_max"] > v["p_o_max"] > 0
    assert len(DYNAMIC.figures(q, v)) == 5


@pytest.mark.parametrize(
    ("changes", "verdict", "words", "in_time"),
    [
        ({}, "holds", "holds at rest and at the first force peak", "the clutch locks"),
        ({"T": 72.0}, "rolls over", "holds at rest, rolls over at the first force peak; longer",
         "the sprags roll over"),
        ({"T": 600.0, "alpha_max": 3.0}, "no state", "the formulas give no equilibrium at rest, "
         "the first force peak is beyond", "the contacts become too wide for the formulas"),
        ({"T": 55.0}, "overloaded", "holds at rest, is overloaded at the first force peak",
         "the clutch locks"),
        (SLIPPERY, "slips", "slips at rest, slips permanently in the engagement",
         "a contact continues to slide"),
        ({"T": 72.0, "t_ramp": 0.05}, "holds", "holds at rest and at the first force peak",
         "the clutch locks"),
    ],
)  # fmt: skip
def test_the_worse_of_rest_and_motion_comes_first(changes, verdict, words, in_time):
    q, v = ran(**changes)
    found, lines = DYNAMIC.overall(q, v)
    assert found == verdict
    assert lines[0].startswith(words)
    assert lines[1].startswith("at rest: ")
    assert "check --dynamic" not in "".join(lines)
    assert DYNAMIC.findings(q, v)[0].startswith(f"in time: {in_time}")


@pytest.mark.parametrize(
    "changes",
    [{"t_end": 2e-3, "w_i": -50.0}, {"t_ramp": 0.06}, {"I_bi": 1.0, "k_out": 1e3, "C_rl": 10.0}],
    ids=str,
)  # fmt: skip
def test_what_ends_before_its_peak_states_how_long_it_takes(changes):
    q, v = ran(**changes)
    assert not {"peak_factor", "p_i_max", "p_o_max", "t_max"} & set(v)
    verdict, lines = DYNAMIC.overall(q, v)
    assert verdict == "not followed"
    assert lines[0] == "holds at rest, the computed time ends before the peak of the engagement"
    (line,) = (x for x in DYNAMIC.findings(q, v) if x.startswith("in time: the computed time ends"))
    assert f"increase t_end to at least {least_time(q) * 1e3:.4g} ms" in line
    assert run_fem(q.model_copy(update={"t_end": least_time(q)})).engagement.verdict == "locks"


def test_energies_that_miss_much_name_a_step_that_does_not():
    q, v = ran(I_bi=1e-6, I_be=1e-6)
    assert 1e-3 < v["missing"] < 1e-2
    (careful,) = (x for x in DYNAMIC.findings(q, v) if x.startswith("inaccurate"))
    q, v = ran(I_bi=1e-6, I_be=1e-6, dt=float(careful.split()[-2]))
    assert v["missing"] < 1e-4
    assert not any(x.startswith("inaccurate") for x in DYNAMIC.findings(q, v))
