"""The half race has the places, names, areas and normals of a ring touched inside."""

from math import pi

import numpy as np
import pytest
from skfem import Basis, ElementQuad1, FacetBasis, Functional

from meshes.contact.race import half_race

R_I, R_O, ZONE = 0.04, 0.055, 0.002  # [m]
ROUND_OFF = 1e-12  # relative


@Functional
def one(w):
    return 1.0 + 0 * w.x[0]


def side(mesh, name):
    return FacetBasis(mesh, ElementQuad1(), intorder=6, facets=mesh.boundaries[name])


def nodes(mesh, name):
    return mesh.doflocs[:, mesh.dofs.get_facet_dofs(np.asarray(mesh.boundaries[name])).flatten()]


@pytest.fixture(scope="module")
def mesh():
    return half_race(r_i=R_I, r_o=R_O, zone=ZONE, refine=2)


def test_its_outline_and_its_body_have_their_names(mesh):
    assert set(mesh.boundaries) == {"bore", "rim", "axis"}
    assert set(mesh.subdomains) == {"race"}
    outline = np.concatenate(list(mesh.boundaries.values()))
    np.testing.assert_array_equal(np.sort(outline), mesh.boundary_facets())


@pytest.mark.parametrize("r_o", [0.041, 0.055, 0.2])
def test_every_node_of_a_circle_lies_on_it(r_o):
    mesh = half_race(r_i=R_I, r_o=r_o, zone=0.0005, refine=1)
    for name, radius in (("bore", R_I), ("rim", r_o)):
        np.testing.assert_allclose(
            np.hypot(*(nodes(mesh, name) - [[0], [R_I]])), radius, rtol=ROUND_OFF
        )


def test_the_bore_touches_the_origin_and_the_cuts_lie_above_each_other(mesh):
    assert np.hypot(*nodes(mesh, "bore")).min() == 0
    x, y = nodes(mesh, "axis")
    np.testing.assert_allclose(x, 0, atol=ROUND_OFF * R_O)
    for low, high in ((R_I - R_O, 0.0), (2 * R_I, R_I + R_O)):
        cut = y[(y > low - 1e-6) & (y < high + 1e-6)]
        assert (cut.min(), cut.max()) == pytest.approx((low, high), abs=ROUND_OFF)
    assert one.assemble(side(mesh, "axis")) == pytest.approx(2 * (R_O - R_I), rel=ROUND_OFF)


def test_its_area_and_its_arcs_converge_with_the_fourth_power_of_its_cells():
    exact = {"bore": pi * R_I, "rim": pi * R_O, "area": pi / 2 * (R_O**2 - R_I**2)}
    meshes = [half_race(r_i=R_I, r_o=R_O, zone=ZONE, refine=refine) for refine in (2, 4)]
    for name, value in exact.items():
        coarse, fine = (measure(mesh, name) / value - 1 for mesh in meshes)
        assert np.log2(coarse / fine) == pytest.approx(4, abs=0.05), (name, coarse, fine)


def measure(mesh, name):
    whole = Basis(mesh, ElementQuad1(), intorder=6)
    return one.assemble(whole if name == "area" else side(mesh, name))


def test_normals_point_out_of_the_wall(mesh):
    for name, sign in (("bore", -1), ("rim", 1)):
        x = np.asarray(side(mesh, name).global_coordinates()) - np.array([0, R_I])[:, None, None]
        outwards = (side(mesh, name).normals * x).sum(axis=0) / np.hypot(*x)
        # the parabola's slope errs by less than the cube of a cell of 0.1 r_i, and enters squared
        np.testing.assert_allclose(outwards, sign, atol=1e-6)
    np.testing.assert_allclose(side(mesh, "axis").normals[0], -1, atol=ROUND_OFF)


@pytest.mark.parametrize(
    ("r_i", "r_o"), [(0.0, 1.0), (-1.0, 1.0), (1.0, 1.0), (2.0, 1.0), (float("nan"), 1.0)]
)
def test_radii_that_are_no_ring_are_refused(r_i, r_o):
    with pytest.raises(ValueError, match="0 < r_i < r_o"):
        half_race(r_i=r_i, r_o=r_o, zone=0.01, refine=1)


@pytest.mark.parametrize(("r_o", "zone"), [(R_I + 0.9 * ZONE, ZONE), (10 * R_I, 0.51 * R_I)])
def test_a_zone_wider_than_the_wall_or_the_bore_allow_is_refused(r_o, zone):
    with pytest.raises(ValueError, match=r"zone <= r_i/2 and zone < r_o - r_i"):
        half_race(r_i=R_I, r_o=r_o, zone=zone, refine=1)
