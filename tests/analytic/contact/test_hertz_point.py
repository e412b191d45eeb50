"""Hertz's point contact and the first correction of spheres, against integrals and series."""

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.contact import hertz_line, hertz_point
from analytic.contact.sphere_series import Sphere, _rest, pressed_spheres

PAIR = {"P": 3.0, "R": 0.7, "E_star": 400.0}
CONTACT = {"a": 0.5, "p_0": 3.0}


def test_the_pressure_carries_the_load_and_gives_the_surface_the_sphere_s_shape():
    """On a rigid sphere u = delta - r²/(2R) over the contact, whose p_0 is that of the load."""
    E, nu = 400.0 * (1 - 0.3**2), 0.3
    a, p_0 = float(hertz_point.radius(**PAIR)), float(hertz_point.peak_pressure(**PAIR))
    load, _ = quad(lambda r: 2 * np.pi * r * float(hertz_point.pressure(r, a=a, p_0=p_0)), 0, a)
    assert load == pytest.approx(PAIR["P"], rel=1e-9)
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


STEEL = {"E": 206e9, "nu": 0.3}


def degree(n, nu):
    """c_n of the series."""
    below = (n - 1) * (n**2 + (1 + 2 * nu) * n + 1 + nu)
    return (2 * (1 - nu) * n**2 + nu * n - 1 + 2 * nu) / below


@pytest.mark.parametrize("nu", [-0.5, 0.3])
def test_the_rest_of_the_series_is_its_sum(nu):
    n = np.arange(0.0, 400001.0, 2.0)
    terms = (2 * n + 1) * degree(n, nu) - 4 * (1 - nu)
    terms[1:] -= 2 * (1 - 2 * nu) ** 2 / n[1:]
    beyond = terms[-1] * n[-1] / 2  # terms fall as 1/n²
    images = 2 * (1 - nu) - 2 * (1 - 2 * nu) ** 2 * np.log(2)
    assert _rest(nu) == pytest.approx(images + 2 * (terms.sum() + beyond), abs=1e-7)


def test_small_contacts_are_hertz_s():
    one, other = Sphere(R=4e-3, **STEEL), Sphere(R=0.011, E=110e9, nu=0.34)
    R = float(hertz_line.relative_radius(R_1=4e-3, R_2=0.011))
    E = hertz_line.contact_modulus(
        E_1=206e9, nu_1=0.3, E_2=110e9, nu_2=0.34, assumption="plane strain"
    )
    hertz = {"R": R, "E_star": float(E), "P": 1e-6}
    pressed = pressed_spheres(one, other, P=1e-6)
    assert pressed.a == pytest.approx(float(hertz_point.radius(**hertz)), rel=1e-5)
    assert pressed.p_0 == pytest.approx(float(hertz_point.peak_pressure(**hertz)), rel=1e-5)
    assert pressed.approach == pytest.approx(float(hertz_point.approach(**hertz)), rel=1e-4)


@pytest.mark.parametrize("nu", [-0.5, 0.3])
def test_the_logarithm_is_what_the_series_leaves_of_the_order_of_its_degree_s_inverse(nu):
    """A force P moves R by P/(8 pi mu R) of (2n + 1) c_n P_n, where P_n/n sums to -ln(d/2R)."""
    n, R, E = 1e6, 0.7, 3.0
    inverse = ((2 * n + 1) * degree(n, nu) - 4 * (1 - nu)) * n
    mu = E / (2 * (1 + nu))
    assert Sphere(R=R, E=E, nu=nu).logarithm == pytest.approx(inverse / (8 * mu * R), rel=1e-4)
