"""The quarter and the half disc have the places, names, areas and normals of discs."""

from math import pi

import numpy as np
import pytest
from skfem import Basis, ElementQuad1, FacetBasis, Functional

from meshes.contact.disc import half_disc, quarter_disc

R, ZONE = 0.01, 0.001  # [m]
ROUND_OFF = 1e-12  # relative
shapes = pytest.mark.parametrize("shape", [quarter_disc, half_disc])
sides = pytest.mark.parametrize("below", [False, True], ids=["above", "below"])


@Functional
def one(w):
    return 1.0 + 0 * w.x[0]


def area(mesh):
    return one.assemble(Basis(mesh, ElementQuad1(), intorder=6))


def side(mesh, name):
    return FacetBasis(mesh, ElementQuad1(), intorder=6, facets=mesh.boundaries[name])


def nodes(mesh, name):
    """Places of all nodes of a boundary, those between corners included."""
    return mesh.doflocs[:, mesh.dofs.get_facet_dofs(np.asarray(mesh.boundaries[name])).flatten()]


@shapes
@sides
def test_its_boundaries_and_its_body_have_their_names(shape, below):
    mesh = shape(R=R, zone=ZONE, refine=1, below=below)
    assert set(mesh.boundaries) == {"surface", "axis", "middle"}
    assert set(mesh.subdomains) == {"disc"}
    assert mesh.subdomains["disc"].size == mesh.nelements


@shapes
def test_the_outline_is_named_all_around(shape):
    mesh = shape(R=R, zone=ZONE, refine=1)
    outside = mesh.boundary_facets()
    named = np.concatenate(list(mesh.boundaries.values()))
    inside = np.setdiff1d(named, outside)
    np.testing.assert_array_equal(np.intersect1d(named, outside), np.sort(outside))
    assert set(inside) == (set(mesh.boundaries["axis"]) if shape is half_disc else set())


@shapes
@sides
@pytest.mark.parametrize("zone", [1e-3 * R, 0.1 * R, 0.5 * R])
def test_every_node_of_the_arc_lies_on_its_circle_and_of_the_cuts_on_them(shape, below, zone):
    mesh = shape(R=R, zone=zone, refine=2, below=below)
    centre = np.array([[0], [-R if below else R]])
    np.testing.assert_allclose(np.hypot(*(nodes(mesh, "surface") - centre)), R, rtol=ROUND_OFF)
    np.testing.assert_allclose(nodes(mesh, "axis")[0], 0, atol=ROUND_OFF * R)
    np.testing.assert_allclose(nodes(mesh, "middle")[1], centre[1, 0], rtol=ROUND_OFF)


@shapes
def test_straight_cells_have_their_corners_on_the_circle(shape):
    mesh = shape(R=R, zone=ZONE, refine=1, straight=True)
    np.testing.assert_allclose(np.hypot(*(nodes(mesh, "surface") - [[0], [R]])), R, rtol=ROUND_OFF)


@sides
def test_it_touches_the_origin_from_its_side(below):
    mesh = quarter_disc(R=R, zone=ZONE, refine=1, below=below)
    assert np.hypot(*mesh.p).min() == 0
    y = mesh.p[1]
    assert (y.min(), y.max()) == pytest.approx((-R, 0) if below else (0, R))
    assert (mesh.p[0].min(), mesh.p[0].max()) == pytest.approx((0, R))


@pytest.mark.parametrize(("shape", "quarters"), [(quarter_disc, 1), (half_disc, 2)])
@pytest.mark.parametrize(("straight", "order"), [(False, 4), (True, 2)], ids=["curved", "chords"])
def test_its_area_and_arc_converge_at_the_order_of_its_edges(shape, quarters, straight, order):
    meshes = [shape(R=R, zone=ZONE, refine=refine, straight=straight) for refine in (4, 8)]
    exact = {area: quarters * pi / 4 * R**2, arc: quarters * pi / 2 * R}
    for measure, value in exact.items():
        coarse, fine = (measure(mesh) / value - 1 for mesh in meshes)
        assert np.log2(coarse / fine) == pytest.approx(order, abs=0.05), (measure, coarse, fine)


def arc(mesh):
    return one.assemble(side(mesh, "surface"))


@sides
def test_normals_point_out_of_the_disc(below):
    mesh = quarter_disc(R=R, zone=ZONE, refine=4, below=below)
    arc, middle, axis = (side(mesh, name) for name in ("surface", "middle", "axis"))
    x = np.asarray(arc.global_coordinates()) - np.array([0, -R if below else R])[:, None, None]
    # the parabola's slope errs by less than the cube of a cell of 0.1 R, and enters squared
    np.testing.assert_allclose((arc.normals * x).sum(axis=0) / R, 1, atol=1e-6)
    np.testing.assert_allclose(middle.normals[1], -1 if below else 1, atol=ROUND_OFF)
    np.testing.assert_allclose(axis.normals[0], -1, atol=ROUND_OFF)


@sides
def test_the_half_disc_is_its_own_mirror_image(below):
    mesh = half_disc(R=R, zone=ZONE, refine=2, below=below)
    images = mesh.doflocs * [[-1], [1]]
    found, mirrored = (np.lexsort(places.round(12)) for places in (mesh.doflocs, images))
    np.testing.assert_allclose(mesh.doflocs[:, found], images[:, mirrored], atol=1e-9 * R)


def test_the_half_disc_is_one_body_of_two_quarters():
    quarter, half = (shape(R=R, zone=ZONE, refine=2) for shape in (quarter_disc, half_disc))
    on_axis = np.unique(quarter.facets[:, quarter.boundaries["axis"]]).size
    assert half.nelements == 2 * quarter.nelements
    assert half.nvertices == 2 * quarter.nvertices - on_axis
    assert half.boundaries["surface"].size == 2 * quarter.boundaries["surface"].size


@pytest.mark.parametrize("radius", [0.0, -1.0, 1.9 * ZONE, float("nan"), float("inf")])
@shapes
def test_a_radius_that_leaves_no_room_for_the_zone_is_refused(shape, radius):
    with pytest.raises(ValueError, match=rf"zone <= R/2, got zone=0.001 m, R={radius:g} m"):
        shape(R=radius, zone=ZONE, refine=1)
