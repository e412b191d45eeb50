"""Rotating discs: a body force that grows with the radius (Timoshenko & Goodier, art. 32)."""

from dataclasses import replace
from functools import cache

import gmsh
import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from meshes.plane import plane_mesh
from meshes.session import gmsh_session

R_I, R_O = 0.1, 0.3  # [m]
MATERIAL = Elastic(E=210e9, nu=0.3)
LOAD = 7850 * 1000.0**2  # rho omega^2 [N/m^4]
KINDS = {
    "tri3": (MeshTri1, MeshTri1),
    "tri6": (MeshTri1, MeshTri2),
    "quad4": (MeshQuad1, MeshQuad1),
    "quad9": (MeshQuad1, MeshQuad2),
}
DEGREE = {"tri3": 1, "tri6": 2, "quad4": 1, "quad9": 2}
SPREAD = 0.2  # of an order observed between 6 x 12 and 12 x 24 cells
every_element = pytest.mark.parametrize("kind", KINDS)
both_assumptions = pytest.mark.parametrize("assumption", ["plane strain", "plane stress"])


def centrifugal(x):
    return LOAD * x


def in_plane(assumption):
    E, nu = MATERIAL.E, MATERIAL.nu
    return (E, nu) if assumption == "plane stress" else (E / (1 - nu**2), nu / (1 - nu))


def wall_movement(r, other, assumption):
    """Radial displacement of one wall of an annulus whose other wall has the radius `other`."""
    E, nu = in_plane(assumption)
    return LOAD * r / (4 * E) * ((1 - nu) * r**2 + (3 + nu) * other**2)


@cache
def annulus(kind, assumption, through):
    straight, shape = KINDS[kind]
    grid = straight.init_tensor(
        np.linspace(R_I, R_O, through + 1), np.linspace(0, np.pi / 2, 2 * through + 1)
    )
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({
        "bore": lambda x: x[0] == R_I,
        "rim": lambda x: x[0] == R_O,
        "y=0": lambda x: x[1] == 0,
        "x=0": lambda x: x[1] == np.pi / 2,
    })  # fmt: skip
    r, phi = mesh.doflocs
    return solve_plane(
        replace(mesh, doflocs=np.array([r * np.cos(phi), r * np.sin(phi)])),
        materials=MATERIAL, assumption=assumption,
        supports={"x=0": "x", "y=0": "y"}, body_forces=centrifugal,
    )  # fmt: skip


@both_assumptions
@every_element
def test_both_walls_of_an_annulus_move_out_as_the_closed_form_says(kind, assumption):
    for wall, r, other in (("bore", R_I, R_O), ("rim", R_O, R_I)):
        exact = wall_movement(r, other, assumption)
        errors = [
            annulus(kind, assumption, through).mean_displacement(wall, lambda x: x / np.hypot(*x))
            / exact - 1
            for through in (6, 12)
        ]  # fmt: skip
        order = np.log2(errors[0] / errors[1])
        assert order == pytest.approx(2 * DEGREE[kind], abs=SPREAD), errors


@both_assumptions
@pytest.mark.parametrize("kind", ["tri6", "quad9"])
def test_the_hoop_stress_in_the_wall_converges_at_the_degree(kind, assumption):
    _, nu = in_plane(assumption)

    def error(s):
        inside = s.in_body()
        r = np.hypot(*inside.x)
        hoop = (3 + nu) / 8 * (R_I**2 + R_O**2 + (R_I * R_O / r) ** 2) - (1 + 3 * nu) / 8 * r**2
        return np.sqrt(inside.mean((inside.polar()[2] / LOAD - hoop) ** 2))

    coarse, fine = (error(annulus(kind, assumption, through)) for through in (6, 12))
    assert np.log2(coarse / fine) == pytest.approx(2, abs=SPREAD), (coarse, fine)


@every_element
def test_each_cut_carries_half_the_centrifugal_force(kind):
    # rho omega^2 int r cos(phi) dA over the quarter = rho omega^2 (R_O^3 - R_I^3) / 3
    s = annulus(kind, "plane stress", 12)
    pull = LOAD * (R_O**3 - R_I**3) / 3
    rel = (np.pi / 48) ** (2 * DEGREE[kind])  # what the polygon or the parabolas miss of the arcs
    assert s.reaction("x=0")[0] == pytest.approx(-pull, rel=rel)
    assert s.reaction("y=0")[1] == pytest.approx(-pull, rel=rel)


@pytest.mark.parametrize("kind", ["tri6", "quad9"])
def test_curved_cells_are_loaded_with_all_of_their_force(kind):
    # int x dA = 1/2 int x^2 n_x ds over the outline, a polynomial on its parabolas: exact, too
    s = annulus(kind, "plane stress", 6)
    sides = [s.on_boundary(name) for name in ("bore", "rim", "x=0", "y=0")]
    pull = LOAD * sum(float(side.weight @ (side.x[0] ** 2 * side.normal[0])) for side in sides) / 2
    assert s.reaction("x=0")[0] == pytest.approx(-pull, rel=1e-12)


@cache
def solid_disc(quadrilaterals, assumption, size):
    """The whole disc on an unstructured mesh, held at three points only."""
    with gmsh_session():
        geo = gmsh.model.geo
        centre = geo.addPoint(0, 0, 0, size)
        corner = [
            geo.addPoint(x * R_O, y * R_O, 0, size) for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1))
        ]
        arcs = [geo.addCircleArc(corner[k], centre, corner[(k + 1) % 4]) for k in range(4)]
        surface = geo.addPlaneSurface([geo.addCurveLoop(arcs)])
        geo.synchronize()
        gmsh.model.addPhysicalGroup(1, arcs, name="rim")
        if quadrilaterals:
            gmsh.model.mesh.setRecombine(2, surface)
        gmsh.model.mesh.generate(2)
        gmsh.model.mesh.setOrder(2)
        mesh = plane_mesh()
    return solve_plane(
        mesh, materials=MATERIAL, assumption=assumption, supports={}, body_forces=centrifugal,
        anchors={(R_O, 0): "y", (-R_O, 0): "y", (0, R_O): "x"},
    )  # fmt: skip


@both_assumptions
@pytest.mark.parametrize("quadrilaterals", [False, True], ids=["tri6", "quad9"])
def test_a_solid_disc_on_unstructured_meshes_converges_at_the_elements_orders(
    quadrilaterals, assumption
):
    E, nu = in_plane(assumption)
    rim = (1 - nu) * LOAD * R_O**3 / (4 * E)

    def movement_error(s):
        return abs(s.mean_displacement("rim", lambda x: x / np.hypot(*x)) / rim - 1)

    def stress_error(s):
        inside = s.in_body()
        _, radial, hoop, _ = np.array(inside.polar()) / (LOAD * R_O**2 / 8)
        q = (np.hypot(*inside.x) / R_O) ** 2
        off = (radial - (3 + nu) * (1 - q)) ** 2 + (hoop - (3 + nu) + (1 + 3 * nu) * q) ** 2
        return np.sqrt(inside.mean(off))

    for error, order in ((movement_error, 4), (stress_error, 2)):
        coarse, fine = (
            error(solid_disc(quadrilaterals, assumption, R_O / cells)) for cells in (8, 16)
        )
        # half an order to spare: the cells of an unstructured mesh aren't halved one by one
        assert np.log2(coarse / fine) == pytest.approx(order, abs=0.5), (coarse, fine)
