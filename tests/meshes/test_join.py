"""Joined meshes keep their nodes, cells, boundaries and bodies under the names of their parts."""

import numpy as np
import pytest
from skfem import ElementQuad1, FacetBasis, MeshQuad1
from skfem.generic_utils import OrientedBoundary

from meshes.contact.block import block, half_block
from meshes.contact.disc import quarter_disc
from meshes.join import join
from meshes.ring.quarter import quarter_ring
from tests.meshes.measures import nodes


def pair(cells, order):
    low = block(x=(0.0, 3.0), y=(-1.0, 0.0), nx=3, ny=2, cells=cells, order=order)
    high = block(x=(0.5, 2.0), y=(0.0, 2.0), nx=2, ny=5, cells=cells, order=order)
    return {"low": low, "high": high}


CURVED = {
    "ring": quarter_ring(r_i=1.0, r_o=2.0, refine=1),
    "disc": quarter_disc(R=0.5, zone=0.1, refine=1),
    "base": half_block(width=1.0, depth=1.0, zone=0.1, refine=1),
}  # fmt: skip


def cells_of(mesh, own):
    """Places of all nodes of cells (2, nodes, cells)."""
    return mesh.doflocs[:, mesh.dofs.element_dofs[:, own]]


@pytest.mark.parametrize("parts", [pair("quad", 2), pair("tri", 1), CURVED], ids=str)
def test_everything_keeps_its_place_and_gets_the_name_of_its_part(parts):
    whole = join(parts)
    assert type(whole) is type(next(iter(parts.values())))
    assert whole.nelements == sum(mesh.nelements for mesh in parts.values())
    assert whole.doflocs.shape[1] == sum(mesh.doflocs.shape[1] for mesh in parts.values())
    assert set(whole.boundaries) == {f"{n}.{b}" for n, m in parts.items() for b in m.boundaries}
    bodies = {f"{n}.{b}" for n, m in parts.items() for b in m.subdomains}
    assert set(whole.subdomains) == {*parts, *bodies}
    for name, mesh in parts.items():
        found = cells_of(whole, whole.subdomains[name])
        np.testing.assert_array_equal(found, cells_of(mesh, np.arange(mesh.nelements)))
        for own, cells in mesh.subdomains.items():
            found = cells_of(whole, whole.subdomains[f"{name}.{own}"])
            np.testing.assert_array_equal(found, cells_of(mesh, cells))
        for own in mesh.boundaries:
            found, expected = (
                {tuple(p) for p in nodes(m, b).T}
                for m, b in ((whole, f"{name}.{own}"), (mesh, own))
            )
            assert found == expected


def test_the_side_of_an_oriented_boundary_is_retained():
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


def test_meshes_of_different_cells_and_no_mesh_are_refused():
    with pytest.raises(ValueError, match=r"meshes to be joined must have the same kind"):
        join({"low": pair("quad", 2)["low"], "high": pair("quad", 1)["high"]})
    with pytest.raises(ValueError, match="got none"):
        join({})
