"""A quarter of a curved bar in pure bending (Golovin) and under a force at its end.

Timoshenko & Goodier, art. 29 and 33: plane stress, unit thickness. Energies and movements follow
from the closed stresses by E and nu of the assumption.
"""

from dataclasses import replace
from functools import cache
from math import log, pi

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

A, B = 1.0, 2.0  # inner and outer radius
MOMENT, FORCE = 0.8, 0.5
MATERIAL = Elastic(E=100.0, nu=0.3)
KINDS = {
    "tri3": (MeshTri1, MeshTri1),
    "tri6": (MeshTri1, MeshTri2),
    "quad4": (MeshQuad1, MeshQuad1),
    "quad9": (MeshQuad1, MeshQuad2),
}
DEGREE = {"tri3": 1, "tri6": 2, "quad4": 1, "quad9": 2}
SPREAD = 0.2  # of an order observed between meshes of 6 x 18 and 12 x 36 cells
every_element = pytest.mark.parametrize("kind", KINDS)
both_assumptions = pytest.mark.parametrize("assumption", ["plane strain", "plane stress"])


def bending_stress(r):
    """Radial and hoop stress of a moment that straightens the bar."""
    q = (A * B / r) ** 2 * log(B / A)
    shell = B**2 * np.log(r / B) + A**2 * np.log(A / r)
    N = (B**2 - A**2) ** 2 - 4 * (A * B * log(B / A)) ** 2
    return -4 * MOMENT / N * (q + shell), -4 * MOMENT / N * (-q + shell + B**2 - A**2)


def bending_angle(E):
    """By which the two ends of the quarter turn against each other."""
    N = (B**2 - A**2) ** 2 - 4 * (A * B * log(B / A)) ** 2
    return 8 * MOMENT * (B**2 - A**2) / (N * E) * pi / 2


def end_shear(r):
    """Shear stress tau_r_phi at phi = 0 of a force along r."""
    N = A**2 - B**2 + (A**2 + B**2) * log(B / A)
    return -FORCE / N * (r + A**2 * B**2 / r**3 - (A**2 + B**2) / r)


def end_movement(E):
    """Along the force."""
    return pi * FORCE * (A**2 + B**2) / (E * (A**2 - B**2 + (A**2 + B**2) * log(B / A)))


def modulus(assumption):
    return MATERIAL.E if assumption == "plane stress" else MATERIAL.E / (1 - MATERIAL.nu**2)


@cache
def bar(kind, assumption, load, through):
    straight, shape = KINDS[kind]
    grid = straight.init_tensor(
        np.linspace(A, B, through + 1), np.linspace(0, pi / 2, 3 * through + 1)
    )
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({
        "end": lambda x: x[1] == 0, "root": lambda x: x[1] == pi / 2, "outside": lambda x: x[0] == B
    })  # fmt: skip
    r, phi = mesh.doflocs
    traction = {
        "moment": lambda x: np.array([0 * x[0], -bending_stress(x[0])[1]]),
        "force": lambda x: np.array([-end_shear(x[0]), 0 * x[0]]),
    }[load]
    # the exact hoop displacement vanishes all along the root, where there is no shear either
    return solve_plane(
        replace(mesh, doflocs=np.array([r * np.cos(phi), r * np.sin(phi)])),
        materials=MATERIAL, assumption=assumption,
        supports={"root": "x"}, anchors={(0, A): "y"}, tractions={"end": traction},
    )  # fmt: skip


def assert_order(error, order, kind, assumption, load):
    coarse, fine = (abs(error(bar(kind, assumption, load, through))) for through in (6, 12))
    observed = np.log2(coarse / fine)
    assert observed == pytest.approx(order, abs=SPREAD), (coarse, fine)


@both_assumptions
@every_element
def test_pure_bending_stores_half_the_moment_times_golovins_angle(kind, assumption):
    energy = MOMENT * bending_angle(modulus(assumption)) / 2
    assert_order(
        lambda s: s.strain_energy / energy - 1, 2 * DEGREE[kind], kind, assumption, "moment"
    )


@both_assumptions
@every_element
def test_an_end_force_moves_its_end_as_the_elasticity_solution_says(kind, assumption):
    energy = FORCE * end_movement(modulus(assumption)) / 2
    assert_order(
        lambda s: s.strain_energy / energy - 1, 2 * DEGREE[kind], kind, assumption, "force"
    )
    assert_order(
        lambda s: abs(s.mean_displacement("end", (1, 0))) / end_movement(modulus(assumption)) - 1,
        2 * DEGREE[kind], kind, assumption, "force",
    )  # fmt: skip


@every_element
def test_bending_stresses_converge_at_the_degree_throughout_the_wall(kind):
    def error(s):
        inside = s.in_body()
        _, radial, hoop, shear = inside.polar()
        exact_radial, exact_hoop = bending_stress(np.hypot(*inside.x))
        return np.sqrt(
            inside.mean((radial - exact_radial) ** 2 + (hoop - exact_hoop) ** 2 + 2 * shear**2)
        )

    assert_order(error, DEGREE[kind], kind, "plane stress", "moment")


@pytest.mark.parametrize(
    ("load", "expected"),
    [
        pytest.param("moment", (0, 0, -MOMENT), id="a couple"),
        pytest.param("force", (FORCE, 0, 0), id="a force whose line passes the centre"),
    ],
)
@every_element
def test_the_root_answers_the_end(kind, load, expected):
    # equilibrium on any mesh; four Gauss points on a facet of 1/6 miss the integral of 1/r^2 by
    # (1/6)^9 (4!)^4 9! / (9 (8!)^3) = 2e-11, the steeper terms by up to ten times as much
    x, y, couple = bar(kind, "plane stress", load, 6).reaction("root")
    assert (x, y, couple) == pytest.approx(expected, abs=1e-9)
