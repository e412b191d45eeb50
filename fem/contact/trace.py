"""Trace of a mesh on a named boundary: positions, normals and displacements along its facets.

The parameter s of a facet runs from 0 to 1 with the body on the left. The outward normal is
therefore the tangent rotated by -90 deg.
"""

from dataclasses import dataclass, replace

import numpy as np
from skfem import Basis
from skfem.mesh import Mesh2D

from fem.contact.shapes import Motion, Shape
from fem.plane.discretisation import Array, Indices, is_curved, outer_facets

BESIDE = 1e-3  # relative to a facet: vertices farther from a shape do not lie on it
SMOOTH = 0.866  # cos 30 deg: facets that turn by less are one smooth wall


@dataclass(frozen=True)
class Trace:
    """Facets of a contact surface, in consecutive order.

    `nodes` (2, 3, m) are the positions of both ends and the middle, `ends` (2, m) vertex numbers,
    `dofs` (2, k, m) the unknowns x, y of the k = 2 or 3 nodes with displacements, ends first.
    `facets` (m,) and `cells` (m,) are numbered as in the mesh. `end_normals` (2, 2, m) are outward
    unit normals at both ends; adjacent facets of a smooth wall have a common normal.
    """

    nodes: Array
    ends: Indices
    dofs: Indices
    facets: Indices
    cells: Indices
    end_normals: Array
    shape: Shape | None

    @property
    def count(self) -> int:
        """Number of facets."""
        return self.facets.size

    @property
    def points(self) -> Array:
        """Positions (2, k m) of the nodes, in the order of `dofs`."""
        return self.nodes[:, : self.dofs.shape[1]].reshape(2, -1)

    @property
    def extent(self) -> float:
        """Length of the longer side of the rectangle around the surface."""
        return float(np.ptp(self.points, axis=1).max())

    def places(self, k: Indices, s: Array) -> Array:
        """Points (2, ...) at the parameters `s` (...) of the facets `k` (...)."""
        x = np.einsum("n...,in...->i...", _quadratic(s), self.nodes[:, :, k])
        return x if self.shape is None else self.shape.project(x)

    def tangents(self, k: Indices, s: Array) -> Array:
        """Tangents dx/ds (2, ...) of the meshed facets, without the exact shape."""
        slope = np.array([4 * s - 3, 4 * s - 1, 4 - 8 * s])
        return np.einsum("n...,in...->i...", slope, self.nodes[:, :, k])

    def normals(self, k: Indices, s: Array) -> Array:
        """Outward unit normals (2, ...) of the shape, or interpolated between facet ends."""
        if self.shape is not None:
            return self.shape.normal(self.places(k, s))
        n = self.end_normals[:, 0, k] * (1 - s) + self.end_normals[:, 1, k] * s
        return n / np.hypot(*n)

    def displacement_shapes(self, s: Array) -> Array:
        """Shape functions (k, ...) of the displacements at `s` (...), in the order of `dofs`."""
        return np.array([1 - s, s]) if self.dofs.shape[1] == 2 else _quadratic(s)

    def carriers(self) -> Indices:
        """Nodes (k, m) that carry the traction, numbered by their first unknowns."""
        return self.dofs[0]

    def hats(self, s: Array) -> Array:
        """Hat functions (k, ...) of the traction nodes at `s` (...), linear between neighbours."""
        if self.dofs.shape[1] == 2:
            return np.array([1 - s, s])
        return np.array([np.maximum(1 - 2 * s, 0), np.maximum(2 * s - 1, 0), 1 - np.abs(1 - 2 * s)])

    def lengths(self) -> Array:
        """Lengths (m,) of the chords of the facets."""
        return np.hypot(*(self.nodes[:, 1] - self.nodes[:, 0]))

    def arc(self, k: Indices, s: Array) -> Array:
        """Arc length (...) along chords from the start of the surface to `s` on facets `k`."""
        length = self.lengths()
        linked = np.concatenate([[False], self.ends[0, 1:] == self.ends[1, :-1]])
        before = np.cumsum(length) - length
        before -= np.maximum.accumulate(np.where(linked, 0.0, before))
        return before[k] + s * length[k]

    def sag(self) -> Array:
        """Upper bound (m,) of the distance of facets from curves with the normals `end_normals`."""
        if self.shape is not None:
            return np.zeros(self.count)
        length = np.hypot(*(self.nodes[:, 1] - self.nodes[:, 0]))
        turn = np.abs(cross(self.end_normals[:, 0], self.end_normals[:, 1]))
        middle = self.nodes[:, 2] - self.nodes[:, :2].mean(axis=1)
        straight = np.hypot(*middle) < 1e-9 * length
        # a chord misses its arc by h phi / 8, a parabola through three points by h phi^3 / 512
        return length * np.where(straight, turn / 8, turn**3 / 200)

    def moved(self, displacement: Array) -> "Trace":
        """Trace with its nodes displaced by `displacement` (unknowns,)."""
        u = displacement[self.dofs]
        if u.shape[1] == 2:
            u = np.concatenate([u, u.mean(axis=1, keepdims=True)], axis=1)
        nodes, shape = self.nodes + u, self.shape
        if shape is not None:
            shape = shape.moved(Motion.fitted(self.nodes.reshape(2, -1), u.reshape(2, -1)))
        normals = _end_normals(nodes, self.ends)
        return replace(self, nodes=nodes, end_normals=normals, shape=shape)

    def curvature(self) -> float:
        """Largest curvature [1/length] of the exact shape or, if there is none, of the facets.

        The curvature of a facet is the angle between the normals at its ends, divided by its
        length.
        """
        if self.shape is not None:
            return self.shape.curvature
        turn = np.abs(cross(self.end_normals[:, 0], self.end_normals[:, 1]))
        return float((turn / self.lengths()).max())


