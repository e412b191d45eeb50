r"""Geometrically exact plane beam elements (Reissner 1972, Simo 1985), evaluated together.

The section at the reference length s rotates by phi. t and n are the tangent and normal of the
undeformed curve, rotated by phi; r is the current position:

.. math:: \varepsilon = t\cdot r' - 1, \quad \gamma = n\cdot r', \quad \kappa = \phi', \qquad
   U = \tfrac12\int EA\,\varepsilon^2 + GA\,\gamma^2 + EI\,\kappa^2\; ds

Rotations are additive in the plane. Interpolated rotations therefore represent a rigid rotation
without strain. Reduced integration (one Gauss point for two nodes, two for three) prevents locking.
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csc_array

from fem.beam.section import Array, Indices, Section

Extended = NDArray[np.longdouble]
# Strains are differences of nearly equal numbers: in double precision a member with
# EA L^2/EI = 1e8 would have round-off errors of 1e-6 EI/L^2 in axial forces.


@dataclass(frozen=True)
class Elements:
    """Reference state and assembly of m elements with k nodes and q Gauss points each.

    `nodes` (m, k), `shape` (q, k), `slope` (m, q, k) d shape/ds, `tangent` (m, q, 2),
    `weight` (m, q) reference length of the Gauss points, `moduli` (m, 1, 3): EA, GA, EI.
    """

    count: int  # nodes of the frame
    nodes: Indices
    shape: Extended
    slope: Extended
    tangent: Extended
    weight: Array
    moduli: Array
    _fields: Array = field(init=False)
    _dofs: Indices = field(init=False)
    _place: Indices = field(init=False)
    _rows: Indices = field(init=False)
    _starts: Indices = field(init=False)
    _unit: Extended = field(init=False)  # 1 within round-off, so that there is no strain at rest

    def __post_init__(self) -> None:
        m, k = self.nodes.shape
        q = len(self.shape)
        fields = np.zeros((m, q, 4, k, 3))  # x', y', phi, phi' of the nodal unknowns
        fields[:, :, 0, :, 0] = fields[:, :, 1, :, 1] = fields[:, :, 3, :, 2] = self.slope
        fields[:, :, 2, :, 2] = self.shape
        dofs = (3 * self.nodes[:, :, None] + np.arange(3)).reshape(m, -1)
        rows = np.repeat(dofs, 3 * k, axis=1).ravel()
        columns = np.tile(dofs, (1, 3 * k)).ravel()
        size = 3 * self.count
        entries, place = np.unique(columns * size + rows, return_inverse=True)
        starts = np.searchsorted(entries, size * np.arange(size + 1))
        self.__dict__.update(
            _fields=fields.reshape(m, q, 4, 3 * k), _dofs=dofs.ravel(), _place=place,
            _rows=entries % size, _starts=starts,
            _unit=(self.tangent**2).sum(axis=-1),
        )  # fmt: skip

    @property
    def noise(self) -> float:
        """Error of the nodal forces due to round-off of strains, per unit of displacement."""
        steepest = self.moduli.max(axis=2) * abs(self.slope).sum(axis=2).astype(float)
        return float(np.finfo(np.longdouble).eps * np.linalg.norm(steepest))

    def strains(self, u: Extended) -> tuple[Array, Array, Array]:
        """Strains (m, q, 3), r' (m, q, 2) and tangent t (m, q, 2) for displacements u (n, 3)."""
        at = u[self.nodes]
        stretch = self.tangent + self.slope @ (at[:, :, :2] - at[:, :1, :2])
        phi = at[:, :, 2] @ self.shape.T
        c, s = np.cos(phi), np.sin(phi)
        x, y = self.tangent[..., 0], self.tangent[..., 1]
        t = np.stack([c * x - s * y, s * x + c * y], axis=-1)
        along = (t * stretch).sum(axis=-1)
        across = t[..., 0] * stretch[..., 1] - t[..., 1] * stretch[..., 0]
        bend = (self.slope @ (at[:, :, 2:] - at[:, :1, 2:]))[..., 0]
        strain = np.stack([along - self._unit, across, bend], axis=-1)
        return strain.astype(float), stretch.astype(float), t.astype(float)

    def increments(self, strain: Array, t: Array) -> Array:
        """Derivatives (m, q, 3, 4) of strains with respect to x', y', phi, phi' at Gauss points."""
        S = np.zeros((*strain.shape[:2], 3, 4))
        S[..., 0, :2] = t
        S[..., 0, 2] = strain[..., 1]
        S[..., 1, 0], S[..., 1, 1] = -t[..., 1], t[..., 0]
        S[..., 1, 2] = -1 - strain[..., 0]
        S[..., 2, 3] = 1
        return S

    def change(self, S: Array, step: Array) -> Array:
        """Linear change of the strains (m, q, 3) for a displacement step (n, 3)."""
        local = step[self.nodes].reshape(len(self.nodes), 1, -1, 1)
        return (S @ (self._fields @ local))[..., 0]

    def forces(self, S: Array, stress: Array) -> tuple[Array, Array]:
        """Internal forces (3n,) due to N, V, M (m, q, 3), and forces of each element (m, k, 3)."""
        local = (S * (stress * self.weight[..., None])[..., None]).sum(axis=2)
        nodal = (self._fields * local[..., None]).sum(axis=(1, 2))
        total = np.zeros(3 * self.count)
        total += np.bincount(self._dofs, nodal.ravel(), total.size)
        return total, nodal.reshape(*self.nodes.shape, 3)

    def change_of_forces(
        self, S: Array, strain: Array, t: Array, stress: Array, step: Extended
    ) -> Array:
        """Linear change of the internal forces (3n,) for a displacement step (n, 3), at `stress`.

        `stress` are N, V, M (m, q, 3). The result equals `tangent_stiffness` times the step,
        without the round-off of stiff directions.
        """
        return self.change_with(S, self.geometric(strain, t, stress), step)

    def geometric(self, strain: Array, t: Array, stress: Array) -> Array:
        """Densities (m, q, 4, 4) of the geometric stiffness for the `stress` N, V, M."""
        A = np.zeros((*self.weight.shape, 4, 4))
        _add_geometric(A, strain, t, stress)
        return A

    def change_with(self, S: Array, A: Array, step: Extended) -> Array:
        """Result of `change_of_forces`, for given densities `A` of the geometric stiffness."""
        at = step[self.nodes]
        change = (self.slope @ (at - at[:, :1]))[..., [0, 1, 2, 2]]
        change[..., 2] = at[:, :, 2] @ self.shape.T
        bent = (S @ change[..., None])[..., 0].astype(float)
        local = (S * (self.moduli * bent)[..., None]).sum(axis=2)
        local += (A @ change.astype(float)[..., None])[..., 0]
        nodal = (self._fields * (local * self.weight[..., None])[..., None]).sum(axis=2)
        total = np.zeros(3 * self.count)
        total += np.bincount(self._dofs, nodal.sum(axis=1).ravel(), total.size)
        return total

    def tangent_stiffness(self, S: Array, strain: Array, t: Array, stress: Array) -> csc_array:
        """Tangent stiffness (3n, 3n): material part, and geometric part for `stress` N, V, M."""
        A = np.swapaxes(S, 2, 3) @ (S * self.moduli[..., None])
        _add_geometric(A, strain, t, stress)
        return self._assemble(A)

    def linear_forces(self, u: Array) -> Array:
        """Section forces N, V, M (m, q, 3) for small displacements `u` (n, 3)."""
        none = np.zeros((*self.weight.shape, 3))
        return self.moduli * self.change(self.increments(none, self.tangent.astype(float)), u)

    def initial_stress_stiffness(self, stress: Array) -> csc_array:
        """Geometric stiffness (3n, 3n) of the undeformed frame for N, V, M (m, q, 3).

        The rotation of the axial direction, in which a member is stiff, is omitted: the first-order
        term of this rotation, without the second-order term, would make a bent member with large EA
        too flexible.
        """
        return self._assemble(
            self.geometric(np.zeros_like(stress), self.tangent.astype(float), stress)
        )

    def _assemble(self, A: Array) -> csc_array:
        """Stiffness (3n, 3n) from densities (m, q, 4, 4)."""
        A = A * self.weight[..., None, None]
        m, q, _, width = self._fields.shape
        P = self._fields.reshape(m, q * 4, width)
        k = np.swapaxes(P, 1, 2) @ (A @ self._fields).reshape(m, q * 4, width)
        values = np.bincount(self._place, k.ravel(), self._rows.size)
        size = 3 * self.count
        return csc_array((values, self._rows, self._starts), shape=(size, size))


