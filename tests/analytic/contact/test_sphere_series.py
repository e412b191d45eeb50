"""Hertz's first correction for spheres against its series, Galin's integrals and its limits."""

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.contact import hertz_line, hertz_point
from analytic.contact.sphere_series import Sphere, _rest, pressed_spheres

FLAT = Sphere(R=np.inf, E=np.inf, nu=0.0)
STEEL = {"E": 206e9, "nu": 0.3}


@pytest.mark.parametrize("nu", [-0.5, 0.0, 0.3, 0.45])
def test_a_degree_of_the_series_is_in_balance_on_its_surface(nu):
    """Love's two solutions of degree n, combined to leave no shear stress at r = 1."""
    n, mu = 7, 1.0
    A, B = -(n**2 + 2 * n - 1 + 2 * nu) / (n - 1), 1.0
    normal = 2 * mu * (n * (n - 1) * A + (n + 1) * (n**2 - n - 2 - 2 * nu) * B)
    moved = n * A + (n + 1) * (n - 2 + 4 * nu) * B
    c = (2 * (1 - nu) * n**2 + nu * n - 1 + 2 * nu) / ((n - 1) * (n**2 + (1 + 2 * nu) * n + 1 + nu))
    assert moved / (normal / (2 * mu)) == pytest.approx(c, rel=1e-13)


@pytest.mark.parametrize("nu", [-0.5, 0.0, 0.3, 0.45])
def test_the_rest_of_the_series_is_its_sum(nu):
    n = np.arange(0.0, 400001.0, 2.0)
    c = (2 * (1 - nu) * n**2 + nu * n - 1 + 2 * nu) / ((n - 1) * (n**2 + (1 + 2 * nu) * n + 1 + nu))
    terms = (2 * n + 1) * c - 4 * (1 - nu)
    terms[1:] -= 2 * (1 - 2 * nu) ** 2 / n[1:]
    beyond = terms[-1] * n[-1] / 2  # terms fall as 1/n²
    images = 2 * (1 - nu) - 2 * (1 - 2 * nu) ** 2 * np.log(2)
    assert _rest(nu) == pytest.approx(images + 2 * (terms.sum() + beyond), abs=1e-7)


@pytest.mark.parametrize("nu", [-0.5, 0.0, 0.3, 0.45])
def test_the_logarithm_is_what_the_series_leaves_of_the_order_of_its_degree_s_inverse(nu):
    """A force P moves R by P/(8 pi mu R) of (2n + 1) c_n P_n, where P_n/n sums to -ln(d/2R)."""
    n, R, E = 1e6, 0.7, 3.0
    c = (2 * (1 - nu) * n**2 + nu * n - 1 + 2 * nu) / ((n - 1) * (n**2 + (1 + 2 * nu) * n + 1 + nu))
    inverse = ((2 * n + 1) * c - 4 * (1 - nu)) * n
    mu = E / (2 * (1 + nu))
    assert Sphere(R=R, E=E, nu=nu).logarithm == pytest.approx(inverse / (8 * mu * R), rel=1e-4)


def test_the_logarithm_changes_load_and_peak_as_galin_s_integrals_have_it():
    """P = 2 E* int r² f'/sqrt(a² - r²) and p_0 = E*/pi int g'/x, of f' from Laplace's equation."""
    a = R = E_star = 1.0
    lam = 0.01

    def slope(r):  # of the logarithm's displacement
        return -2 * lam / R * (2 / np.pi) * (a**2 / 3) * (1 - (1 - r**2) ** 1.5) / r

    def bent(x):
        return x * quad(lambda t: slope(x * np.sin(t)), 0, np.pi / 2)[0]

    load = 2 * E_star * quad(lambda t: np.sin(t) ** 2 * slope(np.sin(t)), 0, np.pi / 2)[0]
    assert load / (4 / 3) == pytest.approx(-3 * lam / (2 * np.pi), rel=1e-9)
    p_0 = (bent(1.0) + quad(lambda x: bent(x) / x**2, 0, 1)[0]) / np.pi
    assert p_0 / (2 / np.pi) == pytest.approx(-lam * (1 / (2 * np.pi) + np.pi / 8), rel=1e-8)
    rise = 4 * lam / (3 * np.pi) * (0.5 + np.log(2))
    assert bent(1.0) == pytest.approx(-rise, rel=1e-9)


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


def test_a_pair_of_equal_spheres_is_one_on_a_rigid_flat_twice():
    ball = Sphere(R=4e-3, **STEEL)
    pair, half = pressed_spheres(ball, ball, P=10.0), pressed_spheres(ball, FLAT, P=10.0)
    assert pair.a == pytest.approx(half.a, rel=1e-14)
    assert pair.p_0 == pytest.approx(half.p_0, rel=1e-14)
    assert pair.approach == pytest.approx(2 * half.approach, rel=1e-13)


def test_the_order_of_the_spheres_does_not_matter():
    one, other = Sphere(R=4e-3, **STEEL), Sphere(R=0.011, E=70e9, nu=0.2)
    a, b = pressed_spheres(one, other, P=10.0), pressed_spheres(other, one, P=10.0)
    assert (a.a, a.p_0) == pytest.approx((b.a, b.p_0), rel=1e-14)
    assert a.approach == pytest.approx(b.approach, rel=1e-14)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: Sphere(R=0.0, **STEEL), "radius must be positive"),
        (lambda: Sphere(R=1.0, E=np.nan, nu=0.3), "Young's modulus must be positive"),
        (lambda: Sphere(R=1.0, E=1.0, nu=0.5), "Poisson's ratio"),
        (lambda: pressed_spheres(Sphere(R=1.0, **STEEL), FLAT, P=0.0), "load must be .* N"),
        (lambda: pressed_spheres(FLAT, FLAT, P=1.0), "one body must be elastic"),
    ],
)
def test_input_that_makes_no_sense_is_refused(call, message):
    with pytest.raises(ValueError, match=message):
        call()
