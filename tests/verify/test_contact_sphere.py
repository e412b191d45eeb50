"""Point contact: every reading and every deliberate fault turns a row red."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from analytic.contact import hertz_line, hertz_point, sphere_series
from fem.contact import bodies, point_contact
from verify.cases.contact.sphere import reference
from verify.cases.contact.sphere.case import SPHERE, Spheres
from verify.core.inputs import InputError, build
from verify.core.results import Status
from verify.jobs.level import Job, judge_case, solve_level

COARSE = replace(SPHERE, levels=(2, 3, 4))
RAW = {"R_1": "4 mm", "R_2": "11 mm", "P": "16 N", "E_1": "206 GPa", "nu_1": 0.3,
       "E_2": "110 GPa", "nu_2": 0.34}  # fmt: skip
SURE = {"approach on a rigid flat", "approach on a sphere"}

pytestmark = pytest.mark.xdist_group("contact-sphere")


def names(rows):
    return {row.quantity for row in rows}


def solve_anew(case):
    q = case.inputs()
    return judge_case(Job(case, q), [solve_level(case, q, level, None) for level in case.levels])


@cache
def red_without_fault():
    """Coarse meshes leave some rows without the sharpness they need: these prove nothing."""
    return frozenset(names(r for r in solve_anew(COARSE).rows if r.status is Status.FAIL))


# Readings, and faults of the formulas: finite elements come from the cache.
def other_modulus(right):
    return lambda **more: right(**more | {"assumption": "plane stress"})


def diameters(right):
    return lambda *, R_1, R_2: right(R_1=2 * R_1, R_2=2 * R_2)


@pytest.mark.parametrize(
    ("owner", "name", "fault", "row"),
    [
        pytest.param(hertz_line, "contact_modulus", other_modulus,
                     "contact radius on a sphere", id="1 - nu^2 dropped"),
        pytest.param(hertz_line, "relative_radius", diameters,
                     "peak pressure on a sphere", id="diameters for radii"),
        pytest.param(hertz_point, "approach", lambda f: lambda **k: f(**k) / 2,
                     "approach on a rigid flat", id="half the approach"),
        pytest.param(hertz_point, "peak_pressure", lambda f: lambda **k: f(**k) * 2 / 3,
                     "peak pressure on a rigid flat", id="mean for peak pressure"),
        pytest.param(hertz_point, "load", lambda f: lambda **k: f(**k) * 1.005,
                     "force at Hertz's approach on a sphere", id="load half a per cent too large"),
        pytest.param(hertz_point, "axis_stresses", lambda f: lambda *z, **k: f(*z, **k | {"nu": 0}),
                     "largest shear stress on a sphere, lower body", id="no Poisson's ratio below"),
        pytest.param(sphere_series, "_rest", lambda _: lambda _nu: 0.0,
                     "approach on a sphere", id="opposite contact forgotten"),
        pytest.param(sphere_series, "pressed_spheres",
                     lambda _: lambda one, other, *, P: far_points(one, other, P),
                     "approach on a rigid flat", id="approach of points at infinity"),
    ],
)  # fmt: skip
def test_another_reading_or_a_wrong_formula_turns_its_row_red(
    owner, name, fault, row, judged, without_fault, red, monkeypatch
):
    assert not red(without_fault(SPHERE))
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert row in names(red(judged(SPHERE, drawn=False)))


def far_points(one, other, P):
    """Hertz without any correction, as if it were the finite spheres' solution."""
    soft, bent = one.softness + other.softness, 1 / one.R + 1 / other.R
    hertz = {"P": P, "R": 1 / bent, "E_star": 1 / soft}
    return sphere_series.PressedSpheres(
        a=float(hertz_point.radius(**hertz)),
        p_0=float(hertz_point.peak_pressure(**hertz)),
        approach=float(hertz_point.approach(**hertz)),
    )


def test_the_sphere_s_own_logarithm_shows_in_the_peak_pressure(judged, red, monkeypatch):
    """Without it Hertz would be right to second order, and finite elements say that he is not."""
    monkeypatch.setattr(sphere_series.Sphere, "logarithm", property(lambda _: 0.0))
    assert "peak pressure on a rigid flat" in names(red(judged(SPHERE)))


# Faults of the finite elements: solved anew on coarse meshes.
@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(
    ("owner", "name", "fault"),
    [
                pytest.param(bodies, "vector_basis",
                     lambda f: lambda mesh, _degree, **k: f(mesh, 1, **k), id="linear elements"),
        pytest.param(point_contact, "push", lambda f: lambda state: 2 * f(state),
                     id="twice the force"),
        pytest.param(reference, "problem",
                     lambda f: lambda q, *a: f(q.model_copy(update={"E_1": 1.01 * q.E_1}), *a),
                     id="a stiffer sphere"),
        pytest.param(reference, "problem",
                     lambda f: lambda q, *a: f(q.model_copy(update={"nu_1": 0.0}), *a),
                     id="Poisson's ratio forgotten"),
    ],
)  # fmt: skip
def test_wrong_finite_elements_turn_a_row_red(owner, name, fault, red, monkeypatch):
    before = red_without_fault()
    assert not before & SURE
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert names(red(solve_anew(COARSE))) & SURE


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"P": "1 MN"}, "a/R from 1e-05 to 0.15"),
        ({"P": "1e-15 N"}, "a/R from 1e-05"),
        ({"R_2": "100 m"}, "take the larger one as flat"),
        ({"E_2": "0.1 GPa"}, "take the stiffer body as rigid"),
        ({"E_1": "0 GPa"}, "must be greater than 0 GPa"),
        ({"nu_2": 0.5}, "must be at most 0.45"),
        ({"P": "16 MPa"}, "a force"),
    ],
)
def test_input_that_makes_no_sense_gets_one_line(change, message):
    with pytest.raises(InputError, match=message) as caught:
        build(Spheres, RAW | change, "my.toml")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"P": "2 kN"}, "Hertz's approach is off"),
        ({"R_p": "500 MPa"}, "it yields below the surface"),
        ({"P": "20 kN", "E_1": "20 GPa", "R_1": "50 mm", "R_2": "50 mm"}, "give R_p"),
    ],
)
def test_formulas_outside_their_range_are_warned_of(change, words):
    q = build(Spheres, {**RAW, **change}, "my.toml")
    assert any(words in line for line in SPHERE.warnings(q, SPHERE.analytic(q)))


def test_an_approach_within_the_round_off_of_the_radius_is_refused():
    q = build(Spheres, RAW | {"P": "4e-8 N"}, "my.toml")
    assert "round-off" in SPHERE.too_large(q)


def test_a_wide_contact_has_no_expected_interval():
    q = build(Spheres, RAW | {"P": "1 kN"}, "my.toml")
    claim = next(c for c in SPHERE.checks if c.name == "contact radius on a sphere")
    assert claim.interval(q, SPHERE.analytic(q)) is None


@pytest.mark.parametrize("P", [16.0, 1e-5])
def test_pressures_next_to_the_axis_are_even_however_small_the_contact(P):
    """Rows there weigh less than those at the equator by many orders of magnitude."""
    q = Spheres(P=P).of("flat")
    a = q.width
    spheres = reference.problem(q, 2)
    down = {"upper.middle": {"y": -(a**2) / q.R_1}}
    touch = spheres.solve(displacements=down).touches[0]
    near = touch.x[0] < a / 3
    p = touch.pressure[near] / np.sqrt(1 - (touch.x[0][near] / a) ** 2)
    assert np.ptp(p) < 2e-3 * p.mean()
