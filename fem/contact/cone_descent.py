"""Solutions of a cone's equations under given loads, on springs that are let go.

The motions are held by weak springs to where they were, until nothing pulls at these. Where
Newton's method fails from a start, the springs are strong first, and then friction is high first:
what sticks has one solution, from which the next one is not far.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.contact.complementarity import AWAY
from fem.contact.cone import SPRING, Cone, State, Task
from fem.plane.discretisation import Array

FINE = 1e-13  # of the peak pressure: Newton's method ends
GOOD = 1e-10  # here too, where rounding lets it come no closer
MAX_STEPS = 40
ROUGHLY = 0.2  # of the peak pressure: so much Newton's full step may miss, and more than before
SHORTEST = 1.0 / 8  # of Newton's step, where it misses more than any of the steps before
MEMORY = 6  # of these steps
WEAKEST = 1e-12  # of the contact's own stiffness
EASED, HARDLY = 0.1, 0.7  # of a spring, the next one: at first, and where that is too far
RUNAWAY = 100.0  # times what surfaces deform: no friction holds what moves more
FAR = 1.0  # nor what moves more than this, if no rest is found near there
MAX_RELEASES = 60
LOWER = 0.7  # friction from one solution on the way down to the next
MAX_LOWER = 40
BEYOND = 1.01  # of the friction that is used: no more is needed


class SlidingError(ArithmeticError):
    """Friction is exhausted: the loads `missed` (k,) move bodies on."""

    def __init__(self, missed: Array) -> None:
        super().__init__("friction is exhausted, and bodies slide on")
        self.missed = missed


@dataclass(frozen=True)
class Descent:
    """A cone under `w_0` (n,) and `e` (k,)."""

    cone: Cone
    w_0: Array
    e: Array

    def solve(self, starts: list[State]) -> State:
        """The solution from the first start that leads to one.

        Where none does, friction is lowered to its value from where everything sticks.
        ArithmeticError where that fails too, or the bodies come to no rest.
        """
        failed: ArithmeticError | None = None
        for solve in (self._released, self._lowered):
            for start in starts:
                try:
                    return solve(start, self.cone.friction)
                except SlidingError:
                    raise
                except ArithmeticError as error:
                    failed = error
        raise failed or ArithmeticError("the contact has no start")

    def _lowered(self, at: State, friction: Array) -> State:
        """From friction at which everything sticks, step by step down to what there is."""
        at = self._released(at, friction * LOWER**-MAX_LOWER)
        share = min(BEYOND * self.cone.use(at.multipliers).max(initial=0.0), LOWER**-MAX_LOWER)
        while share > 1:
            at = self._released(at, friction * share)
            share *= LOWER
        return self._released(at, friction)

    def _released(self, at: State, friction: Array) -> State:
        """The solution on springs that follow the motions until nothing pulls at them."""
        try:
            at = self._newton(at, SPRING, friction, most=MAX_STEPS // 2)
        except ArithmeticError:
            at = self._eased(at, friction)
        spring = SPRING
        missed = self.cone.missed(self.e, at)
        for _ in range(MAX_RELEASES):
            if missed <= FINE:
                return at
            before = missed
            at = self._newton(at, spring, friction)
            missed = self.cone.missed(self.e, at)
            if missed > before / 2:
                if missed <= GOOD:
                    return at
                spring = max(WEAKEST, spring / 10)
        raise SlidingError(self.e + self.cone.D.T @ at.multipliers)

    def _eased(self, at: State, friction: Array) -> State:
        """On springs that are let go; what they still carry then slides."""
        spring, share, moved = 1.0, EASED, 0.0
        at = self._newton(at, spring, friction)
        while spring > SPRING:
            try:
                new = self._newton(at, max(share * spring, SPRING), friction)
            except ArithmeticError:
                share = float(np.sqrt(share))
                if share <= HARDLY:
                    continue
                if moved > FAR:
                    raise SlidingError(self.e + self.cone.D.T @ at.multipliers) from None
                raise
            at, spring, share = new, max(share * spring, SPRING), max(share**2, EASED)
            # in what surfaces deform: a spring's stiffness is a share of theirs
            moved = self.cone.missed(self.e, at) / spring
            if moved > RUNAWAY:
                raise SlidingError(self.e + self.cone.D.T @ at.multipliers)
        return at

    def _newton(self, at: State, spring: float, friction: Array, most: int = MAX_STEPS) -> State:
        """The solution with springs that hold the motions where they are."""
        K = self.cone.springs(spring)
        task = Task(w_0=self.w_0, e=self.e + K @ at.motion, K=K, friction=friction)
        error, states = self.cone.error(task, at)
        errors = [error]
        for _ in range(most):
            before = states
            at, error, states = self._step(task, at, states, errors)
            errors.append(error)
            ends = bool(np.all(states == before)) and error <= GOOD and error > errors[-2] / 10
            if error <= FINE or ends:
                return at
        raise ArithmeticError(
            f"the contact did not converge: after {most} steps Newton's method still misses "
            f"Coulomb's law by {error:.2e} of the pressure{AWAY}"
        )

    def _step(
        self, task: Task, at: State, states: NDArray[np.int8], errors: list[float]
    ) -> tuple[State, float, NDArray[np.int8]]:
        """Newton's step, or the part of it that misses no more than those before; else the best."""
        goal, share = self.cone.linear(task, at, states), 1.0
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
