"""The constants of rings, shafts and stars against the series they stand for."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.bounds.freewheel import star_bracket
from analytic.bounds.freewheel.parts import Parts
from analytic.contact import hertz_line_approach
from analytic.freewheel import series
from analytic.freewheel.clutch import Clutch, Material
from analytic.freewheel.compliance import compliance
from analytic.freewheel.geometry import InnerCam, OuterCam
from analytic.ring.fourier_ring import FourierRing
from analytic.ring.loaded_race import LoadedRace

E, NU = 206e9, 0.3
STEEL = Material(E=E, nu=NU)
PARTS = {"roller": STEEL, "inner": STEEL, "outer": STEEL}


@pytest.mark.parametrize("a", [2e-5, 1e-4, 4e-4])
def test_the_ring_gives_way_as_the_loaded_race_does(a, star):
    """The constant is read off at one width; at others the first power of a is told, a² not."""
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


@pytest.mark.parametrize(("low", "high"), [(1.2, 1.21), (1.1, 1.6), (1.05, 2.0)])
def test_rings_of_many_ratios_are_interpolated_to_round_off(low, high):
    ratio = np.linspace(low, high, 300)
    every = series.race_constant(ratio=ratio, n=8, nu=0.43, loaded="bore")
    some = [series.race_constant(ratio=x, n=8, nu=0.43, loaded="bore") for x in ratio[::60]]
    np.testing.assert_allclose(every[::60], some, rtol=1e-9)
    every = series.star_constant(ratio=ratio, n=8, nu=0.43)
    some = [series.star_constant(ratio=x, n=8, nu=0.43) for x in ratio[::60]]
    np.testing.assert_allclose(every[::60], some, atol=1e-8)


def test_the_ring_s_constant_is_linear_in_poisson_s_ratio():
    k = [series.race_constant(ratio=1.3, n=8, nu=nu, loaded="bore") for nu in (0.1, 0.25, 0.4)]
    direct = LoadedRace(r_i=1.0, r_o=1.3, E=1.0, nu=0.25, assumption="plane stress",
                        loaded="bore", n=8, P=np.pi, a=1e-3).displacement(1.0, 0.0)  # fmt: skip
    linear = series.curvature_term(nu=0.25, loaded="bore") * 1e-3
    assert float(k[1]) == pytest.approx(float(k[0] + k[2]) / 2, rel=1e-12)
    assert float(k[1]) == pytest.approx(direct - 2 * np.log(1e3) - float(linear), rel=1e-5)


def test_a_star_clamped_on_a_tiny_bore_answers_waves_as_a_solid_disc_does():
    m, nu = np.array([8.0, 16.0, 40.0]), 0.4
    found = series._clamped_waves(m, 1e-3, nu)
    for wave, value in zip(m, found, strict=True):
        disc = FourierRing(r_i=1e-3, r_o=1.0, E=1.0, nu=nu, assumption="plane stress",
                           loaded="rim", n=int(wave), p=np.array([0.0, 1.0]))  # fmt: skip
        assert value == pytest.approx(-float(disc.at(1.0, 0.0).u_r), rel=1e-9)


@pytest.mark.parametrize("nu", [0.2, 0.3, 0.45])
def test_a_star_of_thin_wall_is_a_bonded_layer(nu):
    """Two solutions that share nothing: powers of r on a clamped bore, hyperbolas of a layer."""
    wall, pitch = 1e-3, 4.0  # of the radius; of the wall
    n = round(2 * np.pi / (wall * pitch))
    disc = series.star_constant(ratio=1 / (1 - wall), n=n, nu=nu / (1 - nu))
    layer = star_bracket.layer_constant(pitch=2 * np.pi / (n * wall), kappa=3 - 4 * nu)
    assert float(disc) - 2 * np.log(wall) == pytest.approx(layer, abs=3 * wall)


def test_the_expected_interval_holds_the_disc_and_not_the_half_space():
    """The half space without clamp is stiffer than even the layer: some 1.5 to 2 % of d_i."""
    cam = InnerCam(R=16.5e-3, r=2.5e-3, X=11.39565e-3, z=8)
    more = {"cam": cam, "L": 10e-3, "r_b": 7.5e-3, "R_a": 21e-3, **PARTS}
    P = np.array([1e4, 1e5, 3e5])
    disc, half_space = Clutch(**more), Clutch(**more, star="half space")
    enclosed = Parts(sense=1, race=16.5e-3, flat=11.39565e-3, r=2.5e-3, z=8, L=10e-3, r_b=7.5e-3,
                     R_a=21e-3, E=E, nu=NU)  # fmt: skip
    least, largest = star_bracket.expected_approach(enclosed, P)
    found = compliance(disc).approaches(P).d_i
    assert np.all((least < found) & (found < largest))
    assert np.all(largest / least - 1 < 0.025)
    off = compliance(half_space).approaches(P).d_i / least - 1
    assert np.all((off > -0.021) & (off < -0.013))


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


def test_more_waves_change_nothing_in_a_star_s_constant(monkeypatch):
    """The waves left out are added as their leading order 1/m²; without, 2e-4 would be missing."""
    few = series._star.__wrapped__(1.5, n=8, nu=0.43)
    monkeypatch.setattr(series, "TERMS", 16 * series.TERMS)
    assert few == pytest.approx(series._star.__wrapped__(1.5, n=8, nu=0.43), abs=1e-6)


def test_roller_and_half_space_give_way_as_hertz_s_contact_says(star):
    P, a = np.array(2e5), np.array(8e-5)
    steel = {"E": E, "nu": NU, "assumption": "plane strain"}
    roller, _ = compliance(star).half_roller.approach(P, a)
    centre = hertz_line_approach.approach_to_centre(P=P, a=a, R=2.5e-3, E_plane=E / (1 - NU**2))
    assert float(roller) == pytest.approx(float(centre), rel=1e-13)
    deep, _ = compliance(replace(star, star="half space")).inner.approach(P, a)
    depth = star.cam.X - star.r_b
    far = hertz_line_approach.approach_to_far_depth(depth, P=P, a=a, **steel)
    assert float(deep) == pytest.approx(float(far), rel=1e-13)


def test_the_star_s_rim_goes_through_the_places_where_its_rollers_touch(star):
    """On the flat, beside its middle by the roller's way along it; its centre lies on R - r."""
    along = (16.5e-3 - 2.5e-3) * np.sin(np.arccos((11.39565e-3 + 2.5e-3) / (16.5e-3 - 2.5e-3)))
    rim = float(compliance(star).inner.l)
    assert rim**2 - 11.39565e-3**2 == pytest.approx(along**2, rel=1e-9)
