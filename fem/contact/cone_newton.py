"""Newton's method for the equations of a cone, with relaxed springs on the rigid motions."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.contact.cone import Cone
from fem.contact.cone_linear import Linearised
from fem.contact.cone_system import State, Task
from fem.contact.errors import NotFoundError
from fem.plane.discretisation import Array

FINE = 1e-13  # relative to the peak pressure: Newton's method ends
GOOD = 1e-10  # accepted as well if rounding prevents a smaller error
MAX_STEPS = 40
ROUGHLY = 0.2  # over the peak pressure: error up to which a full Newton step may increase the error
SHORTEST = 1.0 / 8  # of Newton's step, if its error exceeds those of the previous MEMORY steps
MEMORY = 6  # number of steps
SPRING, WEAKEST = 1e-7, 1e-12  # of the contact's stiffness: the first springs and the last
MAX_RELEASES = 60


class SlidingError(NotFoundError):
    """No state of rest was found: springs still carry the loads `carried` (k,) on rigid motions.

    This is not a proof: another state of rest may exist.
    """

    def __init__(self, carried: Array, reasons: Sequence[str] = ()) -> None:
        super().__init__("; ".join(reasons) or "bodies move on as springs are released")
        self.carried = carried


@dataclass(frozen=True)
class Newton:
    """Newton's method for a cone with gaps `w_0` (n,) and loads `e` (k,).

    `w_0` are the gaps and slips without contact forces, `e` the loads on the rigid motions.
    """

    cone: Cone
    w_0: Array
    e: Array

    def at_rest(self, at: State, friction: Array) -> State:
        """State of rest, found by relaxing springs on the rigid motions until they carry no load.

        Raises SlidingError if the springs still carry loads at the end, NotFoundError if a step
        fails.
        """
        spring, imbalance = SPRING, np.inf
        for _ in range(MAX_RELEASES):
            K = self.cone.springs(spring)
            task = Task(w_0=self.w_0, e=self.e + K @ at.motion, K=K, friction=friction)
            at = self.solve(at, task)
            before, imbalance = imbalance, self.cone.imbalance(self.w_0, self.e, at)
            if imbalance <= FINE:
                return at
            if imbalance > before / 2:
                if imbalance <= GOOD:
                    return at
                if spring <= WEAKEST * (1 + 1e-9):  # not the last bit of a product
                    break
                spring = max(WEAKEST, spring / 10)
        raise SlidingError(self.e + self.cone.D.T @ at.multipliers)

    def solve(self, at: State, task: Task) -> State:
        """Solution of `task`, iterated from `at`. Raises NotFoundError without convergence."""
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
            f"after {MAX_STEPS} steps of Newton's method, the violation of Coulomb's law is still "
            f"{error:.1e} of the pressure"
        )

    def _step(
        self, task: Task, at: State, states: NDArray[np.int8], errors: list[float]
    ) -> tuple[State, float, NDArray[np.int8]]:
        """State after a step, its residual and contact states.

        The step is Newton's step or a part of it: the longest part with an acceptable residual, or
        the part with the smallest residual if no residual is acceptable.
        """
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
