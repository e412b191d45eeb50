"""A formula must not notice whether lengths are in m or mm, stresses in Pa or MPa."""

import numpy as np
import pytest

from analytic.contact import (
    disc,
    disc_series,
    hertz_line,
    hertz_line_approach,
    hertz_line_stress,
    hertz_point,
    partial_slip,
    press_fit,
    sphere_series,
    tangential_cycle,
)

MM, MPA = 1e3, 1e-6  # from SI


def line(k, s):  # load per length: stress times length
    return {"P": 1e5 * s * k, "R": 0.01 * k, "E_star": 1.1e11 * s}


def point(k, s):
    return {"P": 1e3 * s * k**2, "R": 0.01 * k, "E_star": 1.1e11 * s}


def sliding(k, s):
    return {"P": 1e5 * s * k, "mu": 0.1}


def contact(k, s):
    return {"a": 1e-4 * k, "p_0": 1e9 * s}


def body(s):
    return {"E": 2e11 * s, "nu": 0.3, "assumption": "plane strain"}


def stack(k, s):
    shaft = press_fit.Wall(r_i=0.01 * k, r_o=0.02 * k, E=2e11 * s, nu=0.3)
    hub = press_fit.Wall(r_i=0.02 * k, r_o=0.04 * k, E=1e11 * s, nu=0.2)
    return [shaft, hub]


def swing(k, s):
    return {"Q": 2e3 * s * k, "Q_max": 5e3 * s * k, "branch": "unloading", **sliding(k, s)}


def fit(k, s):
    return {"p_i": 1e6 * s, "p_o": 2e6 * s, "assumption": "plane stress"}


def overlap(k, s):
    shaft, hub = stack(k, s)
    return shaft, press_fit.Wall(r_i=0.01999 * k, r_o=0.04 * k, E=hub.E, nu=hub.nu)


def spheres(k, s):
    one = sphere_series.Sphere(R=0.01 * k, E=2e11 * s, nu=0.3)
    other = sphere_series.Sphere(R=0.03 * k, E=1e11 * s, nu=0.2)
    return sphere_series.pressed_spheres(one, other, P=1e3 * s * k**2)


