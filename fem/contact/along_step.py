"""Result along z of a step of a contact problem."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from fem.contact.along import Pull
from fem.contact.along_interface import AlongInterface
from fem.contact.cone import Residual
from fem.plane.discretisation import Array


@dataclass(frozen=True, kw_only=True)
class AlongStep:
    """Displacements and forces along z in equilibrium.

    For nodes with friction: `traction` (r,) [stress] on the master, `w` (r,) weighted slips of this
    step, `slips_before` (r,) weighted slips before it. `shift` (k,) are shifts of bodies supported
    by friction only. `residual` is the violation of the laws by the whole step.
    """

    interface: AlongInterface
    pull: Pull
    traction: Array
    shift: Array
    w: Array
    slips_before: Array
    residual: Residual

    @property
    def slips(self) -> Array:
        """Weighted slips (r,) since the mesh."""
        return self.slips_before + self.w

    @cached_property
    def u(self) -> Array:
        """u_z (nodes,): vertices, nodes on edges and in cells, obstacles."""
        i = self.interface
        return i.bodies.displacements(self.pull, i.C.T @ self.traction, self.shift)

    @property
    def strain_energy(self) -> float:
        """Strain energy of the shear along z [force x length]."""
        return self.interface.bodies.strain_energy(self.u)

    def reaction(self, boundary: str) -> float:
        """Force along z that the support of a boundary, or of an obstacle, exerts."""
        forces = self.pull.f + self.interface.rows.T @ self.traction
        return self.interface.bodies.reaction(boundary, self.u, forces)

    def stress(self) -> Array:
        """Mean shear stresses (cells, 2), xz and yz, of every cell."""
        cells = self.interface.bodies.bodies.cells
        weight = cells.dx / cells.dx.sum(axis=1, keepdims=True)
        grad = (self.interface.bodies.gradient(self.u) * weight[..., None]).sum(axis=1)
        G = self.interface.bodies.bodies.mu
        return np.asarray(G[:, None] * grad)
