"""Solution of a shell problem."""

from dataclasses import dataclass

import numpy as np

from fem.shell.loads import edge_average
from fem.shell.reference import POINTS, Array, Indices, shapes
from fem.shell.strains import BENDING, MEMBRANE, SHEAR
from fem.shell.supports import Boundaries, nodes_of


@dataclass(frozen=True)
class ShellSolution:
    """Solution of a shell problem.

    `u` and `rotation` are (nodes, 3). `f` and `reactions` (nodes, 6) are forces and couples of the
    loads and of the supports (including ties); at free nodes, the reactions are round-off.
    `resultants` (cells, 9, 8) at the Gauss points are membrane forces [force/length], moments
    [force] and shear forces [force/length] in the directions of the unit `tangents` (cells, 9, 2,
    3). `residual` is the energy of the solver's last correction relative to the total energy. This
    ratio is the square of the relative correction of the displacements.
    """

    points: Array
    cells: Indices
    boundaries: Boundaries
    u: Array
    rotation: Array
    f: Array
    reactions: Array
    strain_energy: float
    residual: float
    thickness: Array
    resultants: Array
    tangents: Array

    @property
    def potential_energy(self) -> float:
        """Strain energy minus the work of the loads [force x length].

        It is stationary at the solution: its error is of second order in the error of u. Without
        prescribed displacements, it is minus half the work of the loads; the compliance is then -2
        x potential energy / force^2.
        """
        return (
            self.strain_energy
            - float(np.sum(self.f[:, :3] * self.u))
            - float(np.sum(self.f[:, 3:] * self.rotation))
        )

    @property
    def stations(self) -> Array:
        """Positions (cells, 9, 3) of the Gauss points to which resultants and stresses belong."""
        return np.einsum("qi,mic->mqc", shapes(POINTS).N, self.points[self.cells])

    @property
    def membrane_stress(self) -> Array:
        """Membrane stress tensors (cells, 9, 3, 3) in space, constant through the thickness."""
        return self._in_space(self.resultants[..., MEMBRANE] / self.thickness[:, None, None])

    @property
    def bending_stress(self) -> Array:
        """Bending stress tensors (cells, 9, 3, 3) on the face to which the normals point.

        The stresses on the opposite face have the opposite sign.
        """
        return self._in_space(
            6 * self.resultants[..., BENDING] / self.thickness[:, None, None] ** 2
        )

    @property
    def shear_stress(self) -> Array:
        """Transverse shear stress vectors (cells, 9, 3) in space, averaged over the thickness."""
        mean = self.resultants[..., SHEAR] / self.thickness[:, None, None]
        return np.asarray(np.einsum("mqi,mqic->mqc", mean, self.tangents))

    def _in_space(self, plane: Array) -> Array:
        e = self.tangents
        tensor = plane[..., [[0, 2], [2, 1]]]
        return np.asarray(np.einsum("mqic,mqij,mqjd->mqcd", e, tensor, e))

    def average(self, boundary: str) -> Array:
        """Displacements and rotations (6,) averaged along a boundary."""
        nodes_of(boundary, self.boundaries, len(self.points))
        values = np.hstack([self.u, self.rotation])
        return edge_average(self.points, np.asarray(self.boundaries[boundary]), values)

    def reaction(self, where: str | int) -> Array:
        """Support force and couple about the origin (6,) on a boundary or a node."""
        nodes = nodes_of(where, self.boundaries, len(self.points))
        force, couple = self.reactions[nodes, :3], self.reactions[nodes, 3:]
        return np.concatenate([
            force.sum(axis=0), (couple + np.cross(self.points[nodes], force)).sum(axis=0)
        ])  # fmt: skip
