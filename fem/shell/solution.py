"""Results of a solved shell."""

from dataclasses import dataclass

import numpy as np

from fem.shell.loads import edge_average
from fem.shell.reference import POINTS, Array, Indices, shapes
from fem.shell.strains import BENDING, MEMBRANE, SHEAR
from fem.shell.supports import Boundaries, nodes_of


@dataclass(frozen=True)
class ShellSolution:
    """A solved shell.

    `u` and `rotation` (nodes, 3); `f` and `reactions` (nodes, 6): forces and couples of the loads
    and of the supports (including ties), round-off at free nodes. `resultants` (cells, 9, 8) at the
    Gauss points: membrane forces [force/length], moments [force], shear forces [force/length] in
    the directions of the unit `tangents` (cells, 9, 2, 3). `residual` is the share of the energy in
    the last correction of the solver, the square of a relative displacement.
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
        """Strain energy less the work of the loads [force x length].

        Stationary at the solution: an error of u has a squared effect. Under loads alone, it is
        minus half their work: compliance = -2 x this / force^2.
        """
        return (
            self.strain_energy
            - float(np.sum(self.f[:, :3] * self.u))
            - float(np.sum(self.f[:, 3:] * self.rotation))
        )

    @property
    def stations(self) -> Array:
        """Gauss points (cells, 9, 3) of resultants and stresses."""
        return np.einsum("qi,mic->mqc", shapes(POINTS).N, self.points[self.cells])

    @property
    def membrane_stress(self) -> Array:
        """Tensors (cells, 9, 3, 3) in space, constant through the thickness."""
        return self._in_space(self.resultants[..., MEMBRANE] / self.thickness[:, None, None])

    @property
    def bending_stress(self) -> Array:
        """Tensors (cells, 9, 3, 3) on the face that the normals point to; minus that opposite."""
        return self._in_space(
            6 * self.resultants[..., BENDING] / self.thickness[:, None, None] ** 2
        )

    @property
    def shear_stress(self) -> Array:
        """Vectors (cells, 9, 3) in the surface, averages over the thickness."""
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
        """Force and couple about the origin (6,) that hold a boundary or node."""
        nodes = nodes_of(where, self.boundaries, len(self.points))
        force, couple = self.reactions[nodes, :3], self.reactions[nodes, 3:]
        return np.concatenate([
            force.sum(axis=0), (couple + np.cross(self.points[nodes], force)).sum(axis=0)
        ])  # fmt: skip
