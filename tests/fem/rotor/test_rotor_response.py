"""Unbalance response: the Jeffcott rotor, orbits, loads, two speeds, and many speeds at once."""

import numpy as np
import pytest

from fem.rotor import response
from fem.rotor.critical import critical_speeds
from fem.rotor.damping import Rayleigh
from fem.rotor.many_speeds import Diagonal
from fem.rotor.model import Disc, Element, Link, Material, Rotor, Shaft, SpeedSupport, Support
from fem.rotor.response import forced_response, unbalance_response
from tests.fem.rotor.rotor_ross import ours

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


def test_each_shaft_turns_its_unbalance():
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
    with pytest.raises(ValueError, match="all unbalances of a response must be on"):
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


UNBALANCES = {3: 1.4e-5, 18: 1e-5j}
SPEEDS = np.linspace(-3000, 4000, 2 * response.MANY)


def whole(rotor, speeds):
    return response.unbalance_response(rotor, speeds, UNBALANCES).q


def one_by_one(rotor, speeds):
    parts = np.array_split(speeds, 1 + speeds.size // (response.MANY // 2))
    return np.concatenate([whole(rotor, part) for part in parts])


AGREE = 1e-9  # of the motion at its speed


@pytest.mark.parametrize(("unlike", "damped"), [(True, True), (False, False)])
def test_many_speeds_agree_with_few(unlike, damped):
    rotor = ours([0.88] * 20, unlike=unlike, damped=damped)
    assert any(Diagonal.of(block, SPEEDS, SPEEDS) for block in rotor.blocks)
    each, together = one_by_one(rotor, SPEEDS), whole(rotor, SPEEDS)
    missed = np.linalg.norm(together - each, axis=1)
    assert np.all(missed <= AGREE * np.linalg.norm(each, axis=1))
    assert np.any(missed > 0)  # not the same computation


def test_at_an_undamped_resonance_the_direct_solution_decides():
    rotor = ours([0.88] * 20, damped=False)
    near = critical_speeds(rotor, 1).speeds * (1 + np.linspace(-1e-9, 1e-9, response.MANY))
    (modes,) = (Diagonal.of(b, near, near) for b in rotor.blocks if b.sense == 1)
    force = np.ones((near.size, modes.mu.size), complex)
    assert not np.any(modes.solve(near, force)[1])
    # of two speeds, one of them far from the modes, only that one is solved
    two = np.array([near[0], 0.5 * near[0]])
    assert modes.solve(two, force[:2])[1].tolist() == [False, True]
    assert np.array_equal(whole(rotor, near), one_by_one(rotor, near))


def shaft(*, damping=None, **more):
    """A shaft on two supports, the first with more."""
    supports = [Support(0, 1e7, cxx=3e3, **more), Support(8, 2e7)]
    return Rotor(
        [Shaft([Element(0.1, 0.03, material=STEEL)] * 8)], [Disc(3, 8.0, 0.4, 0.2)], supports,
        damping=damping,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("rotor", "omega"),
    [
        (shaft(damping=Rayleigh(3.0, 1e-6)), SPEEDS),  # damped everywhere
        (shaft(kxy=1e5, kyx=-2e5), SPEEDS),  # a stiffness that is not symmetric
        (shaft(), 900.0 + 0 * SPEEDS),  # forces that do not turn with the shaft
    ],
)
def test_other_problems_are_left_to_direct_solutions(rotor, omega):
    bending = [block for block in rotor.blocks if "bending" in block.planes]
    assert all(Diagonal.of(block, SPEEDS, omega) is None for block in bending)
