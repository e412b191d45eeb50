"""Large displacements against closed forms; properties to round-off and by order."""

from math import pi

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from scipy.optimize import root
from scipy.special import ellipj, ellipk

from fem.beam.curved import solve_curved_frame
from fem.beam.large import LargeFrame
from fem.beam.large_balance import Balance
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


def test_a_follower_force_bends_as_by_jacobis_functions():
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


SECTION = Section(EA=300.0, EI=20.0, GA=100.0)
R, COUNT = 1.5, 12


def hook(nodes=3):
    """A quarter arc and a straight leg, built in at its start; the tip is the last node."""
    phi = np.linspace(0, pi / 2, (nodes - 1) * COUNT + 1)
    arc = R * np.column_stack([np.sin(phi), 1 - np.cos(phi)])
    leg = np.linspace(0, 1, (nodes - 1) * COUNT + 1)[1:, None] * [0.3, 1.0] + arc[-1]
    k = (nodes - 1) * np.arange(2 * COUNT)
    columns = (k, k + 1) if nodes == 2 else (k, k + 2, k + 1)
    return LargeFrame(
        np.vstack([arc, leg]), np.column_stack(columns), sections=SECTION, supports={0: "xyr"}
    )


TIP = 4 * COUNT
LOAD = (3.0, -5.0, 1.0)


def test_at_rest_the_tangent_is_that_of_the_linear_curved_beam():
    frame = hook()
    small = frame.under_loads({TIP: LOAD}, [1e-7]).last
    linear = solve_curved_frame(
        frame.points, frame.elements.nodes, sections=SECTION, supports={0: "xyr"},
        loads={TIP: LOAD},
    )  # fmt: skip
    np.testing.assert_allclose(small.u * 1e7, linear.u, rtol=1e-6, atol=1e-6)
    stations, forces = frame.section_forces(small)
    np.testing.assert_allclose(stations, linear.stations, atol=1e-12)
    np.testing.assert_allclose(forces * 1e7, linear.section_forces, atol=1e-5)


@pytest.mark.parametrize("nodes", [2, 3])
def test_force_and_tangent_are_derivatives_of_the_energy(nodes):
    frame, rng = hook(nodes), np.random.default_rng(3)
    e = frame.elements
    u, step = rng.normal(size=(2, len(frame.points), 3))
    u = (0.3 * u).astype(np.longdouble)

    def look(u):
        strain, _, t = e.strains(u)
        S, stress = e.increments(strain, t), e.moduli * strain
        energy = ((stress * strain).sum(axis=-1) * e.weight).sum() / 2
        change = e.change_of_forces(S, strain, t, stress, step.astype(np.longdouble))
        return energy, e.forces(S, stress)[0], e.tangent_stiffness(S, strain, t, stress), change

    _, f, K, change = look(u)
    h = 1e-5
    ahead, behind = look(u + h * step), look(u - h * step)
    assert (ahead[0] - behind[0]) / (2 * h) == pytest.approx(f @ step.ravel(), rel=1e-7)
    slope = (ahead[1] - behind[1]) / (2 * h)
    np.testing.assert_allclose(slope, K @ step.ravel(), atol=1e-7 * abs(slope).max())
    assert abs(K - K.T).max() < 1e-12 * abs(K).max()
    np.testing.assert_allclose(change, K @ step.ravel(), atol=1e-12 * abs(slope).max())


def test_newtons_method_converges_quadratically():
    path = hook().under_loads({TIP: LOAD}, [1.0], follower={TIP: (1.0, -4.0)})
    (history,) = path.residuals
    e = -np.log10([r for r in history if 1e-13 < r < 1e-1])
    assert len(e) >= 2, history
    assert e[-1] > 1.7 * e[-2], history
    assert len(history) <= 8


def test_work_becomes_strain_energy():
    path = hook().under_loads({TIP: LOAD}, np.linspace(0, 1, 101)[1:])
    np.testing.assert_allclose(path.work, path.strain_energy, atol=1e-8 * path.work[-1])
    moved = hook().displaced({TIP: {"x": -0.5, "r": 0.7}}, np.linspace(0, 1, 61)[1:])
    assert moved.work[-1] == pytest.approx(moved.strain_energy[-1], rel=1e-8)
    arc = hook().along_arc({TIP: LOAD}, first=0.02, steps=60, largest=0.02)
    assert arc.work[-1] == pytest.approx(arc.strain_energy[-1], rel=1e-6)


def test_reactions_balance_loads_and_prescribed_movement_returns_them():
    frame = hook()
    loaded = frame.under_loads({TIP: LOAD, 0: (1.0, 2.0, 0.5)}, [1.0]).last
    assert abs(loaded.reactions[1:]).max() == 0
    arm = (frame.points + loaded.u[:, :2])[TIP] - frame.points[0]
    couple = LOAD[2] + arm[0] * LOAD[1] - arm[1] * LOAD[0]
    total = [LOAD[0] + 1.0, LOAD[1] + 2.0, couple + 0.5]
    np.testing.assert_allclose(-loaded.reactions[0], total, atol=1e-9)
    x, y, r = loaded.u[TIP]
    moved = frame.displaced({TIP: {"x": x, "y": y, "r": r}}, [0.5, 1.0]).last
    np.testing.assert_allclose(moved.reactions[TIP], LOAD, atol=1e-8)
    np.testing.assert_allclose(moved.u, loaded.u, atol=1e-10)


def test_movement_along_an_arc_passes_the_states_of_given_movement():
    frame, moved = hook(), {TIP: {"x": -0.5, "y": 0.4}}
    path = frame.along_arc({2 * COUNT: (0, 0.5, 0)}, first=0.1, steps=6, moved=moved)
    last = path.last
    given = frame.displaced(moved, [last.factor / 2, last.factor]).last
    given = frame.under_loads({2 * COUNT: (0, 0.5, 0)}, [last.factor], since=given).last
    np.testing.assert_allclose(last.u[TIP, :2], np.array([-0.5, 0.4]) * last.factor, atol=1e-12)
    np.testing.assert_allclose(last.u, given.u, atol=1e-9)
    np.testing.assert_allclose(last.reactions, given.reactions, atol=1e-7)


@pytest.mark.parametrize("unit", [1.0, 1e3])
def test_a_couple_counts_as_the_pair_of_forces_across_the_frame(unit):
    # across 5: a couple of 10 is as large as a force of 2, in any unit of length
    points = np.array([[0.0, 0.0], [3.0, 4.0]]) * unit
    balance = Balance(points, None, (), None, None, None)
    f = np.array([[0.0, 0.0, 10.0 * unit], [1.0, -2.0, 0.0]])
    assert balance.measure(f) == pytest.approx(np.sqrt(1 + 4 + 4), rel=1e-14)
