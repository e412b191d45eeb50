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
CANCELLED = 1e-5  # of the pressures that close gaps: smaller ones are known less than EXACT
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
    def t(self) -> Indices:
        return self.friction.size + np.arange(self.rough.size)

    @property
    def z(self) -> Indices:
        return self.t + self.rough.size

    @cached_property
    def stiff(self) -> tuple[Array, Array]:
        """c_n (m,) and c (r,): pressures that close unit weighted gaps and slips."""
        own = np.diag(self.B)
        return 1 / own[: self.friction.size], 1 / np.sqrt(own[self.t] * own[self.z])

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

    def use(self, multipliers: Array, mu: Array) -> Array:
        """Friction (r,) as a share of what the pressure allows, zero without pressure."""
        friction = np.hypot(multipliers[self.t], multipliers[self.z])
        most = mu[self.rough] * multipliers[self.rough]
        pressed = most > EXACT * most.max(initial=0.0)
        return np.where(pressed, friction / np.where(pressed, most, 1.0), 0.0)

    def missed(self, w_0: Array, e: Array, at: State) -> float:
        """Share of the forces on rigid motions by which they are out of balance."""
        pushed = np.abs(self.D.T)
        size = np.abs(e) + pushed @ np.abs(at.multipliers)
        least = self._cancelled(w_0, self.trial(w_0, at)[0], at.motion)
        missed = np.abs(self._felt @ (e + self.D.T @ at.multipliers))
        most = max(size.max(initial=0.0), least * pushed.max(initial=0.0))
        return float(missed.max(initial=0.0) / (most or 1.0))

    def trial(self, w_0: Array, at: State) -> tuple[Array, Array, Array]:
        """Gaps and slips w (n,), max(0, l_n - c_n w_n) (m,) and the friction's trial (2, r)."""
        m, (c_n, c) = self.friction.size, self.stiff
        w = w_0 + self.B @ at.multipliers + self.D @ at.motion
        pressure = np.maximum(at.multipliers[:m] - c_n * w[:m], 0.0)
        tau = np.array([self.t, self.z])
        return w, pressure, at.multipliers[tau] - c * w[tau]

    def error(self, task: Task, at: State) -> tuple[float, NDArray[np.int8]]:
        """How far `at` is from its projection, of the pressure, and the states (m,) of that."""
        w, pressure, trial = self.trial(task.w_0, at)
        normal, along, states = self._projected(at, pressure, trial, task.friction)
        balance = task.e + self.D.T @ at.multipliers - task.K @ at.motion
        reach = np.abs(self.D).sum(axis=0)
        size = self._size(task.w_0, task.e, w, at, pressure)
        parts = normal.ravel(), along.ravel(), balance / np.where(reach > 0, reach, 1.0)
        return float(np.linalg.norm(np.concatenate(parts)) / size), states

    def _size(self, w_0: Array, e: Array, w: Array, at: State, pressure: Array) -> float:
        """The largest pressure, or what rounding lets the loads and gaps say about pressures."""
        closing = np.abs(w_0) / np.diag(self.B)
        reach = np.abs(self.D).sum(axis=0)
        pulling = np.abs(e) / np.where(reach > 0, reach, 1.0)
        least = EXACT * float(max(closing.max(initial=0.0), pulling.max(initial=0.0))) or 1.0
        largest = float(pressure.max(initial=0.0))
        return max(largest, self._cancelled(w_0, w, at.motion), least)

    def _cancelled(self, w_0: Array, w: Array, motion: Array) -> float:
        """A pressure below which gaps `w` that nearly close are uncertain by rounding."""
        m = self.friction.size
        gaps = np.abs(w_0[:m]) + np.abs(self.D[:m]) @ np.abs(motion)
        closed = w[:m] <= CANCELLED * gaps
        return CANCELLED * float((gaps / np.diag(self.B)[:m])[closed].max(initial=0.0))

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
        tau = np.array([self.t, self.z])
        return (
            at.multipliers[: pressure.size] - pressure, at.multipliers[tau] - share * trial, states,
        )  # fmt: skip

    def stuck(self, w_0: Array, e: Array, plane: State) -> State:
        """A solution of the plane, with all nodes that touch sticking along z."""
        n, k = self.z[0] if self.z.size else len(self.B), plane.motion.size
        closed = self.z[plane.multipliers[self.rough] > 0]
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
        w, pressure, trial = self.trial(w_0, at)
        normal, along, states = self._projected(at, pressure, trial, self.friction)
        size = self._size(w_0, e, w, at, pressure)
        residual = Residual(
            coulomb=float(np.abs(along).max(initial=0.0)) / size,
            complementarity=float(np.abs(normal).max(initial=0.0)) / size,
            equilibrium=self.missed(w_0, e, at),
        )
        backward = self.rough[at.multipliers[self.t] < 0]
        states[backward] = np.where(states[backward] == SLIP, BACKWARD, states[backward])
        return residual, states, w
