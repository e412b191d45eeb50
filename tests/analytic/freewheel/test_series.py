"""Constants of rings, shafts and stars against series, layers and transfer matrices."""

import numpy as np
import pytest

from analytic.bounds.freewheel import ring_constants, star_bracket
from analytic.freewheel import series
from analytic.freewheel.clutch import Clutch, Material
from analytic.freewheel.compliance import compliance
from analytic.freewheel.geometry import OuterCam
from analytic.ring.loaded_race import LoadedRace

E, NU = 206e9, 0.3
STEEL = Material(E=E, nu=NU)
PARTS = {"roller": STEEL, "inner": STEEL, "outer": STEEL}


@pytest.mark.parametrize("a", [2e-5, 1e-4, 4e-4])
def test_the_ring_gives_way_as_the_loaded_race_does(a, star):
    """The constant is read off at one width; at others the first power of a is known, a² not."""
    P = 2e5
    race = LoadedRace(r_i=16.5e-3, r_o=21e-3, E=E, nu=NU, assumption="plane strain",
                      loaded="bore", n=8, P=P, a=a)  # fmt: skip
    whole = race.displacement(16.5e-3, 0.0)
    found, _ = compliance(star).outer.approach(np.array(P), np.array(a))
    assert float(found) == pytest.approx(whole, rel=2 * (a / 16.5e-3) ** 2 + 1e-7)


@pytest.mark.parametrize("r_b", [4e-3, 0.0])
def test_the_shaft_gives_way_as_the_loaded_race_does(r_b):
    P, a = 2e5, 1e-4
    cam = OuterCam(R_s=10e-3, r=2e-3, X_o=13.88e-3, z=8)
    body = compliance(Clutch(cam=cam, L=10e-3, r_b=r_b, R_a=20e-3, **PARTS)).inner
    race = LoadedRace(r_i=max(r_b, 1e-7), r_o=10e-3, E=E, nu=NU, assumption="plane strain",
                      loaded="rim", n=8, P=P, a=a)  # fmt: skip
    found, _ = body.approach(np.array(P), np.array(a))
    assert float(found) == pytest.approx(-race.displacement(10e-3, 0.0), rel=3e-6)


@pytest.mark.parametrize("nu", [0.2, 0.3, 0.45])
def test_a_star_of_thin_wall_is_a_bonded_layer(nu):
    """Two solutions that share nothing: powers of r on a clamped bore, hyperbolas of a layer."""
    wall, pitch = 1e-3, 4.0  # of the radius; of the wall
    n = round(2 * np.pi / (wall * pitch))
    disc = series.star_constant(ratio=1 / (1 - wall), n=n, nu=nu / (1 - nu))
    layer = star_bracket.layer_constant(pitch=2 * np.pi / (n * wall), kappa=3 - 4 * nu)
    assert float(disc) - 2 * np.log(wall) == pytest.approx(layer, abs=3 * wall)


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
