"""Time at which a load path reaches the capacity of a clutch, by a second formulation.

This module verifies the times of slip that `load_path` and the slip criterion give. It uses only
the definitions of the load paths of the test rig (Nagler, Lohrengel, Sec. 6):

1. the torque increases to T within `rise`, then the axial load increases linearly to F_ax at
   `duration`;
2. as path 1, but the axial load alternates about zero;
3. torque T_m + T sin and an axial load in phase, whose amplitude increases from the beginning.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

FINE = 400  # times of a cycle: a crossing below the top by less than 4e-5 of it may be missed
ROUND_OFF = 1e-9  # relative to the cycles, so that their times are the same on all processors

Tangent = Callable[[float], float]  # tan(alpha) over the torque


@dataclass(frozen=True, kw_only=True)
class Rig:
    """Loads [N m, N], frequency f [Hz] and times [s] of the three paths; R [m] is the race radius.

    `T_critical` is the torque of path 3 at which the smallest axial amplitude causes slip.
    """

    R: float
    T: float
    T_m: float
    T_critical: float
    F_ax: float
    f: float
    rise: float
    duration: float

    def time_of_slip(self, path: int, F: float, tan: Tangent) -> float:
        """First time [s] at which the clutch slips on the load path; infinite if it does not slip.

        `path` is the number of the load path. `F` is the axial load at slip, under the torque T or,
        for path 3, under T_critical. At this load and torque, the required friction equals the
        available friction. `tan` is used only for path 3.
        """
        if path == 1:
            t = self.rise + F / self.F_ax * (self.duration - self.rise)
            return t if t <= self.duration else math.inf
        return self._steady(F) if path == 2 else self._in_phase(F, tan)

    def _steady(self, F: float) -> float:
        span = self.duration - self.rise

        def beyond(t: float) -> float:
            s = t - self.rise
            return self.F_ax * s / span * abs(math.sin(2 * math.pi * self.f * s)) - F

        return self._first(beyond, self.rise)

    def _in_phase(self, F: float, tan: Tangent) -> float:
        mu = tan(self.T_critical) * math.hypot(1, self.R * F / self.T_critical)

        def asks(t: float) -> float:
            sine = math.sin(2 * math.pi * self.f * t)
            T, load = self.T_m + self.T * sine, self.F_ax * t / self.duration * sine
            return tan(T) * math.hypot(1, self.R * load / T) - mu if T > 0 else -mu

        return self._first(asks, 0.0)

    def _first(self, beyond: Callable[[float], float], start: float) -> float:
        """First time [s] after which `beyond` is positive; infinite if it is never positive."""
        cycles = self.f * (self.duration - start) * (1 - ROUND_OFF)
        times = np.linspace(start, self.duration, 1 + math.ceil(FINE * cycles))
        above = np.flatnonzero([beyond(float(t)) > 0 for t in times])
        if not above.size:
            return math.inf
        k = int(above[0])
        return float(brentq(beyond, times[k - 1], times[k])) if k else start

    def tangent(self, sines: tuple[float, float], mu_req: tuple[float, float]) -> Tangent:
        """Linear function tan(alpha) of the torque [N m], through two points of load path 3.

        The points are the required frictions `mu_req` at the end of the path for two values `sines`
        of the sine of its loads. From 0.3 to 1 times the torque of the synthetic clutch, the error
        of the line is below 2e-3.
        """

        def at(sine: float, friction: float) -> tuple[float, float]:
            T = self.T_m + sine * self.T
            return T, friction / math.hypot(1, self.R * sine * self.F_ax / T)

        (T, tan), (T_low, tan_low) = map(at, sines, mu_req)
        return lambda torque: tan + (torque - T) * (tan - tan_low) / (T - T_low)
