"""Facets of a plane mesh with adjacent cells: points, normals and shape functions."""

from functools import cached_property

import numpy as np
from skfem import Basis, FacetBasis
from skfem.element import DiscreteField
from skfem.mesh import Mesh2D

from fem.plane.geometry import Array, Indices, jacobians, shapes_in


class Trace(FacetBasis):
    """Basis of the cells on one `side` of `facets`, evaluated at the facet parameters `X` (1, q).

    The class has the content of scikit-fem's `FacetBasis`, with two differences. First, the
    reference coordinates of a point of a facet are calculated from the corners of the facet.
    scikit-fem inverts the curved map by Newton's method to 1e-12 of a cell; round-off makes this
    impossible if cells are small relative to their distance from the origin. Second, shape
    functions are evaluated on demand.
    """

    def __init__(self, basis: Basis, facets: Indices, side: int, X: Array, W: Array) -> None:
        mesh: Mesh2D = basis.mesh
        self.mesh, self.elem, self.dofs, self.Nbfun = mesh, basis.elem, basis.dofs, basis.Nbfun
        self.mapping, self.doflocs = mesh.mapping(), basis.doflocs
        self.find, self.nelems, self.X, self.W = facets, facets.size, X, W
        self.tind, self.tind_normals = mesh.f2t[side, facets], mesh.f2t[0, facets]
        along = _tangents(mesh, facets, X[0])
        length = np.hypot(*along)
        self.dx = length * W
        outward = _outward(mesh, facets, self.tind_normals)[:, None] / length
        self.normals = DiscreteField(value=np.array([along[1], -along[0]]) * outward)

    @cached_property
    def shapes(self) -> tuple[Array, Array]:
        """Shape functions (n, m, q) and derivatives d/dx_i (2, n, m, q) at the points of facets."""
        places = _places(self.mesh, self.find, self.tind, self.X[0])
        return shapes_in(self.mesh, self.tind, self.elem.elem, places)

    @cached_property
    def basis(self) -> list[tuple[DiscreteField]]:
        """Shape functions in the form of scikit-fem, for each unknown of a cell."""
        N, slope = self.shapes
        found = []
        for k in range(self.Nbfun):
            node, component = divmod(k, self.elem.dim)
            value = np.zeros((self.elem.dim, *N.shape[1:]))
            grad = np.zeros((self.elem.dim, 2, *N.shape[1:]))
            value[component], grad[component] = N[node], slope[:, node]
            found.append((DiscreteField(value, grad),))
        return found

    def displacement(self, u: Array) -> tuple[Array, Array]:
        """Displacements u_i (2, m, q) at the points, and d_j u_i (2, 2, m, q), with i first."""
        N, slope = self.shapes
        local = u[self._unknowns]
        value = np.einsum("nmi,nmq->imq", local, N)
        return value, np.einsum("nmi,jnmq->ijmq", local, slope)

    def load(self, traction: Array) -> Array:
        """Forces (unknowns,) of `traction` (2, m, q): stress times the thickness at the points."""
        N, _ = self.shapes
        force = np.einsum("nmq,imq->nmi", N, traction * self.dx)
        return np.bincount(self._unknowns.ravel(), force.ravel(), self.N).astype(float)

    @property
    def _unknowns(self) -> Indices:
        """Unknowns (n, m, 2) of the cells."""
        dofs = np.asarray(self.element_dofs)
        return dofs.reshape(-1, self.elem.dim, dofs.shape[1]).swapaxes(1, 2)


def _tangents(mesh: Mesh2D, facets: Indices, s: Array) -> Array:
    """Tangents dx/ds (2, m, q) along `facets` at the parameters `s` (q,)."""
    start, end = mesh.p[:, mesh.facets[:, facets]].swapaxes(0, 1)[..., None]
    if not mesh.dofs.facet_dofs.size:
        return np.repeat(end - start, s.size, axis=2)
    middle = mesh.doflocs[:, mesh.dofs.facet_dofs[0, facets]][..., None]
    return np.asarray((start - middle) * (4 * s - 3) + (end - middle) * (4 * s - 1))


def _places(mesh: Mesh2D, facets: Indices, cells: Indices, s: Array) -> Array:
    """Reference coordinates (2, m, q) in `cells` of the points at the parameters `s` (q,)."""
    a, b = _ends(mesh, facets, cells)[..., None]
    return np.asarray(a * (1 - s) + b * s)


def _ends(mesh: Mesh2D, facets: Indices, cells: Indices) -> Array:
    """Reference coordinates (2 ends, 2, m) in `cells` of the start and end of `facets`."""
    corner, reference = mesh.t[:, cells], mesh.elem.refdom.p
    # the facet parameter runs from row 0 to row 1
    return np.array([
        reference[:, np.argmax(corner == end, axis=0)] for end in mesh.facets[:, facets]
    ])  # fmt: skip


def _outward(mesh: Mesh2D, facets: Indices, cells: Indices) -> Array:
    """Sign (m,): 1 if a cell is on the left of its facet, seen from start to end, otherwise -1."""
    a, b = _ends(mesh, facets, cells)
    middle = mesh.elem.refdom.p.mean(axis=1, keepdims=True)
    (x, y), (u, v) = b - a, (a + b) / 2 - middle
    _, det = jacobians(mesh, middle, cells)
    return np.sign((y * u - x * v) * det[:, 0])
