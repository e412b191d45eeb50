"""Free vibration against closed forms: rigid rotors, shafts by three theories, torsion."""

import numpy as np
import pytest
from scipy.optimize import brentq

from fem.rotor.branches import whirl_sense
from fem.rotor.damping import Modal, Rayleigh
from fem.rotor.model import Disc, Element, Material, Rotor, Shaft, Support
from fem.rotor.modes import modes

E, NU, RHO = 210e9, 0.3, 7850.0
STEEL = Material(E=E, nu=NU, rho=RHO)
LIGHT = Material(E=E, nu=NU)
RIGID = Material(E=1e17, nu=NU)


def section(d):
    return np.pi * d**2 / 4, np.pi * d**4 / 64


def hinged(n, theory, d=0.03):
    """Of length 1."""
    shaft = Shaft([Element(1 / n, d, material=STEEL)] * n)
    return Rotor([shaft], supports=[Support(0, 1e15), Support(n, 1e15)], theory=theory)


def shaft_frequencies(j, W, theory, d=0.03):
    """Backward and forward frequency of mode j, from the differential equation of each theory."""
    A, inertia = section(d)
    k = j * np.pi
    turn = 0 if theory == "euler" else RHO * inertia
    kappa = 6 * (1 + NU) ** 2 / (7 + 12 * NU + 4 * NU**2)
    S = kappa * A * E / (2 * (1 + NU)) if theory == "timoshenko" else np.inf

    def balance(w):
        """S (k u - phi) k = rho A w^2 u, and the moments about phi, with u = 1."""
        across = RHO * A * w**2
        phi = k - across / (S * k)  # from the forces
        return E * inertia * k**2 * phi - turn * (w**2 - 2 * W * w) * phi - across / k

    guess = k**2 * np.sqrt(E * inertia / (RHO * A))
    return [abs(brentq(balance, s * guess * 0.5, s * guess * 1.1, xtol=1e-10)) for s in (-1, 1)]


@pytest.mark.parametrize(
    ("theory", "W"), [("euler", 0.0), ("rayleigh", 700.0), ("timoshenko", 700.0)]
)
def test_a_hinged_shaft_whirls_as_in_theory(theory, W):
    found = modes(hinged(40, theory), W, 6)
    for j in (1, 2, 3):
        back, forth = shaft_frequencies(j, W, theory)
        np.testing.assert_allclose(
            found.frequencies[2 * j - 2 : 2 * j], sorted([back, forth]), rtol=3e-5 * j**2
        )
    if W:
        np.testing.assert_array_equal(found.whirl, [-1, 1] * 3)
    exact = shaft_frequencies(1, W, theory, 0.2)[1]
    errors = [max(modes(hinged(n, theory, 0.2), W, 2).frequencies) for n in (4, 8)]
    order = np.log2((errors[0] / exact - 1) / (errors[1] / exact - 1))
    assert order == pytest.approx(2 if theory == "timoshenko" else 4, abs=0.25)


def test_a_rigid_rotor_on_two_springs():
    """Translation and tilt coupled: m u'' + ..., four frequencies of a 2 x 2 pencil."""
    m, Ip, Id, a, b, k_1, k_2, W = 20.0, 0.5, 0.8, 0.3, 0.5, 3e6, 5e6, 400.0
    rotor = Rotor(
        [Shaft([Element(a, 0.1, material=RIGID), Element(b, 0.1, material=RIGID)])],
        [Disc(1, m, Ip, Id)], [Support(0, k_1), Support(2, k_2)],
    )  # fmt: skip
    K = np.array([[k_1 + k_2, k_2 * b - k_1 * a], [k_2 * b - k_1 * a, k_1 * a**2 + k_2 * b**2]])
    M, G = np.diag([m, Id]), np.diag([0, Ip])
    # w^2 M - w W G - K = 0
    state = np.block([[np.zeros((2, 2)), np.eye(2)],
                      [np.linalg.solve(M, K), np.linalg.solve(M, W * G)]])  # fmt: skip
    w = np.linalg.eigvals(state).real
    found = modes(rotor, W, 4)
    np.testing.assert_allclose(found.frequencies, sorted(abs(w)), rtol=1e-6)
    order = np.argsort(abs(w))
    np.testing.assert_array_equal(found.whirl, np.sign(w[order]))


