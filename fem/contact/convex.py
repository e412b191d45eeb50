"""Minimum of a convex, piecewise quadratic function, by Newton's method."""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq
from scipy.sparse import csr_array, diags_array
from scipy.sparse.linalg import SuperLU, splu

from fem.plane.discretisation import Array

CONVERGED = 1e-10  # relative to the largest force
FULL = 1e-9  # relative to the slope at the start of a step: a full step leads to the least value
SPRINGS = 1e-7  # over the stiffness, for bodies without any support yet; a tenth of it at each step
LEAST_SPRINGS = 1e-13
DOUBLINGS = 60
MAX_STEPS = 100
ADRIFT = "the loads move a body that neither supports nor contact hold"
SUPERLU = {
    "permc_spec": "MMD_AT_PLUS_A", "diag_pivot_thresh": 0.0, "options": {"SymmetricMode": True},
}  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Piecewise:
    """Convex function J(v) = v A v / 2 - f v + sum_i w_i Psi_i(Z_i v + z_i).

    Psi_i' is its argument limited to the interval `low_i` to `high_i`. `A` (n, n) is symmetric; `f`
    is (n,), `Z` (rows, n); `z`, `weight` w, `low` and `high` are (rows,). `stiffness` (n,) is a
    positive measure of the size of A and Z.
    """

    A: csr_array
    f: Array
    Z: csr_array
    z: Array
    weight: Array
    low: Array
    high: Array
    stiffness: Array

    def cut(self, v: Array) -> Array:
        """Values (rows,) of Z v + z, limited to their intervals."""
        return np.clip(self.z + self.Z @ v, self.low, self.high)

    def least(self, v: Array) -> tuple[Array, int]:
        """Point (n,) of the minimum of J, iterated from `v` (n,), and the number of steps.

        Springs to the previous point affect the steps, but not the result. Raises ArithmeticError
        if J is not convex or has no minimum, or if the iteration does not converge.
        """
        for step in range(MAX_STEPS):
            push = self.Z.T @ (self.weight * self.cut(v))
            residual = self.f - self.A @ v - push
            size = max(np.abs(self.f).max(), np.abs(push).max())
            missed = np.abs(residual).max()
            if missed <= CONVERGED * size:
                return v, step
            springs = max(SPRINGS * 0.1**step, LEAST_SPRINGS)
            way = self._factor(v, springs).solve(residual)
            v = v + self._length(v, way, residual) * way
        if missed > size:  # round-off strains of bodies that move far away exceed all loads
            raise ArithmeticError(ADRIFT)
        raise ArithmeticError(
            f"the contact did not converge: after {MAX_STEPS} steps the error of the forces is "
            f"{missed / size:.1e} of the largest force, allowed {CONVERGED:.0e}"
        )

    def _factor(self, v: Array, springs: float) -> SuperLU:
        x = self.z + self.Z @ v
        moves = self.weight * ((self.low < x) & (x < self.high))
        H = self.A + self.Z.T @ (diags_array(moves) @ self.Z)
        factor = splu((H + diags_array(springs * self.stiffness)).tocsc(), **SUPERLU)
        if not np.all(factor.U.diagonal() > 0):
            raise ArithmeticError(
                "the stiffness of Nitsche's method must be positive definite: reduce alpha"
            )
        return factor

    def _length(self, v: Array, way: Array, residual: Array) -> float:
        """Factor of the step `way` (n,) for which J is least."""
        start, bend = -float(residual @ way), float(way @ (self.A @ way))
        before, rate = self.cut(v), self.Z @ way

        def slope(share: float) -> float:
            turned = self.weight * (self.cut(v + share * way) - before)
            return start + share * bend + float(turned @ rate)

        share = 1.0
        if abs(slope(share)) <= FULL * abs(start):
            return share
        for _ in range(DOUBLINGS):
            if slope(share) > 0:
                # on springs a body may have moved much too far
                return float(brentq(slope, 0.0, share, xtol=1e-300, rtol=1e-12, maxiter=1000))
            share *= 2
        raise ArithmeticError(ADRIFT)
