"""The condensed contact problem as a linear complementarity problem, solved by Lemke's method.

With w_t = w_t+ - w_t- and motions a = a+ - a-, the unknowns z = (l_n, mu l_n + l_t, w_t-, a+, a-)
are complementary to (w_n, w_t+, mu l_n - l_t, -(e + D'l), e + D'l) (Klarbring 1986). The matrix is
copositive: z'M z = l'B l + 2 mu l_n w_t-. If contact without friction can balance the loads, or if
no rigid motion is free, Lemke's method cannot end in a ray. A solution then exists for every mu.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from fem.contact.active_sets import StateEquations, States
from fem.contact.lemke import lemke
from fem.contact.system import BACKWARD, FORWARD, OPEN, STICK, ContactSystem
from fem.plane.discretisation import Array

COVERING_VECTORS = 8
SPREAD = 0.5  # relative to the covering vector's entries: breaks ties of symmetric problems


@dataclass(frozen=True)
class FrictionLcp:
    """Contact system on springs (k, k) as a linear complementarity problem.

    `w_0` (n,) are the gaps and slips without contact forces, `e` (k,) the loads on the rigid
    motions. The entries of the problem are scaled to about one.
    """

    system: ContactSystem
    w_0: Array
    e: Array
    spring: Array

    def candidates(self) -> Iterator[tuple[Array, Array, States]]:
        """Multipliers, motions and states that may solve the problem, for several covering vectors.

        For each vector: first the solution of the linear system of the final states, then the
        result of the pivots.
        """
        M, q = self.matrix, self.vector
        for seed in range(COVERING_VECTORS):
            d = 1 + SPREAD * np.random.default_rng(seed).random(q.size)
            z = lemke(M, q, d)
            if z is not None:
                multipliers, motion, states = self._unpacked(z)
                yield *self.polished(multipliers, motion, states), states
                yield multipliers, motion, states

    @cached_property
    def matrix(self) -> Array:
        """Matrix M (N, N) of the linear complementarity problem."""
        system, k = self.system, self.system.D.shape[1]
        m, r = system.friction.size, system.rough.size
        own, motions = system.scales
        Q, rows = self._tractions, self._rows
        D = own[:, None] * system.D * motions
        K = motions[:, None] * self.spring * motions
        M = np.zeros((m + 2 * r + 2 * k, m + 2 * r + 2 * k))
        slip, bound, a = m + np.arange(r), m + r + np.arange(r), m + 2 * r
        M[: m + r, : m + r] = (own[rows, None] * system.B[rows] * own) @ Q
        M[slip, bound] = 1.0
        M[bound, system.rough], M[bound, slip] = 2 * self._friction, -1.0
        signs = np.array([[1.0, -1.0]])
        M[: m + r, a:] = np.kron(signs, D[rows])
        M[a:, : m + r] = -np.kron(signs.T, D.T @ Q)
        M[a:, a:] = np.kron(signs.T @ signs, K)
        return M

    @cached_property
    def vector(self) -> Array:
        """Vector q (N,) of the linear complementarity problem; loads below round-off are zero."""
        own, motions = self.system.scales
        e = self.e if np.abs(self.e).max(initial=0.0) > self._round_off else 0 * self.e
        free = motions * e
        none = np.zeros(self.system.rough.size)
        return np.concatenate([(own * self.w_0)[self._rows], none, -free, free])

    @property
    def _round_off(self) -> float:
        return self.system.loads_at_round_off(self.w_0)

    @property
    def _rows(self) -> Array:
        """Rows of the system: normal rows, then the tangential rows of contacts with friction."""
        system = self.system
        return np.concatenate([np.arange(system.friction.size), system.partner[system.rough]])

    @cached_property
    def _friction(self) -> Array:
        """Coefficients of friction (r,) in the units of the scaled multipliers."""
        system, own = self.system, self.system.scales[0]
        rough = system.rough
        return system.friction[rough] * own[rough] / own[system.partner[rough]]

    @cached_property
    def _tractions(self) -> Array:
        """Matrix Q (n, m + r) of l = Q (l_n, mu l_n + l_t)."""
        system, m, r = self.system, self.system.friction.size, self.system.rough.size
        Q, t = np.zeros((len(system.B), m + r)), system.partner[system.rough]
        Q[np.arange(m), np.arange(m)] = 1.0
        Q[t, system.rough], Q[t, m + np.arange(r)] = -self._friction, 1.0
        return Q

    def _unpacked(self, z: Array) -> tuple[Array, Array, States]:
        system, k = self.system, self.system.D.shape[1]
        m, r = system.friction.size, system.rough.size
        own, motions = system.scales
        states = np.where(z[:m] > 0, STICK, OPEN).astype(np.int8)
        pressed, rough = z[system.rough] > 0, system.rough
        states[rough[pressed & (z[m : m + r] <= 0)]] = BACKWARD
        states[rough[pressed & (z[m + r : m + 2 * r] > 0)]] = FORWARD
        multipliers = own * (self._tractions @ z[: m + r])
        a = z[m + 2 * r :]
        return multipliers, motions * (a[:k] - a[k:]), states

    def polished(self, multipliers: Array, motion: Array, states: States) -> tuple[Array, Array]:
        """Solution of the linear system of `states`, nearest to the result of Lemke's method."""
        system = self.system
        equations = StateEquations.of(system, states, self.spring)
        scale = np.concatenate([system.scales[0][equations.own], system.scales[1]])
        A = scale[:, None] * equations.A * scale
        known = scale * np.concatenate([-self.w_0[equations.own], -self.e])
        x = np.concatenate([multipliers[equations.own], motion]) / scale
        try:
            x = x + np.linalg.solve(A, known - A @ x)
        except np.linalg.LinAlgError:
            x = x + np.linalg.lstsq(A, known - A @ x)[0]
        return equations.unpacked(scale * x, self.w_0.size)
