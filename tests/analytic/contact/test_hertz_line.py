"""Hertz's line contact: half-plane integrals, approaches by quadrature, stresses."""

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.contact import hertz_line
from analytic.contact import hertz_line_approach as approach
from analytic.contact import hertz_line_stress as below

ROLLER = {"P": 3.0, "R": 0.7, "E_star": 400.0}


def test_the_pressure_carries_the_load_and_bends_a_half_plane_to_the_parabola():
    """Slope of the surface -2/(pi E*) times the principal value of p/(x - t), here x/R.

    The singularity is taken out by hand: the principal value of 1/(x - t) over (-a, a) is
    ln((a + x)/(a - x)).
    """
    a, p_0 = float(hertz_line.half_width(**ROLLER)), float(hertz_line.peak_pressure(**ROLLER))

    def p(t):
        return float(hertz_line.pressure(t, a=a, p_0=p_0))

    assert quad(p, -a, a)[0] == pytest.approx(ROLLER["P"], rel=1e-9)
    x = 0.4 * a
    regular, _ = quad(lambda t: (p(t) - p(x)) / (x - t), -a, a, points=[x], epsabs=1e-10)
    principal = regular + p(x) * np.log((a + x) / (a - x))
    assert 2 / (np.pi * ROLLER["E_star"]) * principal == pytest.approx(x / 0.7, rel=1e-8)


@pytest.mark.parametrize(
    ("assumption", "expected"),
    [
        ("plane stress", 1.2),  # 1/2 + 1/3 = 5/6
        ("plane strain", 1 / (0.75 / 2 + 0.96 / 3)),  # (1 - 0.25)/2 + (1 - 0.04)/3
    ],
)
def test_contact_modulus_adds_the_compliances(assumption, expected):
    pair = {"E_1": 2.0, "nu_1": -0.5, "E_2": 3.0, "nu_2": 0.2}
    modulus = hertz_line.contact_modulus(**pair, assumption=assumption)
    assert float(modulus) == pytest.approx(expected, rel=1e-14)


BODY = {"P": 2.0, "a": 0.3, "E": 5.0, "nu": 0.3}


@pytest.mark.parametrize("d", [0.01, 0.3, 4.0])
@pytest.mark.parametrize("assumption", ["plane stress", "plane strain"])
def test_approach_is_the_strain_summed_up_to_the_depth(d, assumption):
    """Hooke's law in space, sigma_y included, on the stresses of the other module."""
    contact = {"a": 0.3, "p_0": 2 * 2.0 / (np.pi * 0.3)}  # P = pi a p_0/2

    def strain(z):
        sx, sz, _ = below.stresses(0.0, z, **contact)
        sy = below.transverse_stress(0.0, z, **contact, nu=0.3, assumption=assumption)
        return float(sz - 0.3 * (sx + sy)) / 5.0

    shortened, _ = quad(strain, 0, d, epsabs=1e-12)
    value = approach.approach_to_depth(d, **BODY, assumption=assumption)
    assert float(value) == pytest.approx(-shortened, rel=1e-9)


CONTACT = {"a": 0.5, "p_0": 3.0}
POINTS = [(0.0, 0.3), (0.2, 0.05), (-0.6, 0.4), (1.3, 0.1), (-0.1, 2.0)]


def field(x, z):
    return np.array(below.stresses(x, z, **CONTACT))


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


def test_largest_shear_stress_is_johnson_s_and_that_of_the_field():
    tau, depth = (float(v) for v in below.largest_shear_stress(**CONTACT))
    assert round(tau / 3.0, 3) == 0.300  # Johnson sec. 4.2: 0.30 p_0 at 0.78 a, third digit here
    assert round(depth / 0.5, 3) == 0.786
    sx, sz, _ = field(np.zeros(3), depth + np.array([-1e-3, 0.0, 1e-3]))
    shear = (sx - sz) / 2
    assert shear[1] == pytest.approx(tau, rel=1e-12)
    assert shear[1] > max(shear[0], shear[2])


def test_the_middle_of_a_disc_is_nearer_than_that_depth_of_a_half_plane_in_johnson_s_ratio():
    """Difference (P/pi E')(2 ln 2 - 1 + nu'), here with P = pi, E' = 1, nu' = 1/4, by hand."""
    plane = approach.approach_to_far_depth(
        1.0, P=np.pi, a=1e-3, E=1.0, nu=0.25, assumption="plane stress"
    )
    disc = approach.approach_to_centre(P=np.pi, a=1e-3, R=1.0, E_plane=1.0)
    assert float(disc - plane) == pytest.approx(2 * np.log(2) - 1 + 0.25, rel=1e-12)
