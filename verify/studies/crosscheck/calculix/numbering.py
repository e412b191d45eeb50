"""Nodes and cells of a plane mesh in the numbering of calculix: vertices, then edges, from 1.

Six-node triangles are the same elements in calculix. Its eight-node quadrilaterals lack the centre
node of nine-node cells.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from skfem import Basis

from fem.contact.trace import Trace
from verify.studies.crosscheck.calculix.keywords import Array, Indices, Side


@dataclass(frozen=True)
class Numbering:
    """Numbers of the nodes and cells in a deck for the quadratic displacements of `basis`."""

    basis: Basis

    @cached_property
    def dofs(self) -> Indices:
        """Unknowns (2, nodes) of the deck's nodes, in the order of their numbers."""
        return np.hstack([np.asarray(self.basis.nodal_dofs), np.asarray(self.basis.facet_dofs)])

    @cached_property
    def of(self) -> Indices:
        """For each unknown, the number of its node in the deck, (unknowns,); 0 if there is none."""
        number = np.zeros(self.basis.N, int)
        number[self.dofs] = np.arange(1, self.count + 1)
        return number

    @cached_property
    def component(self) -> Indices:
        """Component of each unknown, (unknowns,), from 1; 0 if the deck has no such node."""
        component = np.zeros(self.basis.N, int)
        component[self.dofs] = [[1], [2]]
        return component

    @property
    def count(self) -> int:
        """Number of nodes of the deck."""
        return int(self.dofs.shape[1])

    @property
    def x(self) -> Array:
        """Positions (2, nodes) of the deck's nodes."""
        return np.asarray(self.basis.doflocs[:, self.dofs[0]])

    @cached_property
    def cells(self) -> Indices:
        """Node numbers (6 or 8, cells) of the cells, counter-clockwise: corners, then edges."""
        mesh = self.basis.mesh
        n = len(mesh.t)
        edges = self.basis.nodal_dofs.shape[1] + np.asarray(mesh.t2f)
        cells: Indices = 1 + np.vstack([mesh.t, edges])
        (a, b), (c, d) = np.diff(mesh.p[:, mesh.t[:3]], axis=1).swapaxes(0, 1)
        clockwise = a * d - b * c < 0
        turned = [0, *range(n - 1, 0, -1), *range(2 * n - 1, n - 1, -1)]
        cells[:, clockwise] = cells[:, clockwise][turned]
        return cells

    def body(self, name: str) -> Indices:
        """Cells of a body, numbered from 0; all cells if `name` is empty."""
        mesh = self.basis.mesh
        return np.asarray(mesh.subdomains[name]) if name else np.arange(mesh.nelements)

    def nodes(self, boundary: str) -> Indices:
        """Numbers of the nodes on a boundary, in ascending order."""
        number = np.unique(self.of[self.basis.get_dofs(boundary).all()])
        return number[number > 0]

    def sides(self, boundary: str) -> list[Side]:
        """Element and side, both from 1, of each facet of an outer boundary."""
        mesh = self.basis.mesh
        facets = mesh.boundaries[boundary]
        return self._sides(mesh.f2t[0, facets], mesh.facets[:, facets])

    def traced(self, trace: Trace) -> list[Side]:
        """Element and side, both from 1, of each facet of a contact surface."""
        return self._sides(trace.cells, trace.ends)

    def _sides(self, own: NDArray[np.int64], ends: NDArray[np.int64]) -> list[Side]:
        corners = self.cells[: len(self.cells) // 2, own]
        after = np.roll(corners, -1, axis=0)
        ends = np.sort(np.asarray(ends) + 1, axis=0)
        match = (np.minimum(corners, after) == ends[0]) & (np.maximum(corners, after) == ends[1])
        return list(zip((own + 1).tolist(), (match.argmax(axis=0) + 1).tolist(), strict=True))

    def spread(self, u: Array) -> Array:
        """Displacements (unknowns,) from the displacements `u` (nodes, 2) of the deck's nodes.

        The centre of a nine-node cell gets the displacement of the eight-node cell at this point.
        """
        found = np.zeros(self.basis.N)
        found[self.dofs] = u.T
        if self.basis.interior_dofs is not None and np.size(self.basis.interior_dofs):
            corners, edges = u[self.cells[:4] - 1], u[self.cells[4:] - 1]
            centre = edges.sum(axis=0) / 2 - corners.sum(axis=0) / 4
            found[np.asarray(self.basis.interior_dofs)[:2]] = centre.T
        return found
