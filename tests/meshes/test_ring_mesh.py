"""The quarter ring has the areas, lengths, normals and names of a quarter ring."""

from math import pi

import numpy as np
import pytest
from skfem import (
    Basis,
    ElementQuad1,
    FacetBasis,
    Functional,
    MeshQuad1,
    MeshQuad2,
)

from meshes.ring.quarter import quarter_ring

R_I, R_O = 0.04, 0.06  # [m]
R_M = 0.05
ROUND_OFF = 1e-12  # relative


@Functional
def one(w):
    return 1.0 + 0 * w.x[0]


def area(mesh, body=None):
    cells = None if body is None else mesh.subdomains[body]
    return one.assemble(Basis(mesh, ElementQuad1(), intorder=6, elements=cells))


def side(mesh, name):
    return FacetBasis(mesh, ElementQuad1(), intorder=6, facets=mesh.boundaries[name])


def length(mesh, name):
    return one.assemble(side(mesh, name))


@pytest.fixture(scope="module")
def mesh():
    return quarter_ring(r_i=R_I, r_o=R_O, refine=2)


def test_its_boundaries_and_bodies_have_their_names(mesh):
    assert set(mesh.boundaries) == {"bore", "middle", "rim", "x=0", "y=0"}
    assert set(mesh.subdomains) == {"inner half", "outer half"}


@pytest.mark.parametrize(
    ("order", "straight", "shape"),
    [(1, False, MeshQuad1), (2, False, MeshQuad2), (2, True, MeshQuad1)],
    ids=["linear", "quadratic", "quadratic, then straight"],
)
def test_order_and_straightness_choose_the_cells(order, straight, shape):
    mesh = quarter_ring(r_i=R_I, r_o=R_O, refine=1, order=order, straight=straight)
    assert type(mesh) is shape


@pytest.mark.parametrize(("straight", "order"), [(False, 4), (True, 2)], ids=["curved", "chords"])
def test_areas_and_lengths_converge_at_the_order_of_the_edges(straight, order):
    exact = {
        "inner half": pi / 4 * (R_M**2 - R_I**2),
        "outer half": pi / 4 * (R_O**2 - R_M**2),
        "bore": pi / 2 * R_I,
        "middle": pi / 2 * R_M,
        "rim": pi / 2 * R_O,
    }
    meshes = [quarter_ring(r_i=R_I, r_o=R_O, refine=refine, straight=straight) for refine in (1, 2)]
    for name, value in exact.items():
        measure = area if "half" in name else length
        coarse, fine = (measure(m, name) / value - 1 for m in meshes)
        assert np.log2(coarse / fine) == pytest.approx(order, abs=0.05), (name, coarse, fine)


def test_the_cuts_are_as_long_as_the_wall_is_thick(mesh):
    assert length(mesh, "x=0") == pytest.approx(R_O - R_I, rel=ROUND_OFF)
    assert length(mesh, "y=0") == pytest.approx(R_O - R_I, rel=ROUND_OFF)


def test_every_corner_of_a_circle_lies_on_it(mesh):
    for name, radius in (("bore", R_I), ("middle", R_M), ("rim", R_O)):
        corners = mesh.doflocs[:, np.unique(mesh.facets[:, mesh.boundaries[name]])]
        np.testing.assert_allclose(np.hypot(*corners), radius, rtol=ROUND_OFF)


def test_normals_point_out_of_the_wall(mesh):
    for name, sign in (("bore", -1), ("rim", 1)):
        x = np.asarray(side(mesh, name).global_coordinates())
        outwards = (side(mesh, name).normals * x).sum(axis=0) / np.hypot(*x)
        # the parabola's slope errs by the cube of half a cell, pi/96, and enters squared
        np.testing.assert_allclose(outwards, sign, atol=(pi / 96) ** 6)
    for name, normal in (("x=0", (-1, 0)), ("y=0", (0, -1))):
        found = np.moveaxis(side(mesh, name).normals, 0, -1)
        np.testing.assert_allclose(found, np.broadcast_to(normal, found.shape), atol=ROUND_OFF)


def test_the_halves_meet_in_the_middle(mesh):
    inner, outer = (set(mesh.subdomains[f"{half} half"].tolist()) for half in ("inner", "outer"))
    assert not inner & outer
    assert len(inner | outer) == mesh.nelements
    for cells in mesh.f2t[:, mesh.boundaries["middle"]].T:
        assert len(inner & set(cells.tolist())) == len(outer & set(cells.tolist())) == 1


def test_refining_halves_every_cell():
    coarse, fine = (quarter_ring(r_i=R_I, r_o=R_O, refine=refine) for refine in (1, 2))
    assert fine.nelements == 4 * coarse.nelements
    for name in coarse.boundaries:
        assert len(fine.boundaries[name]) == 2 * len(coarse.boundaries[name])
    corners = {tuple(p) for p in fine.doflocs[:, : fine.nvertices].T.round(12)}
    assert {tuple(p) for p in coarse.doflocs[:, : coarse.nvertices].T.round(12)} <= corners


@pytest.mark.parametrize(
    ("r_i", "r_o"), [(0.0, 1.0), (-1.0, 1.0), (1.0, 1.0), (2.0, 1.0), (float("nan"), 1.0)]
)
def test_radii_that_are_no_ring_are_refused(r_i, r_o):
    with pytest.raises(ValueError, match="0 < r_i < r_o"):
        quarter_ring(r_i=r_i, r_o=r_o, refine=1)


@pytest.mark.parametrize(
    ("r_i", "r_o"), [(1e-6, 2e-6), (1.0, 1.01), (1.0, 1.001), (1.0, 20.0), (50.0, 60.0)]
)
def test_cells_cover_a_ring_of_any_size_and_thickness_once(r_i, r_o):
    mesh = quarter_ring(r_i=r_i, r_o=r_o, refine=2)
    # a parabola over an arc of half angle t leaves out t^4 / 30 of its sector: Taylor series of
    # (sin(2 t) / 2 + 4/3 sin(t) (1 - cos(t))) / t; n cells make t = pi/4n, the next term is t^6
    t = pi / 4 / mesh.boundaries["bore"].size
    assert t <= pi / 96
    exact = pi / 4 * (r_o**2 - r_i**2) * (1 - t**4 / 30)
    assert area(mesh) == pytest.approx(exact, rel=t**6 + 1e-12)  # and the round-off of thin walls
