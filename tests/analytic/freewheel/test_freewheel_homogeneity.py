"""A freewheel must not notice whether it is told in m and Pa or in mm and MPa."""

import numpy as np
import pytest

from analytic.bounds.freewheel import star_bracket
from analytic.bounds.freewheel.parts import Parts
from analytic.freewheel import criterion, limits, state, tilt, tolerance
from analytic.freewheel.clutch import Clutch, Material
from analytic.freewheel.geometry import InnerCam, OuterCam

MM, MPA = 1e3, 1e-6  # from SI; forces stay in N, torques are N mm


def star(k, s):
    steel = Material(E=206e9 * s, nu=0.3)
    cam = InnerCam(R=16.5e-3 * k, r=2.5e-3 * k, X=11.39565e-3 * k, z=8)
    parts = {"roller": steel, "inner": steel, "outer": steel}
    return Clutch(cam=cam, L=10e-3 * k, r_b=7.5e-3 * k, R_a=21e-3 * k, **parts)


def cup(k, s):
    steel = Material(E=206e9 * s, nu=0.3)
    cam = OuterCam(R_s=10e-3 * k, r=2e-3 * k, X_o=13.883e-3 * k, z=8)
    parts = {"roller": steel, "inner": steel, "outer": steel}
    return Clutch(cam=cam, L=10e-3 * k, r_b=0.0, R_a=20e-3 * k, **parts)


def enclosed(k, s):
    return Parts(sense=1, race=16.5e-3 * k, flat=11.39565e-3 * k, r=2.5e-3 * k, z=8, L=10e-3 * k,
                 r_b=7.5e-3 * k, R_a=21e-3 * k, E=206e9 * s, nu=0.3)  # fmt: skip


CASES = [
    *(
        pytest.param(
            lambda k, s, make=make, name=name: getattr(state.loaded(make(k, s), 10.0 * k), name),
            factor, id=f"{make.__name__}, {name}")
        for make in (star, cup)
        for name, factor in (
            ("N", 1.0), ("F_t", 1.0), ("T", MM), ("alpha", 1.0), ("d_i", MM), ("d_o", MM),
            ("a_i", MM), ("p_o", MPA), ("s", MM), ("phi", 1.0), ("phi_printed", 1.0),
            ("phi_small", 1.0))
    ),
    pytest.param(
        lambda k, s: limits.limits(star(k, s), mu=0.08, p_lim=2e9 * s).torque, MM, id="limit"),
    pytest.param(
        lambda k, s: limits.limits(cup(k, s), mu=0.2, p_lim=1e11 * s).pop_through, MM,
        id="pop-through"),
    pytest.param(
        lambda k, s: criterion.required_friction(alpha=0.06, T=9.0 * k, F_ax=50.0, R=0.0165 * k),
        1.0, id="required friction"),
    pytest.param(
        lambda k, s: criterion.largest_axial_load(alpha=0.06, T=9.0 * k, R=0.0165 * k, mu=0.1),
        1.0, id="largest axial load"),
    pytest.param(
        lambda k, s: star_bracket.expected_approach(enclosed(k, s), 2e5 / k)[1], MM, id="interval"),
    pytest.param(
        lambda k, s: tilt.offset(F_a=3.0, F_n=90.0, r=2.5e-3 * k, alpha=0.06), MM, id="offset"),
    pytest.param(
        lambda k, s: tolerance.sensitivities(cup(k, s).cam)["r"], 1 / MM, id="sensitivity"),
]  # fmt: skip


@pytest.mark.parametrize(("formula", "factor"), CASES)
def test_formula_is_dimensionally_homogeneous(formula, factor):
    told = float(np.asarray(formula(MM, MPA)))
    assert told == pytest.approx(factor * float(formula(1.0, 1.0)), rel=1e-9)
