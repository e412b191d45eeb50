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
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls

from fem.plane.discretisation import Array, Indices

OPEN, STICK, FORWARD, BACKWARD = 0, 1, 2, 3  # slip states by the sign of l_t: + and -
HELD = 4  # open, but sticking or slipping (5, 6) on friction whose limit is given
SIGN = np.array([0.0, 0.0, 1.0, -1.0, 0.0, 1.0, -1.0])
SPRINGS = (1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7)  # of the contact's own stiffness
WEAKEST, STAYING = 1e-12, 1e-2
FELT = 1e-7  # of the largest stiffness against a rigid motion: below, the motion is neutral
TOLERANCE = 1e-11
BALANCED = 1e-13
NOTHING = 1e-13  # of the forces that would close the gaps
AWAY = "; bodies may slide or roll away under these loads, unless held or pressed together first"
PATIENCE = 10  # full exchanges without progress before single ones
MAX_EXCHANGES = 100
BRIEF = 40  # exchanges before friction is suspected of going round in circles
UNHELD = 1e-9  # of the loads on rigid motions: less than that may be missing
BARE = 1e-12  # of the largest: rows that act on no rigid motion
FEW, GROUP = 24, 4  # rows that need no coarse start, and how many are taken in one for it
MAX_RELEASES = 60
MAX_LIMITS = 80
SETTLED = 1e-9  # of the limits on the traction
ASKEW = 1e-2  # of the loads: so much may act on a neutral motion until surfaces are paired anew
OFFSET = 1e-3  # and this much where they are: moments count about places in the mesh
NEUTRAL = 1e-6  # of the forces on rigid motions: what facets may exert where the surface does not


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
        changes: list[int] = []
        none = np.zeros(self.friction.size, np.int8)
        if start is None:
            start = self._start(w_0, e)
        if start is not None and start.any():
            try:
                return self._released(w_0, e, start, SPRINGS[-1:], changes)
            except ArithmeticError:
                pass  # a start that leads nowhere is no reason to give up
        return self._released(w_0, e, none, SPRINGS, changes)

    def _released(self, w_0, e, states, springs, changes):
        """Rest on ever weaker springs, and then on none."""
        motion = np.zeros(self.D.shape[1])
        if not motion.size:
            springs = (0.0,)
        for spring in springs:
            at = self._settle(w_0, e, motion, self._springs(spring), states, changes)
            multipliers, motion, states = at
        missed, size = self._missed(e, multipliers)
        nothing = NOTHING * float(np.max(np.abs(w_0) / np.diag(self.B), initial=0.0))
        nothing *= float(np.abs(self.D).max(initial=0.0))
        spring = springs[-1]
        for _ in range(MAX_RELEASES):
            if missed <= max(BALANCED * size, nothing):
                break
            at = self._settle(w_0, e, motion, self._springs(spring), states, changes)
            before = missed
            missed, size = self._missed(e, at[0])
            multipliers, motion, states = at
            if missed > before / 2:
                if missed <= NEUTRAL * size:
                    break  # a motion that the contact hardly feels stays where it is
                spring = max(spring / 10, WEAKEST)  # a gap still has to close
        else:
            raise ArithmeticError(
                "the contact does not come to rest: its forces still miss the loads by "
                f"{missed:.2e} of {size:.2e} after {len(changes)} iterations{AWAY}"
            )
        return Rest(multipliers, motion, states, tuple(changes))

    def _missed(self, e: Array, multipliers: Array) -> tuple[float, float]:
        """What is missing to balance on the rigid motions, and the size of the forces there."""
        size = np.abs(e) + np.abs(self.D.T) @ np.abs(multipliers)
        missed = np.abs(self._felt[0].T @ (e + self.D.T @ multipliers))
        return float(missed.max(initial=0.0)), float(size.max(initial=0.0))

    def missing(self, e: Array) -> Array:
        """What no admissible contact forces can balance of the loads `e` (k,) on rigid motions.

        Zero where they can, to round-off.
        """
        m, (felt, neutral) = self.friction.size, self._felt
        if not np.any(e):
            return np.zeros_like(e)
        if np.linalg.norm(neutral.T @ e) > ASKEW * np.linalg.norm(e):
            return neutral @ (neutral.T @ e)
        D = self.D @ felt
        normal = D[:m].T
        held = self.partner >= 0
        sideways = self.friction[held] * D[self.partner[held]].T
        cone = np.hstack([normal, normal[:, held] + sideways, normal[:, held] - sideways])
        size = np.abs(cone).max(axis=0, initial=0.0)
        cone = cone[:, size > BARE * size.max(initial=0.0)]
        cone /= np.hypot.reduce(cone, axis=0)
        share, _ = nnls(cone, -felt.T @ e, maxiter=100 * cone.shape[1])
        missed = felt @ (felt.T @ e + cone @ share)
        return missed if np.linalg.norm(missed) > UNHELD * np.linalg.norm(e) else np.zeros_like(e)

    def unfelt(self, e: Array) -> Array:
        """What of the loads `e` (k,) acts on neutral motions; zero where that is little."""
        _, neutral = self._felt
        found = neutral @ (neutral.T @ e)
        return found if np.linalg.norm(found) > OFFSET * np.linalg.norm(e) else np.zeros_like(e)

    def smooth(self, group: int = 1) -> "Complementarity":
        """The same without friction, and with `group` rows of a surface at a time in one."""
        start = np.flatnonzero(np.diff(self._groups(group), prepend=-1))
        m = self.friction.size
        return Complementarity(
            B=np.add.reduceat(np.add.reduceat(self.B[:m, :m], start, axis=0), start, axis=1),
            D=np.add.reduceat(self.D[:m], start, axis=0), friction=np.zeros(start.size),
            partner=np.full(start.size, -1), part=self.part[start],
        )  # fmt: skip

    def _groups(self, group: int) -> Indices:
        """Numbers (m,) of the groups that normal rows belong to."""
        along = np.arange(self.part.size) - np.searchsorted(self.part, self.part)
        new = (along % group == 0).astype(int)
        return np.cumsum(new) - 1

    def _start(self, w_0: Array, e: Array) -> NDArray[np.int8] | None:
        """Where the surfaces would touch without friction, as a start; None if that is not found.

        Where there is none, groups of rows are taken in one: from there a few exchanges are left at
        the edges, instead of one for every row that the contact shrinks by.
        """
        m, rough = self.friction.size, bool(np.any(self.partner >= 0))
        if not rough and m <= FEW:
            return None
        simpler, group = self.smooth(1 if rough else GROUP), self._groups(1 if rough else GROUP)
        if rough and np.any(simpler.missing(e)):
            return None  # friction holds what slides
        first = np.flatnonzero(np.diff(group, prepend=-1))
        try:
            return simpler.solve(np.add.reduceat(w_0[:m], first), e).states[group]
        except ArithmeticError:
            return None

    @cached_property
    def _scales(self) -> tuple[Array, Array]:
        """Units (n,) of multipliers and (k,) of motions, in which the system is about one."""
        own = 1 / np.sqrt(np.diag(self.B))
        felt = np.sqrt(((own[:, None] * self.D) ** 2).sum(axis=0))
        return own, 1 / np.maximum(felt, BARE * felt.max(initial=BARE))

    @cached_property
    def _felt(self) -> tuple[Array, Array]:
        """Motions (k, .) that the contact resists, and neutral ones that it hardly feels.

        A smooth pin in a hole may turn: facets alone resist that.
        """
        own = self.D / np.sqrt(np.diag(self.B))[:, None]
        size, motions = np.linalg.eigh(own.T @ own)
        felt = size > FELT * size.max(initial=0.0)
        return motions[:, felt], motions[:, ~felt]

    def _springs(self, share: float) -> Array:
        """Springs (k, k) on rigid motions; those on neutral ones stay as they are."""
        own = (self.D**2 / np.diag(self.B)[:, None]).sum(axis=0)
        felt, neutral = self._felt
        return float(own.max(initial=0.0)) * (share * felt @ felt.T + STAYING * neutral @ neutral.T)

    def _settle(self, w_0, e, motion, spring, states, changes):
        """Multipliers, motions and states that fit, with springs back to `motion`."""
        if not np.any(self.partner >= 0):
            return self._exchange(w_0, e, motion, spring, states, changes)
        try:
            return self._exchange(w_0, e, motion, spring, states, changes, most=BRIEF)
        except ArithmeticError:
            pass
        # Friction may make the exchanges go round in circles. With limits on the traction that are
        # given instead of drawn from the pressure, the problem is convex and they end.
        limit = np.zeros(states.size)
        for step in range(MAX_LIMITS):
            multipliers, _, states = self._exchange(w_0, e, motion, spring, states, changes, limit)
            wanted = self.friction * np.maximum(multipliers[: states.size], 0.0)
            if np.abs(wanted - limit).max() <= SETTLED * np.abs(wanted).max():
                break
            limit = wanted if step < MAX_LIMITS // 4 else (wanted + limit) / 2
        states = np.where(states >= HELD, OPEN, states).astype(np.int8)
        return self._exchange(w_0, e, motion, spring, states, changes)

    def _exchange(self, w_0, e, motion, spring, states, changes, limit=None, most=None):
        """As `_settle`, with Coulomb's limit of the tangential traction or a given one (m,)."""
        fewest, patience = states.size + 1, PATIENCE
        most = most or MAX_EXCHANGES + 10 * states.size
        for _ in range(most):
            multipliers, moved = self._linear(w_0, e, motion, spring, states, limit)
            wanted = self._wanted(w_0, multipliers, moved, states, limit)
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
            f"{states.size} points still change between open, stick and slip{AWAY}"
        )

    def _linear(self, w_0, e, motion, spring, states, limit):
        """Multipliers and motions that `states` imply."""
        m = self.friction.size
        rough = self.partner >= 0
        closed = np.flatnonzero((states != OPEN) & (states < HELD))
        stick = np.flatnonzero(((states == STICK) | (states == HELD)) & rough)
        slip = np.flatnonzero(SIGN[states] != 0)
        own = np.concatenate([closed, self.partner[stick]])
        columns, pull = self.B[:, own], self.D[own].T.copy()
        given = np.zeros(w_0.size)  # tangential multipliers that do not depend on the pressure
        if limit is not None:
            given[self.partner[slip]] = SIGN[states[slip]] * limit[slip]
        else:
            row_of = np.full(m, -1)
            row_of[closed] = np.arange(closed.size)
            drag = SIGN[states[slip]] * self.friction[slip]
            columns[:, row_of[slip]] += drag * self.B[:, self.partner[slip]]
            pull[:, row_of[slip]] += drag * self.D[self.partner[slip]].T
        A = np.block([[columns[own], self.D[own]], [pull, -spring]])
        scale = np.concatenate([self._scales[0][own], self._scales[1]])
        known = np.concatenate([
            -w_0[own] - self.B[own] @ given, -e - spring @ motion - self.D.T @ given
        ])  # fmt: skip
        try:
            x = scale * np.linalg.solve(scale[:, None] * A * scale, scale * known)
        except np.linalg.LinAlgError:
            raise ArithmeticError(
                "the contact has no unique forces: supports or another pair fix the same nodes"
            ) from None
        multipliers = given
        multipliers[own] += x[: own.size]
        if limit is None:
            multipliers[self.partner[slip]] = drag * x[row_of[slip]]
        return multipliers, x[own.size :]

    def _wanted(self, w_0, multipliers, motion, states, limit):
        """The states (m,) that multipliers and gaps call for."""
        m = self.friction.size
        w = w_0 + self.B @ multipliers + self.D @ motion
        # of each row's own terms: far from the contact gaps are larger than any slip in it
        reach = np.sqrt(np.diag(self.B))
        size = np.abs(w_0) + reach * (reach @ np.abs(multipliers)) + np.abs(self.D) @ np.abs(motion)
        tiny_w = TOLERANCE * size
        normal = multipliers[:m]
        tiny = TOLERANCE * np.abs(normal).max(initial=0)
        rough = self.partner >= 0
        tangential, slip, tiny_slip = np.zeros(m), np.zeros(m), np.zeros(m)
        tangential[rough] = multipliers[self.partner[rough]]
        slip[rough], tiny_slip[rough] = w[self.partner[rough]], tiny_w[self.partner[rough]]
        most = (self.friction * normal if limit is None else limit) + tiny
        along = np.array([STICK, STICK, FORWARD, BACKWARD, STICK, FORWARD, BACKWARD])[states]
        sticks = (along == STICK) & rough
        along[sticks & (tangential > most)] = FORWARD
        along[sticks & (tangential < -most)] = BACKWARD
        along[SIGN[states] * slip > tiny_slip] = STICK
        closed = (states != OPEN) & (states < HELD)
        opens, closes = closed & (normal < -tiny), ~closed & (w[:m] < -tiny_w[:m])
        closed = (closed & ~opens) | closes
        if limit is not None:  # friction with a limit of its own does not ask for pressure
            return np.where(closed, along, np.where(rough, along + HELD - STICK, OPEN))
        along[closes] = STICK
        return np.where(closed, along, OPEN)
