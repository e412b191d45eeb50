"""Primal-dual active sets: the fast method for the condensed contact problem.

Each row has a state: open, stick, or slip in one of two directions. The linear system of these
states is solved. Rows whose solution contradicts their state change their state: all of these rows
together as long as their number decreases, otherwise one row at a time (block principal pivoting,
Judice and Pires 1994). Without friction, the method ends after a finite number of steps. With
friction, the states may repeat in a cycle; the method then ends without a solution.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.contact.errors import NotFoundError
from fem.contact.system import BACKWARD, FORWARD, OPEN, SIGN, STICK, ContactSystem
from fem.plane.discretisation import Array, Indices

States = NDArray[np.int8]
Solution = tuple[Array, Array, States]  # multipliers (n,), motions (k,), states (m,)

STATE_TOLERANCE = 1e-11  # relative to the terms of a row: a gap, slip or traction within it is zero
FINE = 1e-3  # times STATE_TOLERANCE, if contact forces are small against closing forces
MAX_BLOCK_EXCHANGES = 10  # full exchanges without progress before single ones
MAX_EXCHANGES, EXCHANGES_PER_ROW = 100, 10  # without friction, for which the method is finite
MAX_FRICTION_EXCHANGES = 40  # a slower descent costs more than Lemke's method


def exchanged(
    system: ContactSystem, w_0: Array, e: Array, spring: Array, states: States, changes: list[int],
    finer: float = 1.0,
) -> Solution:  # fmt: skip
    """Multipliers, motions and contact states that are consistent with each other.

    Springs (k, k) act on the rigid motions. The iteration begins with `states` (m,). `changes`
    receives the number of changed rows of each iteration. Raises NotFoundError if the states repeat
    or continue to change.
    """
    rough, seen = bool(system.rough.size), set()
    fewest, patience = states.size + 1, MAX_BLOCK_EXCHANGES
    most = MAX_FRICTION_EXCHANGES if rough else MAX_EXCHANGES + EXCHANGES_PER_ROW * states.size
    for _ in range(most):
        multipliers, motion = linear(system, w_0, e, spring, states)
        wanted = fitting_states(system, w_0, multipliers, motion, states, finer)
        other = np.flatnonzero(wanted != states)
        changes.append(other.size)
        if not other.size:
            return multipliers, motion, states
        if other.size < fewest:
            fewest, patience = other.size, MAX_BLOCK_EXCHANGES
        elif patience > 0:
            patience -= 1
        else:
            other = other[-1:]
        states = states.copy()
        states[other] = wanted[other]
        known = states.tobytes(), patience
        if rough and known in seen:
            raise NotFoundError("the contact states repeat in a cycle")
        seen.add(known)
    raise NotFoundError(f"{other.size} of {states.size} contact points still change their state")


@dataclass(frozen=True)
class StateEquations:
    """Linear system A x = known for given contact `states`, with springs (k, k) on rigid motions.

    x contains the multipliers of the rows `own`, then the motions. The friction of the slipping
    rows `slip` is `drag` times the multiplier of their normal row, whose position in x is `at`.
    """

    own: Indices
    slip: Indices
    at: Indices
    drag: Array
    A: Array

    @classmethod
    def of(cls, system: ContactSystem, states: States, spring: Array) -> "StateEquations":
        """Linear system for the contact states `states` (m,)."""
        closed = np.flatnonzero(states != OPEN)
        stick = np.flatnonzero((states == STICK) & (system.partner >= 0))
        slip = np.flatnonzero(SIGN[states] != 0)
        own, at = np.concatenate([closed, system.partner[stick]]), np.searchsorted(closed, slip)
        drag, n = SIGN[states[slip]] * system.friction[slip], own.size
        A, D = np.empty((n + len(spring),) * 2), system.D.take(own, axis=0)
        rows = system.B.take(own, axis=0)
        A[:n, :n], A[:n, n:] = rows.take(own, axis=1), D
        A[n:, :n], A[n:, n:] = D.T, -spring
        if slip.size:
            A[:n, at] += drag * rows[:, system.partner[slip]]
            A[n:, at] += drag * system.D[system.partner[slip]].T
        return cls(own, system.partner[slip], at, drag, A)

    def unpacked(self, x: Array, n: int) -> tuple[Array, Array]:
        """Multipliers (n,) and motions (k,) from the solution x."""
        multipliers = np.zeros(n)
        multipliers[self.own] = x[: self.own.size]
        multipliers[self.slip] = self.drag * x[self.at]
        return multipliers, x[self.own.size :]


def linear(
    system: ContactSystem, w_0: Array, e: Array, spring: Array, states: States
) -> tuple[Array, Array]:
    """Multipliers (n,) and motions (k,) for given contact `states`.

    Springs (k, k) act on the rigid motions. Raises NotFoundError if the states do not determine the
    multipliers and motions.
    """
    equations = StateEquations.of(system, states, spring)
    scale = np.concatenate([system.scales[0][equations.own], system.scales[1]])
    known = np.concatenate([-w_0[equations.own], -e])
    A = equations.A
    A *= scale[:, None]
    A *= scale
    try:
        x = scale * np.linalg.solve(A, scale * known)
    except np.linalg.LinAlgError:
        raise NotFoundError("the contact states do not determine the contact forces") from None
    return equations.unpacked(x, w_0.size)


def fitting_states(
    system: ContactSystem, w_0: Array, multipliers: Array, motion: Array, states: States,
    finer: float = 1.0,
) -> States:  # fmt: skip
    """Contact states (m,) that agree with the multipliers and gaps found for the old `states`.

    `finer` is a factor of the tolerances.
    """
    m, rough = system.friction.size, system.rough
    w = w_0 + system.B @ multipliers + system.D @ motion
    # of the terms of each row: far from the contact gaps are larger than any slip in it
    reach = system.reach
    size = np.abs(w_0) + reach * (reach @ np.abs(multipliers))
    w_tolerance = finer * STATE_TOLERANCE * (size + system.arms @ np.abs(motion))
    normal, wanted = multipliers[:m], np.full(m, STICK, np.int8)
    tolerance = finer * STATE_TOLERANCE * np.abs(normal).max(initial=0)
    if rough.size:
        before, partner = states[rough], system.partner[rough]
        tangential, bound = multipliers[partner], system.friction[rough] * normal[rough] + tolerance
        along = np.where(before == OPEN, STICK, before)
        sticks = along == STICK
        along[sticks & (tangential > bound)] = FORWARD
        along[sticks & (tangential < -bound)] = BACKWARD
        along[SIGN[before] * w[partner] > w_tolerance[partner]] = STICK
        wanted[rough] = along
    opens = (states != OPEN) & (normal < -tolerance)
    closes = (states == OPEN) & (w[:m] < -w_tolerance[:m])
    wanted[closes] = STICK
    wanted[opens | ((states == OPEN) & ~closes)] = OPEN
    return wanted
