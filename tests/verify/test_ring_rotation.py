"""The rotating race: readings and faults turn rows red; parameters of one's own."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from pydantic import ValidationError

from analytic.ring import rotating
from fem.plane.material import Elastic
from meshes.ring import quarter
from verify.cases.registry import find
from verify.cases.ring.rotation.case import ROTATION, RotatingRace
from verify.core.results import Status
from verify.jobs.level import Job, judge_case, solve_level

pytestmark = pytest.mark.xdist_group("ring-rotation")
COARSE = replace(ROTATION, levels=(1, 2, 4))


def names(rows):
    return {row.quantity for row in rows}


def solve_anew(case):
    q = case.inputs()
    return judge_case(Job(case, q), [solve_level(case, q, level, None) for level in case.levels])


def test_every_row_passes_and_the_case_is_registered(judged, red):
    assert not red(judged(ROTATION))
    assert find("ring-rotation") is ROTATION


@pytest.mark.parametrize(
    ("owner", "name", "fault", "row"),
    [
        pytest.param(rotating, "_load", lambda f: lambda rho, w: f(rho, np.asarray(w) * 30 / np.pi),
                     "bore growth, plane stress", id="r/min for an angular speed"),
        pytest.param(rotating, "_load", lambda f: lambda rho, w: 1.002 * f(rho, w),
                     "strain energy, plane stress", id="0.2 % too heavy"),
        pytest.param(rotating, "in_plane", lambda f: lambda E, nu, _: f(E, nu, "plane stress"),
                     "bore growth, plane strain", id="plane stress for plane strain"),
        pytest.param(rotating, "in_plane", lambda f: lambda E, nu, _: f(E, nu, "plane strain"),
                     "bore growth, plane stress", id="plane strain for plane stress"),
        pytest.param(rotating, "stresses", lambda f: lambda *a, **k: f(*a, **k)[::-1],
                     "bore hoop stress, plane stress", id="stresses swapped"),
    ],
)  # fmt: skip
def test_another_reading_or_a_wrong_formula_turns_its_row_red(
    owner, name, fault, row, judged, red, monkeypatch
):
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert row in names(red(judged(ROTATION)))


@cache
def red_without_fault():
    return frozenset(names(r for r in solve_anew(COARSE).rows if r.status is Status.FAIL))


@pytest.mark.parametrize(
    ("owner", "name", "fault"),
    [
        pytest.param(Elastic, "lame_constants", lambda f: lambda self, _: f(self, "plane stress"),
                     id="plane stress for plane strain"),
        pytest.param(quarter, "quarter_ring", lambda f: lambda **k: f(**k | {"straight": True}),
                     id="straight edges"),
    ],
)  # fmt: skip
def test_wrong_finite_elements_turn_a_row_red(owner, name, fault, monkeypatch, red):
    before = red_without_fault()
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert names(red(solve_anew(COARSE))) - before


def test_the_growth_is_shown_as_no_speed_is_printed(judged):
    (row,) = (r for r in judged(ROTATION).rows if "Eq. 8 over Eq. 6" in r.quantity)
    assert row.status is Status.SHOWN
    assert "0.35% at 3000 r/min; 1 % at 5047.5" in row.reason


def test_the_speeds_told_are_those_of_one_and_ten_per_cent():
    q = RotatingRace()
    v = ROTATION.analytic(q)
    for key, part in (("n_1", 0.01), ("n_10", 0.1)):
        there = ROTATION.analytic(RotatingRace(omega=v[key]))
        assert there["ratio"] == pytest.approx(part, rel=1e-12)


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"r_o": 19e-3}, "R_e < R_ed"),
        ({"r_o": 19.45e-3}, "a shell"),
        ({"omega": 1e5}, "flies apart"),
        ({"rho": -1.0}, "greater than 0"),
    ],
)
def test_inputs_without_sense_are_refused_in_words(wrong, said):
    with pytest.raises(ValidationError, match=said):
        RotatingRace(**wrong)


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"omega": 700.0}, "Eq. 8 counts from"),
        ({"R_p": 1e5}, "the race yields"),
        ({"omega": 12e3}, "most steels yield"),
    ],
)
def test_an_engineer_is_warned(more, said):
    q = RotatingRace(**more)
    assert any(said in words for words in ROTATION.warnings(q, ROTATION.analytic(q)))


def test_nothing_is_warned_of_at_the_case_s_own_numbers():
    q = RotatingRace()
    assert not ROTATION.warnings(q, ROTATION.analytic(q))
