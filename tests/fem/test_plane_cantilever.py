"""A cantilever of rectangular section under an end force (Timoshenko & Goodier, art. 21).

The parabolic shear at both ends makes xx = -P (l - x) y / I, xy = P (c^2 - y^2) / (2 I) exact, with
I = 2 c^3 / 3 and unit thickness; so are its energy and, less a rigid motion, its displacements.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

LENGTH, HALF, P = 8.0, 1.0, 3.0
MATERIAL = Elastic(E=1000.0, nu=0.25)
I = 2 * HALF**3 / 3  # noqa: E741
KINDS = {
    "tri3": (MeshTri1, MeshTri1, 1),
    "tri6": (MeshTri1, MeshTri2, 2),
    "quad4": (MeshQuad1, MeshQuad1, 1),
    "quad9": (MeshQuad1, MeshQuad2, 2),
    "quad9 with straight edges": (MeshQuad1, MeshQuad1, 2),
}
SPREAD = 0.15  # of an order observed between meshes of 32 x 8 and 64 x 16 cells
every_element = pytest.mark.parametrize("kind", KINDS)
both_assumptions = pytest.mark.parametrize("assumption", ["plane strain", "plane stress"])


def in_plane(assumption):
    E, nu = MATERIAL.E, MATERIAL.nu
    return (E, nu) if assumption == "plane stress" else (E / (1 - nu**2), nu / (1 - nu))


def energy(assumption):
    """Bending and the shear of a parabola, whose square is 6/5 of the mean's square."""
    E, nu = in_plane(assumption)
    G = E / (2 * (1 + nu))
    return P**2 * LENGTH**3 / (6 * E * I) + 6 / 5 * P**2 * LENGTH / (2 * G * 2 * HALF)


def shear(x):
    return P * (HALF**2 - x[1] ** 2) / (2 * I)


@cache
def beam(kind, assumption, across):
    straight, shape, degree = KINDS[kind]
    grid = straight.init_tensor(
        np.linspace(0, LENGTH, 4 * across + 1), np.linspace(-HALF, HALF, across + 1)
    )
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({"root": lambda x: x[0] == 0, "end": lambda x: x[0] == LENGTH})
    x, y = mesh.doflocs  # no two cells alike, sides straight
    mesh = replace(mesh, doflocs=np.array([x + 0.1 * np.sin(x * np.pi / LENGTH) * (y + 0.3), y]))
    return solve_plane(
        mesh, materials=MATERIAL, assumption=assumption, degree=degree,
        supports={}, anchors={(0, -HALF): "xy", (0, HALF): "x"},
        tractions={
            "root": lambda x: np.array([P * LENGTH * x[1] / I, -shear(x)]),
            "end": lambda x: np.array([0 * x[0], shear(x)]),
        },
    )  # fmt: skip


@both_assumptions
@every_element
def test_the_energy_converges_at_twice_the_degree(kind, assumption):
    coarse, fine = (
        beam(kind, assumption, across).strain_energy / energy(assumption) - 1 for across in (8, 16)
    )
    order = 2 * KINDS[kind][2]
    assert np.log2(coarse / fine) == pytest.approx(order, abs=SPREAD), (coarse, fine)


@both_assumptions
@pytest.mark.parametrize("kind", ["tri6", "quad9"])
def test_the_tip_rises_by_bending_and_by_the_slope_that_shear_leaves_at_the_root(kind, assumption):
    # P l^3 / (3 E I) against the tangent at the root. The anchors hold the root's corners in x, and
    # from 0 = int (xy / G - dv/dx) dy over half the root that tangent has the slope
    # P c^2 / (3 I G) + nu P c^2 / (6 E I)
    E, nu = in_plane(assumption)
    G = E / (2 * (1 + nu))
    slope = P * HALF**2 / (3 * I * G) + nu * P * HALF**2 / (6 * E * I)
    exact = P * LENGTH**3 / (3 * E * I) + slope * LENGTH
    errors = []
    for across in (8, 16):
        s = beam(kind, assumption, across)
        errors.append(s.displacement_at((LENGTH, 0))[1] - s.displacement_at((0, 0))[1] - exact)
    # u of degree 2 is off by h^3 at least, at some nodes by h^4
    assert np.log2(errors[0] / errors[1]) > 3 - SPREAD, errors


def test_anchors_that_only_stop_the_rigid_motion_carry_nothing():
    s = beam("quad9", "plane stress", 4)
    # round-off of 1e-16 grows by (length / depth)^4 = 256 and the 2000 unknowns
    for corner in ((0, -HALF), (0, HALF)):
        assert s.reaction_at(corner) == pytest.approx((0, 0), abs=1e-10 * P)
