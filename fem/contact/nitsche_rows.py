"""Rows of Nitsche's method at the integration points: stresses of the slave, gaps and slips."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array, diags_array, vstack

from fem.contact.bodies import Bodies
from fem.contact.convex import Piecewise
from fem.contact.interface import Interface, Surfaces
from fem.contact.traction import traction_rows
from fem.plane.discretisation import Array, Indices
from fem.plane.geometry import jacobians


@dataclass(frozen=True, kw_only=True)
class Rows:
    """Normal rows at the n integration points of all pairs, then tangential rows.

    Only pairs with friction have tangential rows. From displacements, `stress` (rows, unknowns)
    gives the traction [stress] of the slave, and `motion` (rows, unknowns) the gap or slip
    [length]. `start` (rows,) is the gap or slip without displacement. `gamma` (rows,) is in
    [length/stress], `weight` (rows,) in [area]. `friction` (n,) are coefficients of friction.
    `rough` (rows - n,) are the points of the tangential rows.
    """

    stress: csr_array
    motion: csr_array
    start: Array
    gamma: Array
    weight: Array
    friction: Array
    rough: Indices

    def moved(self, u: Array) -> Array:
        """Gaps and slips (rows,) under the displacements `u` (unknowns,)."""
        return np.asarray(self.start + self.motion @ u)

    def limits(self, p: Array) -> tuple[Array, Array]:
        """Lower and upper limits (rows,) of tractions; the pressures `p` (n,) limit friction."""
        n, bound = self.friction.size, self.friction[self.rough] * p[self.rough]
        return np.concatenate([np.zeros(n), -bound]), np.concatenate([np.full(n, np.inf), bound])

    def forces(self, u: Array, tractions: Array) -> Array:
        """Contact forces (unknowns,) of the tractions `tractions` (rows,)."""
        push = self.motion.T @ (self.weight * tractions)
        # without resultant: rigid motions have no stress
        missed = self.gamma * (tractions - self.stress @ u)
        return np.asarray(push - self.stress.T @ (self.weight * missed))

    def energy(self, bodies: Bodies, f: Array, u_0: Array) -> Piecewise:
        """Function J of the free unknowns under forces and prescribed displacements.

        The limits of the tractions are not set.
        """
        T, n = bodies.unknowns.T, bodies.basis.N
        K = bodies.cells.stiffness()
        K.resize((bodies.count, bodies.count))
        weight = self.weight * self.gamma
        consistency = self.stress.T @ (diags_array(weight) @ self.stress)
        internal = np.zeros(bodies.count)
        internal[:n] = bodies.cells.internal_forces(u_0[:n])
        elastic = (T.T @ K @ T).tocsr()
        rows = self.stress - diags_array(1 / self.gamma) @ self.motion
        Z = (rows @ T).tocsr()
        return Piecewise(
            A=(elastic - T.T @ consistency @ T).tocsr(),
            f=T.T @ (f - internal + consistency @ u_0), Z=Z,
            z=rows @ u_0 - self.start / self.gamma, weight=weight,
            low=np.zeros(weight.size), high=np.zeros(weight.size),
            stiffness=elastic.diagonal() + (Z**2).T @ weight,
        )  # fmt: skip


def rows(bodies: Bodies, surfaces: Surfaces, interface: Interface, alpha: float) -> Rows:
    """Rows of all pairs, with gamma = `alpha` h/(lambda + 2 mu).

    h is the depth of the cell behind a facet: its area divided by the length of the facet. The
    depth determines how large the stress on the facet can be for a given strain energy of the cell.
    """
    area = np.abs(jacobians(bodies.basis.mesh, bodies.basis.X)[1]) @ bodies.basis.W
    normal, tangential = [], []
    for pair, slave, m in zip(surfaces.pairs, surfaces.slaves, interface.mortars, strict=True):
        points, n = m.points, m.points.n
        cells = slave.cells[points.slave]
        depth = area[cells] / slave.lengths()[points.slave]
        gamma = alpha * depth / (bodies.lam + 2 * bodies.mu)[cells]
        stress = traction_rows(bodies, slave, points, n)
        normal.append((stress, m.normal, points.gap - pair.interference, gamma, m.weight))
        if pair.friction > 0:
            stress = traction_rows(bodies, slave, points, np.array([-n[1], n[0]]))
            tangential.append((stress, m.tangential, np.zeros(gamma.size), gamma, m.weight))
    stress, motion, start, gamma, weight = zip(*normal, *tangential, strict=True)
    friction = np.repeat(
        [p.friction for p in surfaces.pairs], [m.weight.size for m in interface.mortars]
    )
    return Rows(
        stress=vstack(stress).tocsr(), motion=vstack(motion).tocsr(),
        start=np.concatenate(start), gamma=np.concatenate(gamma), weight=np.concatenate(weight),
        friction=friction, rough=np.flatnonzero(friction > 0),
    )  # fmt: skip
