"""Finite elements of the driven ring: the hub's force goes with that of the rollers."""

from collections.abc import Callable
from math import inf, isfinite
from typing import TYPE_CHECKING

import numpy as np
from scipy.optimize import brentq

from verify.cases.contact.errors import fem_errors
from verify.cases.polyhedral.clutch.inputs import ClutchInputs
from verify.cases.polyhedral.locking.fem import LockedRing

if TYPE_CHECKING:
    from fem.contact.solution import ContactSolution

CLOSE, MOST = 1e-11, 60
GROWTH, LOCKED = 1.5, 100.0  # steps in search of N, and how often the pressure's part is no limit
THICK = 0.15  # wall over outer diameter from which on a mesh is twice as fine
THIN = 0.02  # and that at the rollers below which it is: bent walls end contacts beside vertices


class DrivenRing:
    """Half a sector, its roller at the friction limit `grip`, the hub in balance with it.

    N [N/m] is the roller's force under the inputs' pressure, infinite where the hub's lift locks.
    """

    def __init__(self, q: ClutchInputs, level: int, *, grip: float, elastic: bool) -> None:
        self.q, self.elastic = q, elastic
        turn = np.hypot(q.e, q.ring.apothem) * np.sin(q.psi + q.phi_1)
        self.kappa = grip * q.D_i / 2 / turn  # moments of roller and hub about the axis
        slim = q.d_e / 2 - q.ring.apothem < THIN * q.d_e
        self.refine = 2 * level if slim or q.delta_1 > THICK * q.d_e else level
        self.ring = self.coarse = self._ring(1, q.p_t, 0.0)
        coarse = self.force(q.p_t)
        if isfinite(coarse):
            self.ring = self._ring(self.refine, q.p_t, coarse)
        self.N = self.force(q.p_t)

    def _ring(self, refine: int, p: float, N: float) -> LockedRing:
        q = self.q
        return LockedRing(q.ring, refine, d=q.d, e=q.e, p=p, hub=self.push(N), elastic=self.elastic)

    def push(self, N: float) -> tuple[float, float]:
        """The hub's force on a flat [N/m]: along its normal, and along it away from the middle."""
        R = self.kappa * N
        return float(R * np.cos(self.q.phi_1)), float(-R * np.sin(self.q.phi_1))

    def at(self, p: float, N: float) -> "ContactSolution":
        """The state under the pressure `p` and the hub's force that goes with N."""
        return self.ring.at(p, self.push(N))

    def force(self, p: float) -> float:
        """Force N [N/m] of a roller under the pressure `p`, infinite where the hub's lift locks."""
        low, high = 0.0, self.ring.force(p)
        while self._excess(p, high) > 0:
            low, high = high, GROWTH * high
            if high > LOCKED * self.ring.force(p):
                return inf
        return float(brentq(lambda N: self._excess(p, N), low, high, xtol=CLOSE * high, rtol=CLOSE))

    def _excess(self, p: float, N: float) -> float:
        """By how much [N/m] the roller's force exceeds the N that the hub's force belongs to."""
        return self.ring.force(p, self.push(N)) - N

    def pressure(self, N: float) -> float:
        """Pressure [Pa] under which a roller carries N [N/m].

        On a mesh of its own, for which a coarse pressure is enough: on that for another force
        contacts end anywhere within a cell, which moves the pressure by 1e-6 to 1e-5 at random.
        """
        p = self._pressure(self.coarse, N)
        return self._pressure(self._ring(self.refine, p, N), N)

    def _pressure(self, ring: LockedRing, N: float) -> float:
        p = self.q.p_t
        return _root(lambda x: ring.force(x * p, self.push(N)) / N - 1, 1.0, 1.1) * p


def _root(f: Callable[[float], float], a: float, b: float) -> float:
    """Zero of a function that is nearly linear, by the secant method."""
    f_a, f_b = f(a), f(b)
    for _ in range(MOST):
        if abs(b - a) <= CLOSE * abs(b) or f_b == f_a:
            return b
        a, b, f_a = b, b - f_b * (b - a) / (f_b - f_a), f_b
        f_b = f(b)
    raise fem_errors().NotFoundError(
        f"the rollers' force is missed by {f_b:.1e} after {MOST} steps"
    )
