"""Long rings, guided at both ends, under pressure that varies as cos n t: Lamé and Michell."""

import numpy as np
import pytest
from skfem import MeshQuad1

from fem.fourier.solid import FourierSolid
from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

E, NU = 206.0, 0.3
STEEL = Elastic(E=E, nu=NU)
MU = E / (2 * (1 + NU))
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
            return ((1 - NU) * srr(k, r) - NU * att(r)) / (2 * MU) * r / (k - 1)

        def u_t(r):  # e_tt = (u_r + n u_t)/r
            hoop = ((1 - NU) * att(r) - NU * srr(k, r)) / (2 * MU)
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
def test_pressure_that_waves_around_a_ring_moves_it_as_michell_says(n, r_i):
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


def test_the_uniform_harmonic_is_the_axisymmetric_problem():
    mesh = ring(R_I, R_O, 3)
    push = lambda x: np.array([-1 - x[1], 0 * x[0]])  # noqa: E731
    plane = solve_plane(
        mesh, materials=STEEL, assumption="axisymmetric", degree=2, supports={"start": "y"},
        tractions={"rim": push},
    )  # fmt: skip
    solid = FourierSolid(mesh, STEEL, {"start": "z"}, degree=2)
    s = solid.harmonic(0).solve({"rim": lambda x: np.array([*push(x), 0 * x[0]])[[0, 2, 1]]})
    points = np.array([[0.61, 0.8, 1.0], [0.02, 0.3, 0.11]])
    own, other = s.amplitudes_at(points), plane.at(points)
    np.testing.assert_allclose(own[0][[0, 2]], other.u, atol=1e-10 * abs(other.u).max())
    np.testing.assert_allclose(own[1][[0, 2, 5, 1]], other.stress, atol=1e-9)
    assert s.strain_energy == pytest.approx(plane.strain_energy, rel=1e-10)
    assert s.reaction("start")[0] == pytest.approx(plane.reaction("start")[1], abs=1e-9)
