"""Exact solutions of harmonics on any mesh, and rings under pressure waves by Michell."""

import numpy as np
import pytest
from skfem import MeshQuad1

from fem.fourier.solid import FourierSolid
from fem.fourier.solution import FourierSolution
from fem.plane.material import Elastic
from tests.fem.plane.models import tube

E, NU = 210.0, 0.3
G = E / (2 * (1 + NU))
STEEL = Elastic(E=E, nu=NU)
ROUND_OFF = 1e-11
every_body = pytest.mark.parametrize(  # solid and hollow
    ("kind", "bore"),
    [("tri6, straight", 0.0), ("tri6", 0.5), ("quad9, straight", 0.5), ("quad9", 0.0)],
)
PLACES = np.array([[0.7, 1.1, 1.9, 2.0], [0.2, 0.9, 0.5, 0.0]])
ANGLES = np.array([0.3, 1.7, 4.0, 5.5])


def walls(bore, tractions):
    """`tractions` (rim, bottom, top), the bore's opposite to the rim's."""
    rim, bottom, top = tractions
    minus = tuple(-t for t in rim)
    return {"rim": rim, "bottom": bottom, "top": top} | ({"bore": minus} if bore else {})


def cartesian(u, angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([u[0] * c - u[1] * s, u[0] * s + u[1] * c, u[2]])


@every_body
def test_a_pull_along_x_is_exact(kind, bore):
    # sigma_xx = 1: t_r = cos^2 t = (1 + cos 2t)/2, t_t = -sin t cos t = -sin(2t)/2 on the rim
    none = (0.0, 0.0, 0.0)
    uniform = FourierSolid(tube(kind, bore), STEEL, {"bottom": "z"}, degree=2).harmonic(0)
    double = FourierSolid(tube(kind, bore), STEEL, degree=2).harmonic(2)
    whole = FourierSolution((
        uniform.solve(walls(bore, ((0.5, 0.0, 0.0), none, none))),
        double.solve(walls(bore, ((0.5, -0.5, 0.0), none, none))),
    ))  # fmt: skip
    u, sigma = whole.at(PLACES, ANGLES)
    r, z = PLACES
    c, s = np.cos(ANGLES), np.sin(ANGLES)
    expected = np.array([r * c, -NU * r * s, -NU * z]) / E
    np.testing.assert_allclose(cartesian(u, ANGLES), expected, atol=ROUND_OFF * 2 / E)
    stress = np.array([c * c, s * s, 0 * c, -s * c, 0 * c, 0 * c])
    np.testing.assert_allclose(sigma, stress, atol=ROUND_OFF)
    volume = np.pi * (4 - bore**2)
    assert whole.strain_energy == pytest.approx(volume / (2 * E), rel=ROUND_OFF)


@every_body
def test_a_shear_in_x_and_z_is_exact(kind, bore):
    # sigma_xz = 1: t_z = cos t on the rim, t_x = 1 on the top; held at the bottom against n = 1
    solid = FourierSolid(tube(kind, bore), STEEL, {"bottom": "rtz"}, degree=2)
    solution = solid.harmonic(1).solve({
        "rim": (0.0, 0.0, 1.0), "top": (1.0, -1.0, 0.0),
        **({"bore": (0.0, 0.0, -1.0)} if bore else {}),
    })  # fmt: skip
    u, sigma = FourierSolution((solution,)).at(PLACES, ANGLES)
    z, none = PLACES[1], np.zeros(4)
    np.testing.assert_allclose(cartesian(u, ANGLES), [z / G, none, none], atol=ROUND_OFF / G)
    c, s = np.cos(ANGLES), np.sin(ANGLES)
    np.testing.assert_allclose(sigma, [none, none, none, none, -s, c], atol=ROUND_OFF)
    area = np.pi * (4 - bore**2)
    assert solution.strain_energy == pytest.approx(solution.work / 2, rel=1e-9)
    force, moment = solution.reaction("bottom")
    assert force == pytest.approx(-area, rel=1e-9)
    assert moment == pytest.approx(0.0, abs=1e-9 * area)


@pytest.mark.parametrize(("bore", "n"), [(0.0, 1), (0.5, 3)])
def test_antisymmetric_harmonics_are_symmetric_ones_turned(bore, n):
    # cos n(t - pi/2n) = sin n t: what was along r and z at an angle is there a quarter wave on
    solid = FourierSolid(tube("quad9", bore), STEEL, {"bottom": "rtz"}, degree=2)
    load = {"rim": lambda x: np.array([1 + x[1], 0.3 + 0 * x[0], x[1] ** 2])}
    turned = {"rim": lambda x: np.array([1 + x[1], -0.3 + 0 * x[0], x[1] ** 2])}
    even = solid.solve({n: load})
    odd = FourierSolution((solid.harmonic(n, antisymmetric=True).solve(turned),))
    for a, b in zip(even.at(PLACES, ANGLES), odd.at(PLACES, ANGLES + np.pi / 2 / n), strict=True):
        np.testing.assert_allclose(a, b, atol=1e-10 * abs(a).max())
    assert odd.strain_energy == pytest.approx(even.strain_energy, rel=1e-10)


R_I, R_O = 0.6, 1.0


def ring(r_i, r_o, n, cells=12):
    """Radial cells shrink towards both circles as the solution does, r^n and r^-n."""
    c = np.log1p(n / 2)
    t = np.linspace(-1 if r_i else 0, 1, cells + 1)
    part = 1 - np.expm1(c * (1 - abs(t))) / np.expm1(c)
    r = (r_i + r_o) / 2 + (r_o - r_i) / 2 * np.sign(t) * part if r_i else r_o * part
    return MeshQuad1.init_tensor(r, np.array([0.0, 0.3])).with_boundaries({
        "bore": lambda x: x[0] == r[0], "rim": lambda x: x[0] == r[-1],
        "start": lambda x: x[1] == 0, "end": lambda x: x[1] == 0.3,
    })  # fmt: skip


def michell(n, r_i, r_o, p):
    """(u_r, u_t) on r_o for sigma_rr = -p cos n t there, both circles free of shear.

    Stress function (a r^n + b r^(n+2) + c r^-n + d r^(2-n)) cos n t, plane strain; displacements
    from 2 mu u_r = -F' + (3 - 4 nu ...) of the harmonic part (Timoshenko & Goodier, art. 42).
    """
    powers = [n, n + 2] + ([-n, 2 - n] if r_i else [])

    def srr(k, r):  # F'/r - n^2 F / r^2
        return (k - n**2) * r ** (k - 2.0)

    def srt(k, r):  # (n F / r)' / 1
        return n * (k - 1) * r ** (k - 2.0)

    def u(k):  # from e_rr and e_tt of plane strain, integrated
        def lap(r):
            return (k**2 - n**2) * r ** (k - 2.0)

        def att(r):
            return k * (k - 1) * r ** (k - 2.0)

        def u_r(r):  # e_rr = ((1-nu) srr - nu stt)/(2 mu) integrates as r^(k-1)
            return ((1 - NU) * srr(k, r) - NU * att(r)) / (2 * G) * r / (k - 1)

        def u_t(r):  # e_tt = (u_r + n u_t)/r
            hoop = ((1 - NU) * att(r) - NU * srr(k, r)) / (2 * G)
            return (hoop * r - u_r(r)) / n

        return u_r, u_t

    circles = [r_o] + ([r_i] if r_i else [])
    rows = [[f(k, r) / r_o ** (k - 2.0) for k in powers] for r in circles for f in (srr, srt)]
    c = np.linalg.solve(rows, [-p, 0.0] + ([0.0, 0.0] if r_i else []))
    return [
        sum(a * u(k)[i](r_o) / r_o ** (k - 2.0) for a, k in zip(c, powers, strict=True))
        for i in (0, 1)
    ]


@pytest.mark.parametrize(("n", "r_i"), [(2, R_I), (8, 0.0), (50, R_I)])
def test_pressure_waves_around_a_ring_deflect_it_as_by_michell(n, r_i):
    solid = FourierSolid(ring(r_i, R_O, n, 24), STEEL, {"start": "z", "end": "z"}, degree=2)
    s = solid.harmonic(n).solve({"rim": (-1.0, 0.0, 0.0)})
    u, sigma = s.amplitudes_at(np.array([[R_O, R_O], [0.05, 0.25]]))
    u_r, u_t = michell(n, r_i, R_O, 1.0)
    bound = 1e-4
    np.testing.assert_allclose(u[0], u_r, rtol=bound)
    np.testing.assert_allclose(u[1], u_t, rtol=0, atol=bound * abs(u_r))
    np.testing.assert_allclose(u[2], 0, atol=1e-9 * abs(u_r))
    np.testing.assert_allclose(sigma[0], -1.0, atol=0.02)
    exact = -u_r * np.pi * R_O * 0.3 / 2
    errors = []
    for cells in (8, 16):
        ends = {"start": "z", "end": "z"}
        solid = FourierSolid(ring(r_i, R_O, n, cells), STEEL, ends, degree=2)
        errors.append(exact - solid.harmonic(n).solve({"rim": (-1.0, 0.0, 0.0)}).strain_energy)
    assert errors[1] > 0  # displacements of a finite space are too stiff
    assert n > 6 or np.log2(errors[0] / errors[1]) == pytest.approx(4, abs=0.2)
