"""Cantilevers at large displacement beside elliptic integrals and Reissner's equations."""

from math import pi

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import ellipj, ellipk

from fem.beam.large import LargeFrame
from fem.beam.section import Section
from tests.fem.beam.large_reference import cantilever, integrate, shoot

THIN = Section(EA=1e8, EI=1.0, GA=4e7)  # as of a strip 1/3000 of its length thick
THICK = Section(EA=80.0, EI=1.0, GA=30.0)


def strip(count, nodes=3, section=THIN):
    """A straight cantilever of length 1 along x; its tip is the last node."""
    k = (nodes - 1) * np.arange(count)
    columns = (k, k + 1) if nodes == 2 else (k, k + 2, k + 1)
    x = np.linspace(0, 1, (nodes - 1) * count + 1)
    return LargeFrame(
        np.column_stack([x, 0 * x]), np.column_stack(columns), sections=section, supports={0: "xyr"}
    )


def tip(path):
    """Position and rotation of the last node (k, 3), of a strip of length 1."""
    return path.u[:, -1] + [1, 0, 0]


@pytest.mark.parametrize("degrees", [30, 175])
def test_a_thin_strip_follows_the_elastica(degrees):
    angle = np.radians(degrees)
    forces = [1.0, 4.0, 10.0]
    force = (np.cos(angle), np.sin(angle), 0.0)
    path = strip(40).under_loads({80: force}, forces)
    expected = np.array([cantilever(F, angle) for F in forces])
    np.testing.assert_allclose(tip(path), expected, atol=2e-6)


def test_an_end_couple_rolls_a_strip_up_twice():
    """A couple alone bends without stretch or shear, so the circle is exact for any section."""
    section, turns = THICK, np.array([0.25, 0.5, 1.0, 2.0])
    path = strip(40, section=section).under_loads({80: (0, 0, 2 * pi)}, turns)
    angle = 2 * pi * turns
    circle = np.column_stack([np.sin(angle) / angle, (1 - np.cos(angle)) / angle, angle])
    np.testing.assert_allclose(tip(path), circle, atol=2e-5)
    np.testing.assert_allclose(path.strain_energy, angle**2 / 2, rtol=1e-10)
    _, forces = strip(40, section=section).section_forces(path.last)
    np.testing.assert_allclose(forces[..., 2], 4 * pi, rtol=1e-9)
    np.testing.assert_allclose(forces[..., :2], 0, atol=1e-7)


def test_a_follower_force_bends_as_jacobis_functions_say():
    """Seen from the tip the force is dead: psi'' = a^2 cos psi, psi = psi' = 0 at the tip.

    With psi = pi/2 - eta a pendulum of 90 deg: sin(eta / 2) = cd(a s) / sqrt 2. At
    a = 2 K(1/sqrt 2) the strip has turned back on itself.
    """
    force = 4 * ellipk(0.5) ** 2
    a = np.sqrt(force)

    def turned(s):
        sn, cn, dn, _ = ellipj(a * s, 0.5)
        del sn
        return pi / 2 - 2 * np.arcsin(np.clip(cn / dn / np.sqrt(2), -1, 1))

    whole = turned(1.0)
    x = quad(lambda s: np.cos(whole - turned(s)), 0, 1, epsabs=1e-12)[0]
    y = quad(lambda s: np.sin(whole - turned(s)), 0, 1, epsabs=1e-12)[0]
    path = strip(60).under_loads({}, np.linspace(0.1, 1, 10) * force, follower={120: (0, 1)})
    np.testing.assert_allclose(tip(path)[-1], [x, y, whole], atol=1e-5)


def test_a_thick_strip_follows_reissners_equations():
    section, F = THICK, np.array([-3.0, 5.0])

    def end(unknown):
        state, _, _ = integrate([(1.0, lambda s: 0.0)], [0, 0, 0, *unknown], F, [], section)
        return state

    M = shoot(lambda m: end(m)[3:], [4.0])
    path = strip(40, section=section).under_loads({80: (*F, 0)}, [0.5, 1.0])
    np.testing.assert_allclose(tip(path)[-1], end(M)[:3], rtol=3e-7)
    np.testing.assert_allclose(path.reactions[-1, 0], [*-F, -M[0]], rtol=1e-7)


@pytest.mark.parametrize(("nodes", "order"), [(2, 2), (3, 4)])
def test_the_order_of_convergence(nodes, order):
    errors = []
    section = Section(EA=1e4, EI=1.0, GA=4e3)
    counts = np.array([8, 16, 32])
    M = shoot(lambda m: _cantilever_end(m, section)[3:], [4.0])
    exact = _cantilever_end(M, section)[:3]
    for count in counts:
        frame = strip(count, nodes, section)
        last = len(frame.points) - 1
        errors.append(np.linalg.norm(tip(frame.under_loads({last: (0, 8.0, 0)}, [1]))[0] - exact))
    observed = -np.diff(np.log(errors)) / np.diff(np.log(counts))
    assert observed == pytest.approx([order, order], abs=0.1)


def _cantilever_end(unknown, section):
    return integrate([(1.0, lambda s: 0.0)], [0, 0, 0, *unknown], (0, 8.0), [], section)[0]
