"""Equilibrium of a geometrically exact frame: residual, tangent, factorisation."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csc_array
from scipy.sparse.linalg import splu

from fem.beam.large_elements import Elements, Extended
from fem.beam.large_loading import Loading, Mask
from fem.beam.section import Array
from fem.beam.terms import Term


class ConvergenceError(ArithmeticError):
    """Newton's method did not converge; a smaller step may converge."""


@dataclass(frozen=True)
class Tangent:
    """Factorised stiffness, number of `negative` pivots, and `push` (3n,): du/d(load factor)."""

    K: csc_array
    solve: Callable[[Array], Array]
    push: Array
    negative: int


@dataclass(frozen=True)
class Response:
    """Energies, forces and stiffness of the frame at given displacements.

    `size` is the root sum of squares of all nodal forces: of elements, terms and loads.
    """

    strain_energy: float
    term_energy: float
    internal: Array
    residual: Array
    size: float
    K: csc_array
    predict: Callable[[Array], Array]  # section forces after a step


@dataclass(frozen=True)
class Balance:
    """Equilibrium equations for the load base + factor x pattern; `held`: prescribed components."""

    points: Array
    elements: Elements
    terms: Sequence[Term]
    base: Loading
    pattern: Loading
    held: Mask

    @property
    def length(self) -> float:
        """Diagonal [length] of the rectangle along x and y that encloses the frame.

        Displacements are divided by it for comparison with rotations, and couples for comparison
        with forces.
        """
        return float(np.hypot(*np.ptp(self.points, axis=0)))

    @property
    def weights(self) -> Array:
        """Weights (3n,) of u^2 and phi^2 in the nodal mean of (u/length)^2 + phi^2 [1]."""
        return np.tile([self.length**-2, self.length**-2, 1.0], len(self.points)) / len(self.points)

    def positions(self, u: Extended) -> Extended:
        x = u.copy()
        x[:, :2] += self.points
        return x

    def respond(self, u: Extended, factor: float, stress: Array | None = None) -> Response:
        """Response to the displacements `u` (n, 3) under the load `factor`.

        The geometric stiffness is computed for the section forces `stress`, by default for the
        section forces at `u`.
        """
        e = self.elements
        strain, _, t = e.strains(u)
        S, true = e.increments(strain, t), e.moduli * strain
        internal, parts = e.forces(S, true)
        size = self.measure(parts) ** 2
        K = e.tangent_stiffness(S, strain, t, true if stress is None else stress)
        energy = float(((true * strain).sum(axis=-1) * e.weight).sum()) / 2
        stored, x = 0.0, self.positions(u)
        for term in self.terms:
            part, force, slope = term.evaluate(x)
            stored, K = stored + float(part), csc_array(K + slope)
            internal = internal + np.asarray(force, float)
            size += self.measure(force.reshape(-1, 3)) ** 2
        acting = self.base.plus(factor, self.pattern)
        if (slope := acting.slope(u)) is not None:
            K = csc_array(K - slope)
        forces = acting.forces(u)
        size += self.measure(forces.reshape(-1, 3)) ** 2
        residual = np.where(self.held, 0.0, forces - internal)

        def predict(step: Array) -> Array:
            return e.moduli * (strain + e.change(S, step.reshape(-1, 3)))

        return Response(energy, stored, internal, residual, math.sqrt(size), K, predict)

    def factorise(self, u: Extended, K: csc_array) -> Tangent:
        """Factorised tangent of the free components. Raises ConvergenceError if it is singular."""
        free = ~self.held
        try:
            factor = splu(
                reduced(K, free),
                permc_spec="MMD_AT_PLUS_A",
                diag_pivot_thresh=0.0,
                options={"SymmetricMode": True},
            )
        except RuntimeError as error:  # SuperLU's error for a zero pivot
            raise ConvergenceError("the tangent stiffness is singular") from error

        def solve(f: Array) -> Array:
            step = np.zeros(f.size)
            step[free] = factor.solve(f[free])
            return step

        push = self.pattern.moved.copy()
        push += solve(self.pattern.forces(u) - K @ push)
        return Tangent(K, solve, push, int((factor.U.diagonal() < 0).sum()))

    def measure(self, f: Array) -> float:
        """Norm of forces and couples (..., 3); couples are divided by the length of the frame."""
        return math.sqrt(float((f[..., :2] ** 2).sum() + (f[..., 2] ** 2).sum() / self.length**2))


def reduced(K: csc_array, free: Mask) -> csc_array:
    """Matrix K reduced to its free rows and columns."""
    column = np.repeat(np.arange(K.shape[1]), np.diff(K.indptr))
    keep = free[K.indices] & free[column]
    number = np.cumsum(free) - 1
    starts = np.concatenate([[0], np.cumsum(np.bincount(column[keep], minlength=free.size)[free])])
    size = int(free.sum())
    return csc_array((K.data[keep], number[K.indices[keep]], starts), shape=(size, size))
