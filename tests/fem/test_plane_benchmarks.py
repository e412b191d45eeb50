"""Known plane problems, on meshes an engineer would draw for them."""

from dataclasses import replace
from functools import cache
from math import pi

import gmsh
import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from meshes.plane import plane_mesh
from meshes.session import gmsh_session

KINDS = {"tri6": (MeshTri1, MeshTri2), "quad9": (MeshQuad1, MeshQuad2)}
both_elements = pytest.mark.parametrize("kind", KINDS)


def mapped(kind, s, t, place):
    """The grid s x t under (x, y) = place(s, t); sides "s=0", "s=1", "t=0", "t=1"."""
    straight, shape = KINDS[kind]
    mesh = shape.from_mesh(straight.init_tensor(s, t)).with_boundaries({
        "s=0": lambda x: x[0] == 0,
        "s=1": lambda x: x[0] == 1,
        "t=0": lambda x: x[1] == 0,
        "t=1": lambda x: x[1] == 1,
    })  # fmt: skip
    return replace(mesh, doflocs=np.array(place(*mesh.doflocs)))


@both_elements
def test_the_elliptic_membrane_le1_has_the_target_stress_of_nafems(kind):
    # NAFEMS R0015 (1990), LE1: ellipses 2 x 1 and 3.25 x 2.75 m, 10 MPa outwards on the outer one,
    # 0.1 m thick; yy at (2, 0) is 92.7 MPa
    def stress(cells):
        s = np.linspace(0, 1, cells + 1) ** 2  # towards (2, 0)
        mesh = mapped(kind, s, np.linspace(0, 1, 2 * cells + 1) ** 2, lambda s, t: (
            (2 + 1.25 * s) * np.cos(t * pi / 2), (1 + 1.75 * s) * np.sin(t * pi / 2)
        ))  # fmt: skip
        inner = solve_plane(
            mesh, materials=Elastic(E=210e3, nu=0.3), assumption="plane stress", thickness=0.1,
            supports={"t=0": "y", "t=1": "x"}, pressures={"s=1": -10.0},
        ).on_boundary("s=0")  # fmt: skip
        return inner.stress[1, np.argsort(inner.x[1])[:4]].mean()  # the facet at (2, 0)

    coarse, fine = stress(8), stress(16)
    gci = 1.25 * abs(fine - coarse) / (2**2 - 1)
    assert fine == pytest.approx(92.7, abs=0.05 + gci)  # half the last printed digit


@both_elements
def test_cooks_membrane_rises_as_far_as_its_converged_value(kind):
    # Cook (1974), corners (0, 0), (48, 44), (48, 60), (0, 44); E = 1, nu = 1/3, unit shear force:
    # the middle of the loaded side rises by 23.96
    def rise(cells):
        mesh = mapped(
            kind, np.linspace(0, 1, cells + 1), np.linspace(0, 1, cells + 1),
            lambda s, t: (48 * s, 44 * s + (44 - 28 * s) * t),
        )  # fmt: skip
        return solve_plane(
            mesh, materials=Elastic(E=1.0, nu=1 / 3), assumption="plane stress",
            supports={"s=0": "xy"}, tractions={"s=1": (0.0, 1 / 16)},
        ).displacement_at((48, 52))[1]  # fmt: skip

    coarse, fine = rise(16), rise(32)
    gci = 1.25 * abs(fine - coarse) / (2**1 - 1)  # first order: the clamped corner is singular
    assert fine == pytest.approx(23.96, abs=0.005 + gci)


@cache
def pressed_disc(size):
    """A quarter of a disc of radius 1 between two opposite forces of 1."""
    with gmsh_session():
        geo = gmsh.model.geo
        centre, foot, head = (geo.addPoint(*p, 0, size) for p in ((0, 0), (1, 0), (0, 1)))
        equator, axis = geo.addLine(centre, foot), geo.addLine(head, centre)
        rim = geo.addCircleArc(foot, centre, head)
        geo.addPlaneSurface([geo.addCurveLoop([equator, rim, axis])])
        geo.synchronize()
        gmsh.model.addPhysicalGroup(1, [equator], name="equator")
        gmsh.model.addPhysicalGroup(1, [axis], name="axis")
        gmsh.model.mesh.generate(2)
        gmsh.model.mesh.setOrder(2)
        mesh = plane_mesh()
    return solve_plane(
        mesh, materials=Elastic(E=1.0, nu=0.3), assumption="plane strain",
        supports={"equator": "y", "axis": "x"}, point_forces={(0, 1): (0.0, -0.5)},
    )  # fmt: skip


def test_a_disc_between_two_forces_has_hertz_stresses_on_its_equator():
    # Timoshenko & Goodier, art. 41, diameter 2: xx = ((1 - x^2) / (1 + x^2))^2 / pi and
    # yy = (1 - 4 / (1 + x^2)^2) / pi, at the centre 1 / pi and -3 / pi
    def error(size):
        cut = pressed_disc(size).on_boundary("equator")
        q = cut.x[0] ** 2
        exact = ((1 - q) / (1 + q)) ** 2 / pi, (1 - 4 / (1 + q) ** 2) / pi
        return np.sqrt(cut.mean(((cut.stress[:2] - exact) ** 2).sum(axis=0)))

    # stresses of quadratic elements away from the forces; cells aren't halved one by one
    errors = error(1 / 8), error(1 / 32)
    assert np.log2(errors[0] / errors[1]) / 2 == pytest.approx(2, abs=0.3), errors


def test_the_equator_of_the_disc_carries_half_the_force():
    assert pressed_disc(1 / 8).reaction("equator")[1] == pytest.approx(0.5, rel=1e-9)
