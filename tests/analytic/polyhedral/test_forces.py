"""Geometry of the bore and forces of pressure and hub."""

import numpy as np
import pytest

from analytic.polyhedral import forces

ALL = np.arange(3, 49)


def test_a_fillet_moves_the_flats_out_while_its_corners_stay():
    """By the unfilleted corner and the fillet's centre, as the bore is drawn."""
    half, rho, d_i = np.pi / ALL, 5e-3, 0.072
    R_u = d_i / 2 + rho * (1 / np.cos(half) - 1)
    centre = R_u - rho / np.cos(half)
    np.testing.assert_allclose(centre + rho, d_i / 2)  # the real corner
    a = forces.apothem(d_i=d_i, z=ALL, rho=rho)
    np.testing.assert_allclose(a, R_u * np.cos(half), rtol=1e-14)
    np.testing.assert_allclose(centre * np.cos(half) + rho, a, rtol=1e-14)  # the arc meets the flat
    flat = forces.half_flat(d_i=d_i, z=ALL, rho=rho)
    np.testing.assert_allclose(flat, R_u * np.sin(half) - rho * np.tan(half), rtol=1e-12)
    np.testing.assert_allclose(centre * np.sin(half), flat, rtol=1e-12)


def test_many_corners_press_like_a_circle():
    z = np.array([1e3, 1e4])
    around = z * forces.pressure_force(p_2=2.0, b=3.0, d_i=5.0, z=z)
    np.testing.assert_allclose(around, 2.0 * 3.0 * np.pi * 5.0, rtol=2e-6)


def test_hub_without_friction_pushes_along_the_normal():
    psi = np.radians([5.0, 16.0, 30.0])
    F_s = forces.radial_force(M_t=400.0, z=6, lever=0.03, psi=psi, phi_1=0.0)
    R = forces.contact_force(F_s=F_s, psi=psi, phi_1=0.0)
    np.testing.assert_allclose(R * np.sin(psi) * 0.03 * 6, 400.0)  # its tangential part's moment
    np.testing.assert_allclose(forces.normal_force(F=1e4, R=R, phi_1=0.0, gamma=0.0), 1e4 + R)
    on_radius = forces.normal_force(F=1e4, R=R, phi_1=0.0, gamma=psi)
    np.testing.assert_allclose(on_radius, 1e4 + F_s)


@pytest.mark.parametrize("z", [2, 0, 3.5, np.nan, np.inf])
def test_fewer_than_three_corners_or_a_part_of_one_are_refused(z):
    with pytest.raises(ValueError, match="whole number of corners, 3 or more, got z="):
        forces.pressure_force(p_2=1.0, b=1.0, d_i=1.0, z=z)


@pytest.mark.parametrize(
    ("refused", "message"),
    [
        (lambda: forces.apothem(d_i=0.072, z=6, rho=0.036),
         "fillet leaves no flat: rho must be below d_i/2=0.036 m, got 0.036 m"),
        (lambda: forces.apothem(d_i=0.072, z=6, rho=-1e-3), "fillet rho must be finite"),
        (lambda: forces.apothem(d_i=0.0, z=6), "corner diameter d_i must be positive"),
        (lambda: forces.contact_angle(e=0.0, apothem=0.03), "distance e of the hub's contact must"),
        (lambda: forces.contact_radius(apothem=0.03, psi=0.0), r"psi > 0, .* got psi=0.0 deg"),
        (lambda: forces.radial_force(M_t=1.0, z=6, lever=0.03, psi=1.5, phi_1=0.1),
         r"psi \+ phi_1 < 90 deg, got psi=85.9\d* deg, phi_1=5.7\d* deg"),
        (lambda: forces.contact_force(F_s=1.0, psi=0.3, phi_1=-0.1), "phi_1 >= 0 and"),
        (lambda: forces.radial_force(M_t=1.0, z=6, lever=0.0, psi=0.3, phi_1=0.1),
         "lever of the hub's contact must be positive and finite, got 0.0 m"),
        (lambda: forces.pressure_force(p_2=np.nan, b=1.0, d_i=1.0, z=6), "p_2 must be finite"),
    ],
)  # fmt: skip
def test_bores_and_hubs_that_make_no_sense_are_refused(refused, message):
    with pytest.raises(ValueError, match=message):
        refused()
