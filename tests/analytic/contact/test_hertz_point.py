"""Hertz's point contact against its integral, superposed point forces and printed values."""

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.contact import hertz_point

PAIR = {"P": 3.0, "R": 0.7, "E_star": 400.0}
CONTACT = {"a": 0.5, "p_0": 3.0}


def test_the_pressure_carries_the_load():
    a, p_0 = float(hertz_point.radius(**PAIR)), float(hertz_point.peak_pressure(**PAIR))
    ring, _ = quad(lambda r: 2 * np.pi * r * float(hertz_point.pressure(r, a=a, p_0=p_0)), 0, a)
    assert ring == pytest.approx(PAIR["P"], rel=1e-9)


def test_the_surface_takes_the_sphere_s_shape_and_the_approach():
    """On a rigid sphere u = delta - r²/(2R) over the contact, whose p_0 is that of the load."""
    E, nu = 400.0 * (1 - 0.3**2), 0.3
    a, p_0 = float(hertz_point.radius(**PAIR)), float(hertz_point.peak_pressure(**PAIR))
    r = np.array([0.0, 0.4, 0.9]) * a
    u = hertz_point.surface_displacement(r, a=a, p_0=p_0, E=E, nu=nu)
    np.testing.assert_allclose(u, hertz_point.approach(**PAIR) - r**2 / (2 * 0.7), rtol=1e-12)


@pytest.mark.parametrize("r", [0.7, 3.0])
def test_beyond_the_contact_the_surface_sinks_as_under_point_forces(r):
    """Boussinesq: u = (1 - nu²)/(pi E) dP/distance, over the disc of pressure."""
    turn, w = np.polynomial.legendre.leggauss(60)
    theta = np.pi * (turn + 1) / 2  # half the disc, twice

    def ring(t):
        near = np.sqrt(r**2 + t**2 - 2 * r * t * np.cos(theta))
        p = float(hertz_point.pressure(t, **CONTACT))
        return float(p * t * np.pi * (w @ (1 / near)))

    total, _ = quad(ring, 0, 0.5, epsabs=1e-12)
    u = hertz_point.surface_displacement(r, **CONTACT, E=2.0, nu=0.3)
    assert float(u) == pytest.approx(0.91 / (np.pi * 2.0) * total, rel=1e-8)


def test_the_surface_is_continuous_where_the_contact_ends():
    u = hertz_point.surface_displacement([0.5 - 1e-9, 0.5 + 1e-9], **CONTACT, E=1.0, nu=0.3)
    np.testing.assert_allclose(u[0], u[1], rtol=1e-7)


@pytest.mark.parametrize("z", [0.05, 0.3, 2.0])
def test_axis_stresses_are_the_sum_over_point_forces(z):
    """Boussinesq, at the distance s from the force's axis and d from the force.

    sigma_z = -3P z³/(2 pi d⁵), sigma_r + sigma_theta = -P/(2 pi) [3 s² z/d⁵ - (1 - 2 nu) z/d³].
    """
    nu = 0.3

    def ring(s, which):
        d = np.hypot(s, z)
        dP = 2 * np.pi * s * float(hertz_point.pressure(s, **CONTACT))
        axial = -3 * z**3 / (2 * np.pi * d**5)
        radial_and_hoop = -(3 * s**2 * z / d**5 - (1 - 2 * nu) * z / d**3) / (2 * np.pi)
        return dP * (axial, radial_and_hoop)[which]

    sigma_r, sigma_z = hertz_point.axis_stresses(z, **CONTACT, nu=nu)
    assert float(sigma_z) == pytest.approx(quad(ring, 0, 0.5, args=(0,))[0], rel=1e-8)
    assert float(2 * sigma_r) == pytest.approx(quad(ring, 0, 0.5, args=(1,))[0], rel=1e-8)


def test_largest_shear_stress_is_the_printed_one():
    """0.310 p_0 at 0.481 a for nu = 0.3, as textbooks have it."""
    tau, depth = hertz_point.largest_shear_stress(**CONTACT, nu=0.3)
    assert round(float(tau) / 3.0, 3) == 0.310
    assert round(float(depth) / 0.5, 3) == 0.481


def test_load_undoes_approach():
    delta = hertz_point.approach(**PAIR)
    again = hertz_point.load(delta=delta, R=0.7, E_star=400.0)
    assert float(again) == pytest.approx(PAIR["P"], rel=1e-14)
    assert float(hertz_point.load(delta=0.0, R=1.0, E_star=1.0)) == 0


def test_the_work_of_the_load_is_two_fifths_of_load_and_approach():
    delta = float(hertz_point.approach(**PAIR))
    work, _ = quad(lambda d: float(hertz_point.load(delta=d, R=0.7, E_star=400.0)), 0, delta)
    assert work == pytest.approx(0.4 * 3.0 * delta, rel=1e-9)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: hertz_point.radius(**PAIR | {"P": 0.0}), "load must be .* N"),
        (lambda: hertz_point.peak_pressure(**PAIR | {"R": np.nan}), "relative radius"),
        (lambda: hertz_point.approach(**PAIR | {"E_star": np.inf}), "contact modulus"),
        (lambda: hertz_point.load(delta=-1.0, R=1.0, E_star=1.0), "approach"),
        (lambda: hertz_point.axis_stresses(-1.0, **CONTACT, nu=0.3), "depth"),
        (lambda: hertz_point.axis_stresses(1.0, **CONTACT, nu=0.5), "Poisson's ratio"),
        (lambda: hertz_point.pressure(np.nan, **CONTACT), "radius must be finite"),
        (
            lambda: hertz_point.surface_displacement(0.0, a=-1.0, p_0=1.0, E=1.0, nu=0.0),
            "contact radius",
        ),
    ],
)
def test_input_that_makes_no_sense_is_refused(call, message):
    with pytest.raises(ValueError, match=message):
        call()
