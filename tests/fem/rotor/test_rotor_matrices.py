"""Matrices of a rotor, and its messages: rigid motions, inertia, planes, exact end loads."""

import numpy as np
import pytest

from fem.rotor.campbell import campbell
from fem.rotor.critical import critical_speeds
from fem.rotor.damping import Modal, Rayleigh
from fem.rotor.model import STEEL, Disc, Element, Link, Material, Rotor, Shaft, Support
from fem.rotor.modes import modes
from fem.rotor.response import forced_response, unbalance_response

STEPPED = [Element(0.2, 0.05), Element(0.3, 0.08, 0.02), Element(0.1, 0.04)]
ROTOR = Rotor(
    [Shaft(STEPPED), Shaft([Element(0.25, 0.12, 0.1)] * 2, ratio=-1.5, z=0.05)],
    [Disc(1, 3.0, 0.02, 0.011), Disc.cylinder(5, 0.3, 0.12, 0.02, 7800.0)],
    [Support(0, 1e7, 2e7, kxy=3e5, cxx=100.0, cyy=300.0, k_tilt=50.0, kzz=1e6)],
    [Link.bearing(1, 4, 5e6, k_turn=10.0)],
)  # fmt: skip


def rigid(z):
    """Motions (6, n): along x, y, z and turns about x, y, z through the origin."""
    q = np.zeros((6, z.size, 6))
    for k in range(6):
        q[k, :, k] = 1
    q[3, :, 1], q[4, :, 0] = -z, z
    return q.reshape(6, -1)


@pytest.mark.parametrize(("theory", "rotary"), [("timoshenko", 1), ("rayleigh", 1), ("euler", 0)])
def test_mass_and_inertia_of_a_rigid_motion_are_those_of_the_body(theory, rotary):
    rotor = Rotor([Shaft(STEPPED)], [Disc(1, 3.0, 0.02, 0.011)], theory=theory, refine=2)
    q = rigid(rotor.system.z)
    assert abs(rotor.K @ q.T).max() < 1e-12 * abs(rotor.K).max()
    own = q @ rotor.M @ q.T
    mass, first, second, polar, left = 3.0, 3.0 * 0.2, 3.0 * 0.04, 0.02, 0.0
    for e in STEPPED:
        m = STEEL.rho * e.area * e.length
        mass += m
        first += m * (left + e.length / 2)
        second += m * (e.length**2 / 12 + (left + e.length / 2) ** 2)
        second += rotary * STEEL.rho * e.inertia * e.length
        polar += 2 * STEEL.rho * e.inertia * e.length
        left += e.length
    second += 0.011
    expected = np.diag([mass] * 3 + [second] * 2 + [polar])
    expected[0, 4] = expected[4, 0] = first
    expected[1, 3] = expected[3, 1] = -first
    np.testing.assert_allclose(own, expected, rtol=1e-12, atol=1e-12 * mass)


def test_gyroscopic_moment_is_the_polar_inertia_of_each_part_at_its_ratio():
    q = rigid(ROTOR.system.z)
    own = q @ ROTOR.G @ q.T
    polar = 0.02 + sum(2 * STEEL.rho * e.inertia * e.length for e in STEPPED)
    mass = 7800.0 * np.pi * (0.15**2 - 0.06**2) * 0.02
    disc = mass * (0.15**2 + 0.06**2) / 2
    assert ROTOR.discs[1].mass == pytest.approx(mass, rel=1e-12)
    assert ROTOR.discs[1].diametral == pytest.approx(disc / 2 + mass * 0.02**2 / 12, rel=1e-12)
    polar -= 1.5 * (disc + 2 * 2 * STEEL.rho * Element(0.25, 0.12, 0.1).inertia * 0.25)
    expected = np.zeros((6, 6))
    expected[3, 4], expected[4, 3] = polar, -polar
    np.testing.assert_allclose(own, expected, atol=1e-12)


