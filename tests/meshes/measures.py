"""Lengths, areas, nodes and normals of plane meshes, by quadrature and by corners; folds."""

import numpy as np
from skfem import Basis, ElementQuad1, ElementTriP1, FacetBasis, Functional, MeshTri1

from fem.plane.geometry import check_unfolded, jacobians

GAUSS = np.stack(np.meshgrid(*[(0.5 + np.array([-1, 0, 1]) * np.sqrt(0.15))] * 2)).reshape(2, -1)


@Functional
def one(w):
    return 1.0 + 0 * w.x[0]


def element(mesh):
    return ElementTriP1() if isinstance(mesh, MeshTri1) else ElementQuad1()


def side(mesh, facets):
    """Quadrature on facets, or on a boundary by its name."""
    facets = mesh.boundaries[facets] if isinstance(facets, str) else facets
    return FacetBasis(mesh, element(mesh), intorder=6, facets=facets)


def measure(mesh, name=""):
    """Length of a boundary, area of a body, or of the whole without a name."""
    if name in mesh.boundaries:
        return one.assemble(side(mesh, name))
    cells = mesh.subdomains[name] if name else None
    return one.assemble(Basis(mesh, element(mesh), intorder=6, elements=cells))


def nodes(mesh, name):
    """Places of all nodes of a boundary, those between corners included."""
    return mesh.doflocs[:, mesh.dofs.get_facet_dofs(np.asarray(mesh.boundaries[name])).flatten()]


def vertices(mesh, name):
    return mesh.p[:, np.unique(mesh.facets[:, mesh.boundaries[name]])]


def cuts_apart(mesh, body, z):
    """Largest distance of nodes on the right cut, turned by 2 pi/z, from those on the left."""
    c, s = np.cos(2 * np.pi / z), np.sin(2 * np.pi / z)
    left = nodes(mesh, f"{body}.left")
    right = np.array([[c, -s], [s, c]]) @ nodes(mesh, f"{body}.right")
    left, right = (x[:, np.argsort(np.hypot(*x))] for x in (left, right))
    return np.hypot(*(right - left)).max()


def lengths(mesh, facets):
    """Of every facet, or of those of a boundary by its name, along its chord."""
    facets = mesh.boundaries[facets] if isinstance(facets, str) else facets
    a, b = (mesh.p[:, ends] for ends in mesh.facets[:, np.asarray(facets)])
    return np.hypot(*(b - a))


def areas(mesh):
    """Signed area of every quadrilateral by its corners."""
    x, y = mesh.p[:, mesh.t]
    return ((x[2] - x[0]) * (y[3] - y[1]) - (x[3] - x[1]) * (y[2] - y[0])) / 2


def assert_unfolded(mesh):
    check_unfolded(mesh, GAUSS)
    assert jacobians(mesh, GAUSS)[1].min() > 0
