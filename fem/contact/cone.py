"""Coulomb's circular cone: contact whose friction acts along the surface and along z at once.

Unknown are the multipliers l = (normal, tangential, along z) and amplitudes a of rigid motions and
of shifts along z, as in `complementarity`:

    w = w_0 + B l + D a,    e + D' l = 0.

Normal rows: l_n >= 0, w_n >= 0, l_n w_n = 0. At nodes with friction the vector (l_t, l_z) is no
longer than mu l_n, and opposes (w_t, w_z) where it reaches that bound. Equivalent is

    l_n = max(0, l_n - c_n w_n),   (l_t, l_z) = P((l_t, l_z) - c (w_t, w_z)),

with P the projection on the disc of radius mu max(0, l_n - c_n w_n). Newton's method solves these
with each node open, sticking or slipping as its projection has it (Alart and Curnier 1991). Its
direction of slip turns with the solution: states of their own do not end it. The motions are held
by weak springs to where they were, until nothing pulls at these.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from fem.contact.complementarity import AWAY, BACKWARD, FORWARD, OPEN, STICK, Complementarity
from fem.plane.discretisation import Array, Indices

SLIP = FORWARD
EXACT = 1e-9  # of the peak pressure and of the forces: what the solution may miss
FINE = 1e-13  # of the peak pressure: Newton's method ends
GOOD = 1e-10  # here too, where rounding lets it come no closer
MAX_STEPS = 40
ROUGHLY = 0.2  # of the peak pressure: so much Newton's full step may miss, and more than before
SHORTEST = 1.0 / 8  # of Newton's step, where it misses more than any of the steps before
MEMORY = 6  # of these steps
BARE = 1e-24  # of the largest stiffness against a motion, in whose units others are
SPRINGS = (1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7)  # of the contact's own stiffness
WEAKEST = 1e-12
RUNAWAY = 100.0  # times what surfaces deform: no friction holds what moves more
FAR = 10.0  # nor what moves more than this, if no rest is found there
MAX_RELEASES = 60
LOWER = 0.7  # friction from one solution on the way down to the next
MAX_LOWER = 40


class Sliding(ArithmeticError):
    """Friction does not balance the loads: `missed` (k,) of these move bodies, a `share` of all."""

    def __init__(self, missed: Array, share: float) -> None:
        super().__init__(f"friction holds no more: {share:.2e} of the loads move bodies on")
        self.missed, self.share = missed, share


@dataclass(frozen=True)
class State:
    """Multipliers (n,) and motions (k,)."""

    multipliers: Array
    motion: Array


@dataclass(frozen=True)
class Residual:
    """What a solution misses: of Coulomb's law and of the complementarity of gap and pressure, both
    of the largest pressure, and of the equilibrium of rigid motions, of the forces on these."""

    coulomb: float
    complementarity: float
    equilibrium: float

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
        """The plane system beside the compliance `B_z` (r, r) and the shifts `D_z` (r, k) along z."""
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
    def _own(self) -> Array:
        """The contact's own stiffness (k,) against motions."""
        return np.asarray((self.D**2 / np.diag(self.B)[:, None]).sum(axis=0))

    def solve(self, w_0: Array, e: Array, starts: list[State]) -> State:
        """The solution under `w_0` (n,), `e` (k,), from the first start that leads to one.

        Where none does, friction is lowered to its value from where everything sticks.
        ArithmeticError where that fails too, or the bodies come to no rest.
        """
        failed: ArithmeticError | None = None
        for solve in (self._released, self._lowered):
            for start in starts:
                try:
                    return solve(w_0, e, start, self.friction)
                except Sliding:
                    raise
                except ArithmeticError as error:
                    failed = error
        raise failed or ArithmeticError("the contact has no start")

    def _lowered(self, w_0: Array, e: Array, at: State, friction: Array) -> State:
        """From friction at which everything sticks, step by step down to what there is."""
        at = self._released(w_0, e, at, friction * LOWER**-MAX_LOWER)
        _, used = self._use(at.multipliers)
        share = max(1.0, 1.01 * float(used.max(initial=0.0)))
        share = min(share, LOWER**-MAX_LOWER)
        while share > 1:
            at = self._released(w_0, e, at, friction * share)
            share *= LOWER
        return self._released(w_0, e, at, friction)

    def _use(self, multipliers: Array) -> tuple[Array, Array]:
        """Friction (r,), and its share (r,) of what the pressure allows, zero without pressure."""
        friction = np.hypot(multipliers[self._t], multipliers[self._z])
        most = self.friction[self.rough] * multipliers[self.rough]
        pressed = most > EXACT * most.max(initial=0.0)
        return friction, np.where(pressed, friction / np.where(pressed, most, 1.0), 0.0)

    def _released(self, w_0: Array, e: Array, at: State, friction: Array) -> State:
        """The solution on springs that follow the motions until nothing pulls at them."""
        try:
            at = self._newton(w_0, e, at, SPRINGS[-1], friction, most=MAX_STEPS // 2)
        except ArithmeticError:
            at = self._eased(w_0, e, at, friction)
        spring = SPRINGS[-1]
        missed = self._missed(e, at)
        for _ in range(MAX_RELEASES):
            if missed <= FINE:
                return at
            before = missed
            at = self._newton(w_0, e, at, spring, friction)
            missed = self._missed(e, at)
            if missed > before / 2:
                if missed <= GOOD:
                    return at
                spring = max(WEAKEST, spring / 10)
        raise Sliding(e + self.D.T @ at.multipliers, missed)

    def _eased(self, w_0: Array, e: Array, at: State, friction: Array) -> State:
        """On springs that are let go; what they still carry then slides."""
        moved = 0.0  # of what surfaces deform: a spring's stiffness is a share of theirs
        for spring in SPRINGS:
            try:
                new = self._newton(w_0, e, at, spring, friction)
            except ArithmeticError:
                if moved > FAR:
                    raise Sliding(e + self.D.T @ at.multipliers, self._missed(e, at)) from None
                raise
            at = new
            moved = self._missed(e, at) / spring
            if moved > RUNAWAY:
                raise Sliding(e + self.D.T @ at.multipliers, self._missed(e, at))
        return at

    def _missed(self, e: Array, at: State) -> float:
        size = np.abs(e) + np.abs(self.D.T) @ np.abs(at.multipliers)
        missed = np.abs(e + self.D.T @ at.multipliers)
        return float(missed.max(initial=0.0) / (size.max(initial=0.0) or 1.0))

    def _newton(
        self, w_0: Array, e: Array, at: State, spring: float, friction: Array, most: int = MAX_STEPS
    ) -> State:
        """The solution with springs that hold the motions where they are."""
        held, K = at.motion, spring * self._own.max(initial=0.0) * np.eye(at.motion.size)
        sizes: list[float] = []
        error, states = self._error(w_0, e, at, held, K, friction)
        for _ in range(most):
            goal = self._linear(w_0, e, at, held, K, friction, states)
            share, best = 1.0, None
            while share >= SHORTEST:
                new = State(
                    at.multipliers + share * (goal.multipliers - at.multipliers),
                    at.motion + share * (goal.motion - at.motion),
                )
                found, wanted = self._error(w_0, e, new, held, K, friction)
                if best is None or found < best[0]:
                    best = found, wanted, new
                if found <= max([ROUGHLY, error, *sizes[-MEMORY:]]):
                    best = found, wanted, new
                    break
                share /= 2
            assert best is not None
            before, same = error, bool(np.all(best[1] == states))
            error, states, at = best
            sizes.append(before)
            if error <= FINE or (same and error <= GOOD and error > before / 10):
                return at
        raise ArithmeticError(
            f"the contact did not converge: after {most} steps Newton's method still misses "
            f"Coulomb's law by {error:.2e} of the pressure{AWAY}"
        )

    def _trial(self, w_0: Array, at: State, friction: Array) -> tuple[Array, Array, Array]:
        """w (n,), max(0, l_n - c_n w_n) (m,) and the trial (2, r) of the friction."""
        m, (c_n, c) = self.friction.size, self._stiff
        w = w_0 + self.B @ at.multipliers + self.D @ at.motion
        pressure = np.maximum(at.multipliers[:m] - c_n * w[:m], 0.0)
        tau = np.array([self._t, self._z])
        return w, pressure, at.multipliers[tau] - c * w[tau]

    def _error(
        self, w_0: Array, e: Array, at: State, held: Array, K: Array, friction: Array
    ) -> tuple[float, NDArray[np.int8]]:
        """How far `at` is from its projection, of the pressure, and the states (m,) of that."""
        w, pressure, trial = self._trial(w_0, at, friction)
        normal, along, states = self._projected(at, pressure, trial, friction)
        balance = e + self.D.T @ at.multipliers - K @ (at.motion - held)
        reach = np.abs(self.D).sum(axis=0)
        size = max(pressure.max(initial=0.0), self._smallest(w_0, e))
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

    def _linear(
        self, w_0: Array, e: Array, at: State, held: Array, K: Array, friction: Array,
        states: NDArray[np.int8],
    ) -> State:  # fmt: skip
        """Where Newton's step leads."""
        _, pressure, trial = self._trial(w_0, at, friction)
        closed = np.flatnonzero(states != OPEN)
        state = states[self.rough]
        stick, slip = np.flatnonzero(state == STICK), np.flatnonzero(state == SLIP)
        length = np.hypot(*trial[:, slip])
        d = trial[:, slip] / length
        share = (friction * pressure)[self.rough[slip]] / length
        # multipliers l = Q x: pressures with the friction of slipping nodes, then what sticks, then
        # friction across the direction of slip
        x = np.concatenate([closed, self._t[stick], self._z[stick]])
        count = x.size + slip.size
        P = np.zeros((len(self.B), count))
        P[x, np.arange(x.size)] = 1
        across = x.size + np.arange(slip.size)
        P[self._t[slip], across], P[self._z[slip], across] = -d[1], d[0]
        Q = P.copy()
        own = np.searchsorted(closed, self.rough[slip])
        drag = friction[self.rough[slip]] * d
        Q[self._t[slip], own], Q[self._z[slip], own] = drag
        A = P.T @ self.B @ Q
        # the friction turns towards what slips across, the more the less has slipped
        A[across, across] += (1 - share) / (share * self._stiff[1][slip])
        A = np.block([[A, P.T @ self.D], [self.D.T @ Q, -K]])
        known = np.concatenate([-P.T @ w_0, -e - K @ held])
        scale = 1 / np.sqrt(np.diag(P.T @ self.B @ P))
        least = BARE * self._own.max(initial=0.0) or 1.0
        scale = np.concatenate([scale, 1 / np.sqrt(np.maximum(self._own, least))])
        try:
            found = scale * np.linalg.solve(scale[:, None] * A * scale, scale * known)
        except np.linalg.LinAlgError:
            raise ArithmeticError(
                "the contact has no unique forces: supports or another pair fix the same nodes"
            ) from None
        return State(Q @ found[:count], found[count:])

    def stuck(self, w_0: Array, e: Array, plane: State) -> State:
        """A solution of the plane, with all nodes that touch sticking along z."""
        n, k = self._z[0] if self._z.size else len(self.B), plane.motion.size
        closed = self._z[plane.multipliers[self.rough] > 0]
        B, D = self.B[np.ix_(closed, closed)], self.D[closed, k:]
        K = SPRINGS[-1] * (self._own[k:].max(initial=0.0) or 1.0) * np.eye(D.shape[1])
        scale = np.concatenate([1 / np.sqrt(np.diag(B)), 1 / np.sqrt(np.maximum(np.diag(K), 1e-300))])
        A = scale[:, None] * np.block([[B, D], [D.T, -K]]) * scale
        found = scale * np.linalg.solve(A, scale * -np.concatenate([w_0[closed], e[k:]]))
        multipliers = np.zeros(len(self.B))
        multipliers[:n] = plane.multipliers
        multipliers[closed] = found[: closed.size]
        return State(multipliers, np.concatenate([plane.motion, found[closed.size :]]))

    def checked(self, w_0: Array, e: Array, at: State) -> tuple[Residual, NDArray[np.int8], Array]:
        """What `at` misses, its states (m,) and w (n,); ArithmeticError for more than 1e-9."""
        w, pressure, trial = self._trial(w_0, at, self.friction)
        normal, along, states = self._projected(at, pressure, trial, self.friction)
        size = max(float(pressure.max(initial=0.0)), self._smallest(w_0, e))
        residual = Residual(
            coulomb=float(np.abs(along).max(initial=0.0)) / size,
            complementarity=float(np.abs(normal).max(initial=0.0)) / size,
            equilibrium=self._missed(e, at),
        )
        if not residual.largest <= EXACT:
            raise ArithmeticError(f"the contact misses its laws by more than {EXACT:g}: {residual}")
        backward = self.rough[at.multipliers[self._t] < 0]
        states[backward] = np.where(states[backward] == SLIP, BACKWARD, states[backward])
        return residual, states, w