def trace_of(basis: Basis, name: str, shape: Shape | None = None) -> Trace:
    """Trace of the outer boundary `name`, optionally with its exact shape.

    Raises ValueError for an unknown boundary or a boundary inside the mesh.
    """
    mesh, facets = basis.mesh, _chained(basis.mesh, np.unique(outer_facets(basis.mesh, name)))
    cells, ends = mesh.f2t[0, facets], _oriented(mesh, facets)
    a, b = mesh.p[:, ends[0]], mesh.p[:, ends[1]]
    middle = (a + b) / 2
    if is_curved(mesh):
        middle = mesh.doflocs[:, mesh.dofs.facet_dofs[0, facets]]
    nodes = np.array([a, b, middle]).swapaxes(0, 1)
    dofs = [basis.nodal_dofs[:2, ends[0]], basis.nodal_dofs[:2, ends[1]]]
    if basis.facet_dofs is not None and np.size(basis.facet_dofs):
        dofs.append(basis.facet_dofs[:2, facets])
    trace = Trace(
        nodes, ends, np.array(dofs).swapaxes(0, 1), facets, cells, _end_normals(nodes, ends), shape
    )
    if shape is not None:
        _check_shape(trace, name, shape)
    return trace


def _check_shape(trace: Trace, name: str, shape: Shape) -> None:
    """Raise ValueError unless the vertices lie on `shape` and its normals point out of the body."""
    x = trace.nodes[:, :2]
    beside = np.hypot(*(shape.project(x) - x))
    astray = beside > BESIDE * trace.lengths()
    against = (shape.normal(x) * trace.end_normals).sum(axis=0) < 0
    if np.any(astray | against):
        i, k = np.argwhere(astray | against)[0]
        what = f"lies {beside[i, k]:.3g} beside it" if astray[i, k] else "has its body beyond it"
        raise ValueError(
            f"boundary {name!r} must have the shape {shape}, but its vertex at "
            f"({x[0, i, k]:.10g}, {x[1, i, k]:.10g}) {what}"
        )


def _oriented(mesh: Mesh2D, facets: Indices) -> Indices:
    """Start and end vertices (2, m) of `facets`, with the body on the left."""
    ends = mesh.facets[:, facets]
    a, b = mesh.p[:, ends[0]], mesh.p[:, ends[1]]
    inside = mesh.p[:, mesh.t[:, mesh.f2t[0, facets]]].mean(axis=1)
    return np.where(cross(b - a, inside - a) > 0, ends, ends[::-1])


def _chained(mesh: Mesh2D, facets: Indices) -> Indices:
    """Facets in consecutive order, one chain after the other."""
    start, end = _oriented(mesh, facets)
    from_vertex = dict(zip(start.tolist(), range(facets.size), strict=True))
    heads = np.flatnonzero(~np.isin(start, end)).tolist()
    order: list[int] = []
    seen = np.zeros(facets.size, bool)
    for head in (*heads, *range(facets.size)):  # closed curves have no head
        at: int | None = head
        while at is not None and not seen[at]:
            seen[at] = True
            order.append(at)
            at = from_vertex.get(int(end[at]))
    return facets[order]


def _quadratic(s: Array) -> Array:
    return np.array([(1 - s) * (1 - 2 * s), s * (2 * s - 1), 4 * s * (1 - s)])


def _end_normals(nodes: Array, ends: Indices) -> Array:
    """Normals (2, 2, m) at both ends of each facet; mean normals on a smooth wall."""
    a, b, middle = nodes.swapaxes(0, 1)
    t = np.array([4 * middle - 3 * a - b, 3 * b + a - 4 * middle])  # dx/ds at s = 0 and 1
    n = np.array([t[:, 1], -t[:, 0]])
    n /= np.hypot(*n)
    flat, at = n.reshape(2, -1), ends.ravel()
    smooth = flat.copy()
    order = np.argsort(at, kind="stable")
    first = np.flatnonzero(np.diff(at[order]) == 0)  # a vertex has at most two facets
    i, j = order[first], order[first + 1]
    one_wall = (flat[:, i] * flat[:, j]).sum(axis=0) > SMOOTH
    i, j = i[one_wall], j[one_wall]
    mean = flat[:, i] + flat[:, j]
    smooth[:, i] = smooth[:, j] = mean / np.hypot(*mean)
    return smooth.reshape(n.shape)


def cross(a: Array, b: Array) -> Array:
    return a[0] * b[1] - a[1] * b[0]
