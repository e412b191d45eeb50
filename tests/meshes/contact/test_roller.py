"""The half roller is a half disc, fine at both ends of the diameter across which it is pressed."""

from math import pi

import numpy as np
import pytest
from skfem import Basis, ElementQuad1, FacetBasis, Functional

from meshes.contact.roller import half_roller

R, ZONES = 0.005, (1e-4, 3e-4)  # [m]
ROUND_OFF = 1e-12  # relative


@Functional
def one(w):
    return 1.0 + 0 * w.x[0]


def nodes(mesh, name):
    """Places of all nodes of a boundary, those between corners included."""
    return mesh.doflocs[:, mesh.dofs.get_facet_dofs(np.asarray(mesh.boundaries[name])).flatten()]


def test_its_boundaries_and_its_body_have_their_names():
    mesh = half_roller(R=R, zones=ZONES, refine=1)
    assert set(mesh.boundaries) == {"near", "far", "cut"}
    assert set(mesh.subdomains) == {"roller"}
    assert mesh.subdomains["roller"].size == mesh.nelements
    named = np.sort(np.concatenate(list(mesh.boundaries.values())))
    np.testing.assert_array_equal(named, np.sort(mesh.boundary_facets()))


@pytest.mark.parametrize("zones", [ZONES, ZONES[::-1], (1e-6, 1e-6), (R / 2, 1e-5), (R / 2, R / 2)])
def test_every_node_of_its_arcs_lies_on_the_circle_and_of_the_cut_on_the_diameter(zones):
    mesh = half_roller(R=R, zones=zones, refine=2)
    for name, side in (("near", -1), ("far", 1)):
        x, y = nodes(mesh, name)
        np.testing.assert_allclose(np.hypot(x, y), R, rtol=ROUND_OFF)
        assert np.all(side * x > -ROUND_OFF * R)
        assert np.all(y > -ROUND_OFF * R)
    x, y = nodes(mesh, "cut")
    np.testing.assert_allclose(y, 0, atol=ROUND_OFF * R)
    assert (x.min(), x.max()) == pytest.approx((-R, R))


@pytest.mark.parametrize("zones", [ZONES, (R / 2, 1e-5), (1e-5, R / 2)])
def test_cells_are_not_folded_and_fill_half_a_disc_at_the_fourth_order(zones):
    excess = []
    for refine in (2, 4):
        basis = Basis(half_roller(R=R, zones=zones, refine=refine), ElementQuad1(), intorder=6)
        assert basis.dx.min() > 0
        excess.append(one.assemble(basis) / (pi / 2 * R**2) - 1)
    assert np.log2(excess[0] / excess[1]) == pytest.approx(4, abs=0.1)


@pytest.mark.parametrize(("name", "zone"), [("near", ZONES[0]), ("far", ZONES[1])])
def test_each_end_has_its_even_cells_on_its_own_zone(name, zone):
    cells, refine = 4, 3
    mesh = half_roller(R=R, zones=ZONES, refine=refine, cells=cells)
    y = np.unique(mesh.p[1, mesh.facets[:, mesh.boundaries[name]]])
    fine = y[y < zone * (1 + 1e-9)]
    assert fine.size == cells * refine + 1
    np.testing.assert_allclose(np.diff(np.arcsin(fine / R)), np.arcsin(zone / R) / fine[1:].size,
                               rtol=1e-6)  # fmt: skip


def test_normals_point_out_of_the_roller():
    mesh = half_roller(R=R, zones=ZONES, refine=4)
    for name in ("near", "far"):
        arc = FacetBasis(mesh, ElementQuad1(), intorder=6, facets=mesh.boundaries[name])
        # the parabola's slope errs by less than the cube of a cell of 0.1 R, and enters squared
        outward = (arc.normals * np.asarray(arc.global_coordinates())).sum(axis=0) / R
        np.testing.assert_allclose(outward, 1, atol=1e-6)


def test_both_halves_are_one_body():
    mesh = half_roller(R=R, zones=(ZONES[0], ZONES[0]), refine=2)
    images = mesh.doflocs * [[-1], [1]]
    found, mirrored = (np.lexsort(places.round(12)) for places in (mesh.doflocs, images))
    np.testing.assert_allclose(mesh.doflocs[:, found], images[:, mirrored], atol=1e-9 * R)
    inner = mesh.nfacets - mesh.boundary_facets().size
    assert 4 * mesh.nelements == 2 * inner + mesh.boundary_facets().size
    on_the_seam = np.isclose(mesh.p[0], 0, atol=1e-12)
    assert on_the_seam.sum() == np.unique(mesh.p[1, on_the_seam].round(12)).size


@pytest.mark.parametrize("zones", [(0.0, 1e-4), (1e-4, 0.51 * R), (float("nan"), 1e-4)])
def test_zones_that_do_not_fit_are_refused(zones):
    with pytest.raises(ValueError, match=r"fine zones of a roller need 0 < zone <= R/2, got zone="):
        half_roller(R=R, zones=zones, refine=1)
