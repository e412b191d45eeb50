"""Bases on cells and boundaries of a plane mesh; quadrature preserves the order of convergence."""

from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from skfem import (
    Basis,
    Element,
    ElementQuad1,
    ElementQuad2,
    ElementTriP1,
    ElementTriP2,
    ElementVector,
    MeshQuad1,
    MeshTri1,
)
from skfem.assembly import Dofs
from skfem.assembly.basis.abstract_basis import AbstractBasis
from skfem.element import DiscreteField
from skfem.mesh import Mesh2D
from skfem.quadrature import get_quadrature

from fem.plane.axis import check_radii
from fem.plane.geometry import check_unfolded, jacobians
from fem.plane.incompressible import ElementTriP2Plus
from fem.plane.recent import Recent
from fem.plane.traces import Trace

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

ELEMENTS: dict[tuple[type, int], type[Element]] = {
    (MeshTri1, 1): ElementTriP1,
    (MeshTri1, 2): ElementTriP2,
    (MeshQuad1, 1): ElementQuad1,
    (MeshQuad1, 2): ElementQuad2,
}


def is_curved(mesh: Mesh2D) -> bool:
    """True if the cells of `mesh` have quadratic edges."""
    return mesh.doflocs.shape[1] > mesh.nvertices


NUMBERS: Recent[Dofs] = Recent(most=96, room=4e6)  # by cells; entries of the tables


class LateBasis(Basis):
    """Basis of scikit-fem whose shape functions are evaluated on demand."""

    def __init__(self, mesh: Mesh2D, elem: ElementVector, quadrature: tuple[Array, Array]) -> None:
        key = (type(mesh), type(elem.elem), mesh.t)
        dofs = NUMBERS.get(key, lambda: Dofs(mesh, elem), lambda dofs: dofs.element_dofs.size)
        AbstractBasis.__init__(self, mesh, elem, quadrature=quadrature, dofs=dofs)
        self.tind, self.nelems = None, mesh.nelements

    @cached_property
    def basis(self) -> list[tuple[DiscreteField]]:
        """Shape functions and their derivatives at the quadrature points."""
        return [self.elem.gbasis(self.mapping, self.X, k) for k in range(self.Nbfun)]

    @cached_property
    def dx(self) -> Array:
        """Area (m, q) that each quadrature point represents: weight times Jacobian determinant."""
        return np.abs(jacobians(self.mesh, self.X)[1]) * self.W


def degree_on(mesh: Mesh2D, degree: int | None) -> int:
    """Degree of the displacements: `degree` if given, otherwise the degree of the mesh."""
    return degree if degree is not None else 2 if is_curved(mesh) else 1


def vector_basis(
    mesh: Mesh2D, degree: int | None = None, *, turn: bool = False, mixed: bool = False
) -> Basis:
    """Basis of displacements of the given degree; by default the degree of the mesh.

    With `turn`, x is a radius. `mixed` selects elements for a projected dilatation. Raises
    ValueError for a degree other than 1 or 2, and if a cell of the mesh is folded or, with `turn`,
    crosses the axis.
    """
    degree = degree_on(mesh, degree)
    shape = MeshTri1 if isinstance(mesh, MeshTri1) else MeshQuad1
    if (shape, degree) not in ELEMENTS:
        raise ValueError(f"displacements must have degree 1 or 2, got degree={degree}")
    # Triangles: exact stiffness on straight cells, one order to spare on curved ones.
    # Quadrilaterals: 2 or 3 Gauss points per direction, the full rule of Q1 and Q2.
    order = 2 * degree if shape is MeshQuad1 or is_curved(mesh) else 2 * (degree - 1)
    element = ELEMENTS[shape, degree]
    if mixed and element is ElementTriP2:
        element, order = ElementTriP2Plus, order + 2  # its slopes are of degree 2, not 1
    # The weight 2 pi r has the degree of the edges, at most 2. Without these two orders the error
    # of the rule is a quarter of the energy's on straight six-node triangles, with them 2e-4.
    quadrature = get_quadrature(mesh.elem.refdom, order + 2 if turn else order)
    check_unfolded(mesh, quadrature[0])
    if turn:
        check_radii(mesh)
    return LateBasis(mesh, ElementVector(element()), quadrature)


def facet_basis(
    basis: Basis, facets: Indices, *, side: int = 0, points: Array | None = None
) -> Trace:
    """Basis restricted to `facets`, at Gauss points or at facet `points` in [0, 1]."""
    if points is None:
        t, w = np.polynomial.legendre.leggauss(4)
        X, W = (t[None] + 1) / 2, w / 2
    else:
        X, W = points[None], np.full(points.size, 1 / points.size)
    return Trace(basis, np.asarray(facets), side, X, W)


def named_facets(mesh: Mesh2D, name: str) -> Indices:
    """Facets of the boundary `name`. Raises ValueError for an unknown name."""
    if name not in (mesh.boundaries or {}):
        known = ", ".join(sorted(mesh.boundaries or {})) or "none"
        raise ValueError(f"the mesh has no boundary {name!r}; its boundaries: {known}")
    return np.asarray(mesh.boundaries[name])


def outer_facets(mesh: Mesh2D, name: str) -> Indices:
    """Facets of the outer boundary `name`. Raises ValueError if a facet lies inside the mesh."""
    facets = named_facets(mesh, name)
    if np.any(mesh.f2t[1, facets] >= 0):
        raise ValueError(
            f"boundary {name!r} lies inside the mesh and has no outward normal: "
            "use x and y as components of supports, and tractions as loads"
        )
    return facets


def named_cells(mesh: Mesh2D, name: str) -> Indices:
    """Cells of the body `name`. Raises ValueError for an unknown name."""
    if name not in (mesh.subdomains or {}):
        known = ", ".join(sorted(mesh.subdomains or {})) or "none"
        raise ValueError(f"the mesh has no body {name!r}; its bodies: {known}")
    return np.asarray(mesh.subdomains[name])
