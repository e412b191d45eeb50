"""Coulomb's circular cone: contact whose friction acts along the surface and along z at once.

Unknown are the multipliers l = (normal, tangential, along z) and amplitudes a of rigid motions and
of shifts along z, as in `complementarity`:

    w = w_0 + B l + D a,    e + D' l = 0.

Normal rows: l_n >= 0, w_n >= 0, l_n w_n = 0. At nodes with friction the vector (l_t, l_z) is no
longer than mu l_n, and opposes (w_t, w_z) where it reaches that bound. Equivalent is

    l_n = max(0, l_n - c_n w_n),   (l_t, l_z) = P((l_t, l_z) - c (w_t, w_z)),

with P the projection on the disc of radius mu max(0, l_n - c_n w_n). Newton's method solves these
with each node open, sticking or slipping as its projection has it (Alart and Curnier 1991). Its
direction of slip turns with the solution: states of their own do not end it.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from fem.contact.complementarity import (
    BACKWARD,
    FELT,
    FORWARD,
    OPEN,
    STAYING,
    STICK,
    Complementarity,
)
from fem.plane.discretisation import Array, Indices

SLIP = FORWARD
EXACT = 1e-9  # of the peak pressure and of the forces: what the solution may miss
BARE = 1e-24  # of the largest stiffness against a motion, in whose units others are
SPRING = 1e-7  # of the contact's own stiffness: holds shifts for the start


@dataclass(frozen=True)
class State:
    """Multipliers (n,) and motions (k,)."""

    multipliers: Array
    motion: Array


@dataclass(frozen=True, kw_only=True)
class Task:
    """Loads `w_0` (n,), `e` (k,), springs `K` (k, k) on the motions, and `friction` (m,)."""

    w_0: Array
    e: Array
    K: Array
    friction: Array


@dataclass(frozen=True)
class Residual:
    """What a solution misses of its laws.

    Of Coulomb's and of the complementarity of gap and pressure as a share of the largest pressure,
    of the equilibrium of rigid motions as a share of the forces on these.
    """

    coulomb: float
    complementarity: float
    equilibrium: float

    def __str__(self) -> str:
        return (
            f"Coulomb's law by {self.coulomb:.1e}, complementarity by {self.complementarity:.1e}, "
            f"equilibrium by {self.equilibrium:.1e}"
        )

    @property
    def largest(self) -> float:
        """The largest of the three."""
        return max(self.coulomb, self.complementarity, self.equilibrium)


@dataclass(frozen=True, kw_only=True)
class Cone:
    """`B` (n, n), `D` (n, k) as above; the first m rows are normal ones.

    `friction` (m,) is mu of each normal row; `rough` (r,) are the normal rows with friction, and
    the rows m to m + r and m + r to m + 2 r are theirs, tangential and along z.
    """

    B: Array
    D: Array
    friction: Array
    rough: Indices

    @classmethod
    def of(cls, plane: Complementarity, B_z: Array, D_z: Array) -> "Cone":
        """The plane system beside compliance `B_z` (r, r) and shifts `D_z` (r, k) along z."""
        (n, k), (r, k_z) = plane.D.shape, D_z.shape
        B, D = np.zeros((n + r, n + r)), np.zeros((n + r, k + k_z))
        B[:n, :n], B[n:, n:] = plane.B, B_z
        D[:n, :k], D[n:, k:] = plane.D, D_z
        return cls(B=B, D=D, friction=plane.friction, rough=np.flatnonzero(plane.partner >= 0))

    @property
    def _t(self) -> Indices:
        return self.friction.size + np.arange(self.rough.size)

    @property
    def _z(self) -> Indices:
        return self._t + self.rough.size

    @cached_property
    def _stiff(self) -> tuple[Array, Array]:
        """c_n (m,) and c (r,): pressures that close unit weighted gaps and slips."""
        own = np.diag(self.B)
        return 1 / own[: self.friction.size], 1 / np.sqrt(own[self._t] * own[self._z])

    @cached_property
    def own(self) -> Array:
        """The contact's own stiffness (k,) against motions."""
        return np.asarray((self.D**2 / np.diag(self.B)[:, None]).sum(axis=0))

    @cached_property
    def _felt(self) -> Array:
        """The part (k, k) of motions that the contact resists; facets alone resist the others."""
        own = self.D / np.sqrt(np.diag(self.B))[:, None]
        size, motions = np.linalg.eigh(own.T @ own)
        felt = motions[:, size > FELT * size.max(initial=0.0)]
        return felt @ felt.T

    def springs(self, share: float) -> Array:
        """Springs (k, k) on motions, of a share of the contact's own stiffness.

        Those that the contact hardly feels stay where they are.
        """
        neutral = np.eye(len(self._felt)) - self._felt
        return float(self.own.max(initial=0.0)) * (share * self._felt + STAYING * neutral)

    def use(self, multipliers: Array) -> Array:
        """Friction (r,) as a share of what the pressure allows, zero without pressure."""
        friction = np.hypot(multipliers[self._t], multipliers[self._z])
        most = self.friction[self.rough] * multipliers[self.rough]
        pressed = most > EXACT * most.max(initial=0.0)
        return np.where(pressed, friction / np.where(pressed, most, 1.0), 0.0)

    def missed(self, e: Array, at: State) -> float:
        size = np.abs(e) + np.abs(self.D.T) @ np.abs(at.multipliers)
        missed = np.abs(self._felt @ (e + self.D.T @ at.multipliers))
        return float(missed.max(initial=0.0) / (size.max(initial=0.0) or 1.0))

    def _trial(self, w_0: Array, at: State) -> tuple[Array, Array, Array]:
        """Gaps and slips w (n,), max(0, l_n - c_n w_n) (m,) and the friction's trial (2, r)."""
        m, (c_n, c) = self.friction.size, self._stiff
        w = w_0 + self.B @ at.multipliers + self.D @ at.motion
        pressure = np.maximum(at.multipliers[:m] - c_n * w[:m], 0.0)
        tau = np.array([self._t, self._z])
        return w, pressure, at.multipliers[tau] - c * w[tau]

    def error(self, task: Task, at: State) -> tuple[float, NDArray[np.int8]]:
        """How far `at` is from its projection, of the pressure, and the states (m,) of that."""
        _, pressure, trial = self._trial(task.w_0, at)
        normal, along, states = self._projected(at, pressure, trial, task.friction)
        balance = task.e + self.D.T @ at.multipliers - task.K @ at.motion
        reach = np.abs(self.D).sum(axis=0)
        size = max(pressure.max(initial=0.0), self._smallest(task.w_0, task.e))
        parts = normal.ravel(), along.ravel(), balance / np.where(reach > 0, reach, 1.0)
        return float(np.linalg.norm(np.concatenate(parts)) / size), states

    def _smallest(self, w_0: Array, e: Array) -> float:
        """A pressure that says nothing against the loads."""
        closing = np.abs(w_0) / np.diag(self.B)
        reach = np.abs(self.D).sum(axis=0)
        pulling = np.abs(e) / np.where(reach > 0, reach, 1.0)
        return EXACT * float(max(closing.max(initial=0.0), pulling.max(initial=0.0))) or 1.0

    def _projected(
        self, at: State, pressure: Array, trial: Array, friction: Array
    ) -> tuple[Array, Array, NDArray[np.int8]]:
        """What multipliers miss, (m,) and (2, r), of their projections, and the states of these."""
        most = (friction * pressure)[self.rough]
        length = np.hypot(*trial)
        slips = length > most
        share = np.where(slips, most / np.where(slips, length, 1.0), 1.0)
        states = np.where(pressure > 0, STICK, OPEN).astype(np.int8)
        states[self.rough[slips & (most > 0)]] = SLIP
        tau = np.array([self._t, self._z])
        return (
            at.multipliers[: pressure.size] - pressure, at.multipliers[tau] - share * trial, states,
        )  # fmt: skip

    def linear(self, task: Task, at: State, states: NDArray[np.int8]) -> State:
        """Where Newton's step leads.

        Multipliers are l = Q x: pressures with the friction of slipping nodes, then what sticks,
        then friction across the direction of slip. The rows P' w are those of P' l = x.
        """
        _, pressure, trial = self._trial(task.w_0, at)
        slip = np.flatnonzero(states[self.rough] == SLIP)
        length = np.hypot(*trial[:, slip])
        d = trial[:, slip] / length
        share = (task.friction * pressure)[self.rough[slip]] / length
        P, Q = self._directions(states, d, task.friction)
        rows = P.T @ self.B
        A = (Q.T @ rows.T).T
        own = np.asarray(P.multiply(P).T @ np.diag(self.B))
        # the friction turns towards what slips across, the more the less has slipped
        across = len(A) - slip.size + np.arange(slip.size)
        A[across, across] += (1 - share) / (share * self._stiff[1][slip])
        A = np.block([[A, P.T @ self.D], [(Q.T @ self.D).T, -task.K]])
        known = -np.concatenate([P.T @ task.w_0, task.e])
        least = BARE * self.own.max(initial=0.0) or 1.0
        scale = 1 / np.sqrt(np.concatenate([own, np.maximum(self.own, least)]))
        try:
            found = scale * np.linalg.solve(scale[:, None] * A * scale, scale * known)
        except np.linalg.LinAlgError:
            raise ArithmeticError(
                "the contact has no unique forces: supports or another pair fix the same nodes"
            ) from None
        return State(Q @ found[: own.size], found[own.size :])

    def _directions(
        self, states: NDArray[np.int8], d: Array, friction: Array
    ) -> tuple[csr_array, csr_array]:
        """P and Q (n, unknowns) where slipping nodes have trials along `d` (2, slipping)."""
        closed = np.flatnonzero(states != OPEN)
        stick, slip = (np.flatnonzero(states[self.rough] == state) for state in (STICK, SLIP))
        x = np.concatenate([closed, self._t[stick], self._z[stick]])
        across = x.size + np.arange(slip.size)
        tau = np.concatenate([self._t[slip], self._z[slip]])
        shape = len(self.B), x.size + slip.size
        entries = np.concatenate([np.ones(x.size), -d[1], d[0]])
        rows = np.concatenate([x, tau])
        columns = np.concatenate([np.arange(x.size), across, across])
        P = csr_array((entries, (rows, columns)), shape)
        dragged = np.tile(np.searchsorted(closed, self.rough[slip]), 2)
        drag = (friction[self.rough[slip]] * d).ravel()
        return P, (P + csr_array((drag, (tau, dragged)), shape)).tocsr()

    def stuck(self, w_0: Array, e: Array, plane: State) -> State:
        """A solution of the plane, with all nodes that touch sticking along z."""
        n, k = self._z[0] if self._z.size else len(self.B), plane.motion.size
        closed = self._z[plane.multipliers[self.rough] > 0]
        B, D = self.B[np.ix_(closed, closed)], self.D[closed, k:]
        K = SPRING * (self.own[k:].max(initial=0.0) or 1.0) * np.eye(D.shape[1])
        scale = 1 / np.sqrt(np.concatenate([np.diag(B), np.diag(K)]))
        A = scale[:, None] * np.block([[B, D], [D.T, -K]]) * scale
        found = scale * np.linalg.solve(A, scale * -np.concatenate([w_0[closed], e[k:]]))
        multipliers = np.zeros(len(self.B))
        multipliers[:n] = plane.multipliers
        multipliers[closed] = found[: closed.size]
        return State(multipliers, np.concatenate([plane.motion, found[closed.size :]]))

    def judged(self, w_0: Array, e: Array, at: State) -> tuple[Residual, NDArray[np.int8], Array]:
        """What `at` misses, its states (m,), and its gaps and slips w (n,)."""
        w, pressure, trial = self._trial(w_0, at)
        normal, along, states = self._projected(at, pressure, trial, self.friction)
        size = max(float(pressure.max(initial=0.0)), self._smallest(w_0, e))
        residual = Residual(
            coulomb=float(np.abs(along).max(initial=0.0)) / size,
            complementarity=float(np.abs(normal).max(initial=0.0)) / size,
            equilibrium=self.missed(e, at),
        )
        backward = self.rough[at.multipliers[self._t] < 0]
        states[backward] = np.where(states[backward] == SLIP, BACKWARD, states[backward])
        return residual, states, w
