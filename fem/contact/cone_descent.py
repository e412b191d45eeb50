"""Solutions of the equations of a friction cone under given loads.

Newton's method is tried from each initial state. If it fails for all of them, paths of solutions
are followed past their turning points. The first path leads from zero friction to the given
friction, with springs that resist the rigid motions, and then to weaker and weaker springs. The
second path leads from a friction at which all nodes stick to the given friction.

The paths have the following properties. With springs, a bounded solution exists for every friction.
The first part of the path therefore reaches the given friction. With weaker and weaker springs, the
solution remains bounded if pressures alone can balance the loads: -e = D_n' l_n with l_n >= 0. This
is always the case without loads on rigid motions. A state of rest then exists for every friction,
and the path leads to it, except for round-off and coincident events. If the balance of the loads
needs friction, there may be no state of rest, or several. A failed search then proves nothing, and
neither do bodies that continue to move as the springs become weaker. The module `cone_reach` proves
that no state of rest exists. Loads within the limit of `cone_reach` can still cause slip, depending
on the elastic distribution of pressures; this module gives no bound for such loads.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.linalg import solve_triangular
from scipy.optimize import nnls

from fem.contact.cone import Cone
from fem.contact.cone_linear import Rate
from fem.contact.cone_newton import SPRING, Newton, SlidingError
from fem.contact.cone_path import Path
from fem.contact.cone_system import State, Task
from fem.contact.errors import NotFoundError
from fem.plane.discretisation import Array

STIFF = 1.0  # over the contact's stiffness: springs that hold motions on the path from no friction
LEAST_FRICTION = 1e-4  # share of the given friction at which the path starts
MOST_FRICTION = 1e6  # times the given friction: everything sticks
BEYOND = 1.01  # relative to the friction that is mobilised: there the path downwards starts


@dataclass(frozen=True)
class Descent:
    """Search for the solution of a cone for gaps `w_0` (n,) and loads `e` (k,).

    `w_0` are the gaps and slips without contact forces, `e` the loads on the rigid motions.
    """

    cone: Cone
    w_0: Array
    e: Array

    def solve(self, starts: list[State]) -> State:
        """Solution found by the first of several searches that converges.

        Newton's method from each of the `starts` is tried first; then paths of solutions are
        followed, which begin without friction or with all nodes sticking. Raises SlidingError if
        bodies continue to move at the end of a search. Otherwise raises NotFoundError with the
        reasons of all failed searches.
        """
        reasons: list[str] = []
        carried: Array | None = None
        searches: list[tuple[str, State | Callable[[], State]]] = [
            *((f"Newton's method from start {i + 1}", at) for i, at in enumerate(starts)),
            ("the path from no friction", self._from_smooth),
            ("the path from where all sticks", self._from_stuck),
        ]
        for name, start in searches:
            try:
                at = start if isinstance(start, State) else start()
                return self._newton.at_rest(at, self.cone.friction)
            except ArithmeticError as error:
                reasons.append(f"{name}: {error}")
                carried = error.carried if isinstance(error, SlidingError) else carried
        if carried is not None:
            raise SlidingError(carried, reasons)
        raise NotFoundError(f"no equilibrium was found ({'; '.join(reasons)})")

    @property
    def _newton(self) -> Newton:
        return Newton(self.cone, self.w_0, self.e)

    def _from_smooth(self) -> State:
        """Solution at the end of the path from zero to given friction, then to weaker springs."""
        cone, mu, K = self.cone, self.cone.friction, self.cone.springs(STIFF)
        none = np.zeros_like(K)

        def rougher(t: float) -> tuple[Task, Rate]:
            return self._task(t * mu, K), Rate(mu, none)

        def weaker(t: float) -> tuple[Task, Rate]:
            share = STIFF * (SPRING / STIFF) ** t
            change = (cone.springs(2 * share) - cone.springs(share)) * np.log(SPRING / STIFF)
            return self._task(mu, cone.springs(share)), Rate(np.zeros_like(mu), change)

        at = self._newton.solve(self._smooth(K), rougher(LEAST_FRICTION)[0])
        at = self._newton.solve(Path(cone, rougher).follow(at, LEAST_FRICTION), rougher(1.0)[0])
        return Path(cone, weaker).follow(at, 0.0)

    def _from_stuck(self) -> State:
        """Solution at the end of the path that begins with all nodes sticking, on weak springs."""
        cone, mu, K = self.cone, self.cone.friction, self.cone.springs(SPRING)
        at = self._newton.at_rest(self._smooth(cone.springs(STIFF)), MOST_FRICTION * mu)
        share = min(BEYOND * float(cone.utilisation(at.multipliers).max(initial=0)), MOST_FRICTION)
        if share <= 1:
            return at
        e, none = self.e + K @ at.motion, np.zeros_like(K)

        def smoother(t: float) -> tuple[Task, Rate]:
            now = share ** (1 - t) * mu
            return Task(w_0=self.w_0, e=e, K=K, friction=now), Rate(-np.log(share) * now, none)

        return Path(cone, smoother).follow(self._newton.solve(at, smoother(0.0)[0]), 0.0)

    def _smooth(self, K: Array) -> State:
        """Solution without friction on springs `K`: pressures with the lowest energy."""
        m = self.cone.friction.size
        D = self.cone.D[:m]
        yields = np.linalg.solve(K, np.column_stack([D.T, self.e]))
        R = np.linalg.cholesky(self.cone.B[:m, :m] + D @ yields[:, :-1])
        w = self.w_0[:m] + D @ yields[:, -1]
        scale = float(np.abs(w).max(initial=0.0)) or 1.0
        pressures, _ = nnls(R.T, -solve_triangular(R, w / scale, lower=True), maxiter=100 * m)
        multipliers = np.zeros(len(self.cone.B))
        multipliers[:m] = scale * pressures
        motion = np.linalg.solve(K, self.e + self.cone.D.T @ multipliers)
        return State(multipliers, np.asarray(motion, np.float64))

    def _task(self, friction: Array, K: Array) -> Task:
        return Task(w_0=self.w_0, e=self.e, K=K, friction=friction)


def sticking(cone: Cone, w_0: Array, e: Array, plane: State) -> State:
    """Initial state: a solution of the plane problem, with all closed nodes sticking along z."""
    n, k = len(cone.B) - cone.rough.size, plane.motion.size
    closed = cone.z[plane.multipliers[cone.rough] > 0]
    B, D = cone.B[np.ix_(closed, closed)], cone.D[closed, k:]
    K = SPRING * (cone.stiffness[k:].max(initial=0.0) or 1.0) * np.eye(D.shape[1])
    scale = 1 / np.sqrt(np.concatenate([np.diag(B), np.diag(K)]))
    A = scale[:, None] * np.block([[B, D], [D.T, -K]]) * scale
    found = scale * np.linalg.solve(A, scale * -np.concatenate([w_0[closed], e[k:]]))
    multipliers = np.zeros(len(cone.B))
    multipliers[:n] = plane.multipliers
    multipliers[closed] = found[: closed.size]
    return State(multipliers, np.concatenate([plane.motion, found[closed.size :]]))
