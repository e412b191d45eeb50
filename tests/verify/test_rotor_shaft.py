"""The uniform turning shaft: readings and faults turn rows red; shafts of one's own."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from pydantic import ValidationError

from analytic.rotor import cylinder, pochhammer, shafts
from fem.fourier import vibration
from fem.rotor import assemble, weak
from verify.cases.registry import find
from verify.cases.rotor.shaft import formulas, inputs
from verify.cases.rotor.shaft.case import SHAFT, UniformShaft
from verify.core.results import Status
from verify.jobs.level import Job, judge_case, solve_level

pytestmark = pytest.mark.xdist_group("rotor-shaft")
COARSE = replace(SHAFT, levels=(1, 2, 3, 4))


def names(rows):
    return {row.quantity for row in rows}


def solve_anew(case):
    q = case.inputs()
    return judge_case(Job(case, q), [solve_level(case, q, level, None) for level in case.levels])


def test_every_row_passes_and_the_case_is_registered(judged, red):
    assert not red(judged(SHAFT))
    assert find("rotor-shaft") is SHAFT


def scaled(factor):
    return lambda f: lambda *a, **k: factor * f(*a, **k)


@pytest.mark.parametrize(
    ("owner", "name", "fault", "row"),
    [
        pytest.param(inputs, "hutchinson", lambda _: shafts.cowper,
                     "Timoshenko's beam as d/L goes to 0", id="Cowper's coefficient"),
        pytest.param(inputs, "hutchinson", scaled(1.01),
                     "elements of Timoshenko, mode 1 forward", id="1 % too stiff in shear"),
        pytest.param(shafts.UniformShaft, "I", lambda f: property(lambda s: 1.001 * f.fget(s)),
                     "elements of Euler, mode 1 forward", id="0.1 % too stiff"),
        pytest.param(shafts.UniformShaft, "whirl",
                     lambda f: lambda s, j, *, Omega=0.0, theory: f(s, j, theory=theory),
                     "what turning splits mode 1 by, elements", id="no gyroscopic term"),
        pytest.param(shafts.UniformShaft, "whirl",
                     lambda f: lambda s, j, *, Omega=0.0, theory: f(s, j, Omega=-Omega,
                                                                    theory=theory),
                     "elements of Rayleigh, mode 1 forward", id="forward for backward"),
        pytest.param(shafts.UniformShaft, "whirl",
                     lambda f: lambda s, j, *, Omega=0.0, theory: f(s, j, Omega=Omega / 2,
                                                                    theory=theory),
                     "weak form of Rayleigh, mode 1 backward", id="polar for diametral inertia"),
        pytest.param(shafts.UniformShaft, "critical_speed",
                     lambda f: lambda s, j, *, theory: f(s, j, theory=theory, backward=True),
                     "elements of Timoshenko, critical speed", id="backward critical speed"),
        pytest.param(cylinder.Cylinder, "whirl",
                     lambda f: lambda s, k, *, Omega=0.0, count=1: f(s, k, Omega=2 * Omega,
                                                                     count=count),
                     "what turning splits mode 1 by, elastic body", id="twice the speed"),
        pytest.param(cylinder.Cylinder, "critical_speeds",
                     lambda f: lambda s, k: f(s, k, backward=True),
                     "elastic body, critical speed", id="elastic body, backward critical speed"),
        pytest.param(formulas, "bending_frequency", scaled(1.00001),
                     "elastic body at rest, Pochhammer's equation", id="1e-5 too fast"),
        pytest.param(pochhammer, "_radial", lambda f: lambda q, r, kind: f(1.01 * q, r, kind),
                     "elastic body at rest, Pochhammer's equation", id="wrong wave numbers"),
    ],
)  # fmt: skip
def test_another_reading_or_a_wrong_formula_turns_its_row_red(
    owner, name, fault, row, judged, red, monkeypatch
):
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert row in names(red(judged(SHAFT)))


@cache
def red_without_fault():
    return frozenset(names(r for r in solve_anew(COARSE).rows if r.status is Status.FAIL))


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(
    ("owner", "name", "fault", "row"),
    [
        pytest.param(vibration, "gyroscopic_form", lambda f: lambda n: f(n) / 2,
                     "what turning splits mode 1 by, elastic body", id="half the polar moment"),
        pytest.param(vibration, "gyroscopic_form", lambda f: lambda n: -f(n),
                     "elastic body, mode 1 forward", id="solid turns the other way"),
        pytest.param(weak, "shear_mixed", lambda _: weak.product,
                     "weak form of Timoshenko, mode 3 forward", id="shear without slope"),
        pytest.param(assemble, "rotary_mass", scaled(1.05),
                     "elements of Rayleigh, mode 3 forward", id="5 % too much rotary inertia"),
    ],
)  # fmt: skip
def test_wrong_finite_elements_turn_a_row_red(owner, name, fault, row, monkeypatch, red):
    before = red_without_fault()
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert row in names(red(solve_anew(COARSE))) - before


def test_an_interval_is_silent_where_a_series_says_nothing():
    row = "Euler's beam, mode 1, at rest"
    for q, sharp in ((UniformShaft(), True), (UniformShaft(L=0.13), False)):
        check = next(c.check for c in q.stated() if c.name == row)
        interval = check.interval(None)
        assert (interval is not None) is sharp
        assert not sharp or 0.015 < interval[0] < interval[1] < 0.02


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"d_i": 0.06}, "d_i < 0.98 d_o"),
        ({"d_i": 0.001}, "take the shaft as solid"),
        ({"L": 0.1}, "a block, not a shaft"),
        ({"rho": -1.0}, "greater than 0"),
    ],
)
def test_inputs_without_sense_are_refused_in_words(wrong, said):
    with pytest.raises(ValidationError, match=said):
        UniformShaft(**wrong)


def test_a_solid_shaft_of_one_s_own_has_no_row_in_red(judged, red):
    assert not red(judged(SHAFT, UniformShaft(d_i=0.0, L=0.4, n=500.0, nu=0.25)))


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"L": 0.4}, "take Timoshenko's"),
        ({"L": 0.2, "d_i": 0.056}, "too stubby or thin"),
        ({"n": 2300.0}, "of the critical speed"),
        ({"n": 25000.0}, "rim runs at 750 m/s"),
    ],
)
def test_an_engineer_is_warned(more, said):
    q = UniformShaft(**more)
    assert any(said in words for words in SHAFT.warnings(q, SHAFT.analytic(q)))


def test_nothing_is_warned_of_at_the_case_s_own_numbers():
    q = UniformShaft()
    assert not SHAFT.warnings(q, SHAFT.analytic(q))
    assert np.isclose(q.n, 1047.1975511965977)
