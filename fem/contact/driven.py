"""Locked sector with its roller at the friction limit: hub force proportional to roller force."""

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
    """Half a sector in equilibrium with the hub, whose force is `kappa` times the roller force N.

    The hub force is inclined by `phi_1` [rad] from the normal of the flat towards the middle of the
    flat. `mesh` generates the sector for a pressure and a hub force; its first argument selects the
    fine mesh. N is the roller force under the pressure `p`. N is infinite if the hub force, which
    increases with N, makes the sector self-locking.
    """

    mesh: Callable[[bool, float, Force], LockedSector]
    kappa: float
    phi_1: float
    p: float

    @cached_property
    def coarse(self) -> LockedSector:
        """Sector on a coarse mesh."""
        return self.mesh(False, self.p, self.push(0.0))

    @cached_property
    def fine(self) -> LockedSector:
        """Sector on a fine mesh, generated for the roller force that results on the coarse mesh.

        If this force is infinite, the result is the coarse sector.
        """
        N = self.force_on(self.coarse, self.p)
        return self.mesh(True, self.p, self.push(N)) if isfinite(N) else self.coarse

    @cached_property
    def N(self) -> float:
        """Force of the roller under the pressure p."""
        return self.force_on(self.fine, self.p)

    def push(self, N: float) -> Force:
        """Hub force: components normal to the flat, and along the flat away from its middle."""
        R = self.kappa * N
        return float(R * np.cos(self.phi_1)), float(-R * np.sin(self.phi_1))

    def at(self, p: float, N: float) -> ContactSolution:
        """Contact state under the pressure `p` and the hub force for the roller force `N`."""
        return self.fine.at(p, self.push(N))

    def force_on(self, sector: LockedSector, p: float) -> float:
        """Force N of a roller under the pressure `p`; infinite if the sector is self-locking."""

        def excess(N: float) -> float:
            """Roller force of the solution minus N, for which the hub force is calculated."""
            return sector.force(p, self.push(N)) - N

        low, high = 0.0, sector.force(p)
        while excess(high) > 0:
            low, high = high, GROWTH * high
            if high > LOCKED * sector.force(p):
                return inf
        return float(brentq(excess, low, high, xtol=CLOSE * high, rtol=CLOSE))

    def pressure(self, N: float) -> float:
        """Pressure under which the force of a roller is N.

        The pressure is calculated on a mesh that is generated for an approximate pressure. On a
        mesh for another force, the edges of contact would lie at random positions within cells,
        which changes the pressure by 1e-6 to 1e-5.
        """
        p = self._pressure(self.coarse, N)
        return self._pressure(self.mesh(True, p, self.push(N)), N)

    def _pressure(self, sector: LockedSector, N: float) -> float:
        return _root(lambda x: sector.force(x * self.p, self.push(N)) / N - 1, 1.0, 1.1) * self.p


def _root(f: Callable[[float], float], a: float, b: float) -> float:
    """Zero of a nearly linear function, by the secant method."""
    f_a, f_b = f(a), f(b)
    for _ in range(MOST):
        if abs(b - a) <= CLOSE * abs(b) or f_b == f_a:
            return b
        a, b, f_a = b, b - f_b * (b - a) / (f_b - f_a), f_b
        f_b = f(b)
    raise NotFoundError(
        f"the roller force did not converge: relative error {f_b:.1e} after {MOST} steps"
    )
