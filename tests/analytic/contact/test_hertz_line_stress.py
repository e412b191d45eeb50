"""The stresses below a line contact against equilibrium, compatibility and superposed forces."""

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import minimize_scalar

from analytic.contact import hertz_line_stress as below

CONTACT = {"a": 0.5, "p_0": 3.0}
POINTS = [(0.0, 0.3), (0.2, 0.05), (-0.6, 0.4), (1.3, 0.1), (-0.1, 2.0)]


def field(x, z):
    return np.array(below.stresses(x, z, **CONTACT))


def slopes(x, z, h=1e-5):
    """Central differences along x and z; their error is of h² = 1e-10."""
    along_x = (field(x + h, z) - field(x - h, z)) / (2 * h)
    return along_x, (field(x, z + h) - field(x, z - h)) / (2 * h)


@pytest.mark.parametrize(("x", "z"), POINTS)
def test_stresses_are_in_equilibrium(x, z):
    (sx_x, _, t_x), (_, sz_z, t_z) = slopes(x, z)
    np.testing.assert_allclose([sx_x + t_z, t_x + sz_z], 0, atol=1e-7)


@pytest.mark.parametrize(("x", "z"), POINTS)
def test_the_sum_of_stresses_is_harmonic(x, z):
    h = z / 100
    around = [(x + h, z), (x - h, z), (x, z + h), (x, z - h)]
    laplacian = sum(sum(field(*p)[:2]) for p in around) - 4 * sum(field(x, z)[:2])
    assert laplacian / (z / 100) ** 2 * z**2 == pytest.approx(0, abs=1e-3)  # of (h/z)² = 1e-4


@pytest.mark.parametrize(("x", "z"), POINTS)
def test_stresses_are_the_sum_over_point_forces(x, z):
    """Flamant: sigma_r = -2 dP cos(theta)/(pi r) from every strip of the pressure."""
    a, p_0 = CONTACT["a"], CONTACT["p_0"]

    def part(t, i):
        r2, dx = (x - t) ** 2 + z**2, x - t
        force = -2 * p_0 * np.sqrt(1 - (t / a) ** 2) * z / (np.pi * r2**2)
        return force * (dx**2, z**2, dx * z)[i]

    near = [x] if abs(x) < a else None
    sums = [quad(part, -a, a, args=(i,), points=near, epsabs=1e-12)[0] for i in range(3)]
    np.testing.assert_allclose(field(x, z), sums, rtol=1e-8, atol=1e-9)


def test_the_surface_carries_the_pressure_and_no_shear():
    x = np.array([-2.0, -0.5, -0.3, 0.0, 0.3, 0.5, 2.0])
    sx, sz, t = below.stresses(x, np.zeros(7), **CONTACT)
    expected = -3 * np.sqrt(np.maximum(1 - (x / 0.5) ** 2, 0))
    np.testing.assert_allclose(sz, expected, atol=1e-14)
    np.testing.assert_allclose(sx, expected, atol=1e-14)  # equal at the surface (sec. 4.2)
    np.testing.assert_allclose(t, 0, atol=1e-14)


def test_a_depth_of_minus_zero_is_the_surface():
    np.testing.assert_array_equal(field([2.0, -2.0], -0.0), field([2.0, -2.0], 0.0))


def test_far_away_the_contact_is_one_force():
    """Flamant's 2P/pi is a p_0 here; what is left is of (a/r)² = 2.5e-13."""
    for x, z in [(0.0, 1e6), (1e6, 1e3), (-7e5, 7e5)]:
        force = -0.5 * 3.0 * z / (x**2 + z**2) ** 2
        flamant = [force * x**2, force * z**2, force * x * z]
        np.testing.assert_allclose(field(x, z), flamant, rtol=1e-10, atol=1e-18)


def test_largest_shear_stress_is_johnson_s_and_where_a_search_finds_it():
    tau, depth = (float(v) for v in below.largest_shear_stress(**CONTACT))
    assert round(tau / 3.0, 3) == 0.300  # Johnson sec. 4.2: 0.30 p_0 at 0.78 a, third digit here
    assert round(depth / 0.5, 3) == 0.786

    def shear(z):
        sx, sz, _ = field(0.0, z)
        return float(sx - sz) / 2

    found = minimize_scalar(lambda z: -shear(z), bounds=(0, 2), method="bounded")
    assert shear(found.x) == pytest.approx(tau, rel=1e-9)
    assert found.x == pytest.approx(depth, rel=1e-4)


def test_no_shear_in_the_plane_exceeds_that_on_the_axis():
    x, z = np.meshgrid(np.linspace(-1.5, 1.5, 121), np.linspace(0, 1.5, 61))
    sx, sz, t = field(x, z)
    tau, _ = below.largest_shear_stress(**CONTACT)
    assert np.hypot((sx - sz) / 2, t).max() <= tau


def test_transverse_stress_stops_the_strain_across_the_plane():
    sx, sz, _ = field(0.1, 0.2)
    held = below.transverse_stress(0.1, 0.2, **CONTACT, nu=0.3, assumption="plane strain")
    assert float(held) == pytest.approx(0.3 * (sx + sz), rel=1e-14)
    free = below.transverse_stress(0.1, 0.2, **CONTACT, nu=0.3, assumption="plane stress")
    assert float(free) == 0


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"z": -0.1}, "depth must be finite and not negative"),
        ({"z": np.nan}, "depth"),
        ({"x": np.inf}, "position must be finite"),
        ({"a": 0.0}, "half-width"),
        ({"p_0": -1.0}, "peak pressure"),
    ],
)
def test_input_that_makes_no_sense_is_refused(change, message):
    sound = {"x": 0.0, "z": 1.0} | CONTACT | change
    with pytest.raises(ValueError, match=message):
        below.stresses(sound.pop("x"), sound.pop("z"), **sound)
