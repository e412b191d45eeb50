"""History of an engagement: forces, sliding, works, energies, peaks and verdict."""

from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from analytic.contact.checks import Array
from analytic.sprag.motion import Motion, Torque
from analytic.sprag.table import Table

STATES = 12  # four angles, their speeds, four works
LATE = 0.25  # part of the time, at the end, that the verdict uses
LAST, STILL = 0.1, 0.01  # part of it in which a force that rises by less is at rest

Verdict = Literal["locks", "slips", "over the end", "disengages", "not followed"]


class Phase(IntEnum):
    """Phase of a contact: open, sticking or slipping."""

    OPEN = 0
    STICK = 1
    SLIP = 2


@dataclass(frozen=True, kw_only=True, eq=False)
class Engagement:
    """History of an engagement in steps `dt`: `states` (steps, 12), `outputs` (steps, 9)."""

    table: Table
    motion: Motion
    torque: Torque
    D_V: float  # m/s
    dt: float  # s
    over: bool  # past the end of the profile
    states: Array
    outputs: Array

    @property
    def t(self) -> Array:
        """Times [s], (steps,)."""
        return np.asarray(self.dt * np.arange(len(self.states)))

    @property
    def N(self) -> Array:
        """Normal force [N] of one sprag, (steps,)."""
        return np.asarray(self.outputs[:, 0])

    @property
    def T_i(self) -> Array:
        """Friction force [N] of one sprag at the inner race, (steps,)."""
        return np.asarray(self.outputs[:, 1])

    @property
    def T_e(self) -> Array:
        """Friction force [N] of one sprag at the outer race, (steps,)."""
        return np.asarray(self.outputs[:, 2])

    @property
    def v_i(self) -> Array:
        """Sliding speed [m/s] of the inner race against the sprag, (steps,)."""
        return np.asarray(self.outputs[:, 3])

    @property
    def v_e(self) -> Array:
        """Sliding speed [m/s] of the sprag against the outer race, (steps,)."""
        return np.asarray(self.outputs[:, 4])

    @property
    def alpha(self) -> Array:
        """Rotation [rad] of a sprag from its first contact, (steps,)."""
        return np.asarray(self.states[:, 3])

    @property
    def theta_i(self) -> Array:
        """Angle [rad] of the inner race, (steps,)."""
        return np.asarray(self.states[:, 0])

    @property
    def theta_e(self) -> Array:
        """Angle [rad] of the outer race, (steps,)."""
        return np.asarray(self.states[:, 1])

    @property
    def phases(self) -> NDArray[np.int8]:
        """`Phase` of the inner and the outer contact, (steps, 2)."""
        return self.outputs[:, 7:9].astype(np.int8)

    @cached_property
    def peak(self) -> tuple[float, float]:
        """Time [s] and value [N] of the largest N, from the parabola through three samples.

        If the sprag passes the end of the profile, the largest sample within the profile is used.
        """
        return _summit(self.t, self.N, int(np.argmax(self.N)))

    @property
    def N_max(self) -> float:
        """Largest normal force [N]."""
        return self.peak[1]

    @cached_property
    def first_peak(self) -> tuple[float, float]:
        """Time [s] and value [N] of the first maximum of N above half of the largest N."""
        N = self.N
        tops = (N[1:-1] >= N[:-2]) & (N[1:-1] > N[2:]) & (N[1:-1] > self.N_max / 2)
        return _summit(self.t, N, int(np.argmax(tops)) + 1) if tops.any() else self.peak

    @cached_property
    def N_static(self) -> float:
        """Force N [N] at rest under the final torque, without energizing springs.

        The value is nan if the torque exceeds that at the end of the profile.
        """
        C, end = float(self.torque.values[-1]), self.table.end
        if C <= 0 or self.table.static_torque(end) < C:
            return 0.0 if C <= 0 else float("nan")
        alpha = brentq(lambda a: float(self.table.static_torque(a)) - C, 0.0, end, xtol=1e-15)
        return float(self.table.at(alpha)["N"])

    @property
    def peak_factor(self) -> float:
        """Ratio of N_max to N at rest; nan if the engagement was not computed up to a peak."""
        return self.N_max / self.N_static if self.followed else float("nan")

    @property
    def followed(self) -> bool:
        """True if the largest force is a peak or a state of rest: N does not rise at the end.

        It is also True if the sprag has passed the end of its profile, and False if the inner race
        still overruns.
        """
        N = self.N
        if self.over:
            return True
        if self.overruns:
            return False
        if int(np.argmax(N)) < len(N) - 1:
            return True
        return float(N[-1] - N[int((1 - LAST) * (len(N) - 1))]) <= STILL * float(N[-1])

    @property
    def overruns(self) -> bool:
        """True if the inner race overruns for most of the last quarter of the time."""
        late = slice(-max(1, int(LATE * len(self.states))), None)
        return bool(np.mean((self.phases[late, 0] == Phase.SLIP) & (self.v_i[late] < 0)) > 0.5)

    @property
    def verdict(self) -> Verdict:
        """Result of the engagement.

        "slips": a contact slides for most of the last quarter of the time. "disengages": the
        contacts are open for most of this quarter. "over the end": the sprag has passed the end of
        its profile. "not followed": the force still rises at the end, or the inner race overruns.
        """
        if self.over:
            return "over the end"
        if not self.followed:
            return "not followed"
        late = self.phases[-max(1, int(LATE * len(self.states))) :]
        if np.mean(late[:, 0] == Phase.OPEN) > 0.5:
            return "disengages"
        return "slips" if np.mean((late == Phase.SLIP).any(axis=1)) > 0.5 else "locks"


def _summit(t: Array, y: Array, k: int) -> tuple[float, float]:
    if not 0 < k < len(y) - 1:
        return float(t[k]), float(y[k])
    left, mid, right = (float(x) for x in y[k - 1 : k + 2])
    bend = left - 2 * mid + right
    if bend == 0:
        return float(t[k]), mid
    ahead = (left - right) / (2 * bend)
    return float(t[k] + ahead * (t[1] - t[0])), mid - (left - right) * ahead / 4
