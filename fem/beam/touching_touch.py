"""Geometry of contacts, the input of the contact law, and assembly of its results."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import csc_array

from fem.beam.section import Array, Indices


@dataclass(frozen=True)
class Touch:
    """Geometry of k contacts with m unknowns each; `dofs` (k, m) are the numbers of the unknowns.

    `gap` has the derivatives `opening` (k, m) and `turning` (k, m, m). The virtual slip `sliding`
    (k, m) has the derivatives `swerving` (k, m, m). `slip` since the last accepted state has the
    derivatives `slipping` (k, m).
    """

    slot: Indices
    dofs: Indices
    gap: Array
    opening: Array
    turning: Array
    sliding: Array
    swerving: Array
    slip: Array
    slipping: Array

    def without(self, last: int) -> "Touch":
        """Contacts without their last `last` unknowns, for a contact body that does not move."""
        keep = slice(None, -last)
        return replace(
            self,
            dofs=self.dofs[:, keep],
            opening=self.opening[:, keep],
            turning=self.turning[:, keep, keep],
            sliding=self.sliding[:, keep],
            swerving=self.swerving[:, keep, keep],
            slipping=self.slipping[:, keep],
        )


def along(weights: Array, direction: Array) -> Array:
    """Rows (k, 3 nodes) that map nodal displacements to their weighted sum along a direction."""
    parts = np.zeros((*weights.shape, 3))
    parts[:, :, :2] = weights[:, :, None] * direction[:, None, :]
    return parts.reshape(len(weights), 3 * weights.shape[1])


def turned(weights: Array) -> Array:
    """Rows (k, 3 nodes) that map nodal rotations to their weighted sum."""
    parts = np.zeros((*weights.shape, 3))
    parts[:, :, 2] = weights
    return parts.reshape(len(weights), 3 * weights.shape[1])


def outer(a: Array, b: Array) -> Array:
    """Outer products a b^T (k, m, m) of the rows of `a` and `b`."""
    return a[:, :, None] * b[:, None, :]


def scatter(size: int, dofs: Indices, force: Array, slope: Array) -> tuple[Array, csc_array]:
    """Force (size,) and tangent (size, size), assembled from the contacts."""
    rows = np.broadcast_to(dofs[:, :, None], slope.shape)
    columns = np.broadcast_to(dofs[:, None, :], slope.shape)
    K = csc_array((slope.ravel(), (rows.ravel(), columns.ravel())), shape=(size, size))
    return np.bincount(dofs.ravel(), force.ravel(), size).astype(float), K
