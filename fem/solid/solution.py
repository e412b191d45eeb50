"""Solution of a problem in space, and quantities evaluated from it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from skfem.mesh import Mesh3D

from fem.solid.cells import Cells
from fem.solid.geometry import Array
from fem.solid.places import Place, Point, nodes_at
from fem.solid.supports import Conditions


@dataclass(frozen=True)
class Stresses:
    """Stresses `stress` (m, 3, 3) at quadrature points `x` (m, 3) with the `weight` (m,)."""

    x: Array
    stress: Array
    weight: Array


@dataclass(frozen=True)
class SolidSolution:
    """Displacements `u` (unknowns,) of `mesh`, in equilibrium with the loads.

    `internal` (unknowns,) are the forces of the stresses, `f` the forces of the loads; their
    difference is the reaction of the supports. `residual` is the energy of the solver's last
    correction relative to the total energy. This ratio is the square of the relative correction of
    the displacements.
    """

    mesh: Mesh3D
    cells: Cells
    u: Array
    internal: Array
    f: Array
    residual: float
    conditions: Conditions

    @cached_property
    def strain_energy(self) -> float:
        """Half the integral of stress times strain [force x length], computed cell by cell."""
        return self.cells.strain_energy(self.u)

    @property
    def potential_energy(self) -> float:
        """Strain energy minus the work of the loads, f . u [force x length].

        It is stationary at the solution. Without prescribed displacements, it is minus half the
        work of the loads; the compliance is then -2 x potential energy / force^2.
        """
        return self.strain_energy - float(self.f @ self.u)

    @property
    def displacement(self) -> Array:
        """Displacements (nodes, 3) of the nodes `mesh.doflocs`."""
        return self.u.reshape(-1, 3)

    def displacement_at(self, point: Point) -> Array:
        """Mean displacement (3,) of the nodes at `point`; a coordinate None means all values."""
        return np.asarray(self.displacement[nodes_at(self.mesh, point)].mean(axis=0))

    def reaction(self, place: Place) -> tuple[Array, Array]:
        """Force (3,) and moment (3,) about the origin that the conditions of `place` exert.

        If several supports fix the same node, each carries an equal share. The forces that keep
        displacements `uniform` have the sum zero.
        """
        nodes_at(self.mesh, place)  # an unknown place is an error, not a zero
        forces = self.conditions.forces(self.internal - self.f, place).reshape(-1, 3)
        moment = np.cross(self.mesh.doflocs.T, forces).sum(axis=0)
        return forces.sum(axis=0), np.asarray(moment)

    def stresses(self) -> Stresses:
        """Stresses at the quadrature points of all cells."""
        x = self.cells.N @ self.mesh.doflocs.T[self.cells.nodes]
        stress = self.cells.stress(self.u)
        return Stresses(x.reshape(-1, 3), stress.reshape(-1, 3, 3), self.cells.dx.ravel())
