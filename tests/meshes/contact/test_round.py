"""Whole rings and discs close, have even cells on their circles and cover their areas once."""

from math import pi, sin

import numpy as np
import pytest
from skfem import Basis, ElementQuad1, FacetBasis, Functional, MeshQuad1, MeshQuad2

from fem.plane.geometry import check_unfolded, jacobians
from meshes.contact.round import full_disc, full_ring

R_I, R_O = 0.02, 0.03  # [m]
ROUND_OFF = 1e-12  # relative
GAUSS = np.stack(np.meshgrid(*[(0.5 + np.array([-1, 0, 1]) * np.sqrt(0.15))] * 2)).reshape(2, -1)


@Functional
def one(w):
    return 1.0 + 0 * w.x[0]


def ring(around, **changed):
    return full_ring(**{"r_i": R_I, "r_o": R_O, "around": around, "across": 3} | changed)


def disc(around, **changed):
    return full_disc(**{"R": R_O, "around": around} | changed)


SHAPES = {
    "ring": (ring, {"bore": (R_I, -1), "rim": (R_O, 1)}, pi * (R_O**2 - R_I**2)),
    "disc": (disc, {"rim": (R_O, 1)}, pi * R_O**2),
}  # circles by name: radius and outward direction; area
shapes = pytest.mark.parametrize(("make", "circles", "exact"), SHAPES.values(), ids=SHAPES)


@shapes
def test_circles_are_named_and_close_the_body(make, circles, exact):
    mesh = make(16)
    assert set(mesh.boundaries) == set(circles)
    outline = np.concatenate(list(mesh.boundaries.values()))
    np.testing.assert_array_equal(np.sort(outline), mesh.boundary_facets())
    # every vertex of a circle belongs to two facets of it: no seam is left open
    for facets in mesh.boundaries.values():
        assert set(np.bincount(mesh.facets[:, facets].ravel())) == {0, 2}


@pytest.mark.parametrize(("make", "body"), [(ring, "ring"), (disc, "disc")])
def test_the_body_has_its_name(make, body):
    mesh = make(16)
    assert set(mesh.subdomains) == {body}
    assert mesh.subdomains[body].size == mesh.nelements


@shapes
@pytest.mark.parametrize("around", [8, 24, 80])
def test_cells_are_even_around_and_their_nodes_lie_on_the_circle(make, circles, exact, around):
    mesh = make(around)
    for name, (radius, _) in circles.items():
        facets = np.asarray(mesh.boundaries[name])
        assert facets.size == around
        nodes = mesh.doflocs[:, mesh.dofs.get_facet_dofs(facets).flatten()]
        np.testing.assert_allclose(np.hypot(*nodes), radius, rtol=ROUND_OFF)
        a, b = mesh.p[:, mesh.facets[:, facets]].swapaxes(0, 1)
        np.testing.assert_allclose(np.hypot(*(b - a)), 2 * radius * sin(pi / around), rtol=1e-7)
        corners = {tuple(p) for p in (mesh.p[:, mesh.facets[:, facets]] / radius).reshape(2, -1).T}
        assert {(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)} <= corners


@shapes
@pytest.mark.parametrize(("straight", "order"), [(False, 4), (True, 2)], ids=["curved", "chords"])
def test_the_area_converges_at_the_order_of_the_edges(make, circles, exact, straight, order):
    coarse, fine = (
        one.assemble(Basis(make(n, straight=straight), ElementQuad1(), intorder=6)) / exact - 1
        for n in (24, 48)
    )
    assert np.log2(coarse / fine) == pytest.approx(order, abs=0.05), (coarse, fine)


@shapes
def test_normals_point_out_of_the_body(make, circles, exact):
    mesh = make(48)
    for name, (radius, sign) in circles.items():
        edge = FacetBasis(mesh, ElementQuad1(), facets=mesh.boundaries[name])
        outwards = (edge.normals * np.asarray(edge.global_coordinates())).sum(axis=0) / radius
        # the parabola's place and slope err by the cube of half a cell, pi/48, or less
        np.testing.assert_allclose(outwards, sign, atol=(pi / 48) ** 3)


@shapes
@pytest.mark.parametrize("around", [8, 40])
def test_no_cell_is_folded_or_turned_over(make, circles, exact, around):
    mesh = make(around)
    check_unfolded(mesh, GAUSS)
    assert jacobians(mesh, GAUSS)[1].min() > 0


def test_the_disc_has_cells_of_about_one_size():
    areas = (jacobians(disc(40), GAUSS)[1]).mean(axis=1)
    assert areas.max() < 4 * areas.min()


@shapes
def test_doubling_the_cells_around_keeps_the_corners(make, circles, exact):
    coarse, fine = (
        make(n, **({"across": n // 8} if make is ring else {}), order=1) for n in (16, 32)
    )
    assert fine.nelements == 4 * coarse.nelements
    gap = np.hypot(*(coarse.p[:, :, None] - fine.p[:, None, :])).min(axis=1)
    assert gap.max() < 1e-7 * R_O


@shapes
def test_order_and_straightness_choose_the_cells(make, circles, exact):
    kinds = [type(make(8, **c)) for c in ({"order": 1}, {"order": 2}, {"straight": True})]
    assert kinds == [MeshQuad1, MeshQuad2, MeshQuad1]


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"r_i": 0.0}, "0 < r_i < r_o"),
        ({"r_i": R_O}, "0 < r_i < r_o"),
        ({"r_o": float("nan")}, "0 < r_i < r_o"),
        ({"around": 10}, "multiple of 4 .* around=10"),
        ({"around": 0}, "multiple of 4 .* around=0"),
        ({"across": 0}, "one across.* across=0"),
    ],
)
def test_a_ring_that_is_none_is_refused(changed, message):
    with pytest.raises(ValueError, match=message):
        full_ring(**{"r_i": R_I, "r_o": R_O, "around": 8, "across": 1} | changed)


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"R": 0.0}, "R > 0"),
        ({"R": float("nan")}, "R > 0"),
        ({"R": float("inf")}, "R > 0"),
        ({"around": 12}, "multiple of 8 .* around=12"),
        ({"around": -8}, "multiple of 8 .* around=-8"),
    ],
)
def test_a_disc_that_is_none_is_refused(changed, message):
    with pytest.raises(ValueError, match=message):
        full_disc(**{"R": R_O, "around": 8} | changed)
