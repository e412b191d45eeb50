"""A locked sector with a hub force proportional to the rollers', at the limit of friction."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from math import inf, isfinite

import numpy as np
from scipy.optimize import brentq

from fem.contact.errors import NotFoundError
from fem.contact.locked import Force, LockedSector
from fem.contact.solution import ContactSolution

CLOSE, MOST = 1e-11, 60
GROWTH, LOCKED = 1.5, 100.0  # steps in search of N, and how often the pressure's part is no limit


@dataclass(frozen=True)
class DrivenSector:
    """Half a sector in balance with the hub, whose force is kappa times the force N of the roller.

    The force of the hub is inclined by `phi_1` [rad] from the normal of the flat to its middle.
    `mesh` generates the sector, coarse or fine, with cells for the contacts under a pressure and a
    force of the hub. N is the force of the roller under the pressure p; it is infinite if the lift
    of the hub locks.
    """

    mesh: Callable[[bool, float, Force], LockedSector]
    kappa: float
    phi_1: float
    p: float

    @cached_property
    def coarse(self) -> LockedSector:
        """The sector on a coarse mesh."""
        return self.mesh(False, self.p, self.push(0.0))

    @cached_property
    def fine(self) -> LockedSector:
        """The sector on a mesh for the N of a coarse mesh; the coarse one if the fine one locks."""
        N = self.force_on(self.coarse, self.p)
        return self.mesh(True, self.p, self.push(N)) if isfinite(N) else self.coarse

    @cached_property
    def N(self) -> float:
        """The roller's force under p."""
        return self.force_on(self.fine, self.p)

    def push(self, N: float) -> Force:
        """The hub's force on a flat: along its normal, and along it away from the middle."""
        R = self.kappa * N
        return float(R * np.cos(self.phi_1)), float(-R * np.sin(self.phi_1))

    def at(self, p: float, N: float) -> ContactSolution:
        """The state under the pressure `p` and the hub's force proportional to N."""
        return self.fine.at(p, self.push(N))

    def force_on(self, sector: LockedSector, p: float) -> float:
        """Force N of a roller under the pressure `p`; infinite if the lift of the hub locks."""

        def excess(N: float) -> float:
            """Excess of the roller's force over the N that belongs to the hub's force."""
            return sector.force(p, self.push(N)) - N

        low, high = 0.0, sector.force(p)
        while excess(high) > 0:
            low, high = high, GROWTH * high
            if high > LOCKED * sector.force(p):
                return inf
        return float(brentq(excess, low, high, xtol=CLOSE * high, rtol=CLOSE))

    def pressure(self, N: float) -> float:
        """Pressure under which the force of a roller is N.

        On a separate mesh, for which an approximate pressure is sufficient: on the mesh for another
        force, the contacts would end anywhere in a cell, which changes the pressure by 1e-6 to 1e-5
        at random.
        """
        p = self._pressure(self.coarse, N)
        return self._pressure(self.mesh(True, p, self.push(N)), N)

    def _pressure(self, sector: LockedSector, N: float) -> float:
        return _root(lambda x: sector.force(x * self.p, self.push(N)) / N - 1, 1.0, 1.1) * self.p


def _root(f: Callable[[float], float], a: float, b: float) -> float:
    """Zero of a function that is nearly linear, by the secant method."""
    f_a, f_b = f(a), f(b)
    for _ in range(MOST):
        if abs(b - a) <= CLOSE * abs(b) or f_b == f_a:
            return b
        a, b, f_a = b, b - f_b * (b - a) / (f_b - f_a), f_b
        f_b = f(b)
    raise NotFoundError(f"the rollers' force still has the error {f_b:.1e} after {MOST} steps")