def test_a_cantilever_bends_shears_stretches_and_twists_as_in_closed_form():
    element = Element(0.5, 0.1, 0.04, Material(E=70e9, nu=0.33, rho=2700.0), shear=0.8)
    rotor = Rotor([Shaft([element])], supports=[
        Support(0, 1e18, kzz=1e18, k_tilt=1e18, k_turn=1e18)
    ])  # fmt: skip
    L, E, G, A, inertia = 0.5, 70e9, 70e9 / 2.66, element.area, element.inertia
    u = np.linalg.solve(rotor.K, np.eye(12)[:, 6:])[6:]
    bend, shear = L**3 / (3 * E * inertia), L / (0.8 * G * A)
    np.testing.assert_allclose(u[[0, 1], [0, 1]], bend + shear, rtol=1e-9)
    np.testing.assert_allclose(u[2, 2], L / (E * A), rtol=1e-9)
    np.testing.assert_allclose(u[5, 5], L / (2 * G * inertia), rtol=1e-9)
    np.testing.assert_allclose(u[4, 0], L**2 / (2 * E * inertia), rtol=1e-9)
    np.testing.assert_allclose(u[3, 1], -(L**2) / (2 * E * inertia), rtol=1e-9)
    np.testing.assert_allclose(u[[3, 4], [3, 4]], L / (E * inertia), rtol=1e-9)


@pytest.mark.parametrize(
    ("nu", "solid", "thin"),
    # kappa of Cowper's and Hutchinson's coefficients: 6 (1+nu)^2/(7+12 nu+4 nu^2); thin tubes
    # (1+nu)/(2+nu)
    [(0.3, 6 * 1.69 / 10.96, 1.3 / 2.3), (0.0, 6 / 7, 0.5)],
)
def test_shear_coefficients_of_solid_and_thin_sections(nu, solid, thin):
    material = Material(E=1.0, nu=nu)
    assert Element(1, 1, material=material).kappa == pytest.approx(solid, rel=1e-12)
    assert Element(1, 1, 1 - 1e-7, material=material).kappa == pytest.approx(thin, rel=1e-6)


def test_a_link_acts_on_the_difference_alone():
    K = np.arange(36.0).reshape(6, 6)
    K = K + K.T
    bare = Rotor(ROTOR.shafts)
    linked = Rotor(ROTOR.shafts, links=[Link(2, 6, K)])
    own = linked.K - bare.K
    a, b = slice(12, 18), slice(36, 42)
    for rows, columns, sign in ((a, a, 1), (b, b, 1), (a, b, -1), (b, a, -1)):
        np.testing.assert_allclose(own[rows, columns], sign * K, atol=1e-5)
        own[rows, columns] = 0
    assert not own.any()


