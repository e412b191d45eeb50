"""Check of the time step of an engagement by its energy balance."""

import math

import numpy as np

from analytic.sprag.balance import balance
from analytic.sprag.history import Engagement
from analytic.sprag.motion import Motion
from analytic.sprag.table import Table

MISSED = 1e-2  # relative to the work put in: beyond it an engagement is not valid
RADIAN = 0.3  # of the fastest motion in one step: Runge-Kutta's error is then below 1e-4


class LongStepError(ArithmeticError):
    """Raised if the time step is too long.

    Then, the error of the energy balance exceeds a hundredth of the work done, the motion diverges,
    or no sticking band is wide enough.
    """

    def __init__(self, *, what: str, dt: float, table: Table, motion: Motion) -> None:
        self.enough = enough(table, motion, dt)
        super().__init__(
            f"{what}: dt={dt:g} s is too long for motions at {fastest(table, motion):.3g} rad/s; "
            f"take dt={self.enough:g} s"
        )


def enough(table: Table, motion: Motion, dt: float) -> float:
    """Sufficiently short time step [s] if `dt` [s] was too long, rounded down to one digit."""
    return _rounded(min(RADIAN / fastest(table, motion), dt / 2))


def missing(engagement: Engagement) -> float:
    """Largest error of the energy balance, divided by the work done plus the initial energy."""
    energies, motion, table = balance(engagement), engagement.motion, engagement.table
    inner, outer = engagement.states[0, 4:6]
    start = (motion.I_bi * inner**2 + motion.I_be * outer**2) / 2
    start += table.n_s * float(table.at(engagement.alpha[0])["W"])
    put_in = float(np.abs(energies.torque).max() + np.abs(energies.blades).max() + start)
    most = float(np.abs(energies.missing).max())
    return most / put_in if put_in > 0 else 0.0


def fastest(table: Table, motion: Motion) -> float:
    """Upper bound [rad/s] of the frequencies and decay rates of an engagement.

    It covers rolling races on stiff sprags, the support, the damping, and a sprag that slides
    alone.
    """
    _, OA, OB, OC_g, b_i, b_e, *_ = table.values[:, 1:]
    alpha = (table.step * np.arange(table.values.shape[1])) ** 2
    moment = table.values[0] * table.values[6]
    slope = float(np.max(np.diff(moment) / np.diff(alpha)))
    turn = b_i / OA + b_e / OB  # rotation of the races against each other, per rotation of a sprag
    races = 1 / motion.I_bi + 1 / motion.I_be
    rolling = table.n_s * slope / float(np.min(turn**2)) * races + motion.k_out / motion.I_be
    own = slope * (1 / motion.I_g + 1 / (motion.m_g * float(np.min(OC_g**2))))
    return max(math.sqrt(rolling), math.sqrt(own), motion.C_rl * races)


def _rounded(x: float) -> float:
    """`x` rounded down to one digit."""
    unit = 10.0 ** math.floor(math.log10(x))
    return math.floor(x / unit * (1 + 1e-9)) * unit
