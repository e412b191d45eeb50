"""Path of solutions of the equations of a cone, followed past turning points by its arc length.

The problem changes with a parameter t. Each step follows the tangent and returns to the path by
Newton's method in a plane normal to the tangent, in which t is also unknown. The path is smooth,
except at points where a node changes its state; there, the path may reverse its direction. The
determinant of the equations and the tangent has a constant sign along the path. This sign gives the
direction (Allgower and Georg 1990).
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.contact.cone import Cone
from fem.contact.cone_linear import Linearised, Rate
from fem.contact.cone_system import State, Task
from fem.contact.errors import NotFoundError
from fem.plane.discretisation import Array

MAX_STEPS = 1000
FIRST, LONGEST, SHORTEST = 1e-2, 0.5, 1e-6  # arc lengths of a step
MAX_CORRECTIONS, FEW_CORRECTIONS = 8, 4
ON_PATH = 1e-9  # relative to the peak pressure: allowed error of points of the path
SMOOTH = 0.7  # cosine of the angle by which the tangent may turn in a step of more than SHORTEST
PROBES, INTO = 20, 4  # steps, each twice the one before: to the next states, and into them


@dataclass(frozen=True)
class Point:
    """Point of a path: `z` (n + k + 1,) = (l, a, t), its `states` (m,) and the unit `tangent`."""

    z: Array
    states: NDArray[np.int8]
    tangent: Array


@dataclass(frozen=True)
class Path:
    """Path of solutions of `cone` under `task`(t) up to t = 1.

    `task`(t) also returns the derivative of the task.
    """

    cone: Cone
    task: Callable[[float], tuple[Task, Rate]]

    def follow(self, at: State, t: float) -> State:
        """Approximate solution at the end of the path, followed from the state `at`.

        `at` solves the equations at the parameter `t` < 1; the path ends at the parameter 1.

        Newton's method can correct the result. Raises NotFoundError if the path does not reach t =
        1 within MAX_STEPS steps.
        """
        z, h = np.concatenate([at.multipliers, at.motion, [t]]), FIRST
        row = np.append(np.zeros(z.size - 1), 1.0)
        states = self._error(z)[1]
        tangent, sign = self._linear(z, states).bordered(self.task(t)[1], row, np.nan, 1.0)
        here = Point(z, states, self._unit(z, tangent))
        for _ in range(MAX_STEPS):
            found = self._step(here, h, sign)
            if found is not None:
                new, steps = found
                h = min(LONGEST, 2 * h) if steps <= FEW_CORRECTIONS else h
            elif h > SHORTEST:
                h /= 4
                continue
            else:
                turned = self._turn(here, h, sign)
                if turned is None:
                    break
                new = turned
            if new.z[-1] < t:
                break  # back at the start
            if new.z[-1] >= 1:
                share = (1 - here.z[-1]) / (new.z[-1] - here.z[-1])
                z, n = here.z + share * (new.z - here.z), at.multipliers.size
                return State(z[:n], z[n:-1])
            here = new
        raise NotFoundError(f"the path of solutions ends at the parameter t = {here.z[-1]:.3g} < 1")

    def _step(self, here: Point, h: float, sign: float) -> tuple[Point, int] | None:
        """Next point of the path, at the arc length `h`, and number of corrections; or None."""
        row = self._weight(here.z) * here.tangent
        found = self._corrected(here.z + h * here.tangent, row)
        if found is None:
            return None
        z, states, steps = found
        tangent = self._tangent(z, states, row, sign)
        turned = (self._weight(z) * tangent) @ self._unit(z, here.tangent)
        if h > SHORTEST and turned < SMOOTH:
            return None
        return Point(z, states, tangent), steps

    def _turn(self, here: Point, h: float, sign: float) -> Point | None:
        """Point after the next change of states, if the path has a kink there; or None."""
        for _ in range(PROBES):
            z = here.z + h * here.tangent
            states = self._error(z)[1]
            if np.any(states != here.states):
                break
            h *= 2
        row = self._weight(z) * here.tangent
        tangent = self._tangent(z, states, row, sign)
        row = self._weight(z) * tangent
        for _ in range(PROBES):
            h *= INTO
            found = self._corrected(z + h * tangent, row)
            if found is not None:
                return Point(found[0], found[1], self._tangent(*found[:2], row, sign))
        return None

    def _corrected(self, z: Array, row: Array) -> tuple[Array, NDArray[np.int8], int] | None:
        """Point of the path in a plane through `z`, its states, and the number of corrections.

        `row` is the normal of the plane. The result is None if Newton's method does not converge.
        """
        to = row @ z
        for step in range(MAX_CORRECTIONS + 1):
            if not (np.all(np.isfinite(z)) and z[-1] >= 0):
                return None
            error, states = self._error(z)
            if error <= ON_PATH:
                return z, states, step
            rate = self.task(z[-1])[1]
            z = self._linear(z, states).bordered(rate, row, float(z[-1]), float(to))[0]
        return None

    def _tangent(self, z: Array, states: NDArray[np.int8], row: Array, sign: float) -> Array:
        """Unit tangent, in the direction for which the determinant has the sign `sign`."""
        found, now = self._linear(z, states).bordered(self.task(z[-1])[1], row, np.nan, 1.0)
        return self._unit(z, found if now == sign else -found)

    def _error(self, z: Array) -> tuple[float, NDArray[np.int8]]:
        return self.cone.error(self.task(z[-1])[0], self._state(z))

    def _linear(self, z: Array, states: NDArray[np.int8]) -> Linearised:
        return Linearised(self.cone, self.task(z[-1])[0], self._state(z), states)

    def _state(self, z: Array) -> State:
        n = len(self.cone.B)
        return State(z[:n], z[n:-1])

    def _weight(self, z: Array) -> Array:
        """Weights (n + k + 1,) of a sum of squares that is one for forces and motions of `z`."""
        weight = np.append(np.diag(self.cone.B), self.cone.stiffness)
        size = float(weight @ z[:-1] ** 2)
        return np.append(weight / (size or 1.0), 1.0)

    def _unit(self, z: Array, direction: Array) -> Array:
        return np.asarray(direction / np.sqrt(self._weight(z) @ direction**2))
