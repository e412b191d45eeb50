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

    For nodes with friction: `traction` (r,) [stress] on the master, weighted slips `w` (r,) of this
    step, and weighted slips `slips_before` (r,) before this step. `shift` (k,) are the rigid shifts
    of bodies that have no support along z. `residual` is the violation of the contact laws by the
    solution.
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
        """Weighted slips (r,) accumulated since the undeformed mesh."""
        return self.slips_before + self.w

    @cached_property
    def u(self) -> Array:
        """Displacements u_z (nodes,) in the order vertices, edge nodes, cell nodes, obstacles."""
        i = self.interface
        return i.bodies.displacements(self.pull, i.C.T @ self.traction, self.shift)

    @property
    def strain_energy(self) -> float:
        """Strain energy of the shear along z [force x length]."""
        return self.interface.bodies.strain_energy(self.u)

    def reaction(self, boundary: str) -> float:
        """Force along z exerted by the support of a boundary or of an obstacle."""
        forces = self.pull.f + self.interface.rows.T @ self.traction
        return self.interface.bodies.reaction(boundary, self.u, forces)

    def stress(self) -> Array:
        """Mean shear stresses (cells, 2), xz and yz, of every cell."""
        cells = self.interface.bodies.bodies.cells
        weight = cells.dx / cells.dx.sum(axis=1, keepdims=True)
        grad = (self.interface.bodies.gradient(self.u) * weight[..., None]).sum(axis=1)
        G = self.interface.bodies.bodies.mu
        return np.asarray(G[:, None] * grad)
