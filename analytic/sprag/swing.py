r"""Oscillation of two races with a sprag clutch as the spring between them.

.. math::
    I_{bi}\,\theta_i'' = C - T(\theta) - C_{rl}\,\theta', \qquad
    I_{be}\,\theta_e'' = T(\theta) + C_{rl}\,\theta' - k_{out}\,\theta_e

This model and the equations of motion (Eqs. 14-16) have only the closure equations in common.
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from analytic.contact.checks import Array
from analytic.sprag.motion import Motion
from analytic.sprag.race_spring import RaceSpring

SAMPLES = 1201  # over the time followed
FINE = 20_001  # turns at which the spring is known
RTOL = 1e-8


@dataclass(frozen=True, eq=False)
class Swing:
    """Relative rotation [rad] of the races and N [N] at times t [s]; time and value of peak N."""

    t: Array
    theta: Array
    N: Array
    peak: tuple[float, float]
    over: bool  # past the end of the profile


@dataclass(frozen=True, kw_only=True)
class Driven:
    """Torque `T` [N m], reached after `t_ramp` [s], on a race with the initial speed `w_i` [rad/s].

    The motion is computed until `t_end` [s].
    """

    T: float
    t_ramp: float
    w_i: float
    t_end: float

    def at(self, t: float) -> float:
        """Torque [N m] on the inner race."""
        return self.T * min(t / self.t_ramp, 1.0) if self.t_ramp > 0 else self.T


def time_to_rest(q: Driven, motion: Motion) -> float:
    """Time [s] after which the torque has stopped an overrunning race.

    Drag is neglected if the torque rises over a time `t_ramp` > 0.
    """
    if q.w_i >= 0:
        return 0.0

    def impulse(t: float) -> float:
        return q.T * (t - q.t_ramp / 2 if t > q.t_ramp else t**2 / (2 * q.t_ramp))

    if q.t_ramp > 0:
        late = motion.I_bi * -q.w_i / q.T + q.t_ramp
        return float(brentq(lambda t: impulse(t) + motion.I_bi * q.w_i, 0.0, 2 * late))
    slowed = motion.C_rl * -q.w_i / q.T
    return motion.I_bi * -q.w_i / q.T * (math.log1p(slowed) / slowed if slowed else 1.0)


def swing(w: RaceSpring, q: Driven, motion: Motion) -> Swing:
    """Motion of two races with the clutch as a spring: rolling, massless sprags.

    An overrunning race first comes to rest and then engages. Raises ArithmeticError if the
    integration ends prematurely.
    """
    rest = time_to_rest(q, motion)
    force, start = w.force(), w.start
    fine = np.linspace(0, w.theta[-1], FINE)
    resists = w.resistance()(fine)

    def spring(theta: float) -> float:
        return float(np.interp(theta, fine, resists))

    def rates(t: float, y: Array) -> list[float]:
        T = spring(y[0] - y[1]) + motion.C_rl * (y[2] - y[3])
        outer = T - motion.k_out * y[1]
        return [y[2], y[3], (q.at(t) - T) / motion.I_bi, outer / motion.I_be]

    def turns(_: float, y: Array) -> float:
        return float(y[2] - y[3])

    def over(_: float, y: Array) -> float:
        return float(w.theta[-1] - (y[0] - y[1]))

    turns.direction = -1  # type: ignore[attr-defined]
    over.terminal = True  # type: ignore[attr-defined]
    t = np.linspace(min(rest, q.t_end * (1 - 1e-3)), q.t_end, SAMPLES)
    found = solve_ivp(
        rates, (t[0], q.t_end), [start, 0.0, max(q.w_i, 0.0), 0.0], method="LSODA", rtol=RTOL,
        atol=1e-12, t_eval=t, events=(turns, over), max_step=q.t_end / 100,
    )  # fmt: skip
    if found.status < 0:
        raise ArithmeticError(
            f"the time integration of the motion of both races failed: {found.message}"
        )
    theta = found.y[0] - found.y[1]
    N = np.where(theta > 0, force(np.maximum(theta, 0)), 0.0)
    peaks = [
        (float(when), float(force(y[0] - y[1])))
        for when, y in zip(found.t_events[0], found.y_events[0], strict=True)
        if y[0] > y[1]
    ]
    last = (float(found.t[-1]), float(N[-1]))
    return Swing(
        found.t, theta, N, max([*peaks, last], key=lambda p: p[1]),
        over=len(found.t_events[1]) > 0,
    )  # fmt: skip
