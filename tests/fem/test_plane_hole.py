"""Plate with a circular hole under tension against Kirsch (Timoshenko & Goodier, art. 35).

The outer circle carries the tractions that the infinite plate exerts there, so that the finite
quarter is the same problem to the last digit. Stresses and displacements (Kolosov-Muskhelishvili)
are written down separately: the solver is loaded with the one and judged by the other too.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

A, B, S = 1.0, 3.0, 1.0  # hole, outer circle, tension along x
MATERIAL = Elastic(E=1000.0, nu=0.3)
KINDS = {
    "tri3": (MeshTri1, MeshTri1),
    "tri6": (MeshTri1, MeshTri2),
    "quad4": (MeshQuad1, MeshQuad1),
    "quad9": (MeshQuad1, MeshQuad2),
}
DEGREE = {"tri3": 1, "tri6": 2, "quad4": 1, "quad9": 2}
# of an order observed between 16 x 24 and 32 x 48 cells: (r/A)^-4 changes by a fifth over a cell
SPREAD = 0.3
every_element = pytest.mark.parametrize("kind", KINDS)
both_assumptions = pytest.mark.parametrize("assumption", ["plane strain", "plane stress"])


def stress(x):
    """Kirsch's xx, yy, xy."""
    phi, q = np.arctan2(x[1], x[0]), (A / np.hypot(*x)) ** 2
    c2, c4, s2, s4 = np.cos(2 * phi), np.cos(4 * phi), np.sin(2 * phi), np.sin(4 * phi)
    return S * np.array([
        1 - q * (1.5 * c2 + c4) + 1.5 * q**2 * c4,
        -q * (0.5 * c2 - c4) - 1.5 * q**2 * c4,
        -q * (0.5 * s2 + s4) + 1.5 * q**2 * s4,
    ])  # fmt: skip


def displacement(x, assumption):
    nu = MATERIAL.nu
    kappa = (3 - nu) / (1 + nu) if assumption == "plane stress" else 3 - 4 * nu
    phi, r = np.arctan2(x[1], x[0]), np.hypot(*x) / A
    c, s, c3, s3 = np.cos(phi), np.sin(phi), np.cos(3 * phi), np.sin(3 * phi)
    scale = S * A / (8 * MATERIAL.E / (2 * (1 + nu)))
    return scale * np.array([
        r * (kappa + 1) * c + 2 / r * ((1 + kappa) * c + c3) - 2 / r**3 * c3,
        r * (kappa - 3) * s + 2 / r * ((1 - kappa) * s + s3) - 2 / r**3 * s3,
    ])  # fmt: skip


def far_pull(x):
    xx, yy, xy = stress(x)
    n_x, n_y = x / np.hypot(*x)
    return np.array([xx * n_x + xy * n_y, xy * n_x + yy * n_y])


@cache
def plate(kind, assumption, fine):
    straight, shape = KINDS[kind]
    grid = straight.init_tensor(
        A * (B / A) ** np.linspace(0, 1, 4 * fine + 1), np.linspace(0, np.pi / 2, 6 * fine + 1)
    )
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({
        "hole": lambda x: x[0] == A,
        "far": lambda x: np.isclose(x[0], B),
        "y=0": lambda x: x[1] == 0,
        "x=0": lambda x: x[1] == np.pi / 2,
    })  # fmt: skip
    r, phi = mesh.doflocs
    return solve_plane(
        replace(mesh, doflocs=np.array([r * np.cos(phi), r * np.sin(phi)])),
        materials=MATERIAL, assumption=assumption,
        supports={"x=0": "x", "y=0": "y"}, tractions={"far": far_pull},
    )  # fmt: skip


def assert_order(error, order, kind, assumption):
    coarse, fine = (abs(error(plate(kind, assumption, fine))) for fine in (4, 8))
    observed = np.log2(coarse / fine)
    assert observed == pytest.approx(order, abs=SPREAD), (coarse, fine)


@both_assumptions
@every_element
def test_displacements_converge_one_order_above_the_degree(kind, assumption):
    def error(s):
        inside = s.in_body()
        off = ((inside.u - displacement(inside.x, assumption)) ** 2).sum(axis=0)
        return np.sqrt(inside.mean(off))

    assert_order(error, DEGREE[kind] + 1, kind, assumption)


@both_assumptions
@every_element
def test_stresses_converge_at_the_degree(kind, assumption):
    def error(s):
        inside = s.in_body()
        return np.sqrt(inside.mean(((inside.stress[:3] - stress(inside.x)) ** 2).sum(axis=0)))

    assert_order(error, DEGREE[kind], kind, assumption)


@both_assumptions
@every_element
def test_the_hole_widens_along_the_pull_three_times_as_much_as_it_narrows_across(kind, assumption):
    # u = (3 S A cos phi, -S A sin phi) / E' at the hole; cos^2 and sin^2 have the mean 1/2
    stiff = MATERIAL.E if assumption == "plane stress" else MATERIAL.E / (1 - MATERIAL.nu**2)
    for outwards, expected in ((np.array([[1], [0]]), 1.5), (np.array([[0], [1]]), -0.5)):

        def error(s, outwards=outwards, expected=expected):
            mean = s.mean_displacement("hole", lambda x: outwards * x / A)
            return mean / (expected * S * A / stiff) - 1

        assert_order(error, 2 * DEGREE[kind], kind, assumption)


@pytest.mark.parametrize("kind", ["tri6", "quad9"])
def test_the_hoop_stress_at_the_hole_runs_from_minus_one_to_three_times_the_tension(kind):
    def error(s):
        hole = s.on_boundary("hole")
        _, _, hoop, _ = hole.polar()
        cos_2phi = (hole.x[0] ** 2 - hole.x[1] ** 2) / A**2
        return np.sqrt(hole.mean((hoop - S * (1 - 2 * cos_2phi)) ** 2))

    assert_order(error, DEGREE[kind], kind, "plane stress")


@every_element
def test_the_cuts_carry_the_far_tension(kind):
    # equilibrium: the traction of the infinite plate over the quarter circle, integrated here
    phi = (np.arange(20_000) + 0.5) / 20_000 * np.pi / 2
    pull = far_pull(B * np.array([np.cos(phi), np.sin(phi)])).mean(axis=1) * B * np.pi / 2
    s = plate(kind, "plane strain", 4)
    # the polygon or the parabolas of the rim miss the arc by h^2 or h^4, h = pi/2 / 24
    rel = (np.pi / 48) ** (2 * DEGREE[kind])
    assert s.reaction("x=0")[0] == pytest.approx(-pull[0], rel=rel)
    assert s.reaction("y=0")[1] == pytest.approx(-pull[1], abs=rel * pull[0])