def _add_geometric(A: Array, strain: Array, t: Array, stress: Array) -> None:
    """Add to `A` the geometric stiffness due to N, V and the rotation of the section."""
    N, V = stress[..., 0], stress[..., 1]
    turn = np.stack([-N * t[..., 1] - V * t[..., 0], N * t[..., 0] - V * t[..., 1]], axis=-1)
    A[..., 2, :2] += turn
    A[..., :2, 2] += turn
    A[..., 2, 2] -= N * (1 + strain[..., 0]) + V * strain[..., 1]


def reference(points: Array, nodes: Indices, sections: list[Section]) -> Elements:
    """Straight elements (m, 2) or quadratic elements (m, 3) with the given sections.

    Raises ValueError for folded elements.
    """
    rule = np.polynomial.legendre.leggauss(nodes.shape[1] - 1)
    X = (np.asarray(rule[0], np.longdouble) + 1) / 2
    if nodes.shape[1] == 2:
        shape, slope = np.array([1 - X, X]), np.array([-np.ones_like(X), np.ones_like(X)])
        at_ends = np.array([[-1.0, 1.0], [-1.0, 1.0]])
    else:
        shape = np.array([(1 - X) * (1 - 2 * X), X * (2 * X - 1), 4 * X * (1 - X)])
        slope = np.array([4 * X - 3, 4 * X - 1, 4 - 8 * X])
        at_ends = np.array([[-3.0, -1.0, 4.0], [1.0, 3.0, -4.0]])
    corner = points[nodes].astype(np.longdouble)
    jacobian = np.einsum("enk,nq->eqk", corner - corner[:, :1], slope)
    length = np.hypot(jacobian[..., 0], jacobian[..., 1])
    chord = corner[:, 1] - corner[:, 0]
    forward = np.einsum("an,enk,ek->ea", at_ends, corner, chord)
    bad = (length.min(axis=1) <= 0) | (forward.min(axis=1) <= 0)
    if bad.any():
        raise ValueError(
            f"element {int(bad.argmax())} is folded or has no length: place its middle node "
            "between its ends"
        )
    moduli = np.array([[(s.EA, s.GA, s.EI)] for s in sections])
    return Elements(
        len(points), nodes, shape.T, slope.T / length[..., None], jacobian / length[..., None],
        np.asarray(length * rule[1] / 2, float), moduli,
    )  # fmt: skip
