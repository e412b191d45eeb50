"""A solid disc that turns about its axis: body forces, and cells at r = 0.

The solution in three dimensions (Timoshenko & Goodier, rotating disks) meets the differential
equations exactly and leaves on the rim a traction without resultant, which is applied here; so the
closed form holds all over.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from skfem import Basis, MeshQuad1, MeshQuad2, MeshTri1, MeshTri2
from skfem.quadrature import get_quadrature

from fem.plane.cells import Cells
from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

A, C = 0.1, 0.03  # radius and half the thickness [m]
RHO, OMEGA = 7850.0, 2000.0  # [kg/m^3], [1/s]
LOAD = RHO * OMEGA**2
STEEL = Elastic(E=210e9, nu=0.3)
E, NU = STEEL.E, STEEL.nu
K = NU * (1 + NU) / (6 * (1 - NU))
KINDS = {
    "tri3": (MeshTri1, MeshTri1, 1),
    "tri6": (MeshTri1, MeshTri2, 2),
    "quad4": (MeshQuad1, MeshQuad1, 1),
    "quad9": (MeshQuad1, MeshQuad2, 2),
    "tri6, straight": (MeshTri1, MeshTri1, 2),
    "quad9, straight": (MeshQuad1, MeshQuad1, 2),
}
SPREAD = 0.25  # of an observed order over two halvings
every_element = pytest.mark.parametrize("kind", KINDS)


def exact(x):
    """Displacement (2, m) and stress (4, m: radial, axial, shear, hoop) at `x` (2, m)."""
    r, z = x
    across = (3 + NU) / 8 * A**2 + K * (C**2 - 3 * z**2)
    radial, hoop = across - (3 + NU) / 8 * r**2, across - (1 + 3 * NU) / 8 * r**2
    w = (3 + NU) / 4 * A**2 * z - (1 + NU) / 2 * r**2 * z + 2 * K * (C**2 * z - z**3)
    zero = np.zeros_like(r)
    u = np.array([r * (hoop - NU * radial), -NU * w]) * LOAD / E
    return u, LOAD * np.array([radial, zero, zero, hoop])


@cache
def disc(kind, across):
    """The upper half, with wavy cells `across` it."""
    straight, shape, degree = KINDS[kind]
    grid = straight.init_tensor(np.linspace(0, 1, 3 * across + 1), np.linspace(0, 1, across + 1))
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({
        "axis": lambda x: x[0] == 0,
        "rim": lambda x: x[0] == 1,
        "middle": lambda x: x[1] == 0,
    })  # fmt: skip
    s, t = mesh.doflocs
    s, t = s + 0.04 * np.sin(np.pi * s) * np.cos(3 * t), t + 0.1 * np.sin(np.pi * t) * np.cos(3 * s)
    return solve_plane(
        replace(mesh, doflocs=np.array([A * s, C * t])), materials=STEEL,
        assumption="axisymmetric", degree=degree, supports={"middle": "y"},
        body_forces=lambda x: np.array([LOAD * x[0], 0 * x[0]]),
        pressures={"rim": lambda x: -exact(x)[1][0]},
    )  # fmt: skip


def energy():
    """Half of stress times strain, by Gauss points that are exact for the polynomial."""
    t, weight = np.polynomial.legendre.leggauss(8)
    x = np.array(np.meshgrid(A * (1 + t) / 2, C * (1 + t) / 2)).reshape(2, -1)
    radial, _, _, hoop = exact(x)[1]
    density = (radial**2 + hoop**2 - 2 * NU * radial * hoop) / (2 * E)
    return np.outer(weight, weight).ravel() @ (2 * np.pi * x[0] * density) * A * C / 4


def replace_rule(basis, rule):
    return Basis(basis.mesh, basis.elem, quadrature=rule)


def assert_order(error, order, kind):
    errors = [abs(error(disc(kind, across))) for across in (6, 12, 24)]
    observed = np.log2(errors[0] / errors[2]) / 2
    assert observed == pytest.approx(order, abs=SPREAD), errors


@every_element
def test_the_energy_converges_at_twice_the_degree(kind):
    assert_order(lambda s: s.strain_energy / energy() - 1, 2 * KINDS[kind][2], kind)


@every_element
def test_displacements_converge_at_one_order_above_the_degree(kind):
    def error(s):
        inside = s.in_body()
        return np.sqrt(inside.mean(((inside.u - exact(inside.x)[0]) ** 2).sum(axis=0)))

    assert_order(error, KINDS[kind][2] + 1, kind)


@every_element
def test_quadrature_adds_next_to_nothing_to_the_error_of_the_energy(kind):
    s = disc(kind, 6)
    rule = get_quadrature(s.basis.mesh.elem.refdom, 14)
    fine = Cells.of(replace_rule(s.basis, rule), s.lam, s.mu, turn=True).strain_energy(s.u)
    assert abs(fine - s.strain_energy) < 0.01 * abs(fine - energy())


@every_element
@pytest.mark.parametrize("place", ["everywhere", "on the axis"])
def test_stresses_converge_at_the_degree(kind, place):
    def error(s):
        some = s.in_body() if place == "everywhere" else s.on_boundary("axis")
        return np.sqrt(some.mean(((some.stress - exact(some.x)[1]) ** 2).sum(axis=0)))

    assert_order(error, KINDS[kind][2], kind)


@every_element
def test_points_near_the_axis_have_the_stress_of_the_axis(kind):
    s = disc(kind, 6)
    z = np.repeat([0.2 * C, 0.71 * C], 30)
    r = np.tile(A * np.logspace(-18, -5, 30), 2)
    near = s.at(np.array([r, z])).stress
    there = s.at(np.array([0 * r, z])).stress
    # the field itself changes by some 1e-4 over 1e-5 of the radius
    np.testing.assert_allclose(near, there, atol=1e-3 * abs(there).max())
    np.testing.assert_allclose(near[:, :20], near[:, :1].repeat(20, axis=1), rtol=2e-6, atol=1.0)


@every_element
def test_the_pictures_means_are_those_of_the_cells(kind):
    s = disc(kind, 6)
    plain = s.cells()
    mean = exact(plain["points"][plain["cells"]].mean(axis=1).T)[1]
    # cells of a sixth of the half thickness: second order, and first for linear triangles
    assert abs(plain["stress"].T - mean).max() < 0.15 * mean.max()
    assert plain["stress"].shape == (s.basis.mesh.nelements, 4)
