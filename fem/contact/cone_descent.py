"""Solutions of a cone's equations under given loads.

Newton's method, with the motions on weak springs that follow them until nothing pulls at these,
from each start. Where it fails from all of them, paths of solutions are followed through their
turns, on springs that hold the motions where they are: one from no friction to the friction there
is, then with weaker and weaker springs, and one from friction at which everything sticks.

On springs there is a solution for every friction, and the first path leads to one: it stays bounded
and cannot return to its only start. As the springs are let go it stays bounded where pressures
alone can balance the loads, -e = D_n' l_n with l_n >= 0. So there a state of rest exists, and is
found but for rounding. Where only friction balances the loads there may be none, or several; that
none is found then proves nothing. `cone_reach` proves that there is none.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_triangular
from scipy.optimize import nnls

from fem.contact.cone import SPRING, Cone, State, Task
from fem.contact.cone_linear import Linearised, Rate
from fem.contact.cone_path import Path
from fem.contact.errors import NotFoundError
from fem.plane.discretisation import Array

FINE = 1e-13  # of the peak pressure: Newton's method ends
GOOD = 1e-10  # here too, where rounding lets it come no closer
MAX_STEPS = 40
ROUGHLY = 0.2  # of the peak pressure: so much Newton's full step may miss, and more than before
SHORTEST = 1.0 / 8  # of Newton's step, where it misses more than any of the steps before
MEMORY = 6  # of these steps
WEAKEST = 1e-12  # of the contact's own stiffness
MAX_RELEASES = 60
LEAST_FRICTION = 1e-4  # of what there is: where the path from no friction starts
MOST_FRICTION = 1e6  # times what there is: everything sticks
BEYOND = 1.01  # of the friction that is used: no more is needed

LAST = ""


class SlidingError(NotFoundError):
    """No state of rest was found: the loads `missed` (k,) move bodies on."""

    def __init__(self, missed: Array) -> None:
        super().__init__("the loads move bodies on")
        self.missed = missed


@dataclass(frozen=True)
class Descent:
    """A cone under `w_0` (n,) and `e` (k,)."""

    cone: Cone
    w_0: Array
    e: Array

    def solve(self, starts: list[State]) -> State:
        """The solution from the first start that leads to one, else along a path.

        SlidingError where solutions on springs do not come to rest without them, else
        NotFoundError.
        """
        global LAST
        failed: NotFoundError | None = None
        for i, start in enumerate(starts):
            try:
                at = self._released(start, self.cone.friction)
                LAST = f"start {i}"
                return at
            except ArithmeticError as error:
                failed = error
        for path in (self._from_smooth, self._from_stuck):
            try:
                at = self._released(path(), self.cone.friction)
                LAST = path.__name__
                return at
            except ArithmeticError as error:
                if not isinstance(failed, SlidingError):
                    failed = error
        raise failed

    def _from_smooth(self) -> State:
        """The end of the path from no friction, on springs, and that of weaker springs."""
        cone, mu, K = self.cone, self.cone.friction, self.cone.springs(1.0)
        none = np.zeros_like(K)

        def rougher(t: float) -> tuple[Task, Rate]:
            return self._task(t * mu, K), Rate(mu, none)

        def weaker(t: float) -> tuple[Task, Rate]:
            share = SPRING**t
            change = (cone.springs(2 * share) - cone.springs(share)) * np.log(SPRING)
            return self._task(mu, cone.springs(share)), Rate(np.zeros_like(mu), change)

        task, _ = rougher(LEAST_FRICTION)
        at = self._newton(self._smooth(K), task)
        at = self._newton(Path(cone, rougher).follow(at, LEAST_FRICTION), self._task(mu, K))
        return Path(cone, weaker).follow(at, 0.0)

    def _from_stuck(self) -> State:
        """The end of the path from where everything sticks."""
        cone, mu = self.cone, self.cone.friction
        at = self._released(self._smooth(cone.springs(1.0)), MOST_FRICTION * mu)
        share = float(min(BEYOND * cone.use(at.multipliers, MOST_FRICTION*mu).max(initial=0.0)*MOST_FRICTION, MOST_FRICTION))
        if share <= 1:
            return at
        K = cone.springs(SPRING)
        e = self.e + K @ at.motion
        none = np.zeros_like(K)

        def smoother(t: float) -> tuple[Task, Rate]:
            now = share ** (1 - t) * mu
            return Task(w_0=self.w_0, e=e, K=K, friction=now), Rate(-np.log(share) * now, none)

        return Path(cone, smoother).follow(self._newton(at, smoother(0.0)[0]), 0.0)

    def _smooth(self, K: Array) -> State:
        """The solution without friction on springs `K`: the least energy under pressures alone."""
        m = self.cone.friction.size
        D = self.cone.D[:m]
        yields = np.linalg.solve(K, np.column_stack([D.T, self.e]))
        R = np.linalg.cholesky(self.cone.B[:m, :m] + D @ yields[:, :-1])
        w = self.w_0[:m] + D @ yields[:, -1]
        l = np.zeros(len(self.cone.B))
        scale = float(np.abs(w).max(initial=0.0)) or 1.0
        l[:m] = scale * nnls(R.T, -solve_triangular(R, w / scale, lower=True), maxiter=100 * m)[0]
        return State(l, np.linalg.solve(K, self.e + self.cone.D.T @ l))

    def _task(self, friction: Array, K: Array) -> Task:
        return Task(w_0=self.w_0, e=self.e, K=K, friction=friction)

    def _released(self, at: State, friction: Array) -> State:
        """The solution on springs that follow the motions until nothing pulls at them."""
        spring, missed = SPRING, np.inf
        for _ in range(MAX_RELEASES):
            K = self.cone.springs(spring)
            e = self.e + K @ at.motion
            at = self._newton(at, Task(w_0=self.w_0, e=e, K=K, friction=friction))
            before, missed = missed, self.cone.missed(self.w_0, self.e, at)
            if missed <= FINE:
                return at
            if missed > before / 2:
                if missed <= GOOD:
                    return at
                if spring <= WEAKEST:
                    break
                spring = max(WEAKEST, spring / 10)
        raise SlidingError(self.e + self.cone.D.T @ at.multipliers)

    def _newton(self, at: State, task: Task) -> State:
        """The solution of the task by Newton's method from `at`."""
        error, states = self.cone.error(task, at)
        errors = [error]
        for step in range(MAX_STEPS):
            before = states
            at, error, states = self._step(task, at, states, errors)
            errors.append(error)
            still = bool(np.all(states == before)) and error > errors[-2] / 10
            if error <= FINE or (error <= GOOD and (still or step >= MAX_STEPS // 2)):
                return at
        raise NotFoundError(
            f"after {MAX_STEPS} steps Newton's method still misses Coulomb's law by {error:.2e} of "
            "the pressure"
        )

    def _step(
        self, task: Task, at: State, states: NDArray[np.int8], errors: list[float]
    ) -> tuple[State, float, NDArray[np.int8]]:
        """Newton's step, or the part of it that misses no more than those before; else the best."""
        goal, share = Linearised(self.cone, task, at, states).newton(), 1.0
        found: list[tuple[float, State, NDArray[np.int8]]] = []
        while share >= SHORTEST:
            new = State(
                at.multipliers + share * (goal.multipliers - at.multipliers),
                at.motion + share * (goal.motion - at.motion),
            )
            error, wanted = self.cone.error(task, new)
            if error <= max([ROUGHLY, *errors[-MEMORY:]]):
                return new, error, wanted
            found.append((error, new, wanted))
            share /= 2
        error, new, wanted = min(found, key=lambda one: one[0])
        return new, error, wanted
