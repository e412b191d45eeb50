"""Cantilevers at large displacement beside closed forms and Reissner's equations."""

from math import pi

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from scipy.optimize import root
from scipy.special import ellipj, ellipk

from fem.beam.large import LargeFrame
from fem.beam.section import Section

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


def reissner(moment, force, section):
    """Tip (x, y, rotation) and its moment, by Reissner's equations from the clamp's moment on."""

    def rate(_, state):
        c, s = np.cos(state[2]), np.sin(state[2])
        N, V = force[0] * c + force[1] * s, -force[0] * s + force[1] * c
        e, g = 1 + N / section.EA, V / section.GA
        dx, dy = e * c - g * s, e * s + g * c
        return [dx, dy, state[3] / section.EI, dy * force[0] - dx * force[1]]

    start = [0.0, 0.0, 0.0, float(np.squeeze(moment))]
    return solve_ivp(rate, (0, 1), start, method="DOP853", rtol=1e-11, atol=1e-12).y[:, -1]


@pytest.mark.parametrize(("nodes", "order"), [(2, 2), (3, 4)])
def test_a_thick_strip_converges_to_reissners_equations(nodes, order):
    F = np.array([-3.0, 5.0])
    M = root(lambda m: reissner(m, F, THICK)[3], [4.0], tol=1e-12).x[0]
    errors = []
    for count in (8, 16, 32):
        frame = strip(count, nodes, THICK)
        path = frame.under_loads({len(frame.points) - 1: (*F, 0)}, [0.5, 1.0])
        errors.append(np.linalg.norm(tip(path)[-1] - reissner(M, F, THICK)[:3]))
    assert np.log2(np.divide(errors[:-1], errors[1:])) == pytest.approx(order, abs=0.1)
    assert errors[-1] < {2: 2e-3, 3: 2e-6}[nodes]
    np.testing.assert_allclose(path.reactions[-1, 0], [*-F, -M], rtol={2: 1e-3, 3: 1e-6}[nodes])
