"""Solver of all plane contact problems: unilateral contact with Coulomb friction, condensed.

The method of active sets is the fast method. If it ends without a solution, Lemke's method follows.
For bodies without loads, a linear programme then looks for a motion that separates the bodies. A
solution is accepted only if its residual is small enough.
"""

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

from fem.contact.active_sets import FINE, StateEquations
from fem.contact.errors import NoEquilibriumError, NotFoundError
from fem.contact.friction_lcp import COVERING_VECTORS, FrictionLcp
from fem.contact.release import ACCEPTED_RESIDUAL, NEUTRAL, SPRINGS, Release
from fem.contact.residual import residual
from fem.contact.system import BACKWARD, FELT, FORWARD, OPEN, SIGN, STAYING, STICK, ContactSystem
from fem.plane.discretisation import Array

__all__ = ["BACKWARD", "FELT", "FORWARD", "OPEN", "STAYING", "STICK", "Complementarity", "Rest"]

# the slowest one that took part; the last finds that bodies rest without contact
METHODS = "active sets", "Lemke's method", "linear programme"
STRICT = 1e-7  # relative to the largest contact force or its approach: margin of a certain state
FEW, GROUP = 24, 4  # largest number of rows without a coarse start; rows per coarse row
AWAY = "; bodies may slide or roll away under these loads, unless held or pressed together first"


@dataclass(frozen=True)
class Rest:
    """Solution of a contact problem: `multipliers` (n,), `motion` (k,), `states` (normal rows,).

    `changes` lists the number of rows that changed their state in each iteration; `method` is the
    name of the method that found the solution.
    """

    multipliers: Array
    motion: Array
    states: NDArray[np.int8]
    changes: tuple[int, ...] = field(default=(), compare=False)
    method: str = METHODS[False]


