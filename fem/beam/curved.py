r"""Plane curved Timoshenko beams in scikit-fem: quadratic displacements on quadratic geometry.

.. math:: \int EA\,\varepsilon\,\bar\varepsilon + GA\,\gamma\,\bar\gamma
          + EI\,\kappa\,\bar\kappa\; ds, \qquad
   \varepsilon = t\cdot u', \quad \gamma = n\cdot u' - \phi, \quad \kappa = \phi'

with the tangent t of the exact curve. Two Gauss points per element (reduced integration) prevent
locking by shear and membrane strains. The closed-form elements of `fem.beam.straight` are
independent of this module.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike
from scipy.sparse import csc_array
from skfem import Basis, BilinearForm, ElementLineP2, ElementVector, LinearForm, MeshLine1

from fem.beam.links import Link, ties
from fem.beam.section import (
    Array,
    Bodies,
    FrameSolution,
    Loads,
    Sections,
    Supports,
    check_elements,
    element_sections,
    solve_supported,
)


@BilinearForm
def stiffness(u, v, w):
    a = _strains(u.grad[:, 0] / w.ds, u[2], w.t)
    b = _strains(v.grad[:, 0] / w.ds, v[2], w.t)
    return (w.EA * a[0] * b[0] + w.GA * a[1] * b[1] + w.EI * a[2] * b[2]) * w.ds


@LinearForm
def section_work(v, w):
    eps, gamma, kappa = _strains(v.grad[:, 0] / w.ds, v[2], w.t)
    return (w.N * eps + w.V * gamma + w.M * kappa) * w.ds


def solve_curved_frame(
    points: ArrayLike,
    elements: ArrayLike,
    *,
    sections: Sections,
    supports: Supports,
    loads: Loads,
    bodies: Bodies | None = None,
    links: Sequence[Link] = (),
) -> FrameSolution:
    """Solve a plane frame of curved members. Every section needs a finite `GA`.

    Parameters
    ----------
    points, elements
        Nodes (n, 2), and elements (m, 3): two ends and the middle node of each element.
    sections, supports, loads, bodies, links
        See `fem.beam.straight.solve_frame`. Middle nodes can also be supported, loaded and linked,
        but links to points between nodes are not possible.

    Raises
    ------
    ValueError
        For unknown names, missing shear stiffness, folded elements, or possible rigid motions.
    ArithmeticError
        If the linear solution leaves a residual above 1e-6.
    """
    points, elements = np.asarray(points, float), np.asarray(elements, int)
    check_elements(len(points), elements)
    chosen = element_sections(len(elements), sections, bodies)
    if not np.all(np.isfinite([s.GA for s in chosen])):
        raise ValueError("a curved beam needs a finite shear stiffness GA in every section")
    basis, node_of = _basis(points, elements)
    tangent, ds = _geometry(points, elements, basis)
    moduli = {
        name: np.repeat([[getattr(s, name)] for s in chosen], ds.shape[1], axis=1)
        for name in ("EA", "EI", "GA")
    }
    K = stiffness.assemble(basis, t=tangent, ds=ds, **moduli)
    order = np.empty(basis.N, int)
    for component in range(3):
        order[3 * node_of + component] = np.concatenate(
            [basis.nodal_dofs[component], basis.interior_dofs[component]]
        )
    K = csc_array(csc_array(K)[order][:, order])

    def strains(u: Array) -> Array:
        """Axial strain, shear strain and curvature (3, m, q)."""
        dofs = np.empty(basis.N)
        dofs[order] = u.ravel()
        field = basis.interpolate(dofs)
        return np.array(_strains(field.grad[:, 0] / ds, np.asarray(field)[2], tangent))

    stiff = np.array([moduli["EA"], moduli["GA"], moduli["EI"]])

    def forces(strains: Array) -> tuple[float, Array]:
        N, V, M = stiff * strains
        energy = float(np.sum((stiff * strains**2).sum(axis=0) * ds * basis.dx)) / 2
        internal = section_work.assemble(basis, t=tangent, ds=ds, N=N, V=V, M=M)
        return energy, internal[order].reshape(-1, 3)

    f = np.zeros(3 * len(points))
    solved, strained = solve_supported(
        points, elements, K, f, supports, loads, strains, forces, ties(len(points), links)
    )
    N, V, M = stiff * strained
    forward = np.sign(np.diff(basis.mesh.p[0][basis.mesh.t], axis=0).T)  # against the numbers: -1
    return replace(
        solved,
        stations=np.einsum("qn,enk->eqk", _shape(basis), points[elements]),
        section_forces=np.stack([N, V, M * forward], axis=-1),  # only M depends on the direction
    )


def _shape(basis: Basis) -> Array:
    """Shape functions (q, 3) of the ends and the middle node at the Gauss points."""
    X = basis.X[0]
    return np.array([(1 - X) * (1 - 2 * X), X * (2 * X - 1), 4 * X * (1 - X)]).T


def _strains(slope, phi, tangent):
    """Axial strain, shear strain and curvature, from d(u_x, u_y, phi)/ds and the rotation phi."""
    t_x, t_y = tangent
    return (
        t_x * slope[0] + t_y * slope[1],
        -t_y * slope[0] + t_x * slope[1] - phi,
        slope[2],
    )


def _basis(points: Array, elements: Array) -> tuple[Basis, Array]:
    """P2 basis on a line mesh of vertex numbers, and the node of each unknown of the basis.

    The coordinate of a vertex is its number, because the line element of scikit-fem has one
    dimension; only `_geometry` contains the geometry. Members may therefore branch and form closed
    rings.
    """
    ends = np.unique(elements[:, :2])
    number = np.full(len(points), -1)
    number[ends] = np.arange(ends.size)
    t = np.ascontiguousarray(number[elements[:, :2]].T)
    mesh = MeshLine1(np.arange(ends.size, dtype=float)[None], t, sort_t=False)
    if not np.array_equal(mesh.t, t):
        raise ValueError("this version of scikit-fem is not supported: it reordered the line mesh")
    quadrature = np.polynomial.legendre.leggauss(2)
    rule = (quadrature[0][None] + 1) / 2, quadrature[1] / 2
    basis = Basis(mesh, ElementVector(ElementLineP2(), 3), quadrature=rule)
    return basis, np.concatenate([ends, elements[:, 2]])


def _geometry(points: Array, elements: Array, basis: Basis) -> tuple[Array, Array]:
    """Unit tangents (2, m, q) and ds per mesh coordinate (m, q) of the quadratic elements."""
    X = basis.X[0]
    slope = np.array([4 * X - 3, 4 * X - 1, 4 - 8 * X])  # of the shape functions: ends, middle
    jacobian = np.einsum("enk,nq->keq", points[elements], slope)
    length = np.hypot(*jacobian)
    ends = np.array([[-3.0, -1.0, 4.0], [1.0, 3.0, -4.0]])  # the slopes at both ends
    corner = points[elements]
    forward = np.einsum("an,enk,ek->ae", ends, corner, corner[:, 1] - corner[:, 0])
    if length.min() <= 0 or forward.min() <= 0:
        raise ValueError(
            "an element is folded or has no length: place its middle node between its ends"
        )
    stretch = np.diff(basis.mesh.p[0][basis.mesh.t], axis=0).T  # coordinate per reference unit
    # negative stretch: the element runs against the vertex numbers; ds keeps its sign with it
    return jacobian / length * np.sign(stretch), length / np.abs(stretch)
