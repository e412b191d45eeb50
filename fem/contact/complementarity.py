"""One kernel for every contact problem: unilateral contact with Coulomb friction, condensed.

Unknown are the multipliers l = (normal, tangential) and amplitudes a of the rigid motions that
only contact holds. Weighted gaps and slips depend on them linearly, and the motions' equilibrium
closes the system:

    w = w_0 + B l + D a,    e + D' l = 0.

Normal rows: l_n >= 0, w_n >= 0, l_n w_n = 0. Tangential rows, each beside a normal one:
|l_t| <= mu l_n, and l_t opposes w_t where it reaches that bound.

Primal-dual active sets: every row is in one state (open, stick, slip to either side), the linear
system of the states is solved, and rows that contradict their state change it, all together while
their number falls, singly where it does not (block principal pivoting, Judice and Pires 1994;
finite without friction). The motions start on weak springs that are let go step by step.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls

from fem.plane.discretisation import Array, Indices

OPEN, STICK, FORWARD, BACKWARD = 0, 1, 2, 3  # slip states by the sign of l_t: + and -
SIGN = np.array([0.0, 0.0, 1.0, -1.0])
SPRINGS = (1e-2, 1e-4, 1e-7)  # of the contact's own stiffness
TOLERANCE = 1e-11
BALANCED = 1e-13
PATIENCE = 10  # full exchanges without progress before single ones
MAX_EXCHANGES = 100
FEW, GROUP = 24, 4  # rows that need no coarse start, and how many are taken in one for it
MAX_RELEASES = 60


@dataclass(frozen=True)
class Rest:
    """A solved contact: `multipliers` (n,), `motion` (k,), `states` (normal rows,).

    `changes` lists how many rows changed their state, iteration by iteration.
    """

    multipliers: Array
    motion: Array
    states: NDArray[np.int8]
    changes: tuple[int, ...]


@dataclass(frozen=True, kw_only=True)
class Complementarity:
    """`B` (n, n), `D` (n, k) as above; the first m rows are normal ones.

    `friction` (m,) is mu of each normal row; row `partner` (m,) is its tangential one, or -1.
    `part` (m,) numbers the surface that a normal row belongs to; rows follow each other along it.
    """

    B: Array
    D: Array
    friction: Array
    partner: Indices
    part: Indices

    def solve(self, w_0: Array, e: Array, start: NDArray[np.int8] | None = None) -> Rest:
        """Multipliers and motions under `w_0` (n,), `e` (k,), from given states or from none.

        ArithmeticError where the states keep changing, or rigid motions keep growing.
        """
        m = self.friction.size
        changes: list[int] = []
        if start is None and m > FEW:
            start = self._coarse_states(w_0, e)
        states = np.zeros(m, np.int8) if start is None else start.copy()
        motion = np.zeros(self.D.shape[1])
        stiffness = self._stiffness()
        springs = SPRINGS if self.D.shape[1] else (0.0,)
        for spring in springs[-1:] if states.any() else springs:
            multipliers, motion, states = self._settle(
                w_0, e, motion, spring * stiffness, states, changes
            )
        for _ in range(MAX_RELEASES):
            size = np.abs(e).sum() + np.abs(self.D.T) @ np.abs(multipliers)
            if np.all(np.abs(e + self.D.T @ multipliers) <= BALANCED * size):
                return Rest(multipliers, motion, states, tuple(changes))
            multipliers, motion, states = self._settle(
                w_0, e, motion, springs[-1] * stiffness, states, changes
            )
        raise ArithmeticError(
            "the contact does not come to rest: its forces still miss the loads by "
            f"{np.abs(e + self.D.T @ multipliers).max():.2e} after {len(changes)} iterations"
        )

    def unbalanced(self, e: Array) -> Array:
        """What no admissible contact forces can balance of the loads `e` (k,) on rigid motions."""
        m = self.friction.size
        normal = self.D[:m].T
        held = self.partner >= 0
        sideways = self.friction[held] * self.D[self.partner[held]].T
        cone = np.hstack([normal, normal[:, held] + sideways, normal[:, held] - sideways])
        size = np.abs(cone).max(axis=0)
        cone = cone[:, size > 1e-12 * size.max(initial=0)]
        cone /= np.hypot.reduce(cone, axis=0)
        share, _ = nnls(cone, -e, maxiter=100 * cone.shape[1])
        return e + cone @ share

    def _coarse_states(self, w_0: Array, e: Array) -> NDArray[np.int8] | None:
        """Where groups of rows in one would touch, without friction; None if that is not found.

        From there a few exchanges are left at the edges, instead of one for every row that the
        contact shrinks by.
        """
        m = self.friction.size
        first = np.searchsorted(self.part, self.part)
        _, group = np.unique(
            np.array([self.part, (np.arange(m) - first) // GROUP]), axis=1, return_inverse=True
        )
        count = int(group.max()) + 1
        start = np.searchsorted(group, np.arange(count))
        B = np.add.reduceat(np.add.reduceat(self.B[:m, :m], start, axis=0), start, axis=1)
        coarse = Complementarity(
            B=B, D=np.add.reduceat(self.D[:m], start, axis=0), friction=np.zeros(count),
            partner=np.full(count, -1), part=self.part[start],
        )  # fmt: skip
        try:
            found = coarse.solve(np.add.reduceat(w_0[:m], start), e)
        except ArithmeticError:
            return None
        return found.states[group]

    def _stiffness(self) -> float:
        """What the springs are measured by: the contact's own stiffness against rigid motions."""
        own = (self.D**2 / np.diag(self.B)[:, None]).sum(axis=0)
        return float(own.max(initial=0.0))

    def _settle(self, w_0, e, motion, spring, states, changes):
        """States that fit, with springs that pull the motions back to `motion`."""
        fewest, patience = states.size + 1, PATIENCE
        most = MAX_EXCHANGES + 50 * states.size
        for _ in range(most):
            multipliers, moved = self._linear(w_0, e, motion, spring, states)
            wanted = self._wanted(w_0, multipliers, moved, states)
            other = np.flatnonzero(wanted != states)
            changes.append(other.size)
            if not other.size:
                return multipliers, moved, states
            states = states.copy()
            if other.size < fewest:
                fewest, patience = other.size, PATIENCE
            elif patience > 0:
                patience -= 1
            else:
                other = other[-1:]
            states[other] = wanted[other]
        raise ArithmeticError(
            f"the contact did not converge: after {most} iterations {other.size} of "
            f"{states.size} points still change between open, stick and slip"
        )

    def _linear(self, w_0, e, motion, spring, states):
        """Multipliers and motions that `states` imply."""
        m, k = self.friction.size, self.D.shape[1]
        closed = np.flatnonzero(states != OPEN)
        stick = closed[(states[closed] == STICK) & (self.partner[closed] >= 0)]
        slip = closed[states[closed] >= FORWARD]
        own = np.concatenate([closed, self.partner[stick]])
        n = own.size
        columns = self.B[:, own]
        row_of = np.full(m, -1)
        row_of[closed] = np.arange(closed.size)
        drag = SIGN[states[slip]] * self.friction[slip]
        columns[:, row_of[slip]] += drag * self.B[:, self.partner[slip]]
        pull = self.D[own].T.copy()
        pull[:, row_of[slip]] += drag * self.D[self.partner[slip]].T
        A = np.block([[columns[own], self.D[own]], [pull, -spring * np.eye(k)]])
        try:
            x = np.linalg.solve(A, np.concatenate([-w_0[own], -e - spring * motion]))
        except np.linalg.LinAlgError:
            raise ArithmeticError(
                "the contact has no unique forces: supports or another pair fix the same nodes"
            ) from None
        multipliers = np.zeros(w_0.size)
        multipliers[own] = x[:n]
        multipliers[self.partner[slip]] = drag * x[row_of[slip]]
        return multipliers, x[n:]

    def _wanted(self, w_0, multipliers, motion, states):
        """The states (m,) that multipliers and gaps call for."""
        m = self.friction.size
        drawn = self.B @ multipliers
        w = w_0 + drawn + self.D @ motion
        tiny_w = TOLERANCE * (np.abs(w_0).max(initial=0) + np.abs(drawn).max(initial=0))
        normal = multipliers[:m]
        tiny = TOLERANCE * np.abs(normal).max(initial=0)
        wanted = states.copy()
        wanted[(states == OPEN) & (w[:m] < -tiny_w)] = STICK
        rough = self.partner >= 0
        tangential, slip = np.zeros(m), np.zeros(m)
        tangential[rough] = multipliers[self.partner[rough]]
        slip[rough] = w[self.partner[rough]]
        limit = self.friction * normal + tiny
        stick = (states == STICK) & rough
        wanted[stick & (tangential > limit)] = FORWARD
        wanted[stick & (tangential < -limit)] = BACKWARD
        wanted[(SIGN[states] * slip > tiny_w)] = STICK
        wanted[(states != OPEN) & (normal < -tiny)] = OPEN
        return wanted