def test_torsion_of_two_discs_and_of_a_free_bar():
    L, d = 0.8, 0.03
    _, inertia = section(d)
    G = E / (2 * (1 + NU))
    rotor = Rotor([Shaft([Element(L, d, material=LIGHT)])], [Disc(0, 1, 0.2), Disc(1, 1, 0.3)])
    w = modes(rotor, 100.0, 2, "torsion").frequencies
    assert w[0] == pytest.approx(0, abs=1e-4 * w[1])
    assert w[1] == pytest.approx(np.sqrt(G * 2 * inertia / L * (1 / 0.2 + 1 / 0.3)), rel=1e-9)
    bar = Rotor([Shaft([Element(L / 40, d, material=STEEL)] * 40)])
    np.testing.assert_allclose(
        modes(bar, 0.0, 3, "torsion").frequencies[1:],
        np.pi * np.array([1, 2]) * np.sqrt(G / RHO) / L, rtol=2e-3,
    )  # fmt: skip
    np.testing.assert_allclose(
        modes(bar, 0.0, 2, "axial").frequencies[1], np.pi * np.sqrt(E / RHO) / L, rtol=5e-4
    )


def test_damped_modes_are_those_of_the_state_matrix():
    els = [Element(0.1, 0.03, material=STEEL)] * 5
    rotor = Rotor(
        [Shaft(els)], [Disc(2, 5.0, 0.4, 0.2)],
        [Support(0, 1e7, 3e7, kxy=2e6, kyx=-1e6, cxx=2e3, cyy=1e3, cxy=200.0), Support(5, 2e7)],
    )  # fmt: skip
    found = modes(rotor, 400.0, 6)
    at = [i for i in range(36) if i % 6 in (0, 1, 3, 4)]
    M, K, C, G = (A[np.ix_(at, at)] for A in (rotor.M, rotor.K, rotor.C, rotor.G))
    S = np.block([[np.zeros_like(M), np.eye(24)],
                  [-np.linalg.solve(M, K), -np.linalg.solve(M, C + 400.0 * G)]])  # fmt: skip
    values = np.linalg.eigvals(S)
    values = values[values.imag > 1][np.argsort(values[values.imag > 1].imag)][:6]
    np.testing.assert_allclose(found.eigenvalues, values, rtol=1e-7)
    for value, shape in zip(found.eigenvalues, found.shapes, strict=True):
        v = shape[:, [0, 1, 3, 4]].reshape(-1)
        force = (value**2 * M + value * (C + 400.0 * G) + K) @ v
        assert abs(force).max() < 1e-8 * abs(K @ v).max()


def test_modal_and_rayleigh_damping_give_the_specified_ratios():
    els = [Element(0.1, 0.03, material=STEEL)] * 6
    parts = {"supports": [Support(n, 1e7, kzz=1e7, k_turn=1e4) for n in (0, 6)]}
    bare = modes(Rotor([Shaft(els)], **parts), 0.0, 10, "all")
    modal = modes(Rotor([Shaft(els)], damping=Modal([0.01, 0.01, 0.03]), **parts), 0.0, 10, "all")
    np.testing.assert_allclose(np.sort(modal.damping), [0.01] * 2 + [0.03] * 8, rtol=1e-6)
    w = bare.frequencies
    rayleigh = Rotor([Shaft(els)], damping=Rayleigh.at((w[0], 0.02), (w[4], 0.05)), **parts)
    found = modes(rayleigh, 0.0, 6, "all").damping
    assert found[[0, 4]] == pytest.approx([0.02, 0.05], rel=1e-6)


def test_round_off_of_a_part_at_rest_does_not_decide_the_whirl_of_a_shaft():
    noise = np.random.default_rng(1).standard_normal((2, 8, 2)) * 1e-17
    tilts, turns = np.zeros((2, 8, 12), complex)
    tilts[:, [3, 9]], tilts[:, [4, 10]] = 1, -1j  # every place forward, the axis stays where it is
    turns[:, 5] = 1
    for shapes, sense in ((tilts, 1), (turns, 0)):
        shapes[:, :2] = noise[0] + 1j * noise[1]
        assert whirl_sense(shapes).tolist() == [sense] * 8
