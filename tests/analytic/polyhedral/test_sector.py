"""Geometry of the half sector: what the fillet touches, what cannot be."""

import numpy as np
import pytest

from analytic.polyhedral.sector import Sector

HEXAGON = {"z": 6, "d_e": 80.0, "d_i": 72.0, "rho": 2.0}


@pytest.mark.parametrize("z", [3, 4, 6, 12, 48])
def test_the_fillet_touches_the_flats_and_reaches_to_the_corner_diameter(z):
    ring = Sector(**HEXAGON | {"z": z})
    corner = np.exp(1j * np.pi / z)
    assert ring.bore(np.array([ring.half_bore]))[0] == pytest.approx(36 * corner)
    assert ring.fillet_centre == pytest.approx(ring.R_u - ring.rho / np.cos(np.pi / z))
    assert ring.straight == pytest.approx(
        ring.R_u * np.sin(np.pi / z) - ring.rho * np.tan(np.pi / z)
    )
    s = np.linspace(ring.straight, ring.half_bore, 9)
    np.testing.assert_allclose(np.abs(ring.bore(s) - ring.fillet_centre * corner), ring.rho)
    mirrored = corner**2 * ring.bore(s).conj()
    assert np.abs(mirrored - ring.fillet_centre * corner) == pytest.approx(ring.rho)


def test_the_arc_length_is_one_and_the_normal_is_square_to_the_bore():
    ring = Sector(**HEXAGON)
    s = np.linspace(0.01, ring.half_bore - 0.01, 50)
    tangent = (ring.bore(s + 1e-6) - ring.bore(s - 1e-6)) / 2e-6
    np.testing.assert_allclose(tangent, 1j * ring.normal(s), atol=1e-6)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"z": 2}, "z >= 3 of corners, got z=2"),
        ({"z": 6.5}, "whole number"),
        ({"d_i": 80.0}, "the wall vanishes: d_i must be below d_e, got d_i=80.0 m, d_e=80.0 m"),
        ({"rho": 36.0}, "rho must be below d_i/2, got rho=36.0 m, d_i=72.0 m"),
        ({"rho": 0.0}, "the fillet radius rho must be positive"),
        ({"d_e": np.nan}, "the outside diameter d_e must be positive"),
    ],
)
def test_rings_that_cannot_be_are_refused(change, message):
    with pytest.raises(ValueError, match=message):
        Sector(**HEXAGON | change)
