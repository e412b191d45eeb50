"""Unbalance response: the Jeffcott rotor, balance of forces, orbits, loads, two speeds."""

import numpy as np
import pytest

from fem.rotor.model import Disc, Element, Link, Material, Rotor, Shaft, SpeedSupport, Support
from fem.rotor.response import forced_response, unbalance_response

E, NU = 210e9, 0.3
STEEL = Material(E=E, nu=NU, rho=7850.0)
RIGID = Material(E=1e17, nu=NU)
ELS = [Element(0.1, 0.03, material=STEEL)] * 8
SUPPORTS = [
    Support(0, 1e7, 2e7, cxx=3e3, cyy=2e3, kxy=1e5, kyx=-2e5), Support(8, 2e7, cxx=2e3)
]  # fmt: skip
ROTOR = Rotor([Shaft(ELS)], [Disc(3, 8.0, 0.4, 0.2)], SUPPORTS)


def test_a_jeffcott_rotor():
    m, k, c, u = 20.0, 6e6, 2e3, 3e-4
    rotor = Rotor(
        [Shaft([Element(0.4, 0.1, material=RIGID)] * 2)], [Disc(1, m, 0.5, 0.4)],
        [Support(n, k / 2, cxx=c / 2) for n in (0, 2)],
    )  # fmt: skip
    W = np.linspace(0, 1500, 40)
    found = unbalance_response(rotor, W, {1: u})
    expected = u * W**2 / (k - m * W**2 + 1j * c * W)
    np.testing.assert_allclose(found.at(1)[:, 0], expected, rtol=1e-6, atol=1e-15)
    np.testing.assert_allclose(found.at(1)[:, 1], -1j * expected, rtol=1e-6, atol=1e-15)
    np.testing.assert_allclose(
        found.support_load(0)[:, 0], expected * (k + 1j * c * W) / 2, rtol=1e-6, atol=1e-9
    )
    orbit = found.orbit(1, 20)
    assert orbit.major == pytest.approx(abs(expected[20]), rel=1e-6)
    assert orbit.minor == pytest.approx(orbit.major, rel=1e-9)  # a circle, run forwards


def test_the_orbit_is_the_path_of_the_node():
    index = 30
    found = unbalance_response(ROTOR, np.linspace(50, 1500, 60), {2: 1e-4})
    orbit = found.orbit(5, index)
    t = np.linspace(0, 2 * np.pi, 7201)
    x, y = ((v * np.exp(1j * t)).real for v in (orbit.x, orbit.y))
    r = np.hypot(x, y)
    assert r.max() == pytest.approx(orbit.major, rel=1e-6)
    assert r.min() == pytest.approx(abs(orbit.minor), rel=1e-4)
    k = np.argmax(r)
    assert np.tan(orbit.inclination) == pytest.approx(y[k] / x[k], rel=1e-2)
    area = np.sum(x[:-1] * np.diff(y) - y[:-1] * np.diff(x)) / 2
    assert area == pytest.approx(np.pi * orbit.major * orbit.minor, rel=1e-4)
    assert found.major(5)[index] == pytest.approx(orbit.major, rel=1e-12)
    np.testing.assert_allclose(orbit.points(4)[0], [orbit.x.real, orbit.y.real])


def test_each_shaft_turns_its_own_unbalance():
    rotor = Rotor(
        [Shaft(ELS), Shaft([Element(0.1, 0.06, 0.045, STEEL)] * 4, ratio=-1.5, z=0.2)],
        [Disc(3, 8.0, 0.4, 0.2)], [*SUPPORTS, Support(9, 1e7, cxx=500.0)],
        [Link.bearing(6, 13, 5e6, cxx=300.0)],
    )  # fmt: skip
    found = unbalance_response(rotor, [300.0], {11: 1e-4})
    assert found.omega[0] == pytest.approx(450.0)
    # a force turning backwards: at positive 450 rad/s y leads x
    force = np.zeros(rotor.M.shape[0], complex)
    force[66], force[67] = 1e-4 * 450**2, 1j * 1e-4 * 450**2
    other = forced_response(rotor, [300.0], [450.0], force)
    np.testing.assert_allclose(found.q, other.q, rtol=1e-9, atol=1e-18)
    assert found.orbit(11).minor < 0
    np.testing.assert_allclose(
        found.link_load(0)[:, 0],
        (5e6 + 1j * 300 * 450) * (found.at(6)[:, 0] - found.at(13)[:, 0]), rtol=1e-9,
    )  # fmt: skip
    with pytest.raises(ValueError, match="different ratios"):
        unbalance_response(rotor, [300.0], {2: 1e-4, 11: 1e-4})


def test_supports_that_depend_on_the_speed_are_taken_at_each():
    def at(speed):
        return Support(0, 1e7 + 10 * speed**2, cxx=100.0 + speed)

    rotor = Rotor([Shaft(ELS)], [Disc(3, 8.0, 0.4, 0.2)], [SpeedSupport(0, at), Support(8, 2e7)])
    W = np.array([200.0, 700.0])
    found = unbalance_response(rotor, W, {2: 1e-4})
    for i, w in enumerate(W):
        frozen = Rotor(rotor.shafts, rotor.discs, [at(w), Support(8, 2e7)])
        own = unbalance_response(frozen, [w], {2: 1e-4})
        np.testing.assert_allclose(found.q[i], own.q[0], rtol=1e-10)
        np.testing.assert_allclose(found.support_load(0)[i], own.support_load(0)[0], rtol=1e-9)