CASES = [
    pytest.param(
        lambda k, s: hertz_line.contact_modulus(
            E_1=2e11 * s, nu_1=0.3, E_2=7e10 * s, nu_2=0.2, assumption="plane strain"),
        MPA, id="contact modulus"),
    pytest.param(
        lambda k, s: hertz_line.relative_radius(R_1=0.01 * k, R_2=-0.02 * k),
        MM, id="relative radius"),
    pytest.param(lambda k, s: hertz_line.half_width(**line(k, s)), MM, id="line: a"),
    pytest.param(lambda k, s: hertz_line.peak_pressure(**line(k, s)), MPA, id="line: p_0"),
    pytest.param(
        lambda k, s: hertz_line.pressure(5e-5 * k, **contact(k, s)), MPA, id="line: pressure"),
    *(
        pytest.param(
            lambda k, s, i=i: hertz_line_stress.stresses(5e-5 * k, 3e-5 * k, **contact(k, s))[i],
            MPA, id=f"line: stress {i}")
        for i in range(3)
    ),
    pytest.param(
        lambda k, s: hertz_line_stress.transverse_stress(
            5e-5 * k, 3e-5 * k, **contact(k, s), nu=0.3, assumption="plane strain"),
        MPA, id="line: stress across"),
    pytest.param(
        lambda k, s: hertz_line_stress.largest_shear_stress(**contact(k, s))[0],
        MPA, id="line: largest shear"),
    pytest.param(
        lambda k, s: hertz_line_stress.largest_shear_stress(**contact(k, s))[1],
        MM, id="line: its depth"),
    *(
        pytest.param(
            lambda k, s, f=f: f(0.01 * k, P=1e5 * s * k, a=1e-4 * k, **body(s)), MM, id=f.__name__)
        for f in (
            hertz_line_approach.approach_to_depth, hertz_line_approach.approach_to_far_depth)
    ),
    *(
        pytest.param(
            lambda k, s, f=f: f(P=1e5 * s * k, a=1e-3 * k, R=0.01 * k, E_plane=2e11 * s),
            MM, id=f"{f.__module__}.{f.__name__}")
        for f in (hertz_line_approach.approach_to_centre, disc_series.approach)
    ),
    *(
        pytest.param(
            lambda k, s, name=name: getattr(
                disc.disc_under_load(P=1e8 * s * k, R=0.01 * k, E_plane=2e11 * s), name),
            factor, id=f"disc: {name}")
        for name, factor in {"a": MM, "p_0": MPA, "P": MM * MPA, "approach": MM}.items()
    ),
    pytest.param(
        lambda k, s: disc.disc_in_contact(
            a=1e-3 * k, R=0.01 * k, E_plane=2e11 * s).pressure(5e-4 * k), MPA, id="disc: pressure"),
    pytest.param(
        lambda k, s: disc_series.pressure_excess(a=1e-3 * k, R=0.01 * k), 1, id="p_0's excess"),
    pytest.param(
        lambda k, s: disc_series.width_excess(a=1e-3 * k, R=0.01 * k), 1, id="a's excess"),
    pytest.param(lambda k, s: hertz_point.radius(**point(k, s)), MM, id="point: a"),
    pytest.param(lambda k, s: hertz_point.peak_pressure(**point(k, s)), MPA, id="point: p_0"),
    pytest.param(lambda k, s: hertz_point.approach(**point(k, s)), MM, id="point: approach"),
    pytest.param(
        lambda k, s: hertz_point.load(delta=1e-6 * k, R=0.01 * k, E_star=1e11 * s),
        MPA * MM**2, id="point: load"),
    pytest.param(
        lambda k, s: hertz_point.pressure(5e-5 * k, **contact(k, s)), MPA, id="point: pressure"),
    *(
        pytest.param(
            lambda k, s, r=r: hertz_point.surface_displacement(
                r * k, **contact(k, s), E=2e11 * s, nu=0.3), MM, id=f"point: surface at {r}")
        for r in (5e-5, 2e-4)
    ),
    *(
        pytest.param(
            lambda k, s, i=i: hertz_point.axis_stresses(5e-5 * k, **contact(k, s), nu=0.3)[i],
            MPA, id=f"point: axis stress {i}")
        for i in range(2)
    ),
    pytest.param(
        lambda k, s: hertz_point.largest_shear_stress(**contact(k, s), nu=0.3)[0],
        MPA, id="point: largest shear"),
    pytest.param(
        lambda k, s: hertz_point.largest_shear_stress(**contact(k, s), nu=0.3)[1],
        MM, id="point: its depth"),
    pytest.param(
        lambda k, s: partial_slip.stick_half_width(Q=5e3 * s * k, **sliding(k, s), a=1e-4 * k),
        MM, id="stick half-width"),
    pytest.param(
        lambda k, s: partial_slip.traction(
            5e-5 * k, Q=5e3 * s * k, **sliding(k, s), a=1e-4 * k), MPA, id="traction"),
    pytest.param(
        lambda k, s: partial_slip.slip(
            9e-5 * k, Q=5e3 * s * k, **sliding(k, s), a=1e-4 * k, E_star=1e11 * s), MM, id="slip"),
    pytest.param(
        lambda k, s: partial_slip.rigid_displacement_beyond_stick(
            Q=5e3 * s * k, **sliding(k, s), E_star=1e11 * s), MM, id="displacement beyond stick"),
    pytest.param(
        lambda k, s: partial_slip.dundurs_beta(
            E_1=2e11 * s, nu_1=0.3, E_2=7e10 * s, nu_2=0.2, assumption="plane strain"),
        1, id="Dundurs' beta"),
    pytest.param(
        lambda k, s: tangential_cycle.traction(5e-5 * k, **swing(k, s), a=1e-4 * k),
        MPA, id="cycle: traction"),
    pytest.param(
        lambda k, s: tangential_cycle.slip(
            9e-5 * k, **swing(k, s), a=1e-4 * k, E_star=1e11 * s), MM, id="cycle: slip"),
    pytest.param(
        lambda k, s: tangential_cycle.rigid_displacement_beyond_stick(
            **swing(k, s), E_star=1e11 * s), MM, id="cycle: displacement"),
    pytest.param(
        lambda k, s: tangential_cycle.dissipation(
            Q_max=5e3 * s * k, **sliding(k, s), E_star=1e11 * s),
        MPA * MM**2, id="dissipation per length (J/m is Pa m²)"),
    pytest.param(
        lambda k, s: press_fit.contact_pressures(stack(k, s), 1e-5 * k, **fit(k, s))[0],
        MPA, id="press fit: pressure"),
    pytest.param(
        lambda k, s: press_fit.pressure_of_overlap(*overlap(k, s), **fit(k, s)),
        MPA, id="press fit: overlap"),
    pytest.param(
        lambda k, s: stack(k, s)[0].strain_energy(
            p_i=1e6 * s, p_o=2e6 * s, assumption="plane strain"),
        MPA * MM**2, id="press fit: energy"),
    *(
        pytest.param(lambda k, s, n=n: getattr(spheres(k, s), n), factor, id=f"spheres: {n}")
        for n, factor in {"a": MM, "p_0": MPA, "approach": MM}.items()
    ),
    pytest.param(
        lambda k, s: press_fit.interferences_lost(stack(k, s), **fit(k, s))[0],
        MM, id="press fit: interference lost"),
    pytest.param(
        lambda k, s: press_fit.opening_interference(
            stack(k, s), 1e-5 * k, interface=0, **fit(k, s)), MM, id="press fit: opening"),
    pytest.param(
        lambda k, s: stack(k, s)[0].stresses(0.015 * k, p_i=1e6 * s, p_o=2e6 * s)[1],
        MPA, id="press fit: hoop stress"),
    pytest.param(
        lambda k, s: stack(k, s)[0].displacement(
            0.015 * k, p_i=1e6 * s, p_o=2e6 * s, assumption="plane strain"),
        MM, id="press fit: displacement"),
]  # fmt: skip


@pytest.mark.parametrize(("formula", "factor"), CASES)
def test_formula_is_dimensionally_homogeneous(formula, factor):
    there, here = np.asarray(formula(MM, MPA)), np.asarray(formula(1.0, 1.0))
    assert here.shape == ()
    assert float(here) != 0
    assert float(there) == pytest.approx(factor * float(here), rel=1e-11)
