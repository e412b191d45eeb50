"""What harmonics have exactly on any mesh: uniform strain, bending, rigid motions, weak forms."""

from dataclasses import replace

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.fourier.solid import FourierSolid
from fem.fourier.solution import FourierSolution
from fem.fourier.supports import rigid_motions
from fem.plane.material import Elastic

E, NU = 210.0, 0.3
G = E / (2 * (1 + NU))
STEEL = Elastic(E=E, nu=NU)
ROUND_OFF = 1e-11
KINDS = {
    "tri6, straight": (MeshTri1, MeshTri1),
    "tri6": (MeshTri1, MeshTri2),
    "quad9, straight": (MeshQuad1, MeshQuad1),
    "quad9": (MeshQuad1, MeshQuad2),
}
BORES = dict(zip(KINDS, (0.0, 0.5, 0.5, 0.0), strict=True))  # solid and hollow
every_body = pytest.mark.parametrize(("kind", "bore"), BORES.items())
PLACES = np.array([[0.7, 1.1, 1.9, 2.0], [0.2, 0.9, 0.5, 0.0]])
ANGLES = np.array([0.3, 1.7, 4.0, 5.5])


def tube(kind, bore=0.0):
    """A tube or bar of outer radius 2, 0 <= z <= 1, wavy cells within."""
    straight, shape = KINDS[kind]
    grid = straight.init_tensor(np.linspace(0, 1, 6), np.linspace(0, 1, 4))
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({
        "bore": lambda x: x[0] == 0, "rim": lambda x: x[0] == 1,
        "bottom": lambda x: x[1] == 0, "top": lambda x: x[1] == 1,
    })  # fmt: skip
    s, t = mesh.doflocs
    wave = np.sin(np.pi * s) * np.sin(np.pi * t)
    s, t = s + 0.05 * wave * np.cos(5 * t), t + 0.06 * np.sin(np.pi * t) * np.cos(4 * s)
    return replace(mesh, doflocs=np.array([bore + (2 - bore) * s, t]))


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


@pytest.mark.parametrize(("n", "antisymmetric"), [(0, False), (0, True), (1, False), (1, True)])
def test_rigid_motions_however_large_cost_nothing(n, antisymmetric):
    solid = FourierSolid(tube("quad9", 0.5 * n), STEEL, degree=2)
    motions = rigid_motions(solid.basis, n, antisymmetric)
    assert motions.shape[1] == n + 1
    for motion in motions.T:
        force = solid.cells.internal_forces(1e6 * motion, -n if antisymmetric else n)
        assert abs(force).max() < 1e6 * E * 1e-12
    # none from the second harmonic on
    assert rigid_motions(solid.basis, 2, False).shape[1] == 0
    assert np.linalg.eigvalsh(solid.harmonic(2).K.toarray()).min() > 0


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