SHAFT = Shaft([Element(0.1, 0.03)] * 4)
HELD = [Support(0, 1e7), Support(4, 1e7)]
GOOD = Rotor([SHAFT], [Disc(2, 5.0, 0.1, 0.06)], HELD)
TWO = [SHAFT, Shaft([Element(0.1, 0.08, 0.06)] * 2, ratio=2.0)]


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Element(0.0, 0.03), "the length of a shaft element must be > 0"),
        (lambda: Element(0.1, 0.03, 0.03), "0 <= d_i < d_o, got d_i=0.03 m, d_o=0.03 m"),
        (lambda: Element(0.1, 0.03, shear=0.0), "shear coefficient must be positive"),
        (lambda: Material(E=-1.0), "Young's modulus must be positive and"),
        (lambda: Material(E=1.0, nu=0.6), "Poisson's ratio"),
        (lambda: Material(E=1.0, rho=-1.0), "density must not be negative, got rho=-1"),
        (lambda: Shaft([]), "at least one element"),
        (lambda: Shaft(SHAFT.elements, ratio=float("inf")),
         "ratio and z of a shaft must be finite"),
        (lambda: Disc(0, -1.0), "a disc's mass must not be negative, got -1 kg"),
        (lambda: Support(0, -1e6), "a support's kxx must not be negative, got -1e\\+06"),
        (lambda: Support(0, 1e6, kxy=float("nan")), "finite"),
        (lambda: Link(1, 1, np.eye(6)), "a link must join two different nodes, got"),
        (lambda: Link(0, 1, np.eye(5)), r"\(6, 6\)"),
        (lambda: Link(0, 1, -np.eye(6)), "the diagonal of a link's K must be >= 0"),
        (lambda: Rotor([]), "at least one shaft"),
        (lambda: Rotor([SHAFT], theory="vlasov"), "timoshenko, rayleigh, euler, got 'vlasov'"),
        (lambda: Rotor([SHAFT], refine=0), "refine must be a whole number >= 1"),
        (lambda: Rotor([SHAFT], [Disc(5, 1.0)]), "the node of a disc must exist, got node 5"),
        (lambda: Rotor([SHAFT], links=[Link(0, 9, np.eye(6))]), "node of a link must exist, got"),
        (lambda: Rotor([SHAFT], [Disc(1, 1, width=0.12), Disc(2, 1, width=0.1)]),
         r"discs at nodes 1 and 2 overlap by 0.01 m"),
        (lambda: Rayleigh(-1.0, 0.0), "alpha and beta must not be negative, got"),
        (lambda: Rayleigh.at((100.0, 0.01), (100.0, 0.02)), "two different frequencies"),
        (lambda: Modal([]), "damping ratios"),
        (lambda: modes(GOOD, count=0), "count, the number of modes, must be an"),
        (lambda: modes(GOOD, plane="up"), "plane must be one of bending, torsion"),
        (lambda: modes(GOOD, float("nan")), "finite numbers in rad/s"),
        (lambda: campbell(GOOD, [0.0, 2.0, 1.0]), "must increase"),
        (lambda: critical_speeds(GOOD, whirl="up"), "forward, backward, both, got 'up'"),
        (lambda: critical_speeds(GOOD, excitation=0.0), "excitation must be a finite ratio other"),
        (lambda: critical_speeds(Rotor([SHAFT])), "can move rigidly across its axis"),
        (lambda: critical_speeds(Rotor(TWO, supports=HELD)), "can move rigidly across its axis"),
        (lambda: unbalance_response(GOOD, [1.0], {}),
         "an unbalance response requires at least one"),
        (lambda: unbalance_response(GOOD, [1.0], {7: 1e-4}),
         "the node of an unbalance must exist, got"),
        (lambda: unbalance_response(GOOD, [1.0], {2: float("nan")}),
         "unbalance at node 2 must be finite"),
        (lambda: unbalance_response(Rotor([SHAFT]), [1.0], {2: 1e-4}),
         "can move rigidly across its axis"),
        (lambda: forced_response(GOOD, 1.0, 1.0, np.ones(3)),
         "forces must have 30 values, one per unknown, got 3"),
        (lambda: unbalance_response(GOOD, [1.0], {2: 1e-4}).at(5),
         "node 5 does not exist: numbers"),
        (lambda: unbalance_response(GOOD, [1.0], {2: 1e-4}).support_load(2),
         "support 2 does not exist: numbers are 0 to 1"),
    ],
)  # fmt: skip
def test_one_line_states_what_is_wrong(make, message):
    with pytest.raises(ValueError, match=message) as caught:
        make()
    assert "\n" not in str(caught.value)


def test_a_static_torque_on_a_rotor_that_may_turn_has_no_bounded_answer():
    torque = np.zeros(12)
    torque[5] = 10.0
    rotor = Rotor([Shaft([Element(0.5, 0.02)])], supports=[Support(0, 1e6), Support(1, 1e6)])
    with pytest.raises(ArithmeticError, match="no bounded response"):
        forced_response(rotor, 100.0, 0.0, torque)
    light = Element(0.5, 0.02, material=Material(E=210e9, nu=0.3))
    with pytest.raises(ArithmeticError, match="without mass are left free"):
        modes(Rotor([Shaft([light])], [Disc(0, 1.0, 0.1, 0.1)]), 10.0)