class Complementarity(ContactSystem):
    """A condensed contact problem and its solutions."""

    def solve(self, w_0: Array, e: Array, start: NDArray[np.int8] | None = None) -> Rest:
        """Multipliers, motions and states for gaps `w_0` (n,) and loads `e` (k,).

        `w_0` are the gaps and slips without contact forces, `e` the loads on the rigid motions.
        `start` optionally gives the initial states. Each residual of the result is below 1e-9 of
        its scale: the largest contact force, or the elastic approach by this force. Two kinds of
        loads cause no rigid motion: loads that the facets balance up to a fraction of 1e-6, and
        loads that are smaller than the effect of round-off of the gaps.

        Raises
        ------
        NoEquilibriumError
            If no admissible contact forces balance `e`.
        NotFoundError
            If neither active sets nor Lemke's method find a solution.
        """
        changes: list[int] = []
        least, neutral = np.inf, None
        if self.is_unloaded(w_0, e):
            w_0 = self.without_round_off(w_0)
        for rest in self._candidates(w_0, e, start, changes):
            missed = residual(self, w_0, e, rest.multipliers, rest.motion)
            if missed.largest <= ACCEPTED_RESIDUAL / 10:
                return rest
            held = missed.laws <= ACCEPTED_RESIDUAL and self._is_balanced_to_round_off(w_0, e, rest)
            if held or missed.largest <= ACCEPTED_RESIDUAL:
                return self._polished(w_0, e, rest)
            least = min(least, missed.largest)
            if (
                neutral is None
                and max(missed.laws / ACCEPTED_RESIDUAL, missed.balance / NEUTRAL) <= 1
            ):
                neutral = rest
        if neutral is not None:
            return neutral
        if np.any(self.missing(e)):
            raise NoEquilibriumError("no admissible contact forces balance the loads")
        best = f"; the best candidate violates a law by {least:.1e}" if least < np.inf else ""
        raise NotFoundError(
            f"no equilibrium was found: {len(changes)} changes of the contact states and Lemke's "
            f"method with {COVERING_VECTORS} covering vectors gave no solution{best}{AWAY}"
        )

    def _candidates(
        self, w_0: Array, e: Array, start: NDArray[np.int8] | None, changes: list[int]
    ) -> Iterator[Rest]:
        """Results of the methods, those of the fast methods first."""
        release = Release(self, w_0, e, changes)
        if start is None:
            start = self._start(w_0, e)
        starts = [] if start is None else [(start, SPRINGS[-1:])]
        for states, springs in [*starts, (np.zeros(self.friction.size, np.int8), SPRINGS)]:
            try:
                found = release.rest(states, springs)
            except NotFoundError:
                continue
            yield Rest(*found, tuple(changes), METHODS[bool(release.pivoted)])
        fine = Release(self, w_0, e, changes, finer=FINE)
        for found in FrictionLcp(self, w_0, e, self.springs(0.0)).candidates():
            yield Rest(*found, tuple(changes), METHODS[1])
            with suppress(NotFoundError):  # states that pivots leave within their round-off
                yield Rest(*fine.rest(found[2], SPRINGS[-1:]), tuple(changes), METHODS[1])
        if self.is_unloaded(w_0, e) and (apart := self._parting(w_0)) is not None:
            none = np.zeros(w_0.size), apart, np.zeros(self.friction.size, np.int8)
            yield Rest(*none, tuple(changes), METHODS[-1])

    def is_proven_non_unique(self, rest: Rest, w_0: Array, e: Array) -> bool:
        """True if the problem is proven to have solutions besides `rest`.

        False proves nothing. The loads are `w_0` (n,) and `e` (k,). The proof uses the index of the
        solution, which is the sign of the determinant of its states. If contact without friction
        can balance the loads, the sum of all indices is +1. Therefore a solution with index -1 is
        not the only solution. The proof requires that no row is at the limit between two states.
        Without any load, a motion that separates all surfaces is also a proof, because zero contact
        force is then a solution.
        """
        if np.any(self.smooth().missing(e)):
            return False
        if not self._is_strict(rest, w_0):
            return False
        A = StateEquations.of(self, rest.states, self.springs(0.0)).A
        if np.linalg.slogdet(A)[0] * (-1) ** self.D.shape[1] < 0:
            return True
        if not self.is_unloaded(w_0, e) or not np.any(rest.multipliers):
            return False
        return self._parting(w_0) is not None

    def _is_strict(self, rest: Rest, w_0: Array) -> bool:
        """True if no row is at the limit between two states.

        Gaps, pressures, slips and friction reserves must be clearly different from zero.
        """
        force = float(rest.multipliers[: self.friction.size].max(initial=0.0))
        share = w_0 + self.B @ rest.multipliers + self.D @ rest.motion
        share /= self.compliance * (force or 1.0)  # of a row's elastic approach
        closed, rough = rest.states != OPEN, self.rough
        pressure = rest.multipliers[: self.friction.size] / (force or 1.0)
        partner, slips = self.partner[rough], SIGN[rest.states[rough]] != 0
        reserve = self.friction[rough] * pressure[rough]
        reserve -= np.abs(rest.multipliers[partner]) / (force or 1.0)
        along = np.where(slips, np.abs(share[partner]), reserve)[closed[rough]]
        margins = np.where(closed, pressure, share[: closed.size])
        return bool(min(margins.min(initial=np.inf), along.min(initial=np.inf)) > STRICT)

    def _is_balanced_to_round_off(self, w_0: Array, e: Array, rest: Rest) -> bool:
        """True if the loads are balanced within the effect of round-off of the gaps."""
        missed, _ = self.missed(e, rest.multipliers)
        return missed <= self.loads_at_round_off(w_0) and not self.is_unloaded(w_0, e)

    def _polished(self, w_0: Array, e: Array, rest: Rest) -> Rest:
        """Solution of the linear system of the states of `rest`, or `rest` if it is more accurate.

        The linear system contains no stabilising springs and no round-off from pivoting.
        """
        exact = FrictionLcp(self, w_0, e, self.springs(0.0))
        found = exact.polished(rest.multipliers, rest.motion, rest.states)
        missed, before = (
            residual(self, w_0, e, *one).largest for one in (found, (rest.multipliers, rest.motion))
        )
        return replace(rest, multipliers=found[0], motion=found[1]) if missed < before else rest

    def _parting(self, w_0: Array) -> Array | None:
        """Rigid motion (k,) that opens all gaps without force, or None if there is no such motion.

        A linear programme maximises the smallest gap, relative to the elastic approach of its row.
        """
        m, k = self.friction.size, self.D.shape[1]
        scale = np.sqrt(self.compliance[:m])
        D, gaps = self.D[:m] * self.scales[1] / scale[:, None], w_0[:m] / scale
        size = np.abs(gaps).max() or 1.0
        found = linprog(
            np.append(np.zeros(k), -1.0), A_ub=np.column_stack([-D, np.ones(m)]),
            b_ub=gaps / size, bounds=[(None, None)] * k + [(None, 1.0)],
        )  # fmt: skip
        is_open = found.success and found.x[-1] >= 0
        return np.asarray(size * self.scales[1] * found.x[:k]) if is_open else None

    def _start(self, w_0: Array, e: Array) -> NDArray[np.int8] | None:
        """Initial states from contact without friction; None if they are not found or not needed.

        To find these states, groups of rows are first treated as one row. The active sets then need
        only a few iterations at the edges of the contact. Without groups, they may need one
        iteration for each row that leaves the contact.
        """
        m, rough = self.friction.size, bool(self.rough.size)
        if not rough and m <= FEW:
            return None
        simpler, group = self.smooth(1 if rough else GROUP), self.groups(1 if rough else GROUP)
        if rough and np.any(simpler.missing(e)):
            return None  # friction stops all sliding
        first = np.flatnonzero(np.diff(group, prepend=-1))
        try:
            return simpler.solve(np.add.reduceat(w_0[:m], first), e).states[group]
        except (NoEquilibriumError, NotFoundError):
            return None
