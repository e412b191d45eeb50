"""Oscillations of a sprag clutch about its state at rest, by time steps.

The methods compute slow load rises, free oscillations and first peaks. Compiled code is imported
only when it is used.
"""

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from analytic.sprag.motion import Motion, Torque
from analytic.sprag.race_spring import RaceSpring
from analytic.sprag.table import Table, tabulated

if TYPE_CHECKING:
    from analytic.sprag.history import Engagement

HELD = 1e6  # times its inertia, which holds the outer race
PACE = 200  # steps in a period, if the period determines the step
DAMPED = 0.3  # of critical damping
RAMP, REST = 4, 12  # periods in which the torque rises, and in which motion decays
SWUNG = 1.5  # periods about rest, past the first peak without damping
SLOW, COUNTED = 8, 12  # periods of the ramp and of the free oscillation
STEP = 0.01  # step over the torque that starts the oscillation


def held(motion: Motion, **changes: float) -> Motion:
    """`motion` with a fixed outer race (very large inertia), and with other `changes`."""
    return replace(motion, I_be=HELD * motion.I_be, **changes)


def strut_table(spring: RaceSpring) -> Table:
    """Table of the clutch, with N_e/N_i of a two-force strut instead of 1."""
    return tabulated(spring.clutch, N_end=spring.end, balanced=True)


@dataclass(frozen=True)
class Oscillation:
    """Oscillation of a clutch with a fixed outer race about its state at rest under T [N m].

    f [Hz] and k [N m/rad] are approximate values of frequency and stiffness. They determine only
    durations, time steps and damping. The equations of `motion` are integrated for the clutch
    `spring`.
    """

    spring: RaceSpring
    motion: Motion
    T: float
    f: float
    k: float

    def undamped(self, dt: float, least: float = 0.0) -> "Engagement":
        """Undamped engagement under a torque step, computed for at least `least` [s]."""
        until = max(least, SWUNG / self.f)
        return self._run(Torque.step(self.T), until, dt)

    def strut(self, dt: float) -> "Engagement":
        """Engagement under a torque step, with N_e/N_i of a two-force strut instead of 1."""
        return self._run(Torque.step(self.T), SWUNG / self.f, dt, strut_table(self.spring))

    def settled(self, refine: int) -> float:
        """Force N [N] at rest after a slow, damped torque rise; `refine` divides the time step."""
        damping = 2 * DAMPED * self.k / (2 * math.pi * self.f)
        course = Torque.step(self.T, t_ramp=RAMP / self.f)
        dt = 1 / (PACE * refine * self.f)
        return float(self._run(course, (RAMP + REST) / self.f, dt, C_rl=damping).N[-1])

    def frequency(self, refine: int) -> float:
        """Frequency [Hz] of small free oscillations about the state at rest, by zero crossings."""
        period = 1 / self.f
        dt = period / (PACE * refine)
        ramp = SLOW * period
        times, shares = np.array([0.0, ramp, ramp + dt]), np.array([0, 1 - STEP, 1])
        course = Torque(times=times, values=self.T * shares)
        found = self._run(course, ramp + COUNTED * period, dt)
        late = found.t > ramp + dt
        N, t = found.N[late] - found.N[late].mean(), found.t[late]
        up = np.flatnonzero((N[:-1] < 0) & (N[1:] >= 0))
        crossings = t[up] - N[up] * dt / (N[up + 1] - N[up])
        return float(1 / np.diff(crossings).mean())

    def _run(
        self, course: Torque, duration: float, dt: float, table: Table | None = None,
        C_rl: float = 0.0,
    ) -> "Engagement":  # fmt: skip
        from analytic.sprag.transient import engage

        moves = held(self.motion, C_rl=C_rl)
        return engage(table or self.spring.table(), moves, course, duration=duration, dt=dt)
