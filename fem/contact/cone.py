"""Coulomb's circular cone: contact with friction along the surface and along z at the same time.

The unknowns are the multipliers l = (normal, tangential, along z) and the amplitudes a of rigid
motions and of shifts along z, as in the module `complementarity`:

    w = w_0 + B l + D a,    e + D' l = 0.

Normal rows: l_n >= 0, w_n >= 0, l_n w_n = 0. At nodes with friction, the length of (l_t, l_z) is at
most mu l_n; if it equals mu l_n, (l_t, l_z) is opposite to (w_t, w_z). Equivalent conditions are

    l_n = max(0, l_n - c_n w_n),   (l_t, l_z) = P((l_t, l_z) - c (w_t, w_z)),

where P is the projection on the disc of radius mu max(0, l_n - c_n w_n). Newton's method solves
these equations. The projection of a node determines its state: open, sticking or slipping (Alart
and Curnier 1991). The direction of slip is part of the solution.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.contact.complementarity import BACKWARD, FORWARD, OPEN, STICK
from fem.contact.cone_system import EXACT, State, System, Task
from fem.plane.discretisation import Array

SLIP = FORWARD
CANCELLED = 1e-5  # relative to the pressures that close gaps: smaller ones are not exact to EXACT


@dataclass(frozen=True)
class Residual:
    """Violation of the contact laws by a solution.

    `coulomb` (Coulomb's law) and `complementarity` (gap and pressure) are relative to the largest
    pressure. `equilibrium` (of rigid motions) is relative to the forces on the rigid motions.
    """

    coulomb: float
    complementarity: float
    equilibrium: float

    def __str__(self) -> str:
        return (
            f"Coulomb's law by {self.coulomb:.1e}, complementarity by {self.complementarity:.1e}, "
            f"equilibrium by {self.equilibrium:.1e}"
        )

    @property
    def largest(self) -> float:
        """Largest of the residuals of Coulomb's law, complementarity and equilibrium."""
        return max(self.coulomb, self.complementarity, self.equilibrium)


class Cone(System):
    """Equations of contact with Coulomb's law of friction and Signorini's conditions."""

    def imbalance(self, w_0: Array, e: Array, at: State) -> float:
        """Unbalanced force on rigid motions, relative to all forces on rigid motions."""
        pushed = np.abs(self.D.T)
        size = np.abs(e) + pushed @ np.abs(at.multipliers)
        least = self._cancelled(w_0, self.trial(w_0, at)[0], at.motion)
        missed = np.abs(self._resisted @ (e + self.D.T @ at.multipliers))
        most = max(size.max(initial=0.0), least * pushed.max(initial=0.0))
        return float(missed.max(initial=0.0) / (most or 1.0))

    def trial(self, w_0: Array, at: State) -> tuple[Array, Array, Array]:
        """Gaps and slips w (n,), max(0, l_n - c_n w_n) (m,) and trial friction (2, r)."""
        m, (c_n, c) = self.friction.size, self.augmentation
        w = w_0 + self.B @ at.multipliers + self.D @ at.motion
        pressure = np.maximum(at.multipliers[:m] - c_n * w[:m], 0.0)
        return w, pressure, at.multipliers[self.tau] - c * w[self.tau]

    def error(self, task: Task, at: State) -> tuple[float, NDArray[np.int8]]:
        """Distance of `at` from its projection on the contact laws; states (m,) of the projection.

        The distance is relative to the largest pressure.
        """
        w, pressure, trial = self.trial(task.w_0, at)
        normal, along, states = self._projected(at, pressure, trial, task.friction)
        balance = task.e + self.D.T @ at.multipliers - task.K @ at.motion
        size = self._size(task.w_0, task.e, w, at, pressure)
        parts = normal.ravel(), along.ravel(), balance / self.reach
        return float(np.linalg.norm(np.concatenate(parts)) / size), states

    def _size(self, w_0: Array, e: Array, w: Array, at: State, pressure: Array) -> float:
        """Pressure by which residuals are divided.

        This is the largest pressure or, if larger, the uncertainty of pressures that round-off of
        loads and gaps causes.
        """
        closing = np.abs(w_0) / self.yields
        pulling = np.abs(e) / self.reach
        least = EXACT * float(max(closing.max(initial=0.0), pulling.max(initial=0.0))) or 1.0
        largest = float(pressure.max(initial=0.0))
        return max(largest, self._cancelled(w_0, w, at.motion), least)

    def _cancelled(self, w_0: Array, w: Array, motion: Array) -> float:
        """Pressure below which nearly closed gaps `w` are uncertain because of round-off."""
        m = self.friction.size
        gaps = np.abs(w_0[:m]) + np.abs(self.D[:m]) @ np.abs(motion)
        closed = w[:m] <= CANCELLED * gaps
        return CANCELLED * float((gaps / self.yields[:m])[closed].max(initial=0.0))

    def _projected(
        self, at: State, pressure: Array, trial: Array, friction: Array
    ) -> tuple[Array, Array, NDArray[np.int8]]:
        """Multipliers minus their projections, (m,) and (2, r), and the projected states."""
        most = (friction * pressure)[self.rough]
        length = np.hypot(*trial)
        slips = length > most
        share = np.where(slips, most / np.where(slips, length, 1.0), 1.0)
        states = np.where(pressure > 0, STICK, OPEN).astype(np.int8)
        states[self.rough[slips & (most > 0)]] = SLIP
        along = at.multipliers[self.tau] - share * trial
        return at.multipliers[: pressure.size] - pressure, along, states

    def judged(self, w_0: Array, e: Array, at: State) -> tuple[Residual, NDArray[np.int8], Array]:
        """Residuals of the state `at`, its contact states (m,), and its gaps and slips w (n,)."""
        w, pressure, trial = self.trial(w_0, at)
        normal, along, states = self._projected(at, pressure, trial, self.friction)
        size = self._size(w_0, e, w, at, pressure)
        residual = Residual(
            coulomb=float(np.abs(along).max(initial=0.0)) / size,
            complementarity=float(np.abs(normal).max(initial=0.0)) / size,
            equilibrium=self.imbalance(w_0, e, at),
        )
        backward = self.rough[at.multipliers[self.t] < 0]
        states[backward] = np.where(states[backward] == SLIP, BACKWARD, states[backward])
        return residual, states, w
