"""Joined meshes keep their nodes, cells, boundaries and bodies under the names of their parts."""

import numpy as np
import pytest
from skfem import (
    Basis,
    ElementQuad1,
    ElementTriP1,
    FacetBasis,
    Functional,
    MeshQuad1,
    MeshTri1,
)
from skfem.generic_utils import OrientedBoundary

from meshes.contact.block import block, half_block
from meshes.contact.disc import quarter_disc
from meshes.join import join
from meshes.ring.quarter import quarter_ring

ROUND_OFF = 1e-12  # relative
KINDS = [("quad", 2), ("tri", 1)]
every_kind = pytest.mark.parametrize(("cells", "order"), KINDS)


@Functional
def one(w):
    return 1.0 + 0 * w.x[0]


@Functional
def first_moment(w):
    return w.x[0] + 7 * w.x[1]


def element(mesh):
    return ElementTriP1() if isinstance(mesh, MeshTri1) else ElementQuad1()


def measures(mesh, boundary=None, body=None):
    """Size and first moment of a boundary, or of a body."""
    if boundary is not None:
        basis = FacetBasis(mesh, element(mesh), intorder=6, facets=mesh.boundaries[boundary])
    else:
        cells = None if body is None else mesh.subdomains[body]
        basis = Basis(mesh, element(mesh), intorder=6, elements=cells)
    return one.assemble(basis), first_moment.assemble(basis)


def pair(cells, order):
    low = block(x=(0.0, 3.0), y=(-1.0, 0.0), nx=3, ny=2, cells=cells, order=order)
    high = block(x=(0.5, 2.0), y=(0.0, 2.0), nx=2, ny=5, cells=cells, order=order)
    return {"low": low, "high": high}


def check_parts(whole, parts):
    """All that the parts have, the whole has, at the same places."""
    assert whole.nelements == sum(mesh.nelements for mesh in parts.values())
    assert whole.nvertices == sum(mesh.nvertices for mesh in parts.values())
    assert whole.doflocs.shape[1] == sum(mesh.doflocs.shape[1] for mesh in parts.values())
    assert set(whole.boundaries) == {f"{n}.{b}" for n, m in parts.items() for b in m.boundaries}
    bodies = {f"{n}.{b}" for n, m in parts.items() for b in m.subdomains}
    assert set(whole.subdomains) == {*parts, *bodies}
    for name, mesh in parts.items():
        assert measures(whole, body=name) == pytest.approx(measures(mesh), rel=ROUND_OFF)
        for own in mesh.boundaries:
            found = measures(whole, boundary=f"{name}.{own}")
            assert found == pytest.approx(measures(mesh, boundary=own), rel=ROUND_OFF, abs=1e-14)
        for own in mesh.subdomains:
            found = measures(whole, body=f"{name}.{own}")
            assert found == pytest.approx(measures(mesh, body=own), rel=ROUND_OFF)


@every_kind
def test_everything_keeps_its_place_and_gets_the_name_of_its_part(cells, order):
    parts = pair(cells, order)
    whole = join(parts)
    assert type(whole) is type(parts["low"])
    check_parts(whole, parts)


def test_curved_bodies_with_inner_boundaries_and_bodies_of_their_own_are_joined():
    ring = quarter_ring(r_i=1.0, r_o=2.0, refine=1)
    disc = quarter_disc(R=0.5, zone=0.1, refine=1)
    base = half_block(width=1.0, depth=1.0, zone=0.1, refine=1)
    parts = {"ring": ring, "disc": disc, "base": base}
    whole = join(parts)
    check_parts(whole, parts)
    assert {"ring.inner half", "ring.outer half", "ring"} <= set(whole.subdomains)


def test_the_side_of_an_oriented_boundary_is_kept():
    mesh = MeshQuad1.init_tensor(np.arange(4.0), np.arange(4.0))
    middle = mesh.elements_satisfying(lambda x: np.hypot(x[0] - 1.5, x[1] - 1.5) < 0.1)
    inner = mesh.facets_around(middle, flip=True)
    assert isinstance(inner, OrientedBoundary)
    mesh = mesh.with_boundaries({"inner": inner})
    plain = MeshQuad1.init_tensor(np.arange(2.0), np.arange(2.0))
    whole = join({"a": plain, "b": mesh})
    np.testing.assert_array_equal(whole.boundaries["b.inner"].ori, inner.ori)
    expected, found = (
        FacetBasis(m, ElementQuad1(), facets=m.boundaries[name])
        for m, name in ((mesh, "inner"), (whole, "b.inner"))
    )
    np.testing.assert_array_equal(found.normals, expected.normals)


def test_meshes_of_different_cells_are_refused_by_name():
    low = pair("quad", 2)["low"]
    high = pair("quad", 1)["high"]
    with pytest.raises(ValueError, match=r"one kind of cell.*low: MeshQuad2, high: MeshQuad1"):
        join({"low": low, "high": high})


def test_no_mesh_is_refused():
    with pytest.raises(ValueError, match="got none"):
        join({})
