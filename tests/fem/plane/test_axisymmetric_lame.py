"""Thick cylinders and spheres under pressure against Lamé (Timoshenko & Goodier, arts. 28 and 136).

Both are solved as bodies of revolution; the sphere's cells reach the axis. An error counts as one
of the solver as soon as it stops falling at the element's own rate.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

R_I, R_O, LENGTH = 0.04, 0.06, 0.03  # [m], the radii of the spheres, too
P_I, P_O = 90e6, 20e6  # [Pa]
STEEL = Elastic(E=210e9, nu=0.3)
E, NU = STEEL.E, STEEL.nu
KINDS = {
    "tri3": (MeshTri1, MeshTri1, 1),
    "tri6": (MeshTri1, MeshTri2, 2),
    "quad4": (MeshQuad1, MeshQuad1, 1),
    "quad9": (MeshQuad1, MeshQuad2, 2),
    "tri6 with straight edges": (MeshTri1, MeshTri1, 2),
    "quad9 with straight edges": (MeshQuad1, MeshQuad1, 2),
}
CURVED = [kind for kind in KINDS if "straight" not in kind]
SPREAD = 0.25  # of an observed order over two halvings
MESHES = (4, 8, 16)  # cells through the wall
FINER = (8, 16, 32)  # where the rate sets in late: 3.6, 3.4, 3.2, 3.1 for triangles in the sphere
ENDS = ("held", "free", "closed")
every_element = pytest.mark.parametrize("kind", KINDS)
every_end = pytest.mark.parametrize("ends", ENDS)


def mapped(kind, through, along, place):
    """Cells over (0, 1) x (0, 1), waved inside and put in their `place`; walls by name."""
    straight, shape, degree = KINDS[kind]
    grid = straight.init_tensor(np.linspace(0, 1, through + 1), np.linspace(0, 1, along + 1))
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({
        "bore": lambda x: x[0] == 0,
        "rim": lambda x: x[0] == 1,
        "bottom": lambda x: x[1] == 0,
        "top": lambda x: x[1] == 1,
    })  # fmt: skip
    s, t = mesh.doflocs
    inside = np.sin(np.pi * s) * np.sin(np.pi * t)
    return replace(mesh, doflocs=np.array(place(s + 0.05 * inside, t - 0.1 * inside))), degree


@cache
def cylinder(kind, ends, through):
    mesh, degree = mapped(
        kind, through, 2 * through, lambda s, t: (R_I + (R_O - R_I) * s, LENGTH * t)
    )
    axial = (P_I * R_I**2 - P_O * R_O**2) / (R_O**2 - R_I**2)
    return solve_plane(
        mesh, materials=STEEL, assumption="axisymmetric", degree=degree,
        supports={"bottom": "y"} | ({"top": "y"} if ends == "held" else {}),
        pressures={"bore": P_I, "rim": P_O},
        tractions={"top": (0.0, axial)} if ends == "closed" else {},
    )  # fmt: skip


def of_cylinder(r, ends):
    """Displacement, radial, hoop and axial stress, axial strain."""
    a = (P_I * R_I**2 - P_O * R_O**2) / (R_O**2 - R_I**2)
    b = (P_I - P_O) * R_I**2 * R_O**2 / (R_O**2 - R_I**2)
    radial, hoop = a - b / r**2, a + b / r**2
    axial = {"held": 2 * NU * a, "free": 0.0, "closed": a}[ends] + 0 * r
    return r * (hoop - NU * (radial + axial)) / E, radial, hoop, axial, (axial - 2 * NU * a) / E


@cache
def sphere(kind, through):
    """The upper half, from the pole on the axis down to the equator."""

    def place(s, t):
        R, polar = R_I + (R_O - R_I) * s, np.pi / 2 * (1 - t)
        return R * np.sin(polar), R * np.cos(polar)

    mesh, degree = mapped(kind, through, 4 * through, place)
    return solve_plane(
        mesh, materials=STEEL, assumption="axisymmetric", degree=degree,
        supports={"bottom": "y"}, pressures={"bore": P_I, "rim": P_O},
    )  # fmt: skip


def of_sphere(R):
    """Displacement, radial and tangential stress."""
    a = (P_I * R_I**3 - P_O * R_O**3) / (R_O**3 - R_I**3)
    b = (P_I - P_O) * R_I**3 * R_O**3 / (R_O**3 - R_I**3)
    radial, tangential = a - b / R**3, a + b / (2 * R**3)
    return R * ((1 - NU) * tangential - NU * radial) / E, radial, tangential


def assert_order(error, order, solved, meshes=MESHES):
    errors = [abs(error(solved(through))) for through in meshes]
    observed = np.log2(errors[0] / errors[2]) / 2
    assert observed == pytest.approx(order, abs=SPREAD), errors


def rms(samples, *off):
    return np.sqrt(samples.mean(sum(d**2 for d in off)))


@every_end
@every_element
def test_the_energy_of_the_cylinder_converges_at_twice_the_degree(kind, ends):
    (u_i, *_), (u_o, *_, axial, strain) = of_cylinder(R_I, ends), of_cylinder(R_O, ends)
    section = np.pi * (R_O**2 - R_I**2)
    work = 2 * np.pi * LENGTH * (P_I * R_I * u_i - P_O * R_O * u_o) + section * LENGTH * (
        axial * strain if ends == "closed" else 0.0
    )
    order = 2 * KINDS[kind][2]
    assert_order(lambda s: 2 * s.strain_energy / work - 1, order, lambda n: cylinder(kind, ends, n))


@every_end
@every_element
def test_displacements_of_the_cylinder_converge_at_one_order_above_the_degree(kind, ends):
    def error(s):
        inside = s.in_body()
        u, *_, strain = of_cylinder(inside.x[0], ends)
        return rms(inside, inside.u[0] - u, inside.u[1] - strain * inside.x[1])

    assert_order(error, KINDS[kind][2] + 1, lambda n: cylinder(kind, ends, n))


@every_end
@every_element
def test_stresses_of_the_cylinder_converge_at_the_degree(kind, ends):
    def error(s):
        inside = s.in_body()
        _, radial, hoop, axial, _ = of_cylinder(inside.x[0], ends)
        xx, yy, xy, zz = inside.stress
        return rms(inside, xx - radial, yy - axial, xy, zz - hoop)

    assert_order(error, KINDS[kind][2], lambda n: cylinder(kind, ends, n))


@pytest.mark.parametrize("kind", ["tri6", "quad9"])
def test_held_ends_carry_the_axial_stress_of_the_wall(kind):
    s = cylinder(kind, "held", 8)
    force = 2 * NU * np.pi * (P_I * R_I**2 - P_O * R_O**2)
    # the reaction is an energy derivative: order 4, some 1e-6 with 8 cells through the wall
    assert s.reaction("top")[1] == pytest.approx(force, rel=1e-5)
    assert s.reaction("bottom")[1] == pytest.approx(-force, rel=1e-5)


@every_element
def test_the_energy_of_the_sphere_converges_but_chords_cost_an_order(kind):
    (u_i, *_), (u_o, *_) = of_sphere(R_I), of_sphere(R_O)
    energy = np.pi * (P_I * R_I**2 * u_i - P_O * R_O**2 * u_o)
    order = 4 if kind in ("tri6", "quad9") else 2
    assert_order(lambda s: s.strain_energy / energy - 1, order, lambda n: sphere(kind, n))


@pytest.mark.parametrize("kind", CURVED)
def test_displacements_of_the_sphere_converge_at_one_order_above_the_degree(kind):
    def error(s):
        inside = s.in_body()
        R = np.hypot(*inside.x)
        return rms(inside, *(inside.u - inside.x * of_sphere(R)[0] / R))

    assert_order(error, KINDS[kind][2] + 1, lambda n: sphere(kind, n), FINER)


@pytest.mark.parametrize("kind", CURVED)
def test_stresses_of_the_sphere_converge_at_the_degree_up_to_the_axis(kind):
    def error(s):
        inside = s.in_body()
        _, radial, meridional, shear = inside.polar()
        _, expected, tangential = of_sphere(np.hypot(*inside.x))
        hoop = inside.stress[3] - tangential
        return rms(inside, radial - expected, meridional - tangential, shear, hoop)

    assert_order(error, KINDS[kind][2], lambda n: sphere(kind, n))


@pytest.mark.parametrize("kind", CURVED)
def test_hoop_and_meridional_stress_meet_on_the_axis(kind):
    def error(s):
        axis = s.on_boundary("top")
        _, radial, tangential = of_sphere(axis.x[1])
        return rms(
            axis, axis.stress[0] - tangential, axis.stress[3] - tangential, axis.stress[1] - radial
        )

    assert_order(error, KINDS[kind][2], lambda n: sphere(kind, n))
