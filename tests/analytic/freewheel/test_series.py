"""Constants of rings, shafts and stars against second implementations, and their derivatives."""

import numpy as np
import pytest

from analytic.bounds.freewheel import ring_constants
from analytic.freewheel import series
from analytic.freewheel.clutch import ContactMaterial, RollerClutch
from analytic.freewheel.compliance import compliance
from analytic.freewheel.geometry import OuterCam
from analytic.ring.loaded_race import LoadedRace

E, NU = 206e9, 0.3
STEEL = ContactMaterial(E=E, nu=NU)
PARTS = {"roller": STEEL, "inner": STEEL, "outer": STEEL}


@pytest.mark.parametrize("r_b", [4e-3, 0.0])
def test_the_shaft_deflects_like_the_loaded_race(r_b):
    P, a = 2e5, 1e-4
    cam = OuterCam(R_s=10e-3, r=2e-3, X_o=13.88e-3, z=8)
    body = compliance(RollerClutch(cam=cam, L=10e-3, r_b=r_b, R_a=20e-3, **PARTS)).inner
    race = LoadedRace(r_i=max(r_b, 1e-7), r_o=10e-3, E=E, nu=NU, assumption="plane strain",
                      loaded="rim", n=8, P=P, a=a)  # fmt: skip
    found, _ = body.approach(np.array(P), np.array(a))
    assert float(found) == pytest.approx(-race.displacement(10e-3, 0.0), rel=3e-6)


RATIOS = (1.1, 1.52, 3.0, 50.0)


@pytest.mark.parametrize("n", [3, 8, 14])
@pytest.mark.parametrize("nu", [0.2, 3 / 7])
def test_a_clamped_disc_is_the_star_of_the_formulas(n, nu):
    """The series of the star is cut at 400 waves, its rest summed to about 2e-7."""
    star = series.star_constant(ratio=RATIOS, n=n, nu=nu)
    again = [ring_constants.clamped_disc(ratio=x, n=n, nu=nu) for x in RATIOS]
    np.testing.assert_allclose(again, star, atol=3e-7)


@pytest.mark.parametrize("n", [3, 8, 14])
@pytest.mark.parametrize("nu", [0.2, 3 / 7])
def test_a_free_ring_is_the_ring_of_the_formulas(n, nu):
    """The formulas' constant is read off a patch of a = 2e-3 r; (a/wall)² of it is left out."""
    ring = series.race_constant(ratio=RATIOS, n=n, nu=nu, loaded="bore")
    again = [ring_constants.free_ring(ratio=x, n=n, nu=nu) for x in RATIOS]
    np.testing.assert_allclose(again, ring, rtol=3e-5)


def test_the_cup_lies_between_the_rings_of_its_inner_and_outer_circle(cup):
    bores = np.array([1, np.sqrt(np.tan(np.pi / 8) / (np.pi / 8)), 1 / np.cos(np.pi / 8)])
    k = series.race_constant(
        ratio=cup.R_a / (cup.cam.X_o * bores), n=8, nu=NU / (1 - NU), loaded="bore"
    )
    whole = 2 * np.log(bores) + k
    assert whole[0] < whole[1] < whole[2]
    assert float(compliance(cup).outer.k) == pytest.approx(k[1], rel=1e-9)


def test_slopes_are_derivatives_of_the_approaches(clutch):
    bodies, P, h = compliance(clutch), 2e5, 1e-5
    d = bodies.approaches(P)
    low, high = bodies.approaches(P * (1 - h)), bodies.approaches(P * (1 + h))
    for name in ("i", "o"):
        step = getattr(high, f"d_{name}") - getattr(low, f"d_{name}")
        assert float(getattr(d, f"slope_{name}")) == pytest.approx(step / (2 * h * P), rel=1e-8)
    tangent, slope = bodies.tangent(2e3)
    above, below = bodies.tangent(2e3 * (1 + h))[0], bodies.tangent(2e3 * (1 - h))[0]
    assert float(slope) == pytest.approx(float(above - below) / (4e3 * h), rel=1e-7)
    assert float(tangent) > 0
