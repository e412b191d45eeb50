"""Linear system of a cone for given states: Newton's step, and tangents of a path of solutions.

The multipliers are l = Q x. The unknowns x are the pressures, the components of friction at
sticking nodes, and the friction perpendicular to the direction of slip. At slipping nodes, Q also
contains the friction in the direction of slip. The equations are the rows P' w of gaps
and slips, and the balance of forces, with P' l = x. P and Q (n, unknowns) are not formed as
matrices: they select and combine rows.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from fem.contact.complementarity import OPEN, STICK
from fem.contact.cone import SLIP, Cone
from fem.contact.cone_system import State, Task
from fem.plane.discretisation import Array, Indices

NEGLIGIBLE = 1e-24  # relative to the largest stiffness against a motion, in whose units others are


@dataclass(frozen=True)
class Rate:
    """Derivatives of `friction` (m,) and springs `K` (k, k) with respect to a path parameter."""

    friction: Array
    K: Array


@dataclass(frozen=True)
class Linearised:
    """Equations of `cone`, linearised at the state `at`.

    `states` (m,) gives the state of each node: open, sticking or slipping.
    """

    cone: Cone
    task: Task
    at: State
    states: NDArray[np.int8]

    def newton(self) -> State:
        """Result of one Newton step. Raises ArithmeticError if the system is singular."""
        x = self.scale * _solved(self._scaled, self.scale * self._known)
        return State(self._multipliers(x[: x.size - self._motions]), x[x.size - self._motions :])

    def bordered(self, rate: Rate, row: Array, t: float, to: float) -> tuple[Array, float]:
        """Solution z = (l, a, t) (n + k + 1,) with `row` z = `to`, and the sign of the determinant.

        `row` (n + k + 1,) defines a plane across the path; `t` is the parameter of the task. If `t`
        is nan, all other right-hand sides are zero, and z is the tangent, of any length.
        """
        n, k = self.cone.D.shape
        change = np.zeros(n)
        for i, tau in enumerate((self.cone.t, self.cone.z)):
            slip = self._slip
            pressure = self.at.multipliers[self.cone.rough[slip]]
            change[tau[slip]] = rate.friction[self.cone.rough[slip]] * self._d[i] * pressure
        column = np.concatenate([
            self._unpushed(self.cone.B @ change),
            self.cone.D.T @ change - rate.K @ self.at.motion,
        ])  # fmt: skip
        across = np.concatenate([self._pushed(row[:n]), row[n : n + k]])
        last = row[-1] + row[:n] @ change
        A = np.block([
            [self._scaled, (self.scale * column)[:, None]],
            [(across * self.scale)[None], np.array([[last]])],
        ])  # fmt: skip
        if np.isnan(t):
            known, there = np.append(np.zeros(column.size), to), 0.0
        else:
            there = t
            known = np.append(self.scale * (self._known + t * column), to + t * (row[:n] @ change))
        size = np.abs(A).max(axis=1)
        size = np.where(size > 0, size, 1.0)
        A, known = A / size[:, None], known / size
        sign = float(np.linalg.slogdet(A)[0])
        y = np.linalg.solve(A, known) if sign else np.full(known.size, np.nan)
        x = self.scale * y[:-1]
        multipliers = self._multipliers(x[: x.size - k]) + (y[-1] - there) * change
        return np.concatenate([multipliers, x[x.size - k :], y[-1:]]), sign

    @property
    def _motions(self) -> int:
        return self.cone.D.shape[1]

    @cached_property
    def _slip(self) -> Indices:
        return np.flatnonzero(self.states[self.cone.rough] == SLIP)

    @cached_property
    def _trial(self) -> tuple[Array, Array]:
        _, pressure, trial = self.cone.trial(self.task.w_0, self.at)
        return pressure, trial

    @cached_property
    def _d(self) -> Array:
        """Directions (2, slipping) of friction at slipping nodes."""
        trial = self._trial[1][:, self._slip]
        return np.asarray(trial / np.hypot(*trial))

    @cached_property
    def _places(self) -> tuple[Indices, Indices, Indices]:
        """Rows of the multipliers, and positions of some pressures among the unknowns.

        The first array contains the rows of pressures and of friction at sticking nodes, the second
        array (2, slipping) the rows of friction at slipping nodes. The last array contains the
        positions of the pressures at slipping nodes.
        """
        cone, slip = self.cone, self._slip
        closed = np.flatnonzero(self.states != OPEN)
        stick = np.flatnonzero(self.states[cone.rough] == STICK)
        x = np.concatenate([closed, cone.t[stick], cone.z[stick]])
        tau = np.array([cone.t[slip], cone.z[slip]])
        return x, tau, np.searchsorted(closed, cone.rough[slip])

    @cached_property
    def _drag(self) -> Array:
        """Friction (2, slipping) at slipping nodes under unit pressure."""
        return np.asarray(self.task.friction[self.cone.rough[self._slip]] * self._d)

    def _unpushed(self, rows: Array) -> Array:
        """Product M P (..., unknowns) for `rows` M (..., n)."""
        x, (t, z), _ = self._places
        across = rows[..., t] * -self._d[1] + rows[..., z] * self._d[0]
        return np.concatenate([rows[..., x], across], axis=-1)

    def _pushed(self, rows: Array) -> Array:
        """Product M Q (..., unknowns) for `rows` M (..., n)."""
        _, (t, z), pressed = self._places
        found = self._unpushed(rows)
        found[..., pressed] += rows[..., t] * self._drag[0]
        found[..., pressed] += rows[..., z] * self._drag[1]
        return found

    def _multipliers(self, unknowns: Array) -> Array:
        """Multipliers Q x (n,) for the `unknowns` x."""
        x, (t, z), pressed = self._places
        found, pressure, across = np.zeros(len(self.cone.B)), unknowns[pressed], unknowns[x.size :]
        found[x] = unknowns[: x.size]
        found[t] = self._drag[0] * pressure - self._d[1] * across
        found[z] = self._drag[1] * pressure + self._d[0] * across
        return found

    @cached_property
    def scale(self) -> Array:
        """Scaling factors of the unknowns, with which the entries of the system are about one."""
        (x, (t, z), _), own, yields = self._places, self.cone.stiffness, self.cone.yields
        across = self._d[1] ** 2 * yields[t] + self._d[0] ** 2 * yields[z]
        stiff = np.concatenate([yields[x], across])
        least = NEGLIGIBLE * own.max(initial=0.0) or 1.0
        return np.asarray(1 / np.sqrt(np.concatenate([stiff, np.maximum(own, least)])))

    @cached_property
    def _scaled(self) -> Array:
        cone, slip = self.cone, self._slip
        pressure, trial = self._trial
        limit = (self.task.friction * pressure)[cone.rough[slip]]
        share = limit / np.hypot(*trial[:, slip])
        A = self._pushed(self._unpushed(cone.B.T).T)
        # friction turns towards the transverse slip; it turns more for a smaller slip
        across = len(A) - slip.size + np.arange(slip.size)
        A[across, across] += (1 - share) / (share * cone.augmentation[1][slip])
        D = self._unpushed(cone.D.T).T
        A = np.block([[A, D], [self._pushed(cone.D.T), -self.task.K]])
        return np.asarray(self.scale[:, None] * A * self.scale)

    @cached_property
    def _known(self) -> Array:
        return -np.concatenate([self._unpushed(self.task.w_0), self.task.e])


def _solved(A: Array, known: Array) -> Array:
    try:
        return np.asarray(np.linalg.solve(A, known), np.float64)
    except np.linalg.LinAlgError:
        raise ArithmeticError(
            "the contact forces are not unique: a support or another pair acts on the same nodes"
        ) from None
