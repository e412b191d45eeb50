"""Races under n sprags and rotating races: readings, statements, refused inputs."""

from dataclasses import replace

import pytest

from analytic.contact import hertz_line
from analytic.ring import fourier_ring, loaded_race, rotating, smeared
from tests.verify.cases.readings import given
from verify.cases.ring.loads import figures
from verify.cases.ring.loads.case import OUTER, InnerRace, OuterRace
from verify.cases.ring.loads.formulas import SpragLoads
from verify.cases.ring.loads_map.case import MAP
from verify.cases.ring.rotation.case import ROTATION, RotatingRace

AT_LOAD = "bore displacement under a sprag"


def race(**changes):
    """The race with other numbers, each made of the inputs."""
    return lambda f: (
        lambda q, **k: replace(f(q, **k), **{name: make(q) for name, make in changes.items()})
    )


READINGS = [
    pytest.param(OUTER, hertz_line, "relative_radius", given(R_2=lambda k: -k["R_2"]), AT_LOAD,
                 id="the race's curvature has the other sign"),
    pytest.param(OUTER, SpragLoads, "race", race(n=lambda q: q.n // 2, P=lambda q: 2 * q.P),
                 "peak-to-peak variation of the deflection, divided by the mean deflection",
                 id="N and the force of two sprags each"),
    pytest.param(OUTER, loaded_race, "share", lambda f: lambda x: 1.0 + 0 * f(x),
                 "hoop force in the cut between sprags", id="a point force for the ellipse"),
    pytest.param(MAP, fourier_ring, "_wall_tractions", lambda f: lambda *a: 1.01 * f(*a),
                 "displacement under a sprag, divided by δ_6, n = 12, r_o/r_i = 1.35",
                 id="loads 1 % too large"),
    pytest.param(ROTATION, rotating, "_load", lambda f: lambda rho, w: f(rho, w * 9.549),
                 "bore growth, plane stress", id="r/min for an angular speed"),
]  # fmt: skip


@pytest.mark.parametrize(("case", "owner", "name", "reading", "row"), READINGS)
def test_another_reading_fails(case, owner, name, reading, row, fails):
    assert row in fails(case, owner, name, reading, row)


def test_n_is_the_number_of_sprags(fails):
    """Not the number of slices of Eqs. 3 to 5, of which 6 would be few, nor a speed."""
    fault = given(n=lambda k: k["n"] / 2)
    found = fails(OUTER, smeared, "race_deflection", fault, "")
    assert {
        "bore displacement, mean",
        "deflection by Eq. 6, compared with the displacement under a sprag",
        "deflection by Eq. 6, compared with the displacement between sprags",
    } <= found


def test_a_uniform_load_misses_windup_and_force_from_12_sprags_on():
    races = (OuterRace(), InnerRace())
    windup, peak = figures.ratios(races, 12)
    assert 1.04 < windup < 1.05
    assert 0.97 < peak < 0.98
    windup, peak = figures.ratios(races, 6)
    assert windup < 1 < peak


def test_speeds_at_which_growth_counts_are_those_of_one_and_ten_per_cent():
    v = ROTATION.analytic(RotatingRace())
    for key, part in (("n_1", 0.01), ("n_10", 0.1)):
        there = ROTATION.analytic(RotatingRace(omega=v[key]))
        assert there["ratio"] == pytest.approx(part, rel=1e-12)
